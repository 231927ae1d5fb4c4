#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/fit/fit.hpp"

namespace analogon {

/// Correlation from which on two estimates can hardly be told apart.
constexpr double hardlyToldApart = 0.9995;

/// What the data say about the parameters at the optimum.
struct Uncertainty {
    Eigen::VectorXd standardErrors;  // NaN: not determined
    Eigen::MatrixXd covariance;      // NaN rows and columns where not determined
    Eigen::MatrixXd correlation;
    Eigen::MatrixXd seen;                 // the covariance on the directions that the data determine, without gaps
    std::vector<Eigen::VectorXd> unseen;  // changes of several parameters that the data do not see, in own units
    std::vector<Text> remarks;
};

/// From the triangular factor R of the weighted Jacobian (any matrix with the same JᵀJ) in own units and the
/// variance of a weighted residual: covariance = variance (JᵀJ)^-1 on the directions that the data determine;
/// the others are named.
Uncertainty uncertaintyOf(const Eigen::MatrixXd& jacobian, double variance, const std::vector<std::string>& names);

/// Standard errors that hold for residuals correlated in time, too, from the "sandwich" (JᵀJ)^-1 S (JᵀJ)^-1 (White
/// 1980) with the long-run covariance S of the scores Jᵀr of each sample. `inverse`: (JᵀJ)^-1, NaN where not
/// determined. `scatter`: against which the priors weighed (FitResult::scatter).
Eigen::VectorXd robustErrorsOf(const FitProblem& problem, const Linearisation& optimum, const Eigen::MatrixXd& inverse,
                               double scatter = 1.0);

/// Sum of the autocovariances of the rows (not centred: scores sum to zero) with Bartlett's weights 1 - lag / window
/// (Newey & West, Econometrica 55, 1987). It cannot be negative.
Eigen::MatrixXd longRunCovariance(const Eigen::MatrixXd& rows, Eigen::Index window);

/// The window that suits rows as they follow one another: Andrews (Econometrica 59, 1991), eqs. 6.2 and 6.4, with a
/// first-order autoregression in each column.
double suitableWindow(const Eigen::MatrixXd& rows);

/// How far the outputs of one experiment that have a weight are uncertain since the parameters are: standard deviations
/// by the delta method, sqrt(y' C y'ᵀ) with the slopes y' and the covariance C of the parameters at these values. Rows:
/// outputs, columns: samples. The noise of a measurement is not in it. NaN: the simulation failed, a parameter is not
/// determined, or the output has no weight. `plan` null: made here.
Eigen::MatrixXd predictionBand(const FitProblem& problem, int experiment, const Eigen::VectorXd& values,
                               const Eigen::MatrixXd& covariance, const GridPlan* plan,
                               const SimulationOptions& options = {}, const Progress& progress = {});

}  // namespace analogon
