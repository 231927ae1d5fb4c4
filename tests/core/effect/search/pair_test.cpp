#include "core/effect/search/pair.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/effect/hand_made.hpp"
#include "tests/core/effect/search/warm_nodes.hpp"

namespace analogon {
namespace {

constexpr int samples = 100;

/// Trials at places of their own, each along an axis of the residual, which has so much along them.
Round roundOf(const std::vector<double>& explained) {
    Round round;
    for (std::size_t i = 0; i < explained.size(); ++i) {
        Trial t;
        t.ok = true;
        t.evidence = explained[i];
        t.screened.candidate.effect.className = "effect " + std::to_string(i);
        t.screened.candidate.place.at = "place " + std::to_string(i);
        t.screened.probes.resize(1);
        t.screened.probes[0].plain.directions =
            Eigen::MatrixXd(Eigen::VectorXd::Unit(samples, static_cast<Eigen::Index>(i)));
        t.screened.probes[0].plain.along = Eigen::VectorXd::Constant(1, std::sqrt(explained[i]));
        round.trials.push_back(t);
    }
    return round;
}

NullModel leavingAlong(const std::vector<double>& explained) {
    Eigen::VectorXd residual = Eigen::VectorXd::Zero(samples);
    for (std::size_t i = 0; i < explained.size(); ++i) residual[static_cast<Eigen::Index>(i)] = std::sqrt(explained[i]);
    return modelThatLeaves(residual, Eigen::MatrixXd(samples, 0));
}

std::vector<std::size_t> beginnings(const std::vector<double>& explained, std::size_t most,
                                    const std::vector<Candidate>& taken = {}) {
    return pairBeginnings(leavingAlong(explained), roundOf(explained), most, taken);
}

TEST(PairBeginnings, AreTheStrongerOfThePairsThatExplainNearlyAsMuchAsTheBest) {
    EXPECT_EQ(beginnings({50, 50, 46, 46}, 9), (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(beginnings({50, 50, 48, 48}, 9), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(beginnings({50, 50, 48, 48}, 1), std::vector<std::size_t>{0});
}

TEST(PairBeginnings, AreNoneThatWereTakenOrAreEquations) {
    const std::vector<double> explained{50, 40, 30};
    const Candidate first = roundOf(explained).candidate(0);
    EXPECT_EQ(beginnings(explained, 9, {first}), std::vector<std::size_t>{1});
    Round round = roundOf(explained);
    round.trials[0].screened.candidate.effect.proposal = "y = u";
    EXPECT_EQ(pairBeginnings(leavingAlong(explained), round, 9, {}), std::vector<std::size_t>{1});
}

TEST(ChosenTogether, AreNoneWhereNothingFailedByItsLittleEvidenceAlone) {
    WarmSearch of(laggingBody(3));
    Round round = of.decided();
    ASSERT_TRUE(round.refused.tooFaint.empty());
    EXPECT_FALSE(chosenTogether(of.search, {of.base, {}}, round));
}

TEST(WithPairMembers, BeginsAnewWithoutAChoiceAndKnowsWhyTheRestIsWeaker) {
    WarmSearch of(laggingBody(3));
    const Round first = of.decided();
    const Round wider = withPairMembers(of.search, of.base, first);
    EXPECT_FALSE(wider.chosen);
    EXPECT_TRUE(wider.refused.why.empty());
    EXPECT_GE(wider.trials.size(), first.trials.size());
    EXPECT_FALSE(wider.refused.behind.empty());
}

/// A dead time of the heater and a lag of the sensor, taken for the lag of the one and the dead time of the other.
TEST(CrossOver, TurnsTwoFaultsRoundThatWereTakenForEachOther) {
    EstimationTask task = laggingBody(3);
    Recording& r = task.recordings.edit().front();
    for (Eigen::Index k = 0; k + 8 < r.inputs.cols(); ++k) r.inputs(0, k) = r.inputs(0, k + 8);
    WarmSearch of(task);
    const Outcome<std::vector<EffectClass>> all = effectCatalogue(task.library);
    for (const EffectClass& e : *all)
        if (e.kind == "actuator.lag" || e.kind == "actuator.delay") of.search.catalogue.push_back(e);
    Node node = together(of, nodeThatChose(of, "actuator.lag"), nodeThatChose(of, "sensor.delay"));
    const double before = node.null.sumOfSquares();
    crossOver(of.search, node);
    ASSERT_EQ(node.null.variant.effects.size(), 2u);
    EXPECT_EQ(node.null.variant.effects[0].effect.kind, "actuator.delay");
    EXPECT_EQ(node.null.variant.effects[1].effect.kind, "sensor.lag");
    EXPECT_LT(node.null.sumOfSquares(), before);
}

TEST(WorthPairing, AreTheSixtyNamesThatExplainMost) {
    std::vector<Screened> screened(100);
    for (std::size_t i = 0; i < screened.size(); ++i) {
        Probe probe;
        probe.plain.explained = static_cast<double>(i);
        probe.plain.visible = 1;
        screened[i].probes = {probe};
    }
    screened[99].candidate.effect.proposal = "y = u";
    screened[98].failure = Text("cannot be wired");
    const std::vector<const Screened*> worth = worthPairing(screened);
    ASSERT_EQ(worth.size(), 60u);
    EXPECT_EQ(worth.front(), &screened[97]);
    EXPECT_EQ(worth.back(), &screened[38]);
}

}  // namespace
}  // namespace analogon
