#pragma once

#include "core/fit/problem.hpp"

/// What the rounding of a computer leaves where nothing else is left: no residual, and no influence of a parameter.
namespace analogon {

/// Norm of the residuals that the rounding of the simulated outputs alone may leave.
double roundingOf(const FitProblem& problem);

/// The slopes without those of parameters that change the residuals, by all of their value, no more than rounding does.
Eigen::MatrixXd beyondRounding(const FitProblem& problem, const Eigen::VectorXd& values, Eigen::MatrixXd jacobian);

}  // namespace analogon
