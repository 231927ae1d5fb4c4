#include "core/signal/range_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace analogon {
namespace {

TEST(RangeFigures, WeighTheTimeAndNotTheSamples) {
    const std::vector<double> time{0, 1, 1.1, 1.2, 3}, values{0, 2, 2, 2, 2};
    const RangeFigures whole = figuresWithin(time, values, -5, 5);
    EXPECT_NEAR(whole.mean, (1 + 2 * 2) / 3.0, 1e-12);
    EXPECT_NEAR(whole.rms, std::sqrt((4.0 / 3 + 8) / 3), 1e-12);
    EXPECT_EQ(whole.low, 0);
    EXPECT_EQ(whole.high, 2);
    EXPECT_NEAR(whole.length, 3, 1e-12);
}

TEST(RangeFigures, CutWithinASampleAndLeaveGapsOut) {
    const std::vector<double> time{0, 2, 4, 6}, values{0, 2, std::nan(""), 6};
    const RangeFigures part = figuresWithin(time, values, 0.5, 1.5);
    EXPECT_NEAR(part.mean, 1, 1e-12);
    EXPECT_NEAR(part.low, 0.5, 1e-12);
    EXPECT_NEAR(figuresWithin(time, values, 0, 6).length, 2, 1e-12);
    EXPECT_TRUE(std::isnan(figuresWithin(time, values, 3, 5).mean));
    EXPECT_TRUE(std::isnan(figuresWithin({}, {}, 0, 1).rms));
}

}  // namespace
}  // namespace analogon
