#include "core/effect/reading/mistaken_unit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/core/effect/driven_rotor.hpp"
#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

constexpr int samples = 300;

double powerAt(double t) { return std::fmod(t, 100) < 50 ? 0.3 : 1.2; }

/// What a store holds at each sample that is fed with powerAt(), along straight lines, and loses by what it holds.
template <class Loss>
std::vector<double> heldBy(double capacity, const Loss& loss) {
    std::vector<double> held;
    double now = 0;
    for (int k = 0; k < samples; ++k) {
        held.push_back(now);
        constexpr int inner = 100;
        for (int i = 0; i < inner; ++i) {
            const double a = (i + 0.5) / inner, power = (1 - a) * powerAt(k) + a * powerAt(k + 1);
            now += 1.0 / inner / capacity * (power - loss(now));
        }
    }
    return held;
}

/// The warm body, its heater switched every 50 s. `loss`: what the model does not have [W/K2].
Recording heated(const std::string& name, double loss = 0) {
    Recording r = warmBodyRecording(name, samples);
    std::mt19937 random(8);
    std::normal_distribution<double> noise(0, 0.02);
    const std::vector<double> above = heldBy(4, [&](double t) { return 0.2 * t + loss * t * t; });
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(k);
        r.inputs(0, k) = powerAt(k);
        r.outputs(0, k) = 300 + above[static_cast<std::size_t>(k)] + noise(random);
    }
    r.units = {{"P", "P_heater", "W", "W"}, {"T", "T_body", "K", "K"}};
    return r;
}

EstimationTask bodyTask(std::vector<Recording> recordings, double reach) {
    EstimationTask task =
        warmBody({{"body.C", "J/K", 3.5, 4 / reach, 4 * reach}, {"joint.G", "W/K", 0.25, 0.2 / reach, 0.2 * reach}});
    task.recordings = std::move(recordings);
    return task;
}

/// `reach`: factor within which the parameters are known.
std::optional<MistakenUnit> mistakeIn(const std::vector<Recording>& recordings, double reach = 5) {
    const EstimationTask task = bodyTask(recordings, reach);
    const Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, {}, {});
    EXPECT_TRUE(null) << format(null.diagnostics());
    return null ? mistakenUnit(*null, {task, {}, {}}, {}, {}) : std::nullopt;
}

Recording inCelsius(Recording r) {
    r.outputs.array() -= 273.15;
    return r;
}

TEST(MistakenUnit, IsThatWithWhichTheModelAsItIsLeavesNoise) {
    const std::optional<MistakenUnit> found = mistakeIn({inCelsius(heated("run"))});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->columns, std::vector<std::string>{"T_body"});
    EXPECT_EQ(found->channels, std::vector<std::string>{"T"});
    EXPECT_EQ(found->unit, "K");
    EXPECT_EQ(found->likely, "degC");
    EXPECT_TRUE(isNoise(found->read));
    EXPECT_NEAR(found->read.fit.find("body.C")->value, 4, 0.1);
}

TEST(MistakenUnit, IsNoneWhereTheNumbersAreRight) {
    EXPECT_FALSE(mistakeIn({heated("run")}));
    EXPECT_FALSE(mistakeIn({heated("run", 0.05)})) << "what the model lacks is no unit";
    Recording offset = heated("run");
    offset.outputs.array() += 2;
    EXPECT_FALSE(mistakeIn({offset})) << "nor is an offset";
}

TEST(MistakenUnit, ByAFactorIsToldWhereTheParametersCannotMakeUpForIt) {
    Recording r = heated("run");
    r.inputs /= 1000;
    const std::optional<MistakenUnit> found = mistakeIn({r});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->columns, std::vector<std::string>{"P_heater"});
    EXPECT_EQ(found->likely, "kW");
    EXPECT_FALSE(mistakeIn({r}, 1e5)) << "a small body in a small flow";
}

TEST(MistakenUnit, MayBeOfOneRecordingOfSeveral) {
    const std::optional<MistakenUnit> found = mistakeIn({heated("run"), inCelsius(heated("next run"))});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->recordings, std::vector<int>{1});
    EXPECT_EQ(channelWords(bodyTask({heated("run"), heated("next run")}, 5), *found), "T ('T_body') in 'next run'");
    const std::optional<MistakenUnit> both = mistakeIn({inCelsius(heated("run")), inCelsius(heated("next run"))});
    ASSERT_TRUE(both);
    EXPECT_EQ(both->recordings, (std::vector<int>{0, 1}));
}

TEST(MistakenUnit, IsAlsoThatOfAStartValueFromTheColumn) {
    Recording r = inCelsius(heated("run"));
    r.starts = {{"body.T_start", r.outputs(0, 0), false, "T_body"}};
    const std::optional<MistakenUnit> found = mistakeIn({r});
    ASSERT_TRUE(found);
    EXPECT_TRUE(isNoise(found->read));
    const EstimationTask read = readAsLikely(bodyTask({r}, 5), *found);
    EXPECT_NEAR(read.recordings[0].starts[0].value, 300, 0.1);
    EXPECT_NEAR(read.recordings[0].outputs(0, 0), 300, 0.1);
    EXPECT_EQ(read.recordings[0].inputs, r.inputs);
}

TEST(MistakenUnit, ConvertsAStartValueOnceHoweverManyChannelsAreReadFromItsColumn) {
    Recording r = inCelsius(heated("run"));
    r.starts = {{"body.T_start", r.outputs(0, 0), false, "T_body"}};
    r.units.push_back({"T_wall", "T_body", "K", "K"});
    MistakenUnit mistake;
    mistake.recordings = {0};
    mistake.columns = {"T_body"};
    mistake.unit = "K";
    mistake.likely = "degC";
    const EstimationTask read = readAsLikely(bodyTask({r}, 5), mistake);
    EXPECT_NEAR(read.recordings[0].starts[0].value, 300, 0.1);
}

/// Numbers in deg/s that are told to be in rad/s.
Recording turning() {
    Recording r = warmBodyRecording("run", samples);
    r.inputNames = {"tau"};
    r.outputNames = {"w"};
    std::mt19937 random(9);
    std::normal_distribution<double> noise(0, 0.2);
    const std::vector<double> speed = heldBy(1.5, [](double w) { return 0.075 * w; });  // rad/s
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(k);
        r.inputs(0, k) = powerAt(k);
        r.outputs(0, k) = speed[static_cast<std::size_t>(k)] * 180 / std::numbers::pi + noise(random);
    }
    r.units = {{"tau", "torque", "Nm", "N.m"}, {"w", "speed", "rad/s", "rad/s"}};
    return r;
}

TEST(MistakenUnit, NamesTheCommonerUnitFirstWhereParametersMakeUpForTheFactorBetweenTwo) {
    const EstimationTask task = drivenRotor(turning());
    const Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, {}, {});
    ASSERT_TRUE(null) << format(null.diagnostics());
    const std::optional<MistakenUnit> found = mistakenUnit(*null, {task, {}, {}}, {}, {});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->channels, std::vector<std::string>{"w"});
    EXPECT_EQ(found->likely, "rpm") << "a rotor of a sixth of the inertia in a sixth of the drag";
    EXPECT_EQ(found->asLikely, std::vector<std::string>{"deg/s"});
    EXPECT_NEAR(found->read.fit.find("rotor.J")->value, 1.5 / 6, 0.01) << "as told first";
}

}  // namespace
}  // namespace analogon
