#include "core/effect/search/flow_ranking.hpp"

#include <gtest/gtest.h>

#include "core/effect/search/contenders.hpp"
#include "tests/core/effect/search/flow_search.hpp"

namespace analogon {
namespace {

class FlowRanking : public testing::Test, protected TriedOnce {
protected:
    FlowRanking() : TriedOnce(laggingBodyBesideAFlow(0.6, 1, 3)) {}
};

TEST_F(FlowRanking, PutsTheEffectThatIsThereFirst) {
    const std::vector<LikelyTrial> ranked = rankedBesideFlow(of.search, of.base, round.trials);
    ASSERT_FALSE(ranked.empty());
    EXPECT_EQ(ranked.front().trial, trialOf("sensor.lag"));
    EXPECT_GT(ranked.front().evidence, 30);
    for (std::size_t i = 1; i < ranked.size(); ++i) EXPECT_LE(ranked[i].evidence, ranked[i - 1].evidence);
}

TEST_F(FlowRanking, TellsARivalThatIsClearlyLikelier) {
    const std::size_t lag = trialOf("sensor.lag"), offset = trialOf("sensor.offset");
    EXPECT_EQ(clearlyLikelier(of.search, of.base, round.trials, {lag, offset}, offset), lag);
    EXPECT_FALSE(clearlyLikelier(of.search, of.base, round.trials, {lag, offset}, lag));
    EXPECT_FALSE(clearlyLikelier(of.search, of.base, round.trials, {offset}, offset)) << "it has no rival";
}

TEST_F(FlowRanking, DecidesBetweenThoseThatPredictNearlyAsWell) {
    const auto contender = [&](const std::string& kind, double left) {
        Contender c{trialOf(kind), {}};
        c.prediction.errorPercentBefore = 10;
        c.prediction.errorPercentAfter = left;
        return c;
    };
    chooseAmong(of.search, of.base, {contender("sensor.lag", 1.5), contender("sensor.offset", 1)}, First::Simplest,
                round);
    EXPECT_EQ(*round.chosen, trialOf("sensor.lag"));
    EXPECT_EQ(round.members.size(), 2u);
    chooseAmong(of.search, of.base, {contender("sensor.lag", 1.5), contender("sensor.offset", 1)}, First::Best, round);
    EXPECT_EQ(*round.chosen, trialOf("sensor.offset")) << "once the likelier one has failed";
    chooseAmong(of.search, of.base, {contender("sensor.lag", 9), contender("sensor.offset", 1)}, First::Simplest,
                round);
    EXPECT_EQ(*round.chosen, trialOf("sensor.offset")) << "what predicts far less is no rival";
    round.trials[trialOf("sensor.lag")].screened.candidate.effect.placement.signalSide = "input";
    chooseAmong(of.search, of.base, {contender("sensor.lag", 1.5), contender("sensor.offset", 1)}, First::Simplest,
                round);
    EXPECT_EQ(*round.chosen, trialOf("sensor.offset")) << "nor is what is met less often";
}

}  // namespace
}  // namespace analogon
