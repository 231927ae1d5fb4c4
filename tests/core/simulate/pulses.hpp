#pragma once

#include "core/simulate/sampled_inputs.hpp"

namespace analogon::test {

/// An input that steps, falls and rests, every 400 samples anew.
inline SampledInputs pulses(int count, double step) {
    SampledInputs inputs;
    inputs.values.resize(1, count);
    for (int k = 0; k < count; ++k) {
        inputs.time.push_back(k * step);
        const int phase = k % 400;
        inputs.values(0, k) = phase < 150 ? 0.1 : phase < 200 ? 0.1 - 0.003 * (phase - 150) : -0.05;
    }
    return inputs;
}

/// Largest difference, in ranges of the second.
inline double differenceInRanges(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return (a - b).cwiseAbs().maxCoeff() / (b.maxCoeff() - b.minCoeff());
}

}  // namespace analogon::test
