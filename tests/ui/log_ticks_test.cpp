#include "ui/signals/log_ticks.hpp"

#include <gtest/gtest.h>

#include <QLineSeries>
#include <QTest>
#include <cmath>

#include "ui/signals/chart_axis.hpp"
#include "ui/signals/figure_chart.hpp"
#include "ui/signals/log_axis.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {
namespace {

void expectTicks(const std::vector<double>& found, const std::vector<double>& wanted) {
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 1e-9 * wanted[i]);
}

TEST(LogTicks, AreOneTwoFiveWithinFewDecades) {
    expectTicks(logTicks(0.1, 10, 400, 40).labelled, {0.1, 0.2, 0.5, 1, 2, 5, 10});
    expectTicks(logTicks(0.1, 10, 400, 40).minor, {0.3, 0.4, 0.6, 0.7, 0.8, 0.9, 3, 4, 6, 7, 8, 9});
    expectTicks(logTicks(1, 10, 600, 40).labelled, {1, 2, 3, 5, 7, 10});
}

TEST(LogTicks, AreWholeDecadesOverMany) {
    expectTicks(logTicks(1e-3, 1e3, 400, 40).labelled, {1e-3, 1e-2, 1e-1, 1, 10, 100, 1000});
    const LogTicks many = logTicks(1e-30, 1e30, 400, 40);
    EXPECT_GE(many.labelled.size(), 4u);
    EXPECT_LE(many.labelled.size(), 10u);
}

TEST(LogTicks, AreEvenStepsWhereTheAxisCoversLess) {
    expectTicks(logTicks(2.9, 3.4, 400, 40).labelled, {2.9, 3, 3.1, 3.2, 3.3, 3.4});
    EXPECT_GE(logTicks(2, 4, 300, 40).labelled.size(), 3u);
}

/// Whatever its range, an axis that is long enough shows a scale.
TEST(LogTicks, AreNeverOneAloneAndNeverTooClose) {
    for (const double low : {1e-9, 3.3e-4, 0.7, 1.0, 5.1, 7777.0})
        for (const double ratio : {1.001, 1.1, 1.5, 2.0, 3.7, 9.0, 30.0, 99.0, 1e3, 1e7})
            for (const double length : {160.0, 300.0, 700.0}) {
                const LogTicks ticks = logTicks(low, low * ratio, length, 40);
                EXPECT_GE(ticks.labelled.size(), 2u) << low << " to " << low * ratio << " on " << length;
                for (std::size_t i = 1; i < ticks.labelled.size(); ++i)
                    EXPECT_GE(std::log(ticks.labelled[i] / ticks.labelled[i - 1]) / std::log(ratio) * length, 39.999);
            }
}

TEST(LogTicks, OfNoRangeAreNone) {
    for (const auto& [low, high] : {std::pair(0.0, 1.0), {-1.0, 1.0}, {2.0, 2.0}, {3.0, 1.0}, {1.0, INFINITY}})
        EXPECT_TRUE(logTicks(low, high, 300, 40).labelled.empty()) << low << ' ' << high;
}

TEST(LogAxis, HasLabelsThatDifferAndFollowTheSize) {
    QChartView view;
    view.chart()->legend()->hide();
    auto* axis = qobject_cast<LogAxis*>(makeAxis("k [N.m/A]", true, "%g", view.font(), view.palette()));
    ASSERT_TRUE(axis);
    view.chart()->addAxis(axis, Qt::AlignBottom);
    auto* series = new QLineSeries;
    series->append(LogAxis::at(0.2), 1);
    series->append(LogAxis::at(20), 2);
    view.chart()->addSeries(series);
    series->attachAxis(axis);
    axis->setValues(0.2, 20);
    axis->fit(500);
    EXPECT_EQ(axis->categoriesLabels(), (QStringList{"0.2", "0.3", "0.5", "0.7", "1", "2", "3", "5", "7", "10", "20"}));
    axis->fit(140);
    EXPECT_LT(axis->categoriesLabels().size(), 11);
    axis->setValues(3.00001, 3.00004);
    axis->fit(500);
    EXPECT_GE(axis->categoriesLabels().size(), 3);
    EXPECT_TRUE(axis->categoriesLabels().front().startsWith("3.00001"))
        << axis->categoriesLabels().front().toStdString();
    axis->setValues(0.2, 20);
    axis->fit(500);
    view.resize(600, 300);
    view.show();
    QTest::qWait(50);
    view.grab().save(QStringLiteral(ANALOGON_PICTURES) + "/log-axis.png");
}

}  // namespace
}  // namespace analogon::ui
