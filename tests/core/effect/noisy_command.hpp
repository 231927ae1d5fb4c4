#pragma once

#include <Eigen/Core>
#include <cmath>
#include <random>

/// An input as a test bench commands it, and the noise with which it may be recorded.
namespace analogon::noisy_command {

inline constexpr int samples = 2000;

/// Steps, a ramp and a slow wave, as a test bench commands them.
inline Eigen::VectorXd command() {
    Eigen::VectorXd u(samples);
    for (int k = 0; k < samples; ++k)
        u[k] = k < 800 ? 2.0 * (k / 100 % 3) : k < 1400 ? 0.01 * (k - 800) : 6 + std::sin(0.01 * k);
    return u;
}

inline Eigen::VectorXd noise(double deviation) {
    std::mt19937 random(2);
    std::normal_distribution<double> normal(0, deviation);
    Eigen::VectorXd n(samples);
    for (double& x : n) x = normal(random);
    return n;
}

}  // namespace analogon::noisy_command
