#pragma once

#include "core/fit/fit.hpp"

namespace analogon {

/// Latin hypercube (McKay et al. 1979) over the bounds, or about the start: start s of dimension i lies in its own
/// stratum. The first start is the problem's own. Each depends on the seed and its index alone.
std::vector<Eigen::VectorXd> startsOf(const FitProblem& problem, const FitOptions& options);

struct StartsElsewhere {
    std::vector<Eigen::VectorXd> starts;
    int simulations{}, failedSimulations{};
};

/// Start values within the bounds from which the model can be simulated, of FitOptions::otherStarts that are looked at:
/// a few, those with the least misfit first.
StartsElsewhere startsElsewhere(const FitProblem& problem, const FitOptions& options, const Progress& progress);

}  // namespace analogon
