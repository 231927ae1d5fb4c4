#include "core/effect/tell/next_experiment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/effect/lagging_body.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;

NullModel fitted(const EstimationTask& task) {
    Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, {}, {});
    EXPECT_TRUE(null) << format(null.diagnostics());
    return null ? std::move(*null) : NullModel{};
}

/// An effect of this kind beside a model, refitted.
Trial trialOf(const NullModel& null, const std::string& kind) {
    const Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(null.variant.task.library);
    const Outcome<std::vector<Candidate>> candidates = candidatesFor(null.variant, *catalogue);
    const auto wanted =
        std::find_if(candidates->begin(), candidates->end(), [&](const Candidate& c) { return c.effect.kind == kind; });
    const Screened screened = screen(null, *wanted, {}, {});
    Trial trial = refit(null, screened, trialOptions({}, trialIterations), 1, {});
    EXPECT_TRUE(trial.ok) << kind << ": " << trial.failure;
    return trial;
}

TEST(NextExperiment, TellsALagFromADeadTimeWithinTheRangeOfTheInput) {
    const NullModel null = fitted(laggingBody(3));
    const Trial lag = trialOf(null, "sensor.lag"), delay = trialOf(null, "sensor.delay");
    const std::optional<ProposedExperiment> next = nextExperiment(null.with(lag.variant, lag.fit), delay, {}, {});
    ASSERT_TRUE(next);
    EXPECT_GT(next->separation, 4.5);
    EXPECT_THAT(next->programme.english(), HasSubstr("input P as"));
    EXPECT_THAT(next->programme.english(), HasSubstr("over 99.8 s")) << "as long as the recording";
}

TEST(NextExperiment, TellsNothingFromTheSameModel) {
    const NullModel null = fitted(laggingBody(3));
    const Trial lag = trialOf(null, "sensor.lag");
    const std::optional<ProposedExperiment> next = nextExperiment(null.with(lag.variant, lag.fit), lag, {}, {});
    ASSERT_TRUE(next);
    EXPECT_LT(next->separation, 0.1);
}

TEST(NextExperiment, IsNoneWhereNoInputMoved) {
    EstimationTask task = laggingBody(3);
    task.recordings.edit().front().inputs.setConstant(5);
    const NullModel null = fitted(task);
    const Trial lag = trialOf(null, "sensor.lag");
    EXPECT_FALSE(nextExperiment(null.with(lag.variant, lag.fit), lag, {}, {}));
}

}  // namespace
}  // namespace analogon
