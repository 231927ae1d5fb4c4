#include "core/effect/search/indicate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

/// A body behind a sensor that lags, beside a draught that nobody recorded.
EstimationTask laggingBodyInADraught(double lag, double draught, unsigned seed = 3) {
    EstimationTask task = laggingBody(lag);
    addDraught(task, draught, seed);
    return task;
}

TEST(Indicate, AddsWhatPredictsBetterThoughStructureRemains) {
    WarmSearch of(laggingBodyInADraught(3, 0.1));
    ASSERT_FALSE(isNoise(of.base));
    Node node{of.base, {}};
    indicate(of.search, of.base, node, {});
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
        indicate(of.search, of.base, node, {});
        EXPECT_TRUE(node.steps.empty()) << node.null.variant.effects.front().effect.kind << ", seed " << seed;
    }
}

TEST(Indicate, LeavesAModelThatLeavesNoiseAsItIs) {
    WarmSearch of(laggingBody(0));
    ASSERT_TRUE(isNoise(of.base));
    Node node{of.base, {}};
    indicate(of.search, of.base, node, {});
    EXPECT_TRUE(node.steps.empty());
}

/// A lag and a dead time each do most of the work of the other.
TEST(Indicate, PrefersAStorageToTheDeadTimeOfAnEnd) {
    WarmSearch of(laggingBodyInADraught(3, 0.1));
    const Node end = nodeWith(of, "sensor.delay");
    ASSERT_EQ(end.steps.size(), 1u);
    Node node{of.base, {}};
    indicate(of.search, of.base, node, {end});
    ASSERT_EQ(node.steps.size(), 1u);
    EXPECT_EQ(node.null.variant.effects.front().effect.kind, "sensor.lag");
}

}  // namespace
}  // namespace analogon
