#include "core/effect/reading/faulty_sample.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/effect/model/model_state.hpp"
#include "tests/core/effect/hand_made.hpp"
#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

constexpr int samples = 300;

/// The warm body by the exact solution, its heater switched every 50 samples.
Recording heated() {
    Recording r = warmBodyRecording("run", samples);
    std::mt19937 random(8);
    std::normal_distribution<double> noise(0, 0.02);
    double temperature = 300;
    for (int k = 0; k < samples; ++k) {
        const double power = k / 50 % 2;
        r.time.push_back(k);
        r.inputs(0, k) = power;
        r.outputs(0, k) = temperature + noise(random);
        const double end = 300 + power / 0.2;
        temperature = end + (temperature - end) * std::exp(-0.05);
    }
    return r;
}

std::vector<FaultySamples> faultsIn(const Recording& recording) {
    EstimationTask task = warmBody({{"body.C", "J/K", 3.5, 1, 10}, {"joint.G", "W/K", 0.25, 0.05, 1}});
    task.recordings = {recording};
    const Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, {}, {});
    EXPECT_TRUE(null) << format(null.diagnostics());
    return null ? faultySamples(*null) : std::vector<FaultySamples>();
}

std::vector<int> samplesOf(const std::vector<FaultySamples>& faults) {
    std::vector<int> found;
    for (const FaultySamples& f : faults) found.push_back(f.begin);
    return found;
}

TEST(FaultySamples, AreThoseThatStandAlone) {
    Recording r = heated();
    EXPECT_TRUE(faultsIn(r).empty());
    for (const int k : {20, 128, 129, 131, 240}) r.outputs(0, k) += k == 131 ? -1 : 0.8;
    const std::vector<FaultySamples> found = faultsIn(r);
    EXPECT_EQ(samplesOf(found), (std::vector<int>{20, 128, 129, 131, 240}));
    EstimationTask task;
    task.recordings = {r};
    leaveOut(task, found);
    EXPECT_TRUE(std::isnan(task.recordings[0].outputs(0, 240)));
    EXPECT_FALSE(std::isnan(task.recordings[0].outputs(0, 241)));
    EXPECT_EQ(faultRemarks(task.recordings, found).size(), 1u);
}

TEST(FaultySamples, AreNotWhatAnInputOrTheComponentDoes) {
    Recording behindJump = heated();
    behindJump.outputs(0, 101) += 1;
    EXPECT_TRUE(faultsIn(behindJump).empty()) << "the heater is switched there";
    Recording step = heated();
    for (int k = 120; k < samples; ++k) step.outputs(0, k) += 1;
    EXPECT_TRUE(faultsIn(step).empty()) << "what stays is none";
    Recording pulse = heated();
    for (int k = 120; k < 125; ++k) pulse.outputs(0, k) += 1;
    EXPECT_TRUE(faultsIn(pulse).empty()) << "what lasts is none";
    Recording often = heated();
    for (int k = 10; k < samples; k += 12) often.outputs(0, k) += 1;
    EXPECT_TRUE(faultsIn(often).empty()) << "what comes often is no fault";
}

TEST(FaultySamples, AreReadingsThatStuck) {
    Recording r = heated();
    for (int k = 110; k < 140; ++k) r.outputs(0, k) = r.outputs(0, 109);
    for (int k = 1; k < 105; k += 2) r.outputs(0, k) = std::nan("");  // was not measured
    const std::vector<FaultySamples> found = faultsIn(r);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].isStuck);
    EXPECT_EQ(found[0].begin, 110) << "the first was right";
    EXPECT_EQ(found[0].end, 140);
    Recording resting = heated();
    for (int k = 0; k < samples; ++k) resting.outputs(0, k) = std::max(302.0, resting.outputs(0, k));
    EXPECT_TRUE(faultsIn(resting).empty()) << "it goes on from where it was";
}

TEST(FaultySamples, AreNoneWhereTheMeasurementGoesOnFromAnotherLevel) {
    const auto faultsBesideStep = [](double step) {
        Recording r = heated();
        r.outputs(0, 128) += 1;
        for (int k = 129; k < samples; ++k) r.outputs(0, k) += step;
        return faultsIn(r).size();
    };
    EXPECT_EQ(faultsBesideStep(0.12), 1u);
    EXPECT_EQ(faultsBesideStep(0.5), 0u) << "half as far away as it was";
}

