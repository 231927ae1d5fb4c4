#include "core/effect/start_value.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

TEST(StartValue, KeepsWhatARecordingWasToldWhenItIsFittedAndHeldAgain) {
    EstimationTask task;
    task.recordings.resize(1);
    task.recordings[0].starts = {{"T_start", 300, false}};
    const ToldStart ofAnother{0, 0, "T_start", 280};
    setFitted(task, ofAnother, true);
    EXPECT_TRUE(task.recordings[0].starts.at(0).isFitted);
    EXPECT_EQ(task.recordings[0].starts[0].value, 300);
    setFitted(task, ofAnother, false);
    ASSERT_EQ(task.recordings[0].starts.size(), 1u);
    EXPECT_FALSE(task.recordings[0].starts[0].isFitted);
    EXPECT_EQ(task.recordings[0].starts[0].value, 300);
}

TEST(StartValue, BeginsWhatNoRecordingWasToldWhereTheModelDoes) {
    EstimationTask task;
    task.recordings.resize(1);
    setFitted(task, {0, 0, "rotor.w.start", 2}, true);
    ASSERT_EQ(task.recordings[0].starts.size(), 1u);
    EXPECT_TRUE(task.recordings[0].starts[0].isFitted);
    EXPECT_EQ(task.recordings[0].starts[0].value, 2);
}

}  // namespace
}  // namespace analogon
