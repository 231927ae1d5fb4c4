#pragma once

#include "core/fit/fit.hpp"

namespace analogon {

/// "R", or "h0 of 'cold start'" where it belongs to one experiment.
Text fittedName(const FitProblem& problem, const FitParameter& p);

/// Of a fit that failed on its way: which parameters it has taken how far, in its message. One that could not even
/// begin is left as it is.
void tellFailure(const FitProblem& problem, const Eigen::VectorXd& begin, FitResult& result);

}  // namespace analogon
