#pragma once

#include <QFileDialog>

namespace analogon::ui {

/// Asks for the directory of a report, by a name that need not be there yet. One that holds something else is opened,
/// and the name is wanted within it.
class ReportFolderDialog : public QFileDialog {
    Q_OBJECT

public:
    ReportFolderDialog(QWidget* parent, const QString& title);
    void setProposal(const QString& name);

protected:
    void accept() override;

private:
    QString proposal_;
};

}  // namespace analogon::ui
