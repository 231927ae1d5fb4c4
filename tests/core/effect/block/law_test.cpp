#include "core/effect/block/law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/core/effect/block/candidates_of.hpp"
#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

/// A body that loses, beside what its joint passes on, so much with the cube of its temperature over 300 K.
NullModel bodyWithCubicLoss(double factor) {
    constexpr int samples = 400, within = 50;
    constexpr double step = 0.25;
    EstimationTask task = warmBody({{"joint.G", "W/K", 0.3, 0.01, 10}});
    Recording r = warmBodyRecording("warm-up", samples);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 0.02);
    double T = 300;
    for (int k = 0; k < samples; ++k) {
        const double power = k / 100 % 2 == 0 ? 8 : 2;
        r.time.push_back(step * k);
        r.inputs(0, k) = power;
        r.outputs(0, k) = T + noise(random);
        const double next = (k + 1) / 100 % 2 == 0 ? 8 : 2;
        for (int i = 0; i < within; ++i) {
            const double part = (i + 0.5) / within, over = T - 300;
            T += step / within * ((1 - part) * power + part * next - 0.2 * over - factor * over * over * over) / 4;
        }
    }
    task.recordings = {r};
    return fittedModel(task);
}

TEST(LikelyLaws, AreWrittenForWhatAFlowLacks) {
    const NullModel null = bodyWithCubicLoss(2e-4);
    const std::vector<Law> laws = likelyLaws(null, 7, {}, 1, {});
    ASSERT_FALSE(laws.empty());
    const EffectClass& best = laws.front().candidate.effect;
    EXPECT_EQ(best.kind, "proposal.law");
    EXPECT_EQ(best.className.find("Missing"), 0u);
    EXPECT_NE(best.className.find('8'), std::string::npos) << "numbered on from the seven that are written";
    const auto ofBody = std::find_if(laws.begin(), laws.end(), [](const Law& law) {
        return law.candidate.effect.className.starts_with("MissingHeatFlow");
    });
    ASSERT_TRUE(ofBody != laws.end());
    EXPECT_NE(laws.front().text.find("model " + best.className), std::string::npos);
    EXPECT_LE(laws.size(), 12u) << "eight for flows, half as many for sensors";
}

TEST(LikelyLaws, AreNoneForNoise) { EXPECT_TRUE(likelyLaws(bodyWithCubicLoss(0), 0, {}, 1, {}).empty()); }

}  // namespace
}  // namespace analogon
