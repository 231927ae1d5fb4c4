#include "core/effect/search/contenders.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

Contender contender(std::size_t trial, double left) {
    Contender c{trial, {}};
    c.prediction.errorPercentBefore = 10;
    c.prediction.errorPercentAfter = left;
    return c;
}

class Contenders : public testing::Test, protected TriedOnce {
protected:
    Contenders() : TriedOnce(laggingBody(3)) {}
};

TEST_F(Contenders, AreThoseThatMakeTheModelPredictBetter) {
    const std::vector<Contender> all = contendersOf(of.search, of.base, round.trials);
    ASSERT_FALSE(all.empty());
    const bool hasLag =
        std::any_of(all.begin(), all.end(), [&](const Contender& c) { return c.trial == trialOf("sensor.lag"); });
    EXPECT_TRUE(hasLag);
    for (const Contender& c : all) EXPECT_GT(c.prediction.removed(), 0.2);
}

TEST_F(Contenders, GoOnToTheBestWhereTheSimplestHasFailed) {
    // among what predicts nearly as well an offset is likelier than a lag
    const std::vector<Contender> two{contender(trialOf("sensor.lag"), 1), contender(trialOf("sensor.offset"), 1.5)};
    chooseAmong(of.search, of.base, two, First::Simplest, round);
    const std::size_t simplest = *round.chosen;
    const std::size_t other = simplest == two[0].trial ? two[1].trial : two[0].trial;
    chooseAmong(of.search, of.base, {contender(simplest, 1.5), contender(other, 1)}, First::Best, round);
    EXPECT_EQ(*round.chosen, other);
    EXPECT_EQ(round.members.size(), 2u) << "both are its class";
}

TEST_F(Contenders, FallWithTheirLike) {
    round.chosen = trialOf("sensor.offset");
    std::vector<Contender> all{contender(*round.chosen, 2), contender(trialOf("sensor.lag"), 2.01),
                               contender(trialOf("sensor.delay"), 2.5)};
    passOver(round, all);
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].trial, trialOf("sensor.delay"));
}

TEST(MayBeIndicated, IsANameOfNoMoreThanTwoParameters) {
    PlacedEffect placed;
    placed.freed.resize(2);
    EXPECT_TRUE(mayBeIndicated(placed));
    placed.effect.proposal = "y = u";
    EXPECT_FALSE(mayBeIndicated(placed));
    placed.effect.proposal.clear();
    placed.freed.resize(3);
    EXPECT_FALSE(mayBeIndicated(placed)) << "it follows any course by its shape";
}

}  // namespace
}  // namespace analogon
