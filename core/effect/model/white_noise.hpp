#pragma once

#include <Eigen/Core>

namespace analogon {

/// Standard deviation of white noise on a signal that is otherwise straight from sample to sample, steps apart; 0 where
/// what is not straight does not look like white noise.
double whiteNoise(const Eigen::VectorXd& signal);

}  // namespace analogon
