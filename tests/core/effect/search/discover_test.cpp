#include "core/effect/search/discover.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/effect/model/model_state.hpp"
#include "tests/core/effect/lagging_body.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;

TEST(SimulateModel, IsTheModelAsItStands) {
    const Outcome<ModelState> state = simulateModel(laggingBody(0), {});
    ASSERT_TRUE(state) << format(state.diagnostics());
    EXPECT_TRUE(state->parameters.empty());
    EXPECT_EQ(state->simulations, 0);
    EXPECT_GT(errorPercentOf(*state, Role::Fit), 5) << "its conductance is not that of the body";
}

TEST(FitModel, FindsTheParametersAndSaysHowSure) {
    const Outcome<ModelState> state = fitModel(laggingBody(0), {});
    ASSERT_TRUE(state) << format(state.diagnostics());
    ASSERT_EQ(state->parameters.size(), 1u);
    EXPECT_NEAR(state->parameters[0].value, 0.2, 5 * state->parameters[0].standardError);
    EXPECT_LT(state->parameters[0].standardError, 0.001);
    EXPECT_LT(errorPercentOf(*state, Role::Fit), 1);
}

TEST(FitModel, ThatIsStoppedBeforeItHasAnythingIsAFault) {
    std::stop_source stop;
    stop.request_stop();
    const Outcome<ModelState> state =
        fitModel(laggingBody(0), {}, Progress(stop.get_token(), [](const Progress::Report&) {}));
    ASSERT_FALSE(state);
    EXPECT_THAT(format(state.diagnostics()), HasSubstr("cancelled"));
}

DiscoverOptions amongSensors() {
    DiscoverOptions options;
    options.kinds = {"sensor.lag", "sensor.offset"};
    return options;
}

/// Recordings that only validate are simulated for the report and used for nothing else.
TEST(Discover, FindsTheSameWhateverTheRecordingsAreThatOnlyValidate) {
    EstimationTask task = laggingBody(3);
    const Outcome<Finding> alone = discover(task, amongSensors());
    ASSERT_TRUE(alone) << format(alone.diagnostics());
    ASSERT_EQ(alone->effects.size(), 1u);
    EXPECT_EQ(alone->effects[0].kind, "sensor.lag");
    Recording check = task.recordings.front();
    check.name = "check";
    check.role = Role::Validate;
    check.outputs *= -1;
    task.recordings.push_back(check);
    const Outcome<Finding> checked = discover(task, amongSensors());
    ASSERT_TRUE(checked);
    ASSERT_EQ(checked->effects.size(), 1u);
    EXPECT_EQ(checked->effects[0].parameters[0].value, alone->effects[0].parameters[0].value);
    EXPECT_EQ(checked->effects[0].evidence.deltaBic, alone->effects[0].evidence.deltaBic);
    EXPECT_GT(validationErrorOf(checked->final), 100);
}

TEST(Discover, KeepsWhatItHasWheneverThatIsMore) {
    DiscoverOptions options = amongSensors();
    std::vector<std::size_t> effects;
    options.keep = [&](const Finding& f) { effects.push_back(f.effects.size()); };
    ASSERT_TRUE(discover(laggingBody(3), options));
    ASSERT_GE(effects.size(), 2u);
    EXPECT_EQ(effects.front(), 0u) << "the model as given";
    EXPECT_EQ(effects.back(), 1u);
}

}  // namespace
}  // namespace analogon
