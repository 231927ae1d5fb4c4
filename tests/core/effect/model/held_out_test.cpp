#include "core/effect/model/held_out.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/hand_made.hpp"
#include "tests/core/effect/left_by.hpp"

namespace analogon {
namespace {

constexpr int samples = 1000;

TEST(HeldOutGain, IsNearOneForATrueEffectAndNegativeForAFalseOne) {
    const std::vector<ResidualChannel> channels{wholeChannel(samples)};
    const Eigen::VectorXd noise = whiteNoise(samples), truth = sineWave(samples, 7), wrong = whiteNoise(samples, 6);
    const Eigen::VectorXd r = noise - truth;
    const Eigen::MatrixXd nothing(samples, 0);
    EXPECT_GT(heldOutGain(channels, leftBy(nothing, r), leftBy(truth, r), 5, 5), 0.8);
    EXPECT_LT(heldOutGain(channels, leftBy(nothing, noise), leftBy(wrong, noise), 5, 5), 0.5);
}

TEST(HeldOutGain, JudgesAnEffectOfWhichOneShapeShowsInOnePartAlone) {
    // strongest where a second parameter of it shows (the stiffness of a contact that is closed there)
    const std::vector<ResidualChannel> channels{wholeChannel(samples)};
    Eigen::MatrixXd effect = Eigen::MatrixXd::Zero(samples, 2);
    effect.col(0) = sineWave(samples, 7);
    effect.col(0).head(samples / 5) *= 5;
    effect(50, 1) = 1;
    const Eigen::VectorXd r = whiteNoise(samples) - effect * Eigen::Vector2d(3, 4);
    const Linearisation none = leftBy(Eigen::MatrixXd(samples, 0), r);
    EXPECT_GT(heldOutGain(channels, none, leftBy(effect, r), 5, 5), 0.8);
}

TEST(HeldOutGain, DoesNotConfirmWhatShowsInOnePartAlone) {
    const std::vector<ResidualChannel> channels{wholeChannel(samples)};
    Eigen::MatrixXd effect = Eigen::MatrixXd::Zero(samples, 1);
    effect.col(0).segment(250, 100) = 5 * sineWave(samples, 70).head(100);
    const Eigen::VectorXd r = whiteNoise(samples) - effect.col(0);
    EXPECT_LT(heldOutGain(channels, leftBy(Eigen::MatrixXd(samples, 0), r), leftBy(effect, r), 5, 5), 0.2);
}

/// To first order about the optimum is exact of a model that is linear in its parameter: a constant, fitted to the
/// rest.
TEST(HeldOut, FollowsTheRestOfTheRecord) {
    Eigen::VectorXd measured(6);
    measured << 1, 2, 3, 4, 5, 9;
    const Eigen::MatrixXd constant = Eigen::MatrixXd::Ones(6, 1);
    const Linearisation with = leftBy(constant, -measured), without = leftBy(Eigen::MatrixXd(6, 0), -measured);
    const LeftOutPart part = HeldOut(without, with).part({0, 5});
    const double ofTheRest = (2 + 3 + 4 + 5) / 4.0;
    EXPECT_NEAR(part.with[0], ofTheRest - 1, 1e-4);
    EXPECT_NEAR(part.with[1], ofTheRest - 9, 1e-4);
    EXPECT_EQ(part.without[0], -1);
    EXPECT_EQ(part.without[1], -9);
    EXPECT_EQ(part.unconfirmed, 0);
}

/// A step of which the rest of the record has so much: no more than the least that counts as told by it, or more.
TEST(HeldOut, LeavesUnconfirmedWhatTheRestTellsNextToNothingOf) {
    const auto unconfirmed = [](double shareOfRest) {
        Eigen::MatrixXd effect(2, 1);
        effect << std::sqrt(1 - shareOfRest), std::sqrt(shareOfRest);
        const Eigen::VectorXd r = -3 * effect.col(0);
        const Linearisation with = leftBy(effect, r), without = leftBy(Eigen::MatrixXd(2, 0), r);
        return HeldOut(without, with).part({0}).unconfirmed;
    };
    EXPECT_NEAR(unconfirmed(0.045), 9 * 0.955, 1e-6);
    EXPECT_EQ(unconfirmed(0.055), 0);
}

}  // namespace
}  // namespace analogon
