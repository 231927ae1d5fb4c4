#pragma once

#include <Eigen/Core>

namespace analogon {

/// Step of a channel that takes few distinct values (an encoder, a coarse converter): the median gap between
/// neighbouring values. 0 where the values are not visibly rounded. NaN samples are left out.
double quantisationStep(const Eigen::Ref<const Eigen::VectorXd>& measured);

/// Standard deviation of the rounding error of such a channel: step / sqrt(12).
double quantisationNoise(const Eigen::Ref<const Eigen::VectorXd>& measured);

}  // namespace analogon
