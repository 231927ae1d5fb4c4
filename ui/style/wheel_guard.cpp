#include "ui/style/wheel_guard.hpp"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>
#include <QSlider>

namespace analogon::ui::style {

namespace {

bool isTurnedByWheels(const QObject* object) {
    return qobject_cast<const QComboBox*>(object) || qobject_cast<const QAbstractSpinBox*>(object) ||
           qobject_cast<const QSlider*>(object);
}

}  // namespace

WheelGuard::WheelGuard(QApplication& application) : QObject(&application) { application.installEventFilter(this); }

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Polish && isTurnedByWheels(watched)) {
        auto* const widget = static_cast<QWidget*>(watched);
        // Qt gives the focus to what takes it by a wheel before it delivers the wheel.
        if (widget->focusPolicy() == Qt::WheelFocus) widget->setFocusPolicy(Qt::StrongFocus);
    } else if (event->type() == QEvent::Wheel && isTurnedByWheels(watched) &&
               !static_cast<const QWidget*>(watched)->hasFocus()) {
        event->ignore();
        return true;
    }
    return false;
}

}  // namespace analogon::ui::style
