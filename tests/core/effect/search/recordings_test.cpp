#include "core/effect/search/recordings.hpp"

#include <gtest/gtest.h>

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

TEST(AllowForRecordings, ChangesNothingWhereNoiseIsLeft) {
    WarmSearch of(laggingBody(0));
    EXPECT_FALSE(allowForRecordings(of.search, of.base, of.decided()));
    EXPECT_TRUE(of.search.readings.freedStarts.empty());
    EXPECT_TRUE(of.search.readings.noisyInputs.empty());
    EXPECT_TRUE(of.search.readings.drawn.clocks.empty());
    EXPECT_TRUE(of.search.readings.drawn.edges.empty());
}

}  // namespace
}  // namespace analogon
