#include "ui/plot/decimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace analogon::ui {
namespace {

std::vector<double> ramp(int n) {
    std::vector<double> t(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) t[static_cast<std::size_t>(i)] = i;
    return t;
}

TEST(Decimate, KeepsShortTracesAsTheyAre) {
    const std::vector<double> time = ramp(100);
    const auto points = decimate(time, time, 0, 99, 100);
    ASSERT_EQ(points.size(), 100);
    EXPECT_EQ(points[42], QPointF(42, 42));
}

TEST(Decimate, BoundsThePointsAndLosesNoPeak) {
    const std::vector<double> time = ramp(1'000'000);
    std::vector<double> values(time.size(), 0.0);
    values[123'457] = 7;
    values[765'433] = -5;
    const auto points = decimate(time, values, 0, 999'999, 800);
    EXPECT_LE(points.size(), 4 * 800 + 8);
    double high = 0, low = 0;
    for (const QPointF& p : points) {
        high = std::max(high, p.y());
        low = std::min(low, p.y());
    }
    EXPECT_EQ(high, 7);
    EXPECT_EQ(low, -5);
    EXPECT_EQ(points.front().x(), 0);
    EXPECT_EQ(points.back().x(), 999'999);
    for (qsizetype i = 1; i < points.size(); ++i) EXPECT_LE(points[i - 1].x(), points[i].x());
}

TEST(Decimate, ShowsOneSampleBeyondEachSideOfTheRange) {
    const std::vector<double> time = ramp(100);
    const auto points = decimate(time, time, 10.5, 12.5, 500);
    ASSERT_EQ(points.size(), 4);
    EXPECT_EQ(points.front().x(), 10);
    EXPECT_EQ(points.back().x(), 13);
}

TEST(Decimate, LeavesOutWhatWasNotMeasured) {
    const std::vector<double> time = ramp(5);
    const std::vector<double> values{1, std::nan(""), 3, INFINITY, 5};
    EXPECT_EQ(decimate(time, values, 0, 4, 100).size(), 3);
    EXPECT_TRUE(decimate({}, {}, 0, 1, 100).isEmpty());
    EXPECT_TRUE(decimate(time, values, 1, 1, 100).isEmpty());
}

TEST(NiceStep, IsOneTwoOrFiveTimesAPowerOfTen) {
    EXPECT_DOUBLE_EQ(niceStep(100, 10), 10);
    EXPECT_DOUBLE_EQ(niceStep(120, 10), 20);
    EXPECT_DOUBLE_EQ(niceStep(0.007, 4), 0.002);
    EXPECT_DOUBLE_EQ(niceStep(0, 4), 1);
}

}  // namespace
}  // namespace analogon::ui
