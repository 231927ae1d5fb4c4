#include "core/effect/model/evidence.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/effect/hand_made.hpp"

namespace analogon {
namespace {

constexpr int samples = 400;

/// A model without parameters, its input switched every 40 samples; what it leaves is white but for so much at the
/// samples that lie `behind` each switch.
NullModel leaving(double extra, int behind) {
    NullModel null;
    Recording r;
    r.name = "run";
    r.inputNames = {"u"};
    r.outputNames = {"y"};
    r.inputs = Eigen::MatrixXd::Zero(1, samples);
    r.outputs = Eigen::MatrixXd::Zero(1, samples);
    ResidualChannel channel;
    channel.end = samples;
    std::mt19937 random(4);
    std::normal_distribution<double> noise;
    Eigen::VectorXd residuals(samples);
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(k);
        r.inputs(0, k) = k / 40 % 2;
        channel.samples.push_back(k);
        residuals[k] = noise(random) + (k >= 40 && k % 40 == behind ? extra : 0);
    }
    channel.measured = Eigen::VectorXd::Zero(samples);
    null.variant.task.recordings = {r};
    null.channels = {channel};
    null.fit.optimum.residuals = residuals;
    null.fit.optimum.jacobian = Eigen::MatrixXd::Zero(samples, 0);
    return null;
}

Acceptance examined(double extra, int behind) { return examine(leaving(extra, behind), leaving(0, 0).fit, 1, 0); }

TEST(Examine, DoubtsWeakEvidenceThatLiesRightBehindJumpsOfAnInputAlone) {
    EXPECT_GT(examined(2.5, 20).evidence, 20);
    EXPECT_LT(examined(2.5, 20).evidence, 100);
    EXPECT_TRUE(examined(2.5, 20).isSignificant) << "far behind the jumps";
    EXPECT_FALSE(examined(2.5, 1).isSignificant) << "how the input ran there is not known";
    EXPECT_TRUE(examined(6, 1).isSignificant) << "too much for that";
}

TEST(Examine, DoesNotDoubtWhatLiesBehindJumpsThatFillMuchOfTheRecord) {
    const auto isSignificant = [](int every) {
        NullModel null = leaving(0, 0);
        Eigen::VectorXd& residuals = null.fit.optimum.residuals;
        for (int k = 0; k < samples; ++k) null.variant.task.recordings.edit().front().inputs(0, k) = k / every % 2;
        const FitResult with = null.fit;
        for (int k = every; k < samples; ++k)
            if (k % every == 1) residuals[k] += 8 / std::sqrt(400.0 / every);
        return examine(null, with, 1, 0).isSignificant;
    };
    EXPECT_FALSE(isSignificant(20)) << "15 % of the samples";
    EXPECT_TRUE(isSignificant(6)) << "half of them: that tells nothing";
}

/// What a model leaves beside a parameter that takes up a slow wave: so much of a wave that an effect explains, and of
/// one that it does not.
Acceptance examinedWaves(double explained, double left, double threshold = 0, int effects = 0) {
    const Eigen::VectorXd noise = whiteNoise(samples), columns = sineWave(samples, 1);
    NullModel null = modelThatLeaves(noise + explained * sineWave(samples, 13) + left * sineWave(samples, 3), columns);
    null.variant.effects.resize(static_cast<std::size_t>(effects));
    return examine(null, modelThatLeaves(noise + left * sineWave(samples, 3), columns).fit, 1, threshold);
}

TEST(Examine, AsksMoreWhereStructureIsLeftAndBesideOtherEffects) {
    EXPECT_EQ(examinedWaves(1, 0).asked.evidence, 20) << "decisive";
    EXPECT_EQ(examinedWaves(1, 3).asked.evidence, 30) << "an effect may only feed on what is left";
    EXPECT_EQ(examinedWaves(1, 0, 0, 1).asked.evidence, 60) << "it may only mend the form of another";
    EXPECT_EQ(examinedWaves(1, 0, 25).asked.evidence, 25) << "what chance brings";
    EXPECT_EQ(examinedWaves(1, 3, 25).asked.evidence, 75) << "three times that, where structure is left";
}

TEST(Examine, AsksBlocksTheLessTheMoreIsExplained) {
    EXPECT_EQ(examinedWaves(2, 0).asked.heldOut, 0.2) << "nothing remains, and far more is explained than chance can";
    EXPECT_EQ(examinedWaves(0.5, 0).asked.heldOut, 0.5);
    EXPECT_EQ(examinedWaves(0.5, 3).asked.heldOut, 0.7) << "a wrong effect may feed on what remains";
}

TEST(Examine, AsksForMoreThanADetailOfWhatStaysUnexplained) {
    EXPECT_TRUE(examinedWaves(0.8, 3).isWorthwhile) << "7 %";
    EXPECT_FALSE(examinedWaves(0.8, 4.5).isWorthwhile) << "3 %";
}

TEST(HeldOutBlocks, OutlastTheMemoryOfTheNoiseAndAreNeverFewerThanAreLeftOut) {
    EXPECT_EQ(heldOutBlocks(15), 10);
    EXPECT_EQ(heldOutBlocks(60), 20) << "three independent samples each";
    EXPECT_EQ(heldOutBlocks(4000), 40);
}

}  // namespace
}  // namespace analogon
