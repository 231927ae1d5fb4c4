#include "core/effect/search/interrupted.hpp"

#include <gtest/gtest.h>

#include "core/effect/judge/judgement.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/search/path.hpp"
#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

/// A search that came to the sensor's lag and was stopped then.
void reachTheLag(WarmSearch& of) {
    const Outcome<ModelState> given =
        stateOf(of.base.variant, of.base.fit, of.search.fit.simulation, of.search.progress);
    ASSERT_TRUE(given);
    of.search.frontier.begun = Finding();
    of.search.frontier.begun->baseline = of.search.frontier.begun->final = *given;
    of.search.frontier.begun->kind = FindingKind::Interrupted;
    Node path{of.base, {}};
    goOn(of.search, path, of.decided());
    ASSERT_TRUE(of.search.frontier.best.whole);
}

TEST(FoundSoFar, IsTheBestNodeByNames) {
    WarmSearch of(laggingBody(3));
    reachTheLag(of);
    const Outcome<Finding> finding = foundSoFar(of.search, of.base);
    ASSERT_TRUE(finding);
    EXPECT_TRUE(finding->end.interrupted);
    EXPECT_EQ(finding->kind, FindingKind::Effect);
    ASSERT_EQ(finding->effects.size(), 1u);
    EXPECT_EQ(finding->effects.front().kind, "sensor.lag");
    EXPECT_LT(errorPercentOf(finding->final, Role::Fit), errorPercentOf(finding->baseline, Role::Fit));
}

/// Beside what nobody recorded, the last tests of an effect have not been made yet.
TEST(FoundSoFar, TellsWhatPredictsClearlyBetterAsAWhole) {
    EstimationTask task = laggingBody(3);
    addDraught(task, 0.03);
    WarmSearch of(task);
    reachTheLag(of);
    Whole& whole = *of.search.frontier.best.whole;
    ASSERT_FALSE(isNoise(whole.node.null));
    EXPECT_TRUE(whole.predicts);
    for (Step& s : whole.node.steps) s.acceptance.heldOut = 0;
    Outcome<Finding> finding = foundSoFar(of.search, of.base);
    ASSERT_TRUE(finding);
    ASSERT_FALSE(finding->effects.empty());
    EXPECT_EQ(finding->effects.front().confidence, Confidence::Indicated);
    whole.predicts = false;
    finding = foundSoFar(of.search, of.base);
    ASSERT_TRUE(finding);
    EXPECT_TRUE(finding->effects.empty());
}

/// What a round chose is told from then on, not only when it was weighed against all that might be in its place.
TEST(FoundSoFar, HasWhatARoundChoseBeforeItIsWeighed) {
    const Frontier* frontier = nullptr;
    std::vector<std::string> unweighed;
    DiscoverOptions options;
    options.keep = [&](const Finding& finding) {
        if (frontier->best.unweighed && !finding.effects.empty()) unweighed.push_back(finding.effects.front().kind);
    };
    WarmSearch of(laggingBody(3), options);
    frontier = &of.search.frontier;
    reachTheLag(of);
    EXPECT_EQ(unweighed, (std::vector<std::string>{"sensor.lag"}));
    EXPECT_FALSE(of.search.frontier.best.unweighed) << "it was weighed since";
}

/// What explains more, but is not clear, does not hide what was.
TEST(FoundSoFar, IsTheLastThatWasClear) {
    WarmSearch of(laggingBody(3));
    reachTheLag(of);
    Frontier& frontier = of.search.frontier;
    frontier.keepClear();
    frontier.best.whole->predicts = false;
    for (Step& s : frontier.best.whole->node.steps) s.acceptance.heldOut = 0;
    frontier.best.whole->node.null = of.base;  // leaves more than noise
    EXPECT_EQ(frontier.toTell(), &*frontier.best.clear);
    frontier.best.clear.reset();
    EXPECT_EQ(frontier.toTell(), nullptr);
}

TEST(FoundSoFar, IsToldWithTheRecordingsAsTheyWereReadThen) {
    WarmSearch of(laggingBody(3));
    reachTheLag(of);
    // another reading has been begun since, in which the inputs are redrawn
    of.search.readings.drawn.asRecorded = of.search.readings.full.task.recordings;
    of.search.readings.drawn.asRecorded.edit().front().outputs.array() += 1000;
    const Outcome<Finding> finding = foundSoFar(of.search, of.base);
    ASSERT_TRUE(finding);
    EXPECT_LT(errorPercentOf(finding->final, Role::Fit), 5);
    EXPECT_EQ(finding->final.experiments.front().outputs.front().measured,
              of.search.frontier.best.whole->node.state->experiments.front().outputs.front().measured);
}

/// Where the search works on fewer samples, all are told of, with the errors that were taken when the node was reached.
TEST(FoundSoFar, IsToldWithItsErrorsOnAllSamples) {
    WarmSearch of(laggingBody(3));
    of.search.readings.thinning = {3};
    of.search.readings.searched.task = thinned(of.search.readings.full.task, {3});
    of.base = *fitNull(of.search.readings.searched, {}, NoiseLevel::Estimate, of.search.fit, of.search.progress);
    const NullModel given =
        *fitNull(of.search.readings.full, {}, NoiseLevel::Estimate, of.search.fit, of.search.progress);
    reachTheLag(of);
    of.search.frontier.begun->baseline = *stateOf(given.variant, given.fit, of.search.fit.simulation, {});
    ASSERT_TRUE(of.search.frontier.best.whole->errorsOnAll);
    Whole reached = *of.search.frontier.best.whole;
    const Outcome<Finding> stopped = foundSoFar(of.search, of.base);
    ASSERT_TRUE(stopped);
    ASSERT_EQ(stopped->effects.size(), 1u);
    EXPECT_EQ(stopped->final.experiments.front().time.size(), 400u);

    of.search.frontier.best.whole = reached;
    fitBestOnAll(of.search, given, of.search.progress);
    const Whole& fitted = *of.search.frontier.best.whole;
    EXPECT_TRUE(fitted.isOnAll);
    EXPECT_EQ(fitted.node.null.channels.front().samples.size(), 400u);
    EXPECT_LE(errorPercentOf(*fitted.node.state, Role::Fit), errorPercentOf(stopped->final, Role::Fit) + 1e-9);

    of.search.frontier.best.whole = reached;
    of.search.frontier.best.whole->errorsOnAll = of.search.frontier.begun->baseline;  // no better
    const Outcome<Finding> worse = foundSoFar(of.search, of.base);
    ASSERT_TRUE(worse);
    EXPECT_TRUE(worse->effects.empty());
}

TEST(FoundSoFar, OfASearchThatReachedNothingIsTheModelAsGivenAndNoVerdict) {
    WarmSearch of(laggingBody(3));
    const Outcome<Finding> finding = foundSoFar(of.search, of.base);
    ASSERT_TRUE(finding);
    EXPECT_EQ(finding->kind, FindingKind::Interrupted);
    EXPECT_TRUE(finding->effects.empty());
}

TEST(FoundSoFar, OfNoFitAtAllIsAFault) {
    WarmSearch of(laggingBody(3));
    EXPECT_FALSE(foundSoFar(of.search, NullModel()));
}

}  // namespace
}  // namespace analogon
