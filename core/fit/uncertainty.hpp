#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace analogon {

/// What the data say about the parameters at the optimum.
struct Uncertainty {
    Eigen::VectorXd standardErrors;  // NaN: not determined
    Eigen::MatrixXd covariance;      // NaN rows and columns where not determined
    Eigen::MatrixXd correlation;
    std::vector<std::string> remarks;
};

/// From the triangular factor R of the weighted Jacobian (any matrix with the same JᵀJ) in own units and the
/// variance of a weighted residual: covariance = variance (JᵀJ)^-1 on the directions that the data determine;
/// the others are named.
Uncertainty uncertaintyOf(const Eigen::MatrixXd& jacobian, double variance, const std::vector<std::string>& names);

}  // namespace analogon
