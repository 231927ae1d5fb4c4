#include "core/study/variable_values.hpp"

#include <gtest/gtest.h>

#include "core/study/run.hpp"
#include "study_fixture.hpp"

namespace analogon {
namespace {

class Variables : public test::StudyTest {
protected:
    void SetUp() override {
        StudyTest::SetUp();
        putHeater();
    }
};

TEST_F(Variables, AreGivenAtEverySampleWhetherOutputsOrNot) {
    const Study study = read();
    const auto result = variableValues(study, "warm-up", {"T", "u"});
    ASSERT_TRUE(result) << format(result.diagnostics());
    ASSERT_EQ(result->values.size(), 2u);
    ASSERT_GE(result->time.size(), 2u);
    EXPECT_EQ(result->values[0].size(), result->time.size());
    const auto simulated = runSimulate(study, {});
    ASSERT_TRUE(simulated);
    EXPECT_EQ(result->time, simulated->finding.final.experiments.front().time);
}

TEST_F(Variables, ThatDoNotExistAreNamed) {
    const auto result = variableValues(read(), "warm-up", {"nothing.here"});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.diagnostics()[0].message, "the model has no variable nothing.here");
    EXPECT_FALSE(variableValues(read(), "of another study", {"T"}));
}

}  // namespace
}  // namespace analogon
