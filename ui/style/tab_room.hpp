#pragma once

#include <QObject>

class QApplication;
class QWidget;

namespace analogon::ui::style {

/// Whether a window has so little room that the words of its tabs need that of the gaps between them.
bool isNarrowWindow(const QWidget& window);

/// Tabs have the gaps for the width of their window, also once it has become wider or narrower, which a bar that keeps
/// its own width does not hear of.
class TabRoom : public QObject {
public:
    explicit TabRoom(QApplication& application);

    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace analogon::ui::style
