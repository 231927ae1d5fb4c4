#pragma once

#include "core/fit/fit.hpp"

namespace analogon {

/// Whether an experiment has parameters of its own (start values that are to be fitted).
bool hasOwnParameters(const FitProblem& problem, int experiment);

/// The parameters of one experiment alone, estimated from it alone; all others are held at `values`. The estimates
/// are numbered as in the problem.
FitResult fitOwnParameters(const FitProblem& problem, int experiment, const Eigen::VectorXd& values,
                           const FitOptions& options = {}, const Progress& progress = {});

}  // namespace analogon
