#pragma once

#include <Eigen/Core>

namespace analogon {

/// Standard deviation of the rounding error of a channel that takes few distinct values (an encoder, a coarse
/// converter): step / sqrt(12) with the step as the median gap between neighbouring values. 0 where the values
/// are not visibly rounded. NaN samples are left out.
double quantisationNoise(const Eigen::Ref<const Eigen::VectorXd>& measured);

}  // namespace analogon
