#include "core/effect/search/context.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

TEST(WorkLimit, EndsASearchThatHasDoneEnough) {
    const std::stop_source outside;
    WorkLimit work(10, outside.get_token());
    work.add(8);
    EXPECT_FALSE(work.token().stop_requested());
    work.add(3);
    EXPECT_TRUE(work.token().stop_requested());
    EXPECT_EQ(work.done, 11);
}

TEST(WorkLimit, OfNoneEndsWhenItIsAskedToFromOutside) {
    std::stop_source outside;
    WorkLimit work(0, outside.get_token());
    work.add(1e300);
    EXPECT_FALSE(work.token().stop_requested());
    outside.request_stop();
    EXPECT_TRUE(work.token().stop_requested());
}

TEST(WorkLimit, IsAMinuteOrThreeHundredFitsTimesThePatience) {
    EXPECT_EQ(workAllowed(1, 1e4), 1e9) << "about a minute, however little the fit took";
    EXPECT_EQ(workAllowed(1, 1e8), 3e10);
    EXPECT_EQ(workAllowed(10, 1e8), 3e11);
    EXPECT_EQ(workAllowed(0, 1e8), 0) << "none";
}

TEST(SearchContext, LimitsASimulationInStepsInsteadOfSeconds) {
    DiscoverOptions options;
    options.fit.simulation.wallClockLimit = 3;
    const SearchContext search(laggingBody(0), options, {});
    EXPECT_EQ(search.fit.simulation.stepLimit, 5'000'000);
    EXPECT_TRUE(std::isinf(search.fit.simulation.wallClockLimit)) << "the same on a busy machine";
}

TEST(Stay, IsOfTheSameEffectsAtTheSameOptimum) {
    const Stay here{{"a@x"}, 2.0, 1};
    EXPECT_TRUE(here.isLike({{"a@x"}, 2.0001, 2}));
    EXPECT_FALSE(here.isLike({{"a@x"}, 2.1, 2})) << "another optimum";
    EXPECT_FALSE(here.isLike({{"a@x", "b@x"}, 2.0, 2}));
}

TEST(SearchContext, WorksOnMeansOfALongRecordAndReportsAllOfIt) {
    EstimationTask task = laggingBody(0);
    Recording& r = task.recordings.edit().front();
    const Eigen::Index samples = 13'000;
    r.time.resize(static_cast<std::size_t>(samples));
    for (std::size_t k = 0; k < r.time.size(); ++k) r.time[k] = 0.01 * static_cast<double>(k);
    r.inputs = Eigen::MatrixXd::Constant(1, samples, 8);
    r.outputs = Eigen::MatrixXd::Constant(1, samples, 300);
    const SearchContext search(task, {}, {});
    EXPECT_EQ(search.readings.thinning.factor, 3);
    EXPECT_EQ(search.readings.full.task.recordings.front().time.size(), 13'000u);
    EXPECT_LE(search.readings.searched.task.recordings.front().time.size(), 6'000u);
}

TEST(Readings, AreTakenAsGivenWithAllThatWasRedrawn) {
    const EstimationTask task = laggingBody(0);
    Readings readings;
    readings.searched.task = readings.full.task = task;
    readings.drawn.stamped = readings.drawn.asRecorded = task.recordings;
    readings.drawn.clocks = {{"P", 0.5}};
    setClocks(readings.searched.task.recordings.edit(), task.recordings, readings.drawn.clocks);
    EXPECT_NE(readings.searched.task.recordings.front().inputs, task.recordings.front().inputs);
    readings.takeRecordingsAsGiven();
    EXPECT_EQ(readings.searched.task.recordings.front().inputs, task.recordings.front().inputs);
    EXPECT_TRUE(readings.drawn.clocks.empty());
    EXPECT_TRUE(readings.drawn.asRecorded.empty());
}

}  // namespace
}  // namespace analogon
