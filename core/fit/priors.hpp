#pragma once

#include "core/fit/problem.hpp"
#include "core/fit/reduced_misfit.hpp"

/// The residuals that priors add to a misfit, one for each, weighed against the scatter of a weighted residual: with
/// the data they make the logarithm of the posterior (maximum a posteriori). They are no part of a Linearisation,
/// which is of the data alone.
namespace analogon {

struct PriorResiduals {
    Eigen::MatrixXd jacobian;  // rows: priors, columns: parameters, in their own units
    Eigen::VectorXd residuals;

    double squares() const { return residuals.squaredNorm(); }
};
PriorResiduals priorResiduals(const FitProblem& problem, const Eigen::VectorXd& values, double scatter);

/// The triangle of the data with the priors in it.
ReducedMisfit withPriors(const ReducedMisfit& data, const PriorResiduals& priors);

}  // namespace analogon
