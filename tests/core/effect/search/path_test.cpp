#include "core/effect/search/path.hpp"

#include <gtest/gtest.h>

#include "core/effect/model/model_state.hpp"
#include "core/effect/search/exchange.hpp"
#include "core/effect/search/prune.hpp"
#include "core/effect/search/verdicts.hpp"
#include "core/effect/search/without.hpp"
#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

/// A node that has chosen the trial of a kind, whatever the round would have.
Node chosen(WarmSearch& of, const std::string& kind) {
    Round round = tryAll(of.search, of.base);
    for (std::size_t i = 0; i < round.trials.size(); ++i)
        if (round.candidate(i).effect.kind == kind) round.chosen = i;
    Node node{of.base, {}};
    EXPECT_TRUE(round.chosen) << kind << " was not refitted";
    if (!round.chosen) return node;
    node.steps.push_back(stepOf(of.search, of.base, round));
    noteAll(of.search, node, round);
    Outcome<NullModel> with = fitNull(node.steps.front().winner.variant, of.base.noise, NoiseLevel::Estimate,
                                      of.search.fit, of.search.progress);
    EXPECT_TRUE(with);
    node.null = std::move(*with);
    return node;
}

TEST(Round, ChoosesTheSensorsLagAndSaysWhyNothingElse) {
    WarmSearch of(laggingBody(3));
    const Round round = of.decided();
    ASSERT_TRUE(round.chosen);
    EXPECT_EQ(WarmSearch::kindOf(round), "sensor.lag");
    EXPECT_TRUE(round.acceptance.accepted());
    Node node{of.base, {}};
    noteAll(of.search, node, round);
    ASSERT_GE(node.candidates.size(), 3u);
    for (const CandidateResult& c : node.candidates)
        EXPECT_EQ(c.reason.empty(), c.verdict == Verdict::Chosen) << c.kind << ": " << c.reason.english();
    EXPECT_EQ(of.search.frontier.noted.size(), node.candidates.size());
}

TEST(Round, ChoosesNothingWhereNoiseIsLeft) {
    WarmSearch of(laggingBody(0));
    EXPECT_TRUE(isNoise(of.base));
    EXPECT_FALSE(of.decided().chosen);
}

TEST(Path, EndsWithTheEffectThatLeavesNoise) {
    WarmSearch of(laggingBody(3));
    Node path{of.base, {}};
    goOn(of.search, path, of.decided());
    ASSERT_EQ(path.steps.size(), 1u);
    EXPECT_EQ(path.null.variant.effects.front().effect.kind, "sensor.lag");
    EXPECT_NEAR(path.null.fit.estimates.back().value, 3, 0.2);
    EXPECT_TRUE(isNoise(path.null));
    ASSERT_TRUE(of.search.frontier.whole);
    EXPECT_EQ(of.search.frontier.whole->node.steps.size(), 1u);
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

TEST(Without, IsTheModelAsItWas) {
    WarmSearch of(laggingBody(3));
    Node node = chosen(of, "sensor.lag");
    const std::optional<NullModel> rest = without(of.search, node.null, 0);
    ASSERT_TRUE(rest);
    EXPECT_TRUE(rest->variant.effects.empty());
    EXPECT_NEAR(sumInUnitsOf(*rest, of.base), rest->sumOfSquares(), 1e-3 * rest->sumOfSquares());
    EXPECT_TRUE(takeOut(of.search, node, 0, Text("a test asks for it")));
    EXPECT_TRUE(node.steps.empty());
    EXPECT_TRUE(node.null.variant.effects.empty());
    for (const CandidateResult& c : node.candidates)
        if (c.kind == "sensor.lag") {
            EXPECT_EQ(c.verdict, Verdict::NotSignificant);
            EXPECT_NE(c.reason.english().find("a test asks for it"), std::string::npos);
        }
}

TEST(Exchange, TakesTheRivalThatExplainsMore) {
    WarmSearch of(laggingBody(3));
    Node node = chosen(of, "sensor.delay");
    ASSERT_FALSE(node.steps.front().rivals.empty());
    EXPECT_TRUE(replace(of.search, node, 0, Rivals::Known));
    ASSERT_EQ(node.steps.size(), 1u);
    EXPECT_EQ(node.null.variant.effects.front().effect.kind, "sensor.lag");
    EXPECT_EQ(node.steps.front().alternatives.front().kind, "sensor.delay");
}

/// Equals that may each take the place of the other do so once.
TEST(Visited, KnowsWhereANodeHasStood) {
    WarmSearch of(laggingBody(3));
    const Node bare{of.base, {}}, lag = chosen(of, "sensor.lag"), delay = chosen(of, "sensor.delay");
    Visited visited(lag);
    EXPECT_FALSE(visited.add(lag));
    EXPECT_TRUE(visited.add(delay));
    EXPECT_FALSE(visited.add(delay));
    EXPECT_FALSE(visited.add(lag));
    EXPECT_TRUE(visited.add(bare));
}

TEST(Exchange, LeavesANodeAloneThatHasTheBest) {
    WarmSearch of(laggingBody(3));
    Node node = chosen(of, "sensor.lag");
    const double before = node.null.sumOfSquares();
    EXPECT_FALSE(replace(of.search, node, 0, Rivals::Known));
    EXPECT_EQ(node.null.sumOfSquares(), before);
    EXPECT_EQ(node.null.variant.effects.front().effect.kind, "sensor.lag");
}

TEST(Prune, KeepsWhatIsMissedAndTakesOutWhatIsNot) {
    WarmSearch of(laggingBody(3));
    Node node = chosen(of, "sensor.lag");
    WarmSearch alone(laggingBody(0, 2));
    Node other = chosen(alone, "sensor.offset");
    std::vector<PlacedEffect> both = node.null.variant.effects;
    both.push_back(other.null.variant.effects.front());
    std::optional<NullModel> with = refittedWith(of.search, node.null, both);
    ASSERT_TRUE(with);
    node.null = std::move(*with);
    node.steps.push_back(other.steps.front());
    removeUnneeded(of.search, node, 0);
    ASSERT_EQ(node.steps.size(), 1u);
    EXPECT_EQ(node.null.variant.effects.front().effect.kind, "sensor.lag");
    EXPECT_GT(node.steps.front().chi2Decrease, 100);
    EXPECT_GT(node.steps.front().errorWithout, of.search.frontier.bestError);
}

TEST(Prune, NeverTakesTheLastOfSoMany) {
    WarmSearch of(laggingBody(0)), other(laggingBody(3));
    Node node = chosen(other, "sensor.lag");
    std::optional<NullModel> with = refittedWith(of.search, of.base, node.null.variant.effects);
    ASSERT_TRUE(with);
    node.null = std::move(*with);
    Node kept = node;
    removeUnneeded(of.search, kept, 1);
    EXPECT_EQ(kept.steps.size(), 1u);
    removeUnneeded(of.search, node, 0);
    EXPECT_TRUE(node.steps.empty()) << "noise alone needs no lag";
}

}  // namespace
}  // namespace analogon
