#include "core/effect/spike.hpp"

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

std::vector<Spike> spikesIn(const Recording& recording) {
    EstimationTask task = warmBody({{"body.C", "J/K", 3.5, 1, 10}, {"joint.G", "W/K", 0.25, 0.05, 1}});
    task.recordings = {recording};
    const Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, {}, {});
    EXPECT_TRUE(null) << format(null.diagnostics());
    return null ? spikes(*null) : std::vector<Spike>();
}

std::vector<int> samplesOf(const std::vector<Spike>& spikes) {
    std::vector<int> found;
    for (const Spike& s : spikes) found.push_back(s.sample);
    return found;
}

TEST(Spikes, AreSamplesThatStandAlone) {
    Recording r = heated();
    EXPECT_TRUE(spikesIn(r).empty());
    for (const int k : {20, 128, 129, 131, 240}) r.outputs(0, k) += k == 131 ? -1 : 0.8;
    const std::vector<Spike> found = spikesIn(r);
    EXPECT_EQ(samplesOf(found), (std::vector<int>{20, 128, 129, 131, 240}));
    EstimationTask task;
    task.recordings = {r};
    leaveOut(task, found);
    EXPECT_TRUE(std::isnan(task.recordings[0].outputs(0, 240)));
    EXPECT_FALSE(std::isnan(task.recordings[0].outputs(0, 241)));
    EXPECT_EQ(spikeRemarks(task, found).size(), 1u);
}

TEST(Spikes, AreNotWhatAnInputOrTheComponentDoes) {
    Recording behindJump = heated();
    behindJump.outputs(0, 101) += 1;
    EXPECT_TRUE(spikesIn(behindJump).empty()) << "the heater is switched there";
    Recording step = heated();
    for (int k = 120; k < samples; ++k) step.outputs(0, k) += 1;
    EXPECT_TRUE(spikesIn(step).empty()) << "what stays is none";
    Recording pulse = heated();
    for (int k = 120; k < 125; ++k) pulse.outputs(0, k) += 1;
    EXPECT_TRUE(spikesIn(pulse).empty()) << "what lasts is none";
    Recording often = heated();
    for (int k = 10; k < samples; k += 12) often.outputs(0, k) += 1;
    EXPECT_TRUE(spikesIn(often).empty()) << "what comes often is no fault";
}

}  // namespace
}  // namespace analogon
