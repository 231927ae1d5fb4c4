#include "core/effect/model/white_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace analogon {
namespace {

constexpr int samples = 2000;

/// Steps, a ramp and a slow wave, as a test bench commands them.
Eigen::VectorXd command() {
    Eigen::VectorXd u(samples);
    for (int k = 0; k < samples; ++k)
        u[k] = k < 800 ? 2.0 * (k / 100 % 3) : k < 1400 ? 0.01 * (k - 800) : 6 + std::sin(0.01 * k);
    return u;
}

Eigen::VectorXd noise(double deviation) {
    std::mt19937 random(2);
    std::normal_distribution<double> normal(0, deviation);
    Eigen::VectorXd n(samples);
    for (double& x : n) x = normal(random);
    return n;
}

TEST(WhiteNoise, IsToldFromWhatWasCommanded) {
    EXPECT_NEAR(whiteNoise(command() + noise(0.05)), 0.05, 0.01);
    EXPECT_EQ(whiteNoise(command()), 0);
    Eigen::VectorXd fast(samples), coarse = command();
    for (int k = 0; k < samples; ++k) fast[k] = std::sin(0.3 * k);
    for (double& x : coarse) x = 0.1 * std::round(x / 0.1);
    EXPECT_EQ(whiteNoise(fast), 0);
    EXPECT_EQ(whiteNoise(coarse), 0) << "steps of a converter are no noise";
}

}  // namespace
}  // namespace analogon
