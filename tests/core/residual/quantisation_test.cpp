#include "core/residual/quantisation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace analogon {
namespace {

TEST(QuantisationNoise, IsTheStepOverRootTwelve) {
    Eigen::VectorXd x(2000);
    for (int k = 0; k < x.size(); ++k) x[k] = 0.5 * std::round(10 * std::sin(0.01 * k) / 0.5);
    EXPECT_NEAR(quantisationNoise(x), 0.5 / std::sqrt(12.0), 1e-12);
}

TEST(QuantisationNoise, IsNothingForAFineChannel) {
    Eigen::VectorXd x(500);
    for (int k = 0; k < x.size(); ++k) x[k] = std::sin(0.013 * k * k);
    EXPECT_EQ(quantisationNoise(x), 0);
}

}  // namespace
}  // namespace analogon
