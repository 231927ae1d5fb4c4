#include "core/effect/search/reading_remarks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/effect/model/model_state.hpp"
#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(RecordingRemarks, AreNoneOfSoundRecordings) {
    const WarmSearch of(laggingBody(0));
    EXPECT_THAT(recordingRemarks(of.search, of.base), IsEmpty());
}

TEST(RecordingRemarks, SayWhatWasAllowedForInTheRecordings) {
    WarmSearch of(laggingBody(0));
    Readings& readings = of.search.readings;
    readings.noisyInputs.resize(1);
    readings.noisyInputs[0].name = "P";
    readings.noisyInputs[0].deviation = 0.25;
    readings.drawn.clocks = {{"P", 0.125}};
    readings.drawn.errorsOnTime = {1.5, -1};
    ToldStart start;
    start.parameter = "body.T_start";
    readings.checkStarts = {start};
    EXPECT_THAT(recordingRemarks(of.search, of.base),
                ElementsAre(HasSubstr("the input 'P' of 'warm-up' is recorded with noise (0.25 rms)"),
                            HasSubstr("the input 'P' is stamped 0.125 s late (0.5 samples"),
                            HasSubstr("with its inputs on time the model has an error of 1.50 %"),
                            HasSubstr("'warm-up' does not begin where the model was told")));
}

TEST(RecordingRemarks, TellAFreedStartWithItsValue) {
    WarmSearch of(laggingBody(0));
    ToldStart start;
    start.parameter = "body.T_start";
    start.value = 300;
    of.search.readings.freedStarts = {start};
    EXPECT_THAT(recordingRemarks(of.search, of.base), IsEmpty()) << "it is not fitted in this model";
    FitEstimate e;
    e.name = "body.T_start";
    e.experiment = 0;
    e.value = 320;
    e.standardError = 0.1;
    e.unit = "K";
    of.base.fit.estimates.push_back(e);
    EXPECT_THAT(recordingRemarks(of.search, of.base), ElementsAre(HasSubstr("body.T_start is 320")));
}

TEST(ReportAsRecorded, TellsTheErrorsWithTheRecordingsAsTheyAre) {
    WarmSearch of(laggingBody(0));
    const auto state = stateOf(of.base.variant, of.base.fit, {}, {});
    ASSERT_TRUE(state);
    ModelState as = *state;
    reportAsRecorded(of.search, of.base, as);
    EXPECT_FALSE(of.search.readings.drawn.errorsOnTime) << "nothing was drawn otherwise";
    of.search.readings.drawn.asRecorded = of.search.readings.full.task.recordings;
    of.search.readings.drawn.asRecorded.edit().front().outputs.array() += 1;
    reportAsRecorded(of.search, of.base, as);
    ASSERT_TRUE(of.search.readings.drawn.errorsOnTime);
    EXPECT_NEAR(of.search.readings.drawn.errorsOnTime->first, errorPercentOf(*state, Role::Fit), 1e-12);
    EXPECT_LT(of.search.readings.drawn.errorsOnTime->second, 0) << "nothing validates";
    EXPECT_GT(errorPercentOf(as, Role::Fit), 2 * errorPercentOf(*state, Role::Fit));
}

}  // namespace
}  // namespace analogon
