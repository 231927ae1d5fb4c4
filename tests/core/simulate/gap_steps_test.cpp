#include "core/simulate/gap_steps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/simulate/pulses.hpp"
#include "tests/core/simulate/text_models.hpp"

namespace analogon {
namespace {

using test::differenceInRanges;
using test::pulses;

/// A pendulum that is driven and a body that warms up: the one turns on through a gap, the other forgets it.
const char* const pendulumText = R"(
model Pendulum
  input Real drive;
  output Real angle;
  output Real speed;
  output Real warmth;
  parameter Real b = 0.2;
  parameter Real g = 4;
  Real phi(start = 0, fixed = true);
  Real w(start = 0, fixed = true);
  Real T(start = 0, fixed = true);
equation
  der(phi) = w;
  der(w) = 10*drive - b*w - g*sin(phi);
  10*der(T) = drive^2*100 - T;
  angle = phi;
  speed = w;
  warmth = T;
end Pendulum;
)";

/// The inputs with a gap of so many seconds in the midst.
SampledInputs withGap(SampledInputs inputs, double gap) {
    for (std::size_t k = inputs.time.size() / 2; k < inputs.time.size(); ++k) inputs.time[k] += gap;
    return inputs;
}

TEST(Gaps, AreFarLongerThanMostIntervalsAndFew) {
    EXPECT_TRUE(Gaps(pulses(2000, 0.002)).intervals().empty());
    EXPECT_EQ(Gaps(withGap(pulses(2000, 0.002), 5)).intervals(), std::vector<int>{999});
    SampledInputs often = pulses(2000, 0.002);
    for (std::size_t k = 0; k < often.time.size(); ++k) often.time[k] += 5.0 * static_cast<double>(k / 10);
    EXPECT_TRUE(Gaps(often).intervals().empty()) << "that is how it was sampled";
}

TEST(Gaps, StepsGrowFromTheUsualLengthToThatOfTheGap) {
    const SampledInputs inputs = withGap(pulses(2000, 0.01), 5e6);
    const Gaps gaps(inputs);
    constexpr int count = 32;
    const Substeps coarse = gaps.implicitSteps(999, count), fine = gaps.implicitSteps(999, 2 * count);
    EXPECT_EQ(coarse.time(0), inputs.time[999]);
    EXPECT_EQ(coarse.time(count), inputs.time[1000]);
    EXPECT_LT(coarse.length(0), 0.01);
    for (int s = 0; s < count; ++s) {
        EXPECT_GT(coarse.length(s), 0);
        if (s > 0) {
            EXPECT_NEAR(coarse.length(s) / coarse.length(s - 1), std::pow(5e8, 1.0 / count), 1e-3);
        }
        EXPECT_NEAR(fine.time(2 * s), coarse.time(s), 1e-9 * coarse.time(s)) << "twice as many are the halves of each";
    }
    const Substeps elsewhere = gaps.implicitSteps(998, 4);
    EXPECT_EQ(elsewhere.time(1), inputs.time[998] + elsewhere.length(0));
}

TEST(GapSteps, CostWhatAGapCosts) {
    const SystemPtr system = test::compileText(pendulumText, "Pendulum", {"b", "g"});
    const SampledInputs whole = pulses(2000, 0.01);
    SimulationTask task;
    task.system = system.get();
    task.parameters = test::ownParameters(*system);
    task.inputs = &whole;
    const GridPlan plain = planGrid(task);
    const Trajectory reference = simulateGrid(task, plain);
    const Eigen::Index half = 1000;
    for (const double gap : {1.0, 5.0, 100.0, 5e6}) {
        const SampledInputs inputs = withGap(whole, gap);
        task.inputs = &inputs;
        const GridPlan plan = planGrid(task);
        ASSERT_TRUE(plan.steps) << gap;
        const auto sum = [](const GridPlan& p) { return p.work() * 1999; };
        EXPECT_LT(sum(plan), 2 * sum(plain) + 12 * kMostInGap) << gap;
        const Trajectory found = simulateGrid(task, plan);
        ASSERT_FALSE(found.failure.failed) << gap;
        EXPECT_LT(differenceInRanges(found.outputs.leftCols(half), reference.outputs.leftCols(half)), 2e-5) << gap;
        const GridPlan again = planGrid(task, {}, {}, &plan);
        EXPECT_LE(sum(again), sum(plan)) << gap;
        // what is not forgotten cannot be known behind it; what is must be as exact as ever
        if (gap > 100) continue;
        const Trajectory fine = simulateAdaptive(task);
        ASSERT_FALSE(fine.failure.failed) << gap;
        EXPECT_LT(differenceInRanges(found.outputs.row(2), fine.outputs.row(2)), 1e-4) << gap;
        if (gap < 50) {
            EXPECT_LT(differenceInRanges(found.outputs.row(1), fine.outputs.row(1)), 1e-3) << gap;
        }
    }
}

/// A gap of weeks, in which the steps grow, takes as many of them as one of minutes.
TEST(GapSteps, OfWeeksAreHardlyMoreThanThoseOfMinutes) {
    const SystemPtr system = test::compileText(pendulumText, "Pendulum", {"b", "g"});
    SimulationTask task;
    task.system = system.get();
    task.parameters = test::ownParameters(*system);
    const auto stepsAcross = [&](double gap) {
        const SampledInputs inputs = withGap(pulses(2000, 0.01), gap);
        task.inputs = &inputs;
        const GridPlan plan = planGrid(task);
        EXPECT_TRUE(plan.steps);
        return plan.steps ? std::abs((*plan.steps)[999]) : kMostInGap;
    };
    EXPECT_LE(stepsAcross(5e6), 4 * stepsAcross(300));
}

}  // namespace
}  // namespace analogon
