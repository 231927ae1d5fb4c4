#include "core/signal/few_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace analogon {
namespace {

TEST(FewPoints, AreTheCornersOfALine) {
    std::vector<double> time(1001), values(1001);
    for (std::size_t i = 0; i < time.size(); ++i) {
        time[i] = 0.01 * static_cast<double>(i);
        values[i] = time[i] < 3 ? 2 * time[i] : time[i] < 7 ? 6 : 6 - (time[i] - 7);
    }
    EXPECT_EQ(fewPoints(time, values, 100, 1e-6), (std::vector<std::size_t>{0, 300, 700, 1000}));
}

TEST(FewPoints, AreNoMoreThanAskedForAndThoseThatMatterMost) {
    std::vector<double> time(10001), values(10001);
    for (std::size_t i = 0; i < time.size(); ++i) {
        time[i] = 1e-3 * static_cast<double>(i);
        values[i] = std::sin(3 * time[i]);
    }
    const std::vector<std::size_t> points = fewPoints(time, values, 60, 0);
    ASSERT_EQ(points.size(), 60u);
    double worst = 0;
    for (std::size_t k = 1; k < points.size(); ++k)
        for (std::size_t i = points[k - 1]; i < points[k]; ++i) {
            const double part = (time[i] - time[points[k - 1]]) / (time[points[k]] - time[points[k - 1]]);
            const double line = values[points[k - 1]] + part * (values[points[k]] - values[points[k - 1]]);
            worst = std::max(worst, std::abs(line - values[i]));
        }
    EXPECT_LT(worst, 0.07);
    EXPECT_LT(fewPoints(time, values, 10000, 0.01).size(), 70u) << "within 1 % of the range";
}

TEST(FewPoints, LeaveOutWhatHasNoValueOrNoTimeOfItsOwn) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> time{0, 1, 1, 2, 3, 4}, values{none, 5, 6, none, 1, 7};
    EXPECT_EQ(fewPoints(time, values, 100, 0), (std::vector<std::size_t>{1, 4, 5}));
    EXPECT_TRUE(fewPoints({}, {}, 100, 0).empty());
    const std::vector<double> flat(6, 2.5);
    EXPECT_EQ(fewPoints(time, flat, 100, 0), (std::vector<std::size_t>{0, 5}));
}

}  // namespace
}  // namespace analogon
