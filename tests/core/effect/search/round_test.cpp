#include "core/effect/search/round.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/hand_made.hpp"
#include "tests/core/effect/search/flow_search.hpp"
#include "tests/core/effect/search/warm_nodes.hpp"

namespace analogon {
namespace {

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

/// A trial beside a model that leaves noise: its evidence and the direction of its trace.
Trial trial(const std::string& kind, double evidence, const Eigen::VectorXd& trace) {
    Trial t;
    t.ok = true;
    t.evidence = evidence;
    t.screened.candidate.effect.kind = t.screened.candidate.effect.className = kind;
    t.screened.candidate.place.at = kind;
    t.screened.probes.resize(1);
    t.screened.probes[0].plain.directions = Eigen::MatrixXd(trace.normalized());
    t.screened.probes[0].strengthIn = Eigen::VectorXd::Ones(1);
    t.variant.effects.resize(1);
    t.fit.optimum.residuals = whiteNoise(trace.size());
    return t;
}

constexpr int samples = 1000;

TEST(Equivalents, AreWhatTheDataDoNotTellApart) {
    const NullModel null = modelThatLeaves(whiteNoise(samples), Eigen::MatrixXd(samples, 0));
    const Eigen::VectorXd own = sineWave(samples, 2), other = sineWave(samples, 5);
    const double weight = independentShare(null, trial("a", 1, own).fit);
    const auto isMember = [&](double evidence, double of, const Eigen::VectorXd& trace) {
        return equivalents(null, {trial("a", of, own), trial("b", evidence, trace)}, 0).size() == 2;
    };
    EXPECT_TRUE(isMember(100 - 9.9 / weight, 100, other));
    EXPECT_FALSE(isMember(100 - 10.1 / weight, 100, other));
    EXPECT_TRUE(isMember(100 - 29.9 / weight, 100, own)) << "twins to three times as much";
    EXPECT_FALSE(isMember(100 - 30.1 / weight, 100, own));
    EXPECT_FALSE(isMember(4.9, 10, own)) << "less than half explains something else";
}

TEST(Equivalents, AreNoEquationsAndNothingThatCouldNotBeFitted) {
    const NullModel null = modelThatLeaves(whiteNoise(samples), Eigen::MatrixXd(samples, 0));
    const Eigen::VectorXd own = sineWave(samples, 2);
    std::vector<Trial> trials{trial("a", 100, own), trial("b", 100, own), trial("c", 100, own)};
    trials[1].screened.candidate.effect.proposal = "y = u";
    trials[2].ok = false;
    EXPECT_EQ(equivalents(null, trials, 0), std::vector<std::size_t>{0});
}

/// What has no name is not known so exactly that a fiftieth of what it explains would tell two places apart.
TEST(EqualPlaces, AreThoseOfOneEquationWithinWhatItsFormMayBeWrongBy) {
    const WarmSearch of(laggingBody(0));
    const NullModel null = modelThatLeaves(whiteNoise(samples), Eigen::MatrixXd(samples, 0));
    const Eigen::VectorXd own = sineWave(samples, 2);
    const double weight = independentShare(null, trial("law", 1, own).fit);
    const auto count = [&](const std::string& kind, double less) {
        std::vector<Trial> trials{trial("law", 1000, own), trial(kind, 1000 - less / weight, own)};
        return equalPlaces(of.search, null, trials, 0).size();
    };
    EXPECT_EQ(count("law", 19.9), 2u);
    EXPECT_EQ(count("law", 20.1), 1u);
    EXPECT_EQ(count("another", 0), 1u);
}

TEST(PassOver, SetsTheChoiceAsideAndSaysWhy) {
    Round round;
    round.chosen = 2;
    round.members = {2, 3};
    round.passOver(Text("too little"));
    EXPECT_FALSE(round.chosen);
    EXPECT_TRUE(round.members.empty());
    EXPECT_EQ(round.refused.why.at(2), "too little");
    round.passOver(Text("again"));
    EXPECT_EQ(round.refused.why.size(), 1u);
}

TEST(Round, AsksForMoreThanNoiseBringsOnceInAHundredSearches) {
    WarmSearch of(laggingBody(0));
    const Round round = tryAll(of.search, of.base);
    std::vector<SharedColumns> directions;
    for (const Screened& s : round.screened)
        if (!s.probes.empty() && !s.isAbsorbed()) directions.push_back(s.probes.front().plain.directions);
    ASSERT_FALSE(directions.empty());
    const double logRows = std::log(static_cast<double>(of.base.fit.optimum.residuals.size()));
    int above = 0;
    for (unsigned seed = 1; seed <= 4000; ++seed) {
        const Eigen::VectorXd noise = whiteNoise(of.base.fit.optimum.residuals.size(), seed);
        double largest = -1e9;
        for (const SharedColumns& d : directions)
            largest = std::max(largest, (d->transpose().cast<double>() * noise).squaredNorm() -
                                            static_cast<double>(d->cols()) * logRows);
        above += largest > round.threshold;
    }
    EXPECT_NEAR(above / 4000.0, 0.01, 0.005);
}

TEST(LeastPromise, CountsTheSamplesThatSpeakForThemselves) {
    Screened screened;
    Probe probe;
    probe.plain.explained = 200;
    probe.plain.visible = probe.whitened.visible = 1;
    probe.whitened.explained = 3;
    screened.probes = {probe};
    EXPECT_DOUBLE_EQ((LeastPromise{4, 0.01}.of(screened)), 3) << "noise with a memory repeats itself";
    EXPECT_DOUBLE_EQ((LeastPromise{4, 0.1}.of(screened)), 20);
    EXPECT_FALSE((LeastPromise{4, 0.01}.isMetBy(screened)));
    EXPECT_TRUE((LeastPromise{4, 0.1}.isMetBy(screened)));
}

TEST(LeastPromise, IsWhatTheRoundAsksForBesideNoiseWithAMemory) {
    WarmSearch white(laggingBody(0)), coloured(laggingBodyBesideAFlow(0, 1, 12));
    ASSERT_TRUE(isNoise(white.base));
    EXPECT_EQ(leastPromise(white.base, 4).score, equivalenceMargin);
    EXPECT_EQ(leastPromise(white.base, 4).share, 1);
    ASSERT_FALSE(isNoise(coloured.base));
    EXPECT_EQ(leastPromise(coloured.base, 4).score, 4);
    EXPECT_LT(leastPromise(coloured.base, 4).share, 0.5);
    for (const Screened& s : screenAll(coloured.search, coloured.base))
        for (const Trial& t : tryAll(coloured.search, coloured.base).trials)
            if (t.screened.candidate.effect.className == s.candidate.effect.className) {
                EXPECT_TRUE(leastPromise(coloured.base, 4).isMetBy(s)) << s.candidate.effect.kind;
            }
}

}  // namespace
}  // namespace analogon
