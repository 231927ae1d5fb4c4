#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QTest>

#include "ui/plot/flow_layout.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

constexpr const char* longName = "after: Dry friction at BasicElectricMechanical.rotor.flange_b  12.34 %";

OutputPlot::Content content() {
    OutputPlot::Content shown;
    shown.name = "rotor.speed";
    shown.unit = "rad/s";
    shown.time = std::make_shared<const std::vector<double>>(std::vector<double>{0, 1, 2});
    shown.measured = shown.before = shown.after = Series(std::vector<double>{1, 2, 3});
    shown.beforeLabel = "before  45.67 %";
    shown.afterLabel = longName;
    return shown;
}

std::vector<QAbstractButton*> entriesOf(const OutputPlot& plot) {
    std::vector<QAbstractButton*> entries;
    for (QAbstractButton* button : plot.findChildren<QAbstractButton*>())
        if (!button->text().isEmpty() && button->isVisible()) entries.push_back(button);
    return entries;
}

TEST(Legend, TakesAsManyRowsAsItsWordsNeedAndNoneIsCut) {
    for (const int width : {1200, 480, 260, 150}) {
        OutputPlot plot;
        plot.show(content());
        plot.resize(width, 360);
        static_cast<QWidget&>(plot).show();
        QTest::qWait(20);
        const auto entries = entriesOf(plot);
        ASSERT_EQ(entries.size(), 3u);
        for (const QAbstractButton* entry : entries) {
            EXPECT_GE(entry->height(), entry->heightForWidth(entry->width())) << width;
            EXPECT_LE(entry->geometry().right(), plot.width()) << width;
            EXPECT_LE(entry->geometry().bottom(), plot.values()->geometry().top()) << "above the plot, " << width;
            for (const QAbstractButton* other : entries)
                EXPECT_TRUE(other == entry || !other->geometry().intersects(entry->geometry())) << width;
        }
        const bool isOneRow = entries[0]->y() == entries[2]->y();
        EXPECT_EQ(isOneRow, width == 1200) << width;
        plot.grab().save(QStringLiteral(ANALOGON_PICTURES) + QStringLiteral("/legend-%1.png").arg(width));
    }
}

TEST(Legend, StaysWhereItIsWhileThePointerReadsValues) {
    OutputPlot plot;
    plot.show(content());
    plot.resize(480, 360);
    static_cast<QWidget&>(plot).show();
    QTest::qWait(20);
    std::vector<QRect> before;
    for (const QAbstractButton* entry : entriesOf(plot)) before.push_back(entry->geometry());
    const QRect values = plot.values()->geometry();
    plot.pointAt(1.0);
    QTest::qWait(20);
    std::vector<QRect> after;
    for (const QAbstractButton* entry : entriesOf(plot)) after.push_back(entry->geometry());
    EXPECT_EQ(before, after);
    EXPECT_EQ(plot.values()->geometry(), values);
    bool isRead = false;
    for (const QLabel* label : plot.findChildren<QLabel*>())
        if (label->isVisible() && label->text().startsWith("1 s")) {
            isRead = true;
            EXPECT_GE(label->x(), 0);
            EXPECT_LE(label->geometry().right(), plot.width());
            for (const QRect& entry : after) EXPECT_FALSE(entry.intersects(label->geometry()));
        }
    EXPECT_TRUE(isRead);
}

}  // namespace

}  // namespace analogon::ui
