#include "core/effect/tell/preview.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/effect/model/model_state.hpp"
#include "core/effect/search/discover.hpp"
#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

/// A body whose sensor reads 4 K too much.
EstimationTask readTooHigh() {
    constexpr int samples = 400;
    EstimationTask task = warmBody({{"joint.G", "", 0.3, 0.01, 10}});
    Recording r = warmBodyRecording("warm-up", samples);
    r.inputs.setConstant(8);
    for (int k = 0; k < samples; ++k) {
        const double t = 0.25 * k, noise = 0.02 * std::sin(12.9898 * k) * std::cos(78.233 * k);
        r.time.push_back(t);
        r.outputs(0, k) = 304 + 40 * (1 - std::exp(-t / 20)) + noise;
    }
    task.recordings = {r};
    return task;
}

TEST(Preview, ShowsTheModelWithOneEffect) {
    const EstimationTask task = readTooHigh();
    const FitOptions options;
    const Outcome<ModelState> without = fitModel(task, options);
    ASSERT_TRUE(without) << format(without.diagnostics());
    const Outcome<ModelState> with = stateWith(task, {"Analogon.Effects.Sensor.Offset", "output T"}, options);
    ASSERT_TRUE(with) << format(with.diagnostics());
    EXPECT_GT(errorPercentOf(*without, Role::Fit), 1);
    EXPECT_LT(errorPercentOf(*with, Role::Fit), 0.05);
    ASSERT_EQ(with->experiments.size(), 1u);
    EXPECT_EQ(with->experiments[0].time.size(), 400u);
}

TEST(Preview, RefusesAPlaceThatIsNotThere) {
    const Outcome<ModelState> with = stateWith(readTooHigh(), {"Analogon.Effects.Sensor.Offset", "output v"}, {});
    ASSERT_FALSE(with);
    EXPECT_THAT(format(with.diagnostics()), testing::HasSubstr("no such place"));
}

TEST(Preview, StopsWhenItIsAskedTo) {
    std::stop_source stop;
    stop.request_stop();
    const Progress progress(stop.get_token(), [](const Progress::Report&) {});
    (void)stateWith(readTooHigh(), {"Analogon.Effects.Sensor.Offset", "output T"}, {}, progress);  // and does not crash
}

}  // namespace
}  // namespace analogon
