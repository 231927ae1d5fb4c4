#include "core/effect/search/exchange.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/search/warm_nodes.hpp"

namespace analogon {
namespace {

TEST(Exchange, TakesTheRivalThatExplainsMore) {
    WarmSearch of(laggingBody(3));
    Node node = nodeThatChose(of, "sensor.delay");
    ASSERT_FALSE(node.steps.front().rivals.empty());
    EXPECT_TRUE(replace(of.search, node, 0, Rivals::Known));
    ASSERT_EQ(node.steps.size(), 1u);
    EXPECT_EQ(node.null.variant.effects.front().effect.kind, "sensor.lag");
    EXPECT_EQ(node.steps.front().alternatives.front().kind, "sensor.delay");
}

TEST(Exchange, LeavesANodeAloneThatHasTheBest) {
    WarmSearch of(laggingBody(3));
    Node node = nodeThatChose(of, "sensor.lag");
    const double before = node.null.sumOfSquares();
    EXPECT_FALSE(replace(of.search, node, 0, Rivals::Known));
    EXPECT_EQ(node.null.sumOfSquares(), before);
    EXPECT_EQ(node.null.variant.effects.front().effect.kind, "sensor.lag");
}

/// Equals that may each take the place of the other do so once.
TEST(Visited, KnowsWhereANodeHasStood) {
    WarmSearch of(laggingBody(3));
    const Node bare{of.base, {}}, lag = nodeThatChose(of, "sensor.lag"), delay = nodeThatChose(of, "sensor.delay");
    Visited visited(lag);
    EXPECT_FALSE(visited.add(lag));
    EXPECT_TRUE(visited.add(delay));
    EXPECT_FALSE(visited.add(delay));
    EXPECT_FALSE(visited.add(lag));
    EXPECT_TRUE(visited.add(bare));
}

Trial ofEvidence(double evidence) {
    Trial t;
    t.evidence = evidence;
    return t;
}

TEST(IsLike, IsWhatTheDataDoNotTellApart) {
    EXPECT_TRUE(isLike(ofEvidence(91), 100, 1));
    EXPECT_FALSE(isLike(ofEvidence(89), 100, 1));
    EXPECT_TRUE(isLike(ofEvidence(81), 100, 0.5)) << "of the samples half are independent";
    EXPECT_TRUE(isLike(ofEvidence(5.1), 10, 1));
    EXPECT_FALSE(isLike(ofEvidence(4.9), 10, 1)) << "half as much is no like";
}

TEST(Reconsider, GivesTheRivalsOfAllButTheNewestAnotherChance) {
    WarmSearch of(laggingBody(3, 2));
    Node newest = nodeThatChose(of, "sensor.delay");
    EXPECT_FALSE(reconsider(of.search, newest));
    WarmSearch alone(laggingBody(0, 2));
    Node node = together(of, newest, nodeThatChose(alone, "sensor.offset"));
    EXPECT_TRUE(reconsider(of.search, node));
    ASSERT_EQ(node.steps.size(), 2u);
    EXPECT_EQ(node.null.variant.effects.back().effect.kind, "sensor.lag") << "what takes a place stands at the end";
}

TEST(CompleteClasses, TriesWhatNoRoundHasTriedAtThePlaceOfAnEffect) {
    WarmSearch of(laggingBody(3));
    Node node = nodeThatChose(of, "sensor.delay");
    node.steps.front().alternatives.clear();
    node.steps.front().rivals.clear();
    completeClasses(of.search, node);
    ASSERT_EQ(node.steps.size(), 1u);
    EXPECT_EQ(node.null.variant.effects.front().effect.kind, "sensor.lag");
}

TEST(Unite, LeavesAloneWhatLacksNoPart) {
    WarmSearch of(laggingBody(3));
    WarmSearch alone(laggingBody(0, 2));
    Node node = together(of, nodeThatChose(of, "sensor.lag"), nodeThatChose(alone, "sensor.offset"));
    const double before = node.null.sumOfSquares();
    unite(of.search, node);
    EXPECT_EQ(node.steps.size(), 2u);
    EXPECT_EQ(node.null.sumOfSquares(), before);
}

TEST(IsExchanged, IsWhatExplainsMoreUnlessItIsTheLessLikelyAndHardlyTold) {
    EXPECT_TRUE(isExchanged({1.1}));
    EXPECT_FALSE(isExchanged({0.9})) << "exact twins differ by rounding alone";
    EXPECT_TRUE(isExchanged({9, 1, 1}));
    EXPECT_FALSE(isExchanged({9, 1, -1}));
    EXPECT_TRUE(isExchanged({11, 1, -1}));
    EXPECT_FALSE(isExchanged({11, 0.5, -1})) << "of the samples half are independent";
    RivalCase simpler{-5};
    simpler.isSimplerEqual = true;
    EXPECT_TRUE(isExchanged(simpler));
    RivalCase late{100, 1, -1};
    late.isAtTheEndOfMuch = true;
    EXPECT_FALSE(isExchanged(late));
}

}  // namespace
}  // namespace analogon