TEST(FaultySamples, OfAnInputThatMovesAlwaysAreThoseFarFromItsJumps) {
    const auto isFault = [](double jump) {
        Recording r = heated();
        for (int k = 0; k < samples; ++k) r.inputs(0, k) += 0.01 * (k % 2) + (k > 128 ? jump : 0);
        double temperature = 300;
        for (int k = 0; k + 1 < samples; ++k) {
            const double mean = 0.5 * (r.inputs(0, k) + r.inputs(0, k + 1)), end = 300 + mean / 0.2;
            r.outputs(0, k) = temperature + 0.02 * std::sin(7.0 * k);
            temperature = end + (temperature - end) * std::exp(-0.05);
        }
        r.outputs(0, samples - 1) = temperature;
        r.outputs(0, 130) += 1;
        return !faultsIn(r).empty();
    };
    EXPECT_TRUE(isFault(0)) << "its usual changes are no jumps";
    EXPECT_TRUE(isFault(0.02)) << "nor is what is hardly more than they";
    EXPECT_FALSE(isFault(0.09));
}

TEST(FaultySamples, AreFewAgainstAllThatWasMeasured) {
    const auto faultsOf = [](int count) {
        Recording r = heated();
        const std::vector<int> at{20, 30, 128, 140, 230, 240, 82, 180, 190};
        for (int i = 0; i < count; ++i) r.outputs(0, at[static_cast<std::size_t>(i)]) += 0.8;
        return faultsIn(r).size();
    };
    EXPECT_EQ(faultsOf(6), 6u) << "however short the record";
    EXPECT_EQ(faultsOf(9), 0u);
}

TEST(RunsAlike, AreToldOfChannelsThatMoveElsewhere) {
    const auto runsOf = [](int count, int pairs) {
        Eigen::VectorXd values(count);
        for (int k = 0; k < count; ++k) values[k] = 1 + k;
        values.segment(10, 15).setConstant(11);
        for (int i = 0; i < pairs; ++i) values[31 + 3 * i] = values[30 + 3 * i];
        return runsAlike(values).size();
    };
    EXPECT_EQ(runsOf(400, 0), 1u);
    EXPECT_EQ(runsOf(400, 3), 1u);
    EXPECT_EQ(runsOf(400, 8), 0u) << "neighbours are often alike: a coarse or a slow reading";
    EXPECT_EQ(runsOf(40, 0), 0u) << "too few to judge a channel by";
    EXPECT_EQ(runsOf(60, 0), 1u);
}

/// What is said of a second recording that is not fitted, and the errors [%] of that: reported, and without its faults.
struct Unfitted {
    std::vector<FaultySamples> faults;
    std::vector<Text> remarks;
    double reported{}, sound{};
};

Unfitted faultsBeside(const Recording& checked) {
    EstimationTask task = warmBody({{"body.C", "J/K", 3.5, 1, 10}, {"joint.G", "W/K", 0.25, 0.05, 1}});
    task.recordings = {heated(), checked};
    task.recordings.edit()[1].name = "check";
    task.recordings.edit()[1].role = Role::Validate;
    const Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, {}, {});
    EXPECT_TRUE(null) << format(null.diagnostics());
    if (!null) return {};
    EXPECT_TRUE(faultySamples(*null).empty()) << "of the fitted one";
    const Outcome<ModelState> state = stateOf(null->variant, null->fit, {}, {});
    EXPECT_TRUE(state) << format(state.diagnostics());
    if (!state) return {};
    Unfitted found;
    found.faults = faultySamples(task.recordings, *state);
    const ModelState sound = withoutFaults(*state, found.faults);
    found.remarks = faultRemarks(task.recordings, found.faults, *state, sound);
    found.reported = state->experiments[1].errorPercent;
    found.sound = sound.experiments[1].errorPercent;
    EXPECT_EQ(sound.experiments[0].errorPercent, state->experiments[0].errorPercent);
    return found;
}

TEST(FaultySamples, OfARecordingThatIsNotFittedAreToldWithTheErrorWithoutThem) {
    const Unfitted none = faultsBeside(heated());
    EXPECT_TRUE(none.faults.empty());
    EXPECT_TRUE(none.remarks.empty());
    EXPECT_EQ(none.reported, none.sound);

    Recording sparks = heated();
    for (const int k : {20, 128, 240}) sparks.outputs(0, k) += 3;
    const Unfitted spiked = faultsBeside(sparks);
    EXPECT_EQ(samplesOf(spiked.faults), (std::vector<int>{20, 128, 240}));
    EXPECT_NEAR(spiked.sound, none.sound, 0.05 * none.sound);
    EXPECT_GT(spiked.reported, 3 * none.sound) << "the errors that are reported stay over all samples";
    ASSERT_EQ(spiked.remarks.size(), 1u);
    EXPECT_THAT(spiked.remarks[0].english(), testing::HasSubstr("output 'T' of 'check'"));
    EXPECT_THAT(spiked.remarks[0].english(), testing::HasSubstr(fmt::format("{:.3g} %: without", spiked.reported)));

    Recording held = heated();
    for (int k = 110; k < 140; ++k) held.outputs(0, k) = held.outputs(0, 109);
    const Unfitted stuck = faultsBeside(held);
    ASSERT_EQ(stuck.faults.size(), 1u);
    EXPECT_TRUE(stuck.faults[0].isStuck);
    EXPECT_EQ(stuck.faults[0].begin, 110);
    EXPECT_EQ(stuck.faults[0].end, 140);
    EXPECT_LT(stuck.sound, 0.5 * stuck.reported);
}

