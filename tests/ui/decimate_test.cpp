#include "ui/plot/decimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace analogon::ui {
namespace {

std::vector<double> ramp(int n) {
    std::vector<double> t(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) t[static_cast<std::size_t>(i)] = i;
    return t;
}

TEST(ValueExtent, IsThatOfAllSamplesOfAnyStretch) {
    std::mt19937 random(7);
    std::vector<double> values(1000);
    for (double& v : values) v = static_cast<double>(random() % 1000);
    for (std::size_t i = 0; i < values.size(); i += 37) values[i] = std::nan("");
    values[500] = INFINITY;
    const ui::ValueExtent extent(values);
    for (int trial = 0; trial < 2000; ++trial) {
        std::size_t begin = random() % 1001, end = random() % 1001;
        if (begin > end) std::swap(begin, end);
        ValueRange expected;
        for (std::size_t i = begin; i < end; ++i)
            if (std::isfinite(values[i])) expected.add(values[i]);
        const ValueRange range = extent.of(values, begin, end);
        ASSERT_EQ(range.low, expected.low) << begin << " to " << end;
        ASSERT_EQ(range.high, expected.high) << begin << " to " << end;
    }
    EXPECT_TRUE(ui::ValueExtent().whole().isEmpty());
}

TEST(ColumnRanges, LoseNoPeak) {
    const std::vector<double> time = ramp(1'000'000);
    std::vector<double> values(time.size(), 0.0);
    values[123'457] = 7;
    values[765'433] = -5;
    const auto columns = columnRanges(time, values, ui::ValueExtent(values), 0, 999'999, 800);
    ASSERT_EQ(columns.size(), 800u);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        EXPECT_EQ(columns[i].high, i == 98 ? 7 : 0) << i;
        EXPECT_EQ(columns[i].low, i == 612 ? -5 : 0) << i;
    }
}

TEST(ColumnRanges, FollowTheLineBetweenSamples) {
    const std::vector<double> time{0, 10, 20}, values{0, 10, 0};
    const auto columns = columnRanges(time, values, ui::ValueExtent(values), -10, 30, 8);
    ASSERT_EQ(columns.size(), 8u);
    EXPECT_TRUE(columns[0].isEmpty());
    EXPECT_TRUE(columns[7].isEmpty());
    EXPECT_EQ(columns[2].high, 5);
    EXPECT_EQ(columns[3].low, 5);
    EXPECT_EQ(columns[3].high, 10);
}

TEST(ColumnRanges, LeaveOutWhatWasNotMeasured) {
    const std::vector<double> time = ramp(5);
    const std::vector<double> values{1, std::nan(""), 3, INFINITY, 5};
    const auto columns = columnRanges(time, values, ui::ValueExtent(values), 0, 5, 5);
    EXPECT_TRUE(columns[1].isEmpty());
    EXPECT_EQ(columns[2].high, 3);
    EXPECT_TRUE(columnRanges({}, {}, ui::ValueExtent(), 0, 1, 3)[1].isEmpty());
    EXPECT_TRUE(columnRanges(time, values, ui::ValueExtent(values), 1, 1, 3)[1].isEmpty());
}

TEST(SamplesWithin, AreThoseOfTheRangeAndOneBeyondEachSide) {
    const std::vector<double> time = ramp(100);
    EXPECT_EQ(samplesWithin(time, 10.5, 12.5), std::pair(std::size_t{10}, std::size_t{14}));
    EXPECT_EQ(samplesWithin(time, -5, 200), std::pair(std::size_t{0}, std::size_t{100}));
}

TEST(NiceStep, IsOneTwoOrFiveTimesAPowerOfTen) {
    EXPECT_DOUBLE_EQ(niceStep(100, 10), 10);
    EXPECT_DOUBLE_EQ(niceStep(120, 10), 20);
    EXPECT_DOUBLE_EQ(niceStep(0.007, 4), 0.002);
    EXPECT_DOUBLE_EQ(niceStep(0, 4), 1);
    EXPECT_DOUBLE_EQ(niceStep(0.4 * 0.05, 1), 0.02) << "what is off by rounding alone is no larger range";
}

TEST(LabelStep, LeavesRoomForTwoLabelsAtLeast) {
    for (double half = 0.0101; half < 1000; half *= 1.07) {  // as a residual has it, around 0
        const double step = labelStep(-half, half, 2);
        EXPECT_GE(std::floor(half / step) - std::ceil(-half / step), 1) << half;
        EXPECT_GT(step, half / 5) << "no more labels than are needed: " << half;
    }
}

}  // namespace
}  // namespace analogon::ui
