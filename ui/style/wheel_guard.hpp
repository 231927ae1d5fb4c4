#pragma once

#include <QObject>

class QApplication;

namespace analogon::ui::style {

/// A wheel over a list of choices, a number or a slider changes its value only where that has the focus; else it goes
/// on to what scrolls around it.
class WheelGuard : public QObject {
    Q_OBJECT

public:
    explicit WheelGuard(QApplication& application);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace analogon::ui::style
