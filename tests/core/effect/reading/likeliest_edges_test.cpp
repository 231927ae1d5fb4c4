#include "core/effect/reading/likeliest_edges.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

constexpr int samples = 120;
constexpr double interval = 5;  // [s], a quarter of the body's time constant

/// The warm body, its heater switched at these parts of the intervals; by the exact solution.
EstimationTask switched(const std::vector<double>& parts) {
    EstimationTask task = warmBody({{"body.C", "J/K", 3.5, 1, 10}, {"joint.G", "W/K", 0.25, 0.05, 1}});
    Recording r = warmBodyRecording("run", samples);
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0, 0.02);
    double t = 0, temperature = 300, power = 0;
    const double rate = 0.2 / 4;
    const auto run = [&](double until) {
        const double end = 300 + power / 0.2;
        temperature = end + (temperature - end) * std::exp(-rate * (until - t));
        t = until;
    };
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(k * interval);
        run(k * interval);
        r.inputs(0, k) = power;
        r.outputs(0, k) = temperature + noise(random);
        if (k % 12 != 6) continue;
        run((k + parts[static_cast<std::size_t>(k / 12) % parts.size()]) * interval);
        power = power > 0 ? 0 : 2;
    }
    task.recordings = {r};
    return task;
}

std::vector<InputEdge> likeliest(const EstimationTask& task, bool areAlike, int& told) {
    FitOptions options;
    const Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, options, {});
    EXPECT_TRUE(null) << format(null.diagnostics());
    if (!null) return {};
    return likeliestEdges(*null, inputEdges(task), areAlike, options.simulation, 2, {}, told);
}

TEST(LikeliestEdges, AreWhereTheOutputsSayThatTheInputJumped) {
    const std::vector<double> parts{0.1, 0.9, 0.35, 0.7};
    int told = 0;
    const std::vector<InputEdge> edges = likeliest(switched(parts), false, told);
    ASSERT_EQ(edges.size(), 10u);
    EXPECT_EQ(told, 10);
    for (const InputEdge& e : edges)
        EXPECT_NEAR(e.part, parts[static_cast<std::size_t>(e.sample / 12) % parts.size()], 0.1) << e.sample;
}

TEST(LikeliestEdges, AreAtTheNextSampleWhereACommandIsHeld) {
    int told = 0;
    const std::vector<InputEdge> edges = likeliest(switched({1.0}), true, told);
    ASSERT_EQ(edges.size(), 10u);
    EXPECT_EQ(told, 1);
    for (const InputEdge& e : edges) EXPECT_GT(e.part, 0.95);
}

}  // namespace
}  // namespace analogon
