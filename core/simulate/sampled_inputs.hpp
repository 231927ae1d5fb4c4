#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/outcome.hpp"

namespace analogon {

/// Measured inputs on a common time grid; between samples they run linearly (first-order hold, eq. 10 of the
/// 2014 paper). Times strictly increase.
struct SampledInputs {
    std::vector<double> time;  // [s] n samples
    Eigen::MatrixXd values;    // rows: inputs, columns: samples
};

/// Samples at which some input leaves the line through its neighbours (relative to its range): true kinks.
/// The first and last sample always belong to them.
std::vector<int> trueKinks(const SampledInputs& inputs, double tolerance = 1e-9);

}  // namespace analogon
