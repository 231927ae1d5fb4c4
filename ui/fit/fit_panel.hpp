#pragma once

#include <QElapsedTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;
class QTreeWidget;

namespace analogon::ui {

class Document;
class ErrorCurve;
class RunController;

/// How the next run works, how the one under way gets on, and all runs so far: two of them can be compared side by
/// side, and one can be gone back to.
class FitPanel : public QWidget {
    Q_OBJECT

public:
    FitPanel(Document& document, RunController& controller, QWidget* parent = nullptr);

    QComboBox* methodBox() const { return method_; }
    QSpinBox* startsBox() const { return starts_; }
    ErrorCurve* curve() const { return curve_; }
    QTreeWidget* history() const { return history_; }
    QTreeWidget* comparison() const { return comparison_; }
    QPushButton* restoreButton() const { return restore_; }

private:
    void applyOptions();
    void refresh();
    void compare();
    int heightOfRuns() const;
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
    QElapsedTimer clock_;
};

}  // namespace analogon::ui