TEST(FaultySamples, OfARecordingThatIsNotFittedMayLastToItsEnd) {
    Recording dead = heated(), resting = heated();
    for (int k = 230; k < samples; ++k) dead.outputs(0, k) = dead.outputs(0, 229);
    const Unfitted stuck = faultsBeside(dead);
    ASSERT_EQ(stuck.faults.size(), 1u);
    EXPECT_EQ(stuck.faults[0].end, samples);
    EXPECT_THAT(stuck.remarks[0].english(), testing::HasSubstr("from 229 s to its end"));
    resting.inputs.setZero();
    for (int k = 50; k < samples; ++k) resting.outputs(0, k) = resting.outputs(0, k < 230 ? k % 50 : 29);
    EXPECT_TRUE(faultsBeside(resting).remarks.empty()) << "the model rests as well";
}

/// A body of which so much was measured beyond what the model says, in noise of 1; its heater does so much.
std::vector<FaultySamples> faultsBeyond(const Eigen::VectorXd& beyond, const Eigen::VectorXd& measured,
                                        const Eigen::VectorXd& power) {
    NullModel null = modelThatLeaves(-beyond, Eigen::MatrixXd(beyond.size(), 0));
    Recording r = null.variant.task.recordings.front();
    null.variant.task = warmBody({});
    r.inputNames = {"P"};
    r.inputs = power.transpose();
    r.outputNames = {"T"};
    r.outputs = measured.transpose();
    null.variant.task.recordings = {r};
    null.channels.front().measured = measured;
    return faultySamples(null);
}

/// A model that begins at rest where so much is measured, and catches up by this factor from one sample to the next.
int samplesOfStart(double lacks, double factor) {
    Eigen::VectorXd beyond = whiteNoise(samples);
    for (int k = 0; k < 30; ++k) beyond[k] = lacks * std::pow(factor, k) + 0.1 * beyond[k];
    const std::vector<FaultySamples> found =
        faultsBeyond(beyond, 500 + whiteNoise(samples, 7).array(), Eigen::VectorXd::Zero(samples));
    return found.empty() ? 0 : found.front().end;
}

TEST(FaultySamples, AreTheFirstOnesUntilAFastStateHasCaughtUp) {
    EXPECT_EQ(samplesOfStart(100, 0.4), 4);
    EXPECT_EQ(samplesOfStart(300, 0.48), 0) << "that takes too long for a start alone";
    EXPECT_EQ(samplesOfStart(30, 0.6), 0) << "nor does a fast state lack so much of it a sample later";
}

TEST(FaultySamples, AreMoreThanStepsOfAConverter) {
    const auto faultsOf = [](double height) {
        Eigen::VectorXd measured = Eigen::VectorXd::Constant(samples, 10);
        for (int k = 5; k < samples; k += 20) measured[k] = 11;  // it reads whole numbers
        measured[128] += height;
        const Eigen::VectorXd beyond = measured.array() - 10 + 0.05 * whiteNoise(samples).array();
        return samplesOf(faultsBeyond(beyond, measured, Eigen::VectorXd::Zero(samples)));
    };
    EXPECT_EQ(faultsOf(3), std::vector<int>{});
    EXPECT_EQ(faultsOf(6), std::vector<int>{128});
}

TEST(FaultySamples, AreNoneBehindAJumpOfMoreThanAHundredthOfTheRange) {
    const auto faultsOf = [](double jump) {
        Eigen::VectorXd beyond = whiteNoise(samples), power = Eigen::VectorXd::Zero(samples);
        beyond[128] += 30;
        power.tail(50).setConstant(100);
        power.segment(127, 60).setConstant(jump);
        return faultsBeyond(beyond, beyond, power).size();
    };
    EXPECT_EQ(faultsOf(0.6), 1u);
    EXPECT_EQ(faultsOf(1.5), 0u);
}

TEST(FaultySamples, AreNoneWhereTheNoiseHasLongTails) {
    const auto faultsOf = [](int halfAsClear) {
        Eigen::VectorXd beyond = whiteNoise(samples);
        for (const int k : {40, 250}) beyond[k] += 30;
        for (int i = 0; i < halfAsClear; ++i) beyond[70 + 30 * i] = 7;
        return faultsBeyond(beyond, beyond, Eigen::VectorXd::Zero(samples)).size();
    };
    EXPECT_EQ(faultsOf(1), 2u);
    EXPECT_EQ(faultsOf(4), 0u) << "twice as many that are half as clear";
}

}  // namespace
}  // namespace analogon
