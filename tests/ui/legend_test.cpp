#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QScrollArea>
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

/// Whether the words of an entry, as they wrap, have room in it.
bool isWhole(const QAbstractButton& entry) { return entry.height() >= entry.heightForWidth(entry.width()); }

TEST(Legend, LosesNoWordWhereAPanelIsLow) {
    for (const int width : {520, 300, 220})
        for (const int height : {260, 160, 120, 90}) {
            QScrollArea area;  // as the panel has it
            auto* plot = new OutputPlot;
            area.setWidget(plot);
            area.setWidgetResizable(true);
            area.resize(width, height);
            area.show();
            plot->show(content());
            plot->fitInto(area.viewport()->height());
            QTest::qWait(20);
            plot->fitInto(area.viewport()->height());
            QTest::qWait(20);
            const auto entries = entriesOf(*plot);
            ASSERT_EQ(entries.size(), 3u);
            for (const QAbstractButton* entry : entries) {
                EXPECT_TRUE(isWhole(*entry)) << width << " x " << height;
                EXPECT_LE(entry->geometry().right(), plot->width());
                EXPECT_LE(entry->geometry().bottom(), plot->values()->geometry().top()) << width << " x " << height;
            }
            EXPECT_GE(plot->values()->height(), 52) << "the traces keep their room, " << width << " x " << height;
            const bool isRoomy = height == 260 && width == 520;
            EXPECT_TRUE(plot->residual()->isVisible() || !isRoomy);
            area.grab().save(QStringLiteral(ANALOGON_PICTURES) +
                             QStringLiteral("/legend-low-%1x%2.png").arg(width).arg(height));
        }
}

TEST(ResidualScale, IsThatOfWhatIsLeftAfter) {
    OutputPlot plot;
    OutputPlot::Content shown = content();
    shown.measured = Series(std::vector<double>{1, 2, 3});
    shown.before = Series(std::vector<double>{101, 2, 3});
    shown.after = Series(std::vector<double>{1.5, 2, 3});
    plot.show(shown);
    EXPECT_LT(plot.residual()->valueRange().second, 1) << "not the 100 of before";
    shown.after = {};
    plot.show(shown);
    EXPECT_GT(plot.residual()->valueRange().second, 90) << "there is nothing else";
}

TEST(Legend, BreaksALongNameOfTheOutput) {
    OutputPlot plot;
    OutputPlot::Content shown = content();
    shown.name = "electricVehicle.batteryPack.coolingCircuit.temperatureSensor.measured";
    plot.show(shown);
    plot.resize(240, 360);
    static_cast<QWidget&>(plot).show();
    QTest::qWait(20);
    for (const QLabel* label : plot.findChildren<QLabel*>())
        if (label->text().contains("coolingCircuit")) {
            EXPECT_LE(label->geometry().right(), plot.width());
            EXPECT_GE(label->width(), label->minimumSizeHint().width());
            EXPECT_GE(label->height(), label->heightForWidth(label->width()));
        }
    plot.grab().save(QStringLiteral(ANALOGON_PICTURES) + "/legend-long-name.png");
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
