#pragma once

#include <QContextMenuEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTableWidget>
#include <QToolButton>
#include <QTreeView>
#include <QTreeWidget>

#include "tests/ui/by_mouse.hpp"
#include "tests/ui/panels_fixture.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/library/library_panel.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/signals/plot_area.hpp"
#include "ui/signals/signal_browser.hpp"
#include "ui/signals/signal_strip.hpp"
#include "ui/text/text_view.hpp"

/// What the window is made for, done as a user does it: where the mouse is pressed and which keys are hit, and nothing
/// that only the program can call.
namespace analogon::ui {
class ByHand : public Panels {
protected:
    SignalBrowser& browser() const { return *window.findChild<SignalBrowser*>(); }
    PlotArea& plots() const { return *window.findChild<PlotArea*>(); }
    QTreeView* list() const { return browser().tree(); }
    QTreeWidget* measurements() const { return panel<MeasurementPanel>()->tree(); }

    void activate() {
        window.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    }
    void raise(std::initializer_list<const char*> docks) {
        for (const char* dock : docks) panel<QDockWidget>(dock)->raise();
        QTest::qWait(20);
    }
    void openSignals() {
        openLambda();
        ASSERT_TRUE(QTest::qWaitFor([&] { return !document().facts().variables.empty(); }, 20000));
        raise({"signals", "plots"});
    }
    /// What is listed of a group, or of all.
    QStringList listed() const {
        QStringList names;
        for (int g = 0; g < list()->model()->rowCount(); ++g) {
            const QModelIndex group = list()->model()->index(g, 0);
            for (int i = 0; i < list()->model()->rowCount(group); ++i)
                names << group.data().toString() + " | " + list()->model()->index(i, 0, group).data().toString();
        }
        return names;
    }
    void seek(const QString& typed) {
        QTest::mouseClick(browser().searchField(), Qt::LeftButton);
        QTest::keyClick(browser().searchField(), Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(browser().searchField(), typed);
    }
    /// The first signal that is found goes to the plots by Enter.
    void send(const QString& typed) {
        seek(typed);
        QTest::keyClick(browser().searchField(), Qt::Key_Return);
        QTest::keyClick(list(), Qt::Key_Return);
    }
    bool isShown(std::size_t axis, std::size_t trace = 0) const {
        const auto& strips = plots().strips();
        if (axis >= strips.size()) return false;
        const auto& lines = strips[axis]->chart()->lines();
        return trace < lines.size() && lines[trace].data && lines[trace].data->time;
    }
    static void clickButton(QWidget* of, const char* name) {
        auto* button = of->findChild<QToolButton*>(name);
        ASSERT_TRUE(button && button->isVisible() && button->isEnabled()) << name;
        QTest::mouseClick(button, Qt::LeftButton);
        QTest::qWait(20);
    }
    /// With the mouse, from the bar of menus.
    void chooseInMenu(const QString& menuTitle, const QString& text) {
        QMenuBar* bar = window.menuBar();
        for (QAction* entry : bar->actions()) {
            if (entry->text().remove('&') != menuTitle) continue;
            QTest::mouseClick(bar, Qt::LeftButton, {}, bar->actionGeometry(entry).center());
            return chooseIn(entry->menu(), text);
        }
        FAIL() << menuTitle.toStdString();
    }
    static void chooseIn(QMenu* menu, const QString& text) {
        ASSERT_TRUE(menu && QTest::qWaitFor([&] { return menu->isVisible(); }, 2000)) << text.toStdString();
        for (QAction* action : menu->actions())
            if (action->text() == text) {
                ASSERT_TRUE(action->isEnabled()) << text.toStdString();
                return QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
            }
        menu->close();
        FAIL() << "no " << text.toStdString();
    }
    /// The menu that the right button opens on a row of the measurements.
    void chooseOf(QTreeWidgetItem* row, const QString& text) {
        measurements()->scrollToItem(row);
        const QPoint at = measurements()->visualItemRect(row).center();
        QWidget* area = measurements()->viewport();
        QTest::mouseClick(area, Qt::LeftButton, {}, at);
        QContextMenuEvent asked(QContextMenuEvent::Mouse, at, area->mapToGlobal(at));
        QCoreApplication::sendEvent(area, &asked);
        QMenu* opened = nullptr;
        for (QMenu* menu : panel<MeasurementPanel>()->findChildren<QMenu*>())
            if (menu->isVisible()) opened = menu;
        chooseIn(opened, text);
    }
    static void type(QLineEdit* field, const QString& text) {
        QTest::mouseClick(field, Qt::LeftButton);
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, text);
    }
    /// The name of a file into a dialog, in which typing begins at once, and Enter.
    static void name(QFileDialog* dialog, const QString& file) {
        ASSERT_TRUE(dialog);
        auto* field = dialog->findChild<QLineEdit*>();
        ASSERT_TRUE(field && QTest::qWaitFor([&] { return field->hasFocus(); }, 5000));
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, file);
        QTest::keyClick(field, Qt::Key_Return);
    }
    /// Into a cell that a double click opens.
    static void typeInCell(QTableWidget* table, int row, int column, const QString& text) {
        const QPoint at = table->visualItemRect(table->item(row, column)).center();
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, at);
        auto* field = table->viewport()->findChild<QLineEdit*>();
        ASSERT_TRUE(field);
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        QTest::qWait(20);
    }
    void showText() {
        auto* text = panel<TextView>();
        test::clickTabOf(window, text);
        ASSERT_TRUE(text->isVisible());
    }
    void newStudy() {
        activate();
        QTest::keyClick(&window, Qt::Key_N, Qt::ControlModifier);
        ASSERT_TRUE(document().isOpen());
        QTest::qWait(100);
    }
    QPoint pixel(Point at) const { return panel<DiagramView>()->mapFromScene(QPointF(at.x, -at.y)); }
    void dragOnDiagram(QPoint from, QPoint to) const {
        QWidget* view = panel<DiagramView>()->viewport();
        QTest::mousePress(view, Qt::LeftButton, {}, from);
        QTest::mouseMove(view, (from + to) / 2);
        QTest::mouseMove(view, to);
        QTest::mouseRelease(view, Qt::LeftButton, {}, to);
    }
    void place(const char* className, Point to) const {
        test::dragFromLibrary(*panel<LibraryPanel>(), *panel<DiagramView>(), className, pixel(to));
    }
    void wire(const char* from, const char* to) {
        const auto a = document().diagram().anchor(from), b = document().diagram().anchor(to);
        ASSERT_TRUE(a && b) << from << " " << to;
        dragOnDiagram(pixel(*a), pixel(*b));
    }
    void simulate() {
        activate();
        const std::size_t before = document().history().size();
        QTest::keyClick(&window, Qt::Key_F4);
        ASSERT_TRUE(QTest::qWaitFor([&] { return document().history().size() == before + 1; }, 20000));
    }
};

}  // namespace analogon::ui
