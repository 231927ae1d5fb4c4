#include "core/study/left_out.hpp"

#include "core/study/run.hpp"
#include "study_fixture.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;

class LeftOutTest : public analogon::test::StudyTest {
protected:
    void SetUp() override {
        StudyTest::SetUp();
        putHeater();
    }
    /// The heater's recording with two more about it, which name a column that the file has not got.
    Study withFaulty() const {
        Study study = read();
        const StudyExperiment sound = study.experiments.front();
        StudyExperiment faulty = sound;
        faulty.outputs.at("i").column = "nowhere";
        faulty.name = "before";
        study.experiments.insert(study.experiments.begin(), faulty);
        faulty.name = "behind";
        study.experiments.push_back(faulty);
        return study;
    }
};

TEST_F(LeftOutTest, RecordingsWithAFaultAreToldWithTheirReason) {
    const std::vector<FaultyRecording> faulty = faultyRecordings(withFaulty());
    ASSERT_EQ(faulty.size(), 2u);
    EXPECT_EQ(faulty[0].index, 0u);
    EXPECT_EQ(faulty[0].name, "before");
    EXPECT_EQ(faulty[1].index, 2u);
    EXPECT_EQ(faulty[1].name, "behind");
    EXPECT_THAT(format(faulty[1].why), HasSubstr("nowhere"));
    EXPECT_TRUE(faultyRecordings(read()).empty());
}

TEST_F(LeftOutTest, TheSoundPartCanBeWorkedOnAndSaysWhatItDoesWithout) {
    const Study study = withFaulty();
    EXPECT_FALSE(estimationTask(study));
    const SoundPart part = soundPart(study);
    ASSERT_EQ(part.study.experiments.size(), 1u);
    EXPECT_EQ(part.study.experiments.front().name, "warm-up");
    EXPECT_TRUE(estimationTask(part.study));
    EXPECT_FALSE(hasError(part.remarks));
    EXPECT_THAT(format(part.remarks), HasSubstr("the recording 'behind' is left out: "));
}

TEST_F(LeftOutTest, NothingIsLeftOutWhereNoRecordingToFitWouldRemain) {
    Study study = withFaulty();
    study.experiments[1].role = Role::Validate;
    EXPECT_TRUE(soundPart(study).leftOut.empty());
    EXPECT_EQ(soundPart(study).study.experiments.size(), 3u);
}

TEST_F(LeftOutTest, NothingIsLeftOutForAFaultOfTheModel) {
    Study study = withFaulty();
    study.className = "Nothing";
    EXPECT_TRUE(soundPart(study).leftOut.empty());
}

TEST_F(LeftOutTest, WhatWasLeftOutComesBackToItsPlace) {
    const Study study = withFaulty();
    const SoundPart part = soundPart(study);
    Outcome<RunResult> result = runFit(part.study, {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    const Study completed = withLeftOut(std::move(result->completed), study, part.leftOut);
    ASSERT_EQ(completed.experiments.size(), 3u);
    EXPECT_EQ(completed.experiments[0].name, "before");
    EXPECT_EQ(completed.experiments[1].name, "warm-up");
    EXPECT_EQ(completed.experiments[2].name, "behind");
    EXPECT_EQ(completed.experiments[2].outputs.at("i").column, "nowhere");
}

}  // namespace
}  // namespace analogon
