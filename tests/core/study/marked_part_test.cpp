#include "core/study/marked_part.hpp"

#include "study_fixture.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;

class MarkedPartTest : public analogon::test::StudyTest {
protected:
    void SetUp() override {
        StudyTest::SetUp();
        putHeater();
    }
    /// The heater's recording three times, of which the last is left out.
    Study withThree() const {
        Study study = read();
        for (const char* name : {"second", "unused"}) {
            study.experiments.push_back(study.experiments.front());
            study.experiments.back().name = name;
        }
        study.experiments.back().isUsed = false;
        return study;
    }
};

TEST_F(MarkedPartTest, UsesTheMarkedRecordingsAndTakesNoneInThatWasLeftOut) {
    const Study part = markedPart(withThree(), {"second", "unused"});
    ASSERT_EQ(part.experiments.size(), 3u);
    EXPECT_FALSE(part.experiments[0].isUsed);
    EXPECT_TRUE(part.experiments[1].isUsed);
    EXPECT_FALSE(part.experiments[2].isUsed);
}

TEST_F(MarkedPartTest, ARunLeavesTheStudyAsItIsAndSaysWhatItLookedAt) {
    const Study whole = withThree();
    const Study part = markedPart(whole, {"second"});
    Outcome<RunResult> run = runFit(part, {});
    ASSERT_TRUE(run) << format(run.diagnostics());
    const RunResult result = forWhole(std::move(*run), whole, part);
    ASSERT_EQ(result.finding.final.experiments.size(), 1u);
    EXPECT_EQ(result.finding.final.experiments.front().name, "second");
    for (std::size_t i = 0; i < whole.experiments.size(); ++i)
        EXPECT_EQ(result.completed.experiments[i].isUsed, whole.experiments[i].isUsed) << i;
    ASSERT_FALSE(result.finding.warnings.empty());
    EXPECT_EQ(result.finding.warnings.front().english(), "only 1 of 2 recordings were looked at: second");
}

TEST_F(MarkedPartTest, ARunOnAllSaysNothing) {
    const Study whole = withThree();
    Outcome<RunResult> run = runFit(whole, {});
    ASSERT_TRUE(run);
    const std::size_t before = run->finding.warnings.size();
    EXPECT_EQ(forWhole(std::move(*run), whole, markedPart(whole, {"warm-up", "second"})).finding.warnings.size(),
              before);
}

}  // namespace
}  // namespace analogon
