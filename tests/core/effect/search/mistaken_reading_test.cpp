#include "core/effect/search/mistaken_reading.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;

TEST(BesideMistake, SaysTheUnitThatTheNumbersLookLikeAndSearchesForNothing) {
    EstimationTask task = laggingBody(0);
    Recording& r = task.recordings.edit().front();
    r.outputs.array() -= 273.15;
    r.units = {{"P", "P", "W", "W"}, {"T", "T_body", "K", "K"}};
    WarmSearch of(task);
    MistakenUnit mistake;
    mistake.recordings = {0};
    mistake.columns = {"T_body"};
    mistake.channels = {"T"};
    mistake.unit = "K";
    mistake.likely = "degC";
    Outcome<NullModel> read =
        fitNull({readAsLikely(task, mistake), {}, {}}, {}, NoiseLevel::Estimate, of.search.fit, {});
    ASSERT_TRUE(read) << format(read.diagnostics());
    mistake.read = std::move(*read);
    Finding begun;
    begun.baseline.experiments.resize(1);
    const Finding finding = besideMistake(of.search, begun, of.base, mistake);
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    EXPECT_TRUE(finding.effects.empty());
    EXPECT_THAT(finding.end.notSearched.english(), HasSubstr("look like degC and not like the K that is told"));
    EXPECT_THAT(finding.end.notSearched.english(), HasSubstr("correct the header, or give the unit in the study"));
    ASSERT_FALSE(finding.warnings.empty());
    EXPECT_EQ(finding.warnings[0], finding.end.notSearched);
    mistake.asLikely = {"degF"};
    EXPECT_THAT(besideMistake(of.search, begun, of.base, mistake).end.notSearched.english(), HasSubstr("(or degF"));
}

TEST(BesideMistake, SaysWhichChannelsAreMeantOtherwiseAndWhereToCorrectThem) {
    EstimationTask task = laggingBody(0);
    task.recordings.edit().front().inputs *= -1;
    WarmSearch of(task);
    MistakenWiring sign{{0}, {"P"}, {}};
    Outcome<NullModel> read = fitNull({readAsMeant(task, sign), {}, {}}, {}, NoiseLevel::Estimate, of.search.fit, {});
    ASSERT_TRUE(read) << format(read.diagnostics());
    sign.read = std::move(*read);
    Finding begun;
    begun.baseline.experiments.resize(1);
    const std::string said = besideMistake(of.search, begun, of.base, {sign}).end.notSearched.english();
    EXPECT_THAT(said, HasSubstr("P seems to be recorded with the wrong sign: read so, the model as it is leaves"));
    EXPECT_THAT(said, HasSubstr("give the column \"scale\": -1 in the study"));
    const MistakenWiring exchanged{{0}, {"P", "T"}, sign.read};
    const Finding either = besideMistake(of.search, begun, of.base, {exchanged, sign});
    EXPECT_EQ(either.kind, FindingKind::Unexplained);
    EXPECT_TRUE(either.effects.empty());
    EXPECT_EQ(either.warnings.at(0), either.end.notSearched);
    EXPECT_THAT(either.end.notSearched.english(),
                HasSubstr("P and T seem to be exchanged, or P seems to be recorded with "
                          "the wrong sign (the data do not tell which)"));
}

}  // namespace
}  // namespace analogon
