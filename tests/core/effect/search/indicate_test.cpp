#include "core/effect/search/indicate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/effect/search/verdicts.hpp"
#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

/// A body behind a sensor that lags, beside a draught that nobody recorded.
EstimationTask laggingBodyInADraught(double lag, double draught, unsigned seed = 3) {
    EstimationTask task = laggingBody(lag);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Recording& r = task.recordings.edit().front();
    double course = 0;
    for (Eigen::Index k = 0; k < r.outputs.cols(); ++k) {
        course = 0.98 * course + draught * normal(random);
        r.outputs(0, k) += course;
    }
    return task;
}

TEST(Indicate, AddsWhatPredictsBetterThoughStructureRemains) {
    WarmSearch of(laggingBodyInADraught(3, 0.1));
    ASSERT_FALSE(isNoise(of.base));
    Node node{of.base, {}};
    indicate(of.search, node, {});
    ASSERT_EQ(node.steps.size(), 1u);
    EXPECT_EQ(node.null.variant.effects.front().effect.kind, "sensor.lag");
    ASSERT_TRUE(node.steps.front().prediction);
    const Prediction& p = *node.steps.front().prediction;
    EXPECT_GT(p.removed(), 0.2);
    EXPECT_EQ(p.blocks, 5);
    EXPECT_EQ(p.betterIn, 5);
    EXPECT_GT(node.steps.front().errorWithout, 0);
    EXPECT_LT(node.null.sumOfSquares(), of.base.sumOfSquares());
}

TEST(Indicate, AddsNothingThatADisturbanceFeigns) {
    for (const unsigned seed : {11, 12, 13}) {
        WarmSearch of(laggingBodyInADraught(0, 0.1, seed));
        Node node{of.base, {}};
        indicate(of.search, node, {});
        EXPECT_TRUE(node.steps.empty()) << node.null.variant.effects.front().effect.kind << ", seed " << seed;
    }
}

TEST(Indicate, LeavesAModelThatLeavesNoiseAsItIs) {
    WarmSearch of(laggingBody(0));
    ASSERT_TRUE(isNoise(of.base));
    Node node{of.base, {}};
    indicate(of.search, node, {});
    EXPECT_TRUE(node.steps.empty());
}

/// A lag and a dead time each do most of the work of the other.
TEST(Indicate, PrefersAStorageToTheDeadTimeOfAnEnd) {
    WarmSearch of(laggingBodyInADraught(3, 0.1));
    Node end{of.base, {}};
    Round round = tryAll(of.search, of.base);
    for (std::size_t i = 0; i < round.trials.size() && !round.chosen; ++i)
        if (round.candidate(i).effect.kind == "sensor.delay" && round.trials[i].ok) round.chosen = i;
    ASSERT_TRUE(round.chosen);
    end.steps.push_back(stepOf(of.search, of.base, round));
    Outcome<NullModel> next =
        fitNull(end.steps.back().winner.variant, of.base.noise, NoiseLevel::Keep, of.search.fit, of.search.progress);
    ASSERT_TRUE(next) << format(next.diagnostics());
    end.null = std::move(*next);
    Node node{of.base, {}};
    indicate(of.search, node, {end});
    ASSERT_EQ(node.steps.size(), 1u);
    EXPECT_EQ(node.null.variant.effects.front().effect.kind, "sensor.lag");
}

}  // namespace
}  // namespace analogon
