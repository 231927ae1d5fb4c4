#include "ui/style/tab_room.hpp"

#include <QApplication>
#include <QResizeEvent>
#include <QTabBar>

namespace analogon::ui::style {

namespace {

constexpr int narrow = 1100;  // [px]

}  // namespace

bool isNarrowWindow(const QWidget& window) { return window.width() < narrow; }

TabRoom::TabRoom(QApplication& application) : QObject(&application) { application.installEventFilter(this); }

bool TabRoom::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Resize || !watched->isWidgetType()) return false;
    const auto& window = *static_cast<QWidget*>(watched);
    const QSize before = static_cast<QResizeEvent*>(event)->oldSize();
    if (!window.isWindow() || (before.width() < narrow) == isNarrowWindow(window)) return false;
    for (QTabBar* bar : window.findChildren<QTabBar*>()) {
        QEvent anew(QEvent::StyleChange);
        QCoreApplication::sendEvent(bar, &anew);
    }
    return false;
}

}  // namespace analogon::ui::style
