#include "core/effect/model/white_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/effect/noisy_command.hpp"

namespace analogon {
namespace {

using namespace noisy_command;

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
