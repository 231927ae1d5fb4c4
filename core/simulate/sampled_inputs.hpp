#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/outcome.hpp"

namespace analogon {

/// Measured inputs on a common time grid. Between samples they run linearly (first-order hold, eq. 10 of the 2014
/// paper), or are held (zero-order hold): u(t) = u_k for t_k <= t < t_k+1, a jump at its sample, at which whatever is
/// looked at sees the value after it. Times strictly increase.
struct SampledInputs {
    std::vector<double> time;  // [s] n samples
    Eigen::MatrixXd values;    // rows: inputs, columns: samples
    std::vector<char> held{};  // by input, whether it is held; empty: none is

    bool isHeld(Eigen::Index input) const {
        const auto i = static_cast<std::size_t>(input);
        return i < held.size() && held[i] != 0;
    }
    bool hasHeld() const;
    /// Rows of the inputs that are held.
    std::vector<int> heldInputs() const;
};

/// Samples at which some input leaves the line through its neighbours (relative to its range), or jumps: true kinks.
/// The first and last sample always belong to them.
std::vector<int> trueKinks(const SampledInputs& inputs, double tolerance = 1e-9);

/// Samples after the first at which some held input takes another value.
std::vector<int> jumpsOf(const SampledInputs& inputs);

}  // namespace analogon
