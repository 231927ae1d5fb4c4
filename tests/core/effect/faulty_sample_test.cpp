#include "core/effect/faulty_sample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "warm_body.hpp"

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
    EXPECT_EQ(faultRemarks(task, found).size(), 1u);
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

}  // namespace
}  // namespace analogon
