#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QToolButton;

namespace analogon::ui {

class RunController;

/// What a run is doing, how far it is, and the button that stops it. Takes no room while nothing runs.
class RunBar : public QWidget {
    Q_OBJECT

public:
    explicit RunBar(RunController& controller, QWidget* parent = nullptr);

    QToolButton* cancelButton() const { return cancel_; }
    QProgressBar* progressBar() const { return bar_; }

private:
    RunController& controller_;
    QLabel* text_;
    QProgressBar* bar_;
    QToolButton* cancel_;
    bool isSearching_{};
};

}  // namespace analogon::ui
