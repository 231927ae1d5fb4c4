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
    EXPECT_THAT(finding.notSearched.english(), HasSubstr("look like degC and not like the K that is told"));
    EXPECT_THAT(finding.notSearched.english(), HasSubstr("correct the header, or give the unit in the study"));
    ASSERT_FALSE(finding.warnings.empty());
    EXPECT_EQ(finding.warnings[0], finding.notSearched);
    mistake.asLikely = {"degF"};
    EXPECT_THAT(besideMistake(of.search, begun, of.base, mistake).notSearched.english(), HasSubstr("(or degF"));
}

}  // namespace
}  // namespace analogon
