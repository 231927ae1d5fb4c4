#include "core/effect/change.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

constexpr int samples = 400, change = 200;

/// A body whose joint to the surroundings conducts otherwise from the change on, in small steps of the exact solution.
NullModel changed(double before, double after) {
    FitParameter g;
    g.name = "joint.G";
    g.unit = "W/K";
    g.start = 0.2;
    EstimationTask task = warmBody({g});
    Recording r = warmBodyRecording("bench", samples);
    double x = 0;
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(k);
        r.inputs(0, k) = 3 + 2 * std::sin(0.1 * k);
        r.outputs(0, k) = 300 + x + 0.05 * ((k * 7919) % 13 - 6) / 6.0;
        constexpr int pieces = 200;
        for (int i = 0; i < pieces; ++i) {
            const double t = k + (i + 0.5) / pieces;
            const double p = 3 + 2 * ((1 - (t - k)) * std::sin(0.1 * k) + (t - k) * std::sin(0.1 * (k + 1)));
            const double G = k < change ? before : after, decay = std::exp(-G / 4 / pieces);
            x = x * decay + p / G * (1 - decay);
        }
    }
    task.recordings = {r};
    Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, {}, {});
    EXPECT_TRUE(null) << format(null.diagnostics());
    return null ? std::move(*null) : NullModel{};
}

TEST(Change, IsFoundWithItsMomentAndItsSize) {
    const std::optional<Change> found = bestChange(changed(0.2, 0.3), {}, 1, {});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->parameter, "joint.G");
    EXPECT_NEAR(found->before, 0.2, 0.002);
    EXPECT_NEAR(found->after, 0.3, 0.002);
    EXPECT_NEAR(found->time, change, 2);
}

TEST(Change, NeverTakesAQuantityOfOneSignToTheOther) {
    // heat that comes out of the surroundings is no change of a conductance
    const std::optional<Change> found = bestChange(changed(0.2, -0.002), {}, 1, {});
    ASSERT_TRUE(found);
    EXPECT_GT(found->after, 0);
}

}  // namespace
}  // namespace analogon
