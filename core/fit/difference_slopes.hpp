#pragma once

#include "core/fit/problem.hpp"

/// Slopes of the residuals by finite changes of the parameters. Where a model switches faster than its steps (the
/// current of a machine through its brushes, dry friction under noise), the tangents of the numerical solution grow at
/// each change of sign although the solution itself hardly moves: exact slopes of a staircase. Changes large enough to
/// show in the outputs step over it.
namespace analogon {

/// Whether the model has operations whose tangents may mislead.
bool maySwitch(const FitProblem& problem);

/// Root of the sum of the squares of all fitted data around their means, weighted as the residuals are.
double signalOf(const FitProblem& problem);

/// One hundredth of each value (a ten-thousandth of the range of its bounds, where it is 0), within its bounds; 0 where
/// they leave it no room.
Eigen::VectorXd visibleSteps(const FitProblem& problem, const Eigen::VectorXd& values);

/// As linearise(), the Jacobian by central differences over changes of about a hundredth of the signal. Adds up its
/// simulations but the first.
Linearisation lineariseByDifferences(const FitProblem& problem, const Eigen::VectorXd& values,
                                     const std::vector<GridPlan>& plans, const SimulationOptions& options,
                                     const Progress& progress, int& simulations);

}  // namespace analogon
