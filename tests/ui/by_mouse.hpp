#pragma once

#include <gtest/gtest.h>

#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <QTreeView>

#include "ui/canvas/diagram_view.hpp"
#include "ui/library/library_panel.hpp"

/// What is done with the mouse in tests of several parts of the window.
namespace analogon::test {

/// Drags a block from the library to a point of the diagram.
inline void dragFromLibrary(ui::LibraryPanel& library, const ui::DiagramView& diagram, const char* className,
                            QPoint to) {
    const QRect row = library.showClass(className);
    ASSERT_FALSE(row.isEmpty()) << className;
    QWidget* from = library.tree()->viewport();
    const QPoint end = from->mapFromGlobal(diagram.viewport()->mapToGlobal(to));
    QTest::mousePress(from, Qt::LeftButton, {}, row.center());
    QTest::mouseMove(from, row.center() + QPoint(30, 10));
    QTest::mouseMove(from, end);
    QTest::mouseRelease(from, Qt::LeftButton, {}, end);
}

/// Clicks the tab of a page, where it has one.
inline void clickTabOf(const QWidget& window, QWidget* page) {
    for (QTabWidget* tabs : window.findChildren<QTabWidget*>())
        if (const int tab = tabs->indexOf(page); tab >= 0)
            QTest::mouseClick(tabs->tabBar(), Qt::LeftButton, {}, tabs->tabBar()->tabRect(tab).center());
    QTest::qWait(20);
}

}  // namespace analogon::test
