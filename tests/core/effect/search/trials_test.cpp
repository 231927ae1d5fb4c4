#include "core/effect/search/trials.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

std::vector<std::string> kindsOf(const std::vector<Candidate>& candidates) {
    std::vector<std::string> kinds;
    for (const Candidate& c : candidates) kinds.push_back(c.effect.kind);
    std::sort(kinds.begin(), kinds.end());
    return kinds;
}

std::vector<std::string> candidateKinds(const WarmSearch& of) {
    const Outcome<std::vector<Candidate>> candidates = candidatesIn(of.search, of.base.variant);
    EXPECT_TRUE(candidates);
    return candidates ? kindsOf(*candidates) : std::vector<std::string>();
}

const Screened& screenedOf(const std::vector<Screened>& all, const std::string& kind) {
    return *std::find_if(all.begin(), all.end(), [&](const Screened& s) { return s.candidate.effect.kind == kind; });
}

TEST(CandidatesIn, AreOfTheChosenPlacesWhereTheUserChose) {
    EXPECT_EQ(candidateKinds(WarmSearch(laggingBody(0))),
              (std::vector<std::string>{"sensor.delay", "sensor.lag", "sensor.offset"}));
    DiscoverOptions options;
    options.choices = {{"Analogon.Effects.Sensor.Lag", "output T"}, {"Analogon.Effects.Sensor.Delay", "output w"}};
    EXPECT_EQ(candidateKinds(WarmSearch(laggingBody(0), options)), std::vector<std::string>{"sensor.lag"});
}

/// Behind a source whose flow follows a command, a storage is the lag of that command: its twin is not tried.
TEST(CandidatesIn, AreBehindASourceInTheLastPassAlone) {
    WarmSearch of(laggingBody(0));
    of.search.catalogue.clear();
    const Outcome<std::vector<EffectClass>> all = effectCatalogue(of.base.variant.task.library);
    for (const EffectClass& e : *all)
        if (e.placement.behindSource) of.search.catalogue.push_back(e);
    ASSERT_FALSE(of.search.catalogue.empty());
    EXPECT_TRUE(candidateKinds(of).empty());
    of.search.frontier.isIndicating = true;
    EXPECT_FALSE(candidateKinds(of).empty());
}

TEST(ScreenAll, RefusesTheEquationThatIsTheTwinOfANameOfTheWrongSign) {
    WarmSearch of(laggingBody(0, -2));
    EffectClass named;
    for (EffectClass& e : of.search.catalogue)
        if (e.kind == "sensor.offset") named = e;
    named.parameters.oneSided = true;
    EffectClass equation = named;
    equation.kind = "proposal.sensor.offset";
    equation.proposal = "y = u + b";
    equation.parameters.oneSided = false;
    of.search.catalogue = {equation};
    EXPECT_GT(screenAll(of.search, of.base).front().score(), 100) << "alone it is not";
    of.search.catalogue = {named, equation};
    const std::vector<Screened> screened = screenAll(of.search, of.base);
    ASSERT_EQ(screened.size(), 2u);
    EXPECT_TRUE(screenedOf(screened, "sensor.offset").isWrongSign());
    EXPECT_TRUE(screenedOf(screened, "proposal.sensor.offset").isWrongSign());
}

TEST(TryThese, RefitsInTheOrderOfTheChosenAndCountsTheWork) {
    WarmSearch of(laggingBody(3));
    const std::vector<Screened> screened = screenAll(of.search, of.base);
    const Screened &lag = screenedOf(screened, "sensor.lag"), &offset = screenedOf(screened, "sensor.offset");
    const double before = of.search.work.done;
    const std::vector<Trial> trials = tryThese(of.search, of.base, {&offset, &lag}, 12, 1);
    ASSERT_EQ(trials.size(), 2u);
    EXPECT_EQ(trials[0].screened.candidate.effect.kind, "sensor.offset");
    EXPECT_EQ(trials[1].screened.candidate.effect.kind, "sensor.lag");
    EXPECT_LT(trials[1].sumOfSquares(), trials[0].sumOfSquares());
    EXPECT_GT(of.search.work.done, before);
}

