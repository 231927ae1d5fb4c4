#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/fit/uncertainty.hpp"

namespace analogon {

/// What the data say of the parameters at an optimum.
struct OptimumUncertainty {
    Uncertainty uncertainty;  // with the products and ratios that are known where the parameters are not
    double variance{};        // of a weighted residual
};

/// `optimum`: channels that none of its slopes moves say nothing of the scatter; without slopes all count. `factor`: R
/// of the weighted Jacobian with the priors. `squares`: sum of the squared weighted residuals without the priors.
/// `ofLoss`: the variance that a robust loss tells.
OptimumUncertainty uncertaintyAt(const FitProblem& problem, const std::vector<std::string>& names,
                                 const Eigen::VectorXd& values, const Linearisation& optimum,
                                 const Eigen::MatrixXd& factor, double squares,
                                 std::optional<double> ofLoss = std::nullopt);

}  // namespace analogon
