#pragma once

#include <Eigen/Core>

namespace analogon {

/// Residuals and Jacobian squeezed into the triangular factor of [J r]: K + 1 rows with the same cost, gradient
/// and JᵀJ as the many (streamed QR: Golub & Van Loan, section 6.5). A least-squares step needs no more.
struct ReducedMisfit {
    bool ok{};
    Eigen::MatrixXd jacobian;   // (K + 1) x K, last row zero
    Eigen::VectorXd residuals;  // K + 1

    double cost() const { return 0.5 * residuals.squaredNorm(); }
    Eigen::VectorXd gradient() const { return jacobian.transpose() * residuals; }
};

ReducedMisfit reduce(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residuals);

}  // namespace analogon