TEST(TryBest, RanksByEvidenceAndTriesNothingBelowTheLeastScore) {
    WarmSearch of(laggingBody(3));
    const std::vector<Screened> screened = screenAll(of.search, of.base);
    const std::vector<Trial> trials = tryBest(of.search, of.base, screened, {});
    ASSERT_FALSE(trials.empty());
    EXPECT_EQ(trials.front().screened.candidate.effect.kind, "sensor.lag");
    for (std::size_t i = 1; i < trials.size(); ++i) EXPECT_LE(trials[i].evidence, trials[i - 1].evidence);
    EXPECT_TRUE(tryBest(of.search, of.base, screened, {1e9}).empty());
}

/// A trial that ended so far behind what another one has reached.
TEST(RetryNear, BeginsOnceMoreWhereATrialMayHaveBeenFittedFromFartherAway) {
    WarmSearch of(laggingBody(3));
    const std::vector<Screened> screened = screenAll(of.search, of.base);
    const std::vector<Trial> fitted = tryThese(of.search, of.base, {&screenedOf(screened, "sensor.lag")}, 24, 1);
    const double best = fitted.front().sumOfSquares(), decrease = of.base.sumOfSquares() - best;
    const auto isRetried = [&](double behind) {
        std::vector<Trial> trials = fitted;
        trials.front().fit.optimum.residuals *= std::sqrt((best + behind) / best);
        retryNear(of.search, of.base, fitted.front().variant.values, best, trials);
        return trials.front().sumOfSquares() < best + 0.5 * behind;
    };
    EXPECT_FALSE(isRetried(9)) << "as good";
    EXPECT_TRUE(isRetried(11));
    EXPECT_TRUE(isRetried(0.19 * decrease));
    EXPECT_FALSE(isRetried(0.21 * decrease)) << "far behind";
    EXPECT_TRUE(isRetried(1.1 * decrease)) << "it promised as much, and lost its way";
}

TEST(ContinueFit, GoesOnFourTimesWhileAFitTellsMore) {
    const auto stepsOf = [](double gain, FitStatus status) {
        Trial trial;
        trial.ok = true;
        trial.fit.status = status;
        trial.fit.optimum.residuals = Eigen::VectorXd::Constant(1, 100);
        int steps = 0;
        continueFit(trial, [&](Trial& t) {
            ++steps;
            t.fit.optimum.residuals[0] = std::sqrt(t.sumOfSquares() - gain);
        });
        return steps;
    };
    EXPECT_EQ(stepsOf(20, FitStatus::IterationLimit), 4);
    EXPECT_EQ(stepsOf(9, FitStatus::IterationLimit), 1) << "the data do not tell so little apart";
    EXPECT_EQ(stepsOf(20, FitStatus::Converged), 0);
}

/// The whole catalogue, where the best of what is tried first leaves much.
TEST(TryBest, SeesWhoDeservesATrialInFiveIterations) {
    DiscoverOptions options;
    options.refitted = 1;
    EstimationTask task = laggingBody(3);
    addDraught(task, 0.5);
    WarmSearch of(task, options);
    of.search.catalogue = *effectCatalogue(task.library);
    const std::vector<Trial> trials = tryBest(of.search, of.base, screenAll(of.search, of.base), {});
    const auto ended = [&](int iterations) {
        return std::count_if(trials.begin(), trials.end(),
                             [&](const Trial& t) { return t.fit.iterations == iterations; });
    };
    EXPECT_GT(ended(5), 3);
    for (int more = 6; more < 12; ++more) EXPECT_LE(ended(more), 1) << more;
}

}  // namespace
}  // namespace analogon
