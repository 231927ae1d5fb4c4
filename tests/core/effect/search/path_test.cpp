#include "core/effect/search/path.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/search/warm_nodes.hpp"

namespace analogon {
namespace {

TEST(Path, EndsWithTheEffectThatLeavesNoise) {
    WarmSearch of(laggingBody(3));
    Node path{of.base, {}};
    goOn(of.search, path, of.decided());
    ASSERT_EQ(path.steps.size(), 1u);
    EXPECT_EQ(path.null.variant.effects.front().effect.kind, "sensor.lag");
    EXPECT_NEAR(path.null.fit.estimates.back().value, 3, 0.2);
    EXPECT_TRUE(isNoise(path.null));
    ASSERT_TRUE(of.search.frontier.best.whole);
    EXPECT_EQ(of.search.frontier.best.whole->node.steps.size(), 1u);
    EXPECT_LT(of.search.frontier.bestError, 1);
    EXPECT_EQ(of.search.journal.path, 1);
}

TEST(Path, ThatMeetsEffectsFromWhichAnotherWentOnEnds) {
    WarmSearch of(laggingBody(3));
    Node first{of.base, {}}, again{of.base, {}};
    goOn(of.search, first, of.decided());
    goOn(of.search, again, of.decided());
    EXPECT_FALSE(first.meetsAnother);
    EXPECT_TRUE(again.meetsAnother);
}

TEST(Path, BeforeItsFirstChoiceKnowsWhatWasTried) {
    WarmSearch of(laggingBody(3));
    const Node bare = bareOf(of.search, of.base, of.decided(), Text("set aside"));
    EXPECT_TRUE(bare.steps.empty());
    EXPECT_FALSE(bare.candidates.empty());
    for (const CandidateResult& c : bare.candidates) EXPECT_NE(c.verdict, Verdict::Chosen);
}

}  // namespace
}  // namespace analogon
