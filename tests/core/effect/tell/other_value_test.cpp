#include "core/effect/tell/other_value.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/effect/model/null_model.hpp"
#include "tests/core/effect/lagging_body.hpp"

namespace analogon {
namespace {

using testing::HasSubstr;

std::vector<Text> toldOf(const std::vector<Recording>& checks) {
    EstimationTask task = warmBody({{"joint.G", "W/K", 0.3, 0.01, 10}, {"body.C", "J/K", 5, 0.1, 100}});
    task.recordings = {recordingOf("bench", {.seed = 1})};
    for (Recording check : checks) {
        check.role = Role::Validate;
        task.recordings.push_back(check);
    }
    const FitOptions options;
    const Outcome<NullModel> fitted = fitNull(Variant{task, {}, {}}, {}, NoiseLevel::Estimate, options, {});
    EXPECT_TRUE(fitted) << format(fitted.diagnostics());
    if (!fitted) return {};
    const Outcome<ModelState> state = stateOf(fitted->variant, fitted->fit, options.simulation, {});
    EXPECT_TRUE(state) << format(state.diagnostics());
    return state ? otherValues(fitted->variant, *state, options, {}) : std::vector<Text>();
}

TEST(OtherValues, NameTheLossThatAFanMakesLarger) {
    const std::vector<Text> told = toldOf({recordingOf("with a fan", {.conductance = 0.5, .seed = 2})});
    ASSERT_EQ(told.size(), 1u);
    EXPECT_THAT(told.front().english(), HasSubstr("'with a fan': with joint.G = 0.5 W/K there, where the fitted"));
    EXPECT_THAT(told.front().english(), HasSubstr("say 0.2"));
}

TEST(OtherValues, AreNoneOfARecordingThatIsForetold) {
    EXPECT_TRUE(toldOf({recordingOf("another day", {.seed = 2})}).empty());
}

TEST(OtherValues, AreNoneWhereNoParameterAccountsForTheMiss) {
    EXPECT_TRUE(toldOf({recordingOf("another sensor", {.offset = -40, .seed = 2})}).empty());
}

TEST(OtherValues, AreLookedForInAFewRecordingsAlone) {
    std::vector<Recording> checks;
    for (int i = 1; i <= 6; ++i)
        checks.push_back(recordingOf("another sensor " + std::to_string(i), {.offset = -40, .seed = 2}));
    checks.push_back(recordingOf("with a fan", {.conductance = 0.5, .seed = 2}));
    EXPECT_TRUE(toldOf(checks).empty()) << "each costs a fit a parameter";
    checks.erase(checks.begin());
    EXPECT_EQ(toldOf(checks).size(), 1u);
}

}  // namespace
}  // namespace analogon
