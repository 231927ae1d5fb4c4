#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace analogon {

/// Whether all values are finite, at the speed of memory: x - x is 0 or not a number.
inline bool allFinite(const double* values, Eigen::Index count) {
    constexpr Eigen::Index lanes = 8;
    double sums[lanes] = {};
    Eigen::Index k = 0;
    for (; k + lanes <= count; k += lanes)
        for (Eigen::Index j = 0; j < lanes; ++j) sums[j] += values[k + j] - values[k + j];
    for (; k < count; ++k) sums[0] += values[k] - values[k];
    double sum = 0.0;
    for (const double each : sums) sum += each;
    return sum == 0.0;
}

}  // namespace analogon
