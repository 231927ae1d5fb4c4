#include "core/effect/search/recordings.hpp"

#include <gtest/gtest.h>

#include "core/effect/search/beside_recordings.hpp"
#include "core/effect/search/first_fit.hpp"
#include "core/effect/search/redraw.hpp"
#include "core/effect/search/starts.hpp"
#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

TEST(LeaveOutFaults, TakesASpikeOutOfAllThatIsFitted) {
    EstimationTask task = laggingBody(0);
    task.recordings.edit().front().outputs(0, 120) += 3;
    WarmSearch of(task);
    EXPECT_TRUE(leaveOutFaults(of.search, of.base));
    ASSERT_EQ(of.search.readings.faults.size(), 1u);
    EXPECT_TRUE(std::isnan(of.search.readings.full.task.recordings.front().outputs(0, 120)));
    EXPECT_TRUE(std::isnan(of.search.readings.searched.task.recordings.front().outputs(0, 120)));
    WarmSearch sound(laggingBody(0));
    EXPECT_FALSE(leaveOutFaults(sound.search, sound.base));
}

TEST(FindBeginning, TellsWhereARecordBeginsThatWasCutOutOfALongerOne) {
    WarmSearch of(laggingBody(0, 0, 320));
    const std::optional<Begun> begun = findBeginning(of.search, of.base, Against::Noise, 0);
    ASSERT_TRUE(begun);
    ASSERT_EQ(begun->starts.size(), 1u);
    EXPECT_LT(begun->sumOfSquares, 0.1 * of.base.sumOfSquares());
    WarmSearch sound(laggingBody(0));
    EXPECT_FALSE(findBeginning(sound.search, sound.base, Against::Noise, 0));
}

TEST(FreeStarts, AreHeldAgainWhereTheyExplainNothing) {
    WarmSearch of(laggingBody(0));
    ToldStart start;
    start.parameter = "body.T_start";
    start.value = 300;
    freeStarts(of.search, {start});
    EXPECT_EQ(of.search.readings.freedStarts.size(), 1u);
    Outcome<NullModel> freed =
        fitNull(of.search.readings.searched, of.base.noise, NoiseLevel::Keep, of.search.fit, of.search.progress);
    ASSERT_TRUE(freed);
    EXPECT_EQ(freed->parameterCount(), of.base.parameterCount() + 1);
    holdUnneededStarts(of.search, *freed);
    EXPECT_TRUE(of.search.readings.freedStarts.empty());
    EXPECT_EQ(freed->parameterCount(), of.base.parameterCount());
}

TEST(AllowForRecordings, ChangesNothingWhereNoiseIsLeft) {
    WarmSearch of(laggingBody(0));
    EXPECT_FALSE(allowForRecordings(of.search, of.base, of.decided()));
    EXPECT_TRUE(of.search.readings.freedStarts.empty());
    EXPECT_TRUE(of.search.readings.noisyInputs.empty());
    EXPECT_TRUE(of.search.readings.drawn.clocks.empty());
    EXPECT_TRUE(of.search.readings.drawn.edges.empty());
}

TEST(Redraw, IsNotAskedWhereTheRecordingsAreTakenAsGiven) {
    WarmSearch of(laggingBody(0));
    EXPECT_TRUE(canPlaceEdges(of.search, of.base));
    of.search.readings.takesAsGiven = true;
    EXPECT_FALSE(canPlaceEdges(of.search, of.base));
    EXPECT_FALSE(findClocks(of.search, of.base, 0, 0));
}

TEST(BestPath, OfARecordThatBeginsElsewhereFreesItsStart) {
    WarmSearch of(laggingBody(0, 0, 320));
    const Outcome<Node> path = bestPath(of.search, of.base);
    ASSERT_TRUE(path);
    EXPECT_TRUE(path->steps.empty());
    EXPECT_EQ(of.search.readings.freedStarts.size(), 1u);
    EXPECT_TRUE(isNoise(path->null));
}

TEST(FirstFit, IsIntegratedNoMoreExactlyThanTheNoiseAsksFor) {
    WarmSearch of(laggingBody(0));
    const double asked = 1e-9, found = toleranceBeside(of.base, asked);
    EXPECT_GT(found, asked);
    EXPECT_LE(found, 3e-5);
    EXPECT_EQ(beginningAnywhere({}).otherStarts, 128);
}

TEST(FirstFit, BeginsNowhereElseWhereNoiseIsLeft) {
    WarmSearch of(laggingBody(0));
    const double before = of.base.sumOfSquares();
    EXPECT_FALSE(beginElsewhere(of.search, of.base));
    EXPECT_EQ(of.base.sumOfSquares(), before);
}

}  // namespace
}  // namespace analogon
