#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/core/simulate/class_run.hpp"

namespace analogon {
namespace {

using std::numbers::pi;
using test::runOf;
using test::Simulated;

/// How often two rows at all but the same time differ by more than `least`.
int jumpsOf(const Simulated& run, double least) {
    int count = 0;
    for (std::size_t k = 1; k < run.trajectory.time.size(); ++k) {
        const bool isClose = run.trajectory.time[k] - run.trajectory.time[k - 1] < 1e-9;
        count += isClose && std::fabs(run.trajectory.rows[k][0] - run.trajectory.rows[k - 1][0]) > least;
    }
    return count;
}

TEST(EventRows, AnAngleThatBeginsAnewIsToldFromBothSides) {
    const Simulated run = runOf(R"(
        model M Real phi(start = 0, fixed = true), y;
        equation der(phi) = 10 + 40*time; y = atan2(sin(phi), cos(phi));
        end M;)",
                                {"y"});
    ASSERT_RAN(run);
    EXPECT_EQ(jumpsOf(run, 6), 5) << "phi(1) = 30";
    double least = 0, most = 0;
    for (const auto& row : run.trajectory.rows) {
        least = std::min(least, row[0]);
        most = std::max(most, row[0]);
    }
    EXPECT_NEAR(most, pi, 1e-6);
    EXPECT_NEAR(least, -pi, 1e-6);
    const double first = (-10 + std::sqrt(100 + 80 * pi)) / 40;  // phi = pi
    EXPECT_GT(run.at(first - 1e-6, "y"), 3.13);
    EXPECT_LT(run.at(first + 1e-6, "y"), -3.141);
}

TEST(EventRows, WhatJumpsWithTheTimeAloneIsToldToo) {
    const Simulated run = runOf("model M Real y = noEvent(if time < 0.30517 then 1 else 2 + time); end M;", {"y"});
    ASSERT_RAN(run);
    EXPECT_EQ(jumpsOf(run, 0.5), 1);
    EXPECT_EQ(run.at(0.30517 - 1e-8, "y"), 1);
    EXPECT_NEAR(run.at(0.30517 + 1e-8, "y"), 2.30517, 1e-7);
}

TEST(EventRows, WhatIsSteepIsNoJump) {
    const Simulated run = runOf("model M Real y = tanh(1e5*(time - 0.50013)); end M;", {"y"});
    ASSERT_RAN(run);
    EXPECT_EQ(jumpsOf(run, 0.1), 0);
    EXPECT_LE(run.trajectory.time.size(), 2503u);
}

}  // namespace
}  // namespace analogon
