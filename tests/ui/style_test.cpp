#include "ui/style/style.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QHeaderView>
#include <QImage>
#include <QPainter>
#include <QStyle>
#include <QStyleOption>
#include <QTreeWidget>
#include <cstdlib>

#include "ui/style/breakable.hpp"

namespace analogon::ui::style {
namespace {

/// How far the lightness of what is drawn is from that of the ground.
int contrast(const QImage& picture, const QColor& ground) {
    int most = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            most = std::max(most, std::abs(picture.pixelColor(x, y).lightness() - ground.lightness()));
    return most;
}

TEST(Style, LinesAreSeenOnALightAndOnADarkGround) {
    constexpr int enough = 15;  // of 255
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
        apply(*qApp, theme);
        const QStyle& style = *QApplication::style();
        const QColor window = QApplication::palette().color(QPalette::Window);
        const auto drawn = [&](auto option, const auto& draw) {
            option.palette = QApplication::palette();
            option.rect = QRect(0, 0, 40, 24);
            QImage picture(option.rect.size(), QImage::Format_RGB32);
            picture.fill(window);
            QPainter painter(&picture);
            draw(option, painter);
            painter.end();
            return contrast(picture, window);
        };
        EXPECT_GT(drawn(QStyleOption(),
                        [&](const QStyleOption& o, QPainter& p) {
                            style.drawPrimitive(QStyle::PE_IndicatorToolBarSeparator, &o, &p);
                        }),
                  enough)
            << "between the buttons of a bar";
        EXPECT_GT(
            drawn(QStyleOptionMenuItem(), [&](const QStyleOptionMenuItem& o,
                                              QPainter& p) { style.drawControl(QStyle::CE_MenuBarEmptyArea, &o, &p); }),
            enough)
            << "below the menus";
        EXPECT_GT(drawn(QStyleOptionProgressBar(),
                        [&](const QStyleOptionProgressBar& o, QPainter& p) {
                            style.drawControl(QStyle::CE_ProgressBarGroove, &o, &p);
                        }),
                  enough)
            << "how much is left";
        QStyleOption cell;
        cell.palette = QApplication::palette();
        const QColor grid = QColor::fromRgba(static_cast<QRgb>(style.styleHint(QStyle::SH_Table_GridLineColor, &cell)));
        EXPECT_GT(std::abs(grid.lightness() - cell.palette.color(QPalette::Base).lightness()), enough)
            << "between the cells of a table";
    }
    apply(*qApp, Theme::Light);
}

/// The name of a connector has no blank in it, and breaks behind its dot where it has no room on one line.
TEST(Style, NamesInAColumnThatWrapsAreNotCut) {
    QTreeWidget table;
    table.setColumnCount(2);
    table.header()->setSectionResizeMode(QHeaderView::Fixed);
    const QString name = "electricMechanical.flange";
    auto* item = new QTreeWidgetItem(&table, {name, "x"});
    wrapColumn(&table, 0);
    table.setRootIsDecorated(false);
    table.show();
    const auto linesAt = [&](int width) {
        table.setColumnWidth(0, width);
        table.doItemsLayout();
        return table.visualItemRect(item).height() / table.fontMetrics().height();
    };
    const int whole = table.fontMetrics().horizontalAdvance(name);
    EXPECT_EQ(linesAt(whole + 20), 1);
    EXPECT_EQ(linesAt(whole - 10), 2);
    EXPECT_EQ(item->text(0), name) << "what is copied is the name";
    EXPECT_EQ(breakableAtSigns("Reibung bei a.b und 0.5").remove(QChar(0x200B)), "Reibung bei a.b und 0.5");
    EXPECT_EQ(breakableAtSigns("0.5 at 1.0").size(), 10) << "numbers stay whole";
}

}  // namespace
}  // namespace analogon::ui::style
