#include "core/effect/tell/other_value.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/effect/model/null_model.hpp"
#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

/// The body of warmBody() with this conductance to its surroundings, in white noise.
Recording warmUp(const std::string& name, double conductance, double offset, unsigned seed) {
    constexpr double step = 0.25;
    constexpr int samples = 300;
    Recording r = warmBodyRecording(name, samples);
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 0.05);
    double body = 300;
    const auto powerAt = [](int k) { return k < samples / 2 ? 8.0 : 2.0; };
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(step * k);
        r.inputs(0, k) = powerAt(k);
        r.outputs(0, k) = body + offset + noise(random);
        for (int i = 0; i < 50; ++i) {
            const double part = (i + 0.5) / 50, power = (1 - part) * powerAt(k) + part * powerAt(k + 1);
            body += step / 50 * (power - conductance * (body - 300)) / 4;
        }
    }
    return r;
}

std::vector<Text> toldOf(Recording check) {
    EstimationTask task = warmBody({{"joint.G", "W/K", 0.3, 0.01, 10}, {"body.C", "J/K", 5, 0.1, 100}});
    check.role = Role::Validate;
    task.recordings = {warmUp("bench", 0.2, 0, 1), check};
    const FitOptions options;
    const Outcome<NullModel> fitted = fitNull(Variant{task, {}, {}}, {}, NoiseLevel::Estimate, options, {});
    EXPECT_TRUE(fitted) << format(fitted.diagnostics());
    if (!fitted) return {};
    const Outcome<ModelState> state = stateOf(fitted->variant, fitted->fit, options.simulation, {});
    EXPECT_TRUE(state) << format(state.diagnostics());
    return state ? otherValues(fitted->variant, *state, options, {}) : std::vector<Text>();
}

TEST(OtherValues, NameTheLossThatAFanMakesLarger) {
    const std::vector<Text> told = toldOf(warmUp("with a fan", 0.5, 0, 2));
    ASSERT_EQ(told.size(), 1u);
    EXPECT_THAT(told.front().english(),
                MatchesRegex("'with a fan': with joint.G = 0.(50|499)[0-9]* W/K there, where the fitted .*"));
    EXPECT_THAT(told.front().english(), HasSubstr("say 0.2"));
}

TEST(OtherValues, AreNoneOfARecordingThatIsForetold) { EXPECT_TRUE(toldOf(warmUp("another day", 0.2, 0, 2)).empty()); }

TEST(OtherValues, AreNoneWhereNoParameterAccountsForTheMiss) {
    EXPECT_TRUE(toldOf(warmUp("another sensor", 0.2, -40, 2)).empty());
}

}  // namespace
}  // namespace analogon
