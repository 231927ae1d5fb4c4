#include "core/effect/reading/start_value.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace analogon {
namespace {

TEST(StartValue, KeepsWhatARecordingWasToldWhenItIsFittedAndHeldAgain) {
    EstimationTask task;
    task.recordings.edit().resize(1);
    task.recordings.edit()[0].starts = {{"T_start", 300, false}};
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
    task.recordings.edit().resize(1);
    setFitted(task, {0, 0, "rotor.w.start", 2}, true);
    ASSERT_EQ(task.recordings[0].starts.size(), 1u);
    EXPECT_TRUE(task.recordings[0].starts[0].isFitted);
    EXPECT_EQ(task.recordings[0].starts[0].value, 2);
}

TEST(StartValue, TellsABeginningFromASampleThatIsOff) {
    Eigen::VectorXd residual = Eigen::VectorXd::Zero(100);
    residual[0] = 9;
    EXPECT_FALSE(beginsElsewhere(residual, 1, 10));
    residual.head(3).setConstant(9);
    EXPECT_TRUE(beginsElsewhere(residual, 1, 10));
    EXPECT_TRUE(beginsElsewhere(-residual, 1, 10));
    EXPECT_FALSE(beginsElsewhere(residual, 4, 10)) << "within what is left elsewhere";
    EXPECT_FALSE(beginsElsewhere(residual, 1, 1000)) << "next to nothing of the range";
    residual[1] = -9;
    EXPECT_FALSE(beginsElsewhere(residual, 1, 10)) << "now above, now below";
}

TEST(StartValue, TellsABeginningByWhatWasMeasured) {
    Eigen::VectorXd residual = Eigen::VectorXd::Zero(100);
    residual.head(9).setConstant(9);
    for (const int k : {1, 2, 4}) residual[k] = std::nan("");
    EXPECT_TRUE(beginsElsewhere(residual, 1, 10));
    residual[0] = std::nan("");
    EXPECT_FALSE(beginsElsewhere(residual, 1, 10)) << "where the record begins nothing was measured";
}

}  // namespace
}  // namespace analogon
