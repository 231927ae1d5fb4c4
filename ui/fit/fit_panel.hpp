#pragma once

#include <QElapsedTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace analogon::ui {

class Document;
class ErrorCurve;
class RunController;
struct RunRecord;

/// How the next run works, how the one under way gets on, and all runs so far: they have names and notes, several can
/// be compared side by side, one can be gone back to, and pinned ones stay. The borders between its parts are the
/// user's.
class FitPanel : public QWidget {
    Q_OBJECT

public:
    FitPanel(Document& document, RunController& controller, QWidget* parent = nullptr);

    QComboBox* methodBox() const { return method_; }
    QSpinBox* startsBox() const { return starts_; }
    ErrorCurve* curve() const { return curve_; }
    QTreeWidget* history() const { return history_; }
    QLineEdit* filterField() const { return filter_; }  // seen once Ctrl+F asks for it
    QTreeWidget* comparison() const { return comparison_; }
    QPushButton* restoreButton() const { return restore_; }
    QToolButton* pinButton() const { return pin_; }
    QLineEdit* nameField() const { return name_; }
    QLineEdit* noteField() const { return note_; }

private:
    void createParts();
    void connectController();
    void applyOptions();
    void refresh();
    void showRow(QTreeWidgetItem* item, const RunRecord& run) const;
    void filter();
    void leaveFilter();
    void showDetails();
    void compare();
    void colourCompared();
    void describe();
    void pin(bool isPinned);
    const RunRecord* chosenRun() const;
    void restore();
    std::vector<std::size_t> chosen() const;

    Document& document_;
    RunController& controller_;
    QComboBox *method_, *loss_;
    QSpinBox* starts_;
    ErrorCurve* curve_;
    QLabel *left_, *hint_;
    QTreeWidget *history_, *comparison_;
    QPushButton* restore_;
    QToolButton* pin_;
    QLineEdit *filter_, *name_, *note_;
    QWidget *options_, *details_;
    QElapsedTimer clock_;
};

}  // namespace analogon::ui
