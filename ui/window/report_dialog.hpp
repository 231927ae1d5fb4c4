#pragma once

#include <QDialog>
#include <map>

#include "core/report/report_head.hpp"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTextBrowser;

namespace analogon::ui {

class Document;

/// What the reports of a study say of themselves, and which sections they have, with a preview of the head. It is kept
/// in the study, as one undoable edit.
class ReportDialog : public QDialog {
    Q_OBJECT

public:
    /// `canWrite`: there is a result to be written.
    ReportDialog(Document& document, bool canWrite, QWidget* parent = nullptr);

    QLineEdit* titleField() const { return title_; }
    QLineEdit* testObjectField() const { return testObject_; }
    QLineEdit* authorField() const { return author_; }
    QLineEdit* dateField() const { return date_; }
    QLineEdit* logoField() const { return logo_; }
    QCheckBox* sectionBox(ReportSection section) const { return sections_.at(section); }
    QTextBrowser* preview() const { return preview_; }
    QLabel* faultLabel() const { return fault_; }
    QPushButton* keepButton() const { return keep_; }
    QPushButton* writeButton() const { return write_; }

Q_SIGNALS:
    /// The head is in the study, and the report is to be written.
    void writeWanted();

private:
    QLayout* fields();
    QWidget* sectionBoxes();
    void fill();
    void askForLogo();
    void setLogo(const QString& path);
    ReportHead head() const;
    void showHead();
    void keep();

    Document& document_;
    QLineEdit *title_, *testObject_, *author_, *date_, *logo_;
    std::map<ReportSection, QCheckBox*> sections_;
    QTextBrowser* preview_;
    QLabel* fault_;
    QPushButton *keep_, *write_;
};

}  // namespace analogon::ui
