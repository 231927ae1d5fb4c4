#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/fit/fit.hpp"
#include "core/fit/reduced_misfit.hpp"

/// A long record tells most of what it tells by a tenth of it: least squares goes most of the way on that tenth, and
/// passes over all of it only for the rest (the growing sample of Friedlander & Schmidt, SIAM J. Sci. Comput. 34,
/// 2012).
namespace analogon {

struct PartialRecords {
    FitProblem problem;
    bool isThinned{};             // else their heads
    std::vector<GridPlan> plans;  // of thinned ones, for a fit that is far from its optimum
};

/// Every tenth sample where the inputs and the solution move so slowly that it sees them all; else the first tenth of
/// each record (what is simulated costs, not what is compared). Nothing: the records are short, or something asks for
/// all of them (robust losses, priors, clocks, models that switch, limited trials, the adaptive engine).
std::optional<PartialRecords> partOf(const FitProblem& problem, const Eigen::VectorXd& start, const FitOptions& options,
                                     const Progress& progress = {});

/// What serves on every tenth sample serves on all: the plans of all records, one step from sample to sample.
std::vector<GridPlan> plansFromThinned(const FitProblem& problem, const std::vector<GridPlan>& thinned,
                                       const Eigen::VectorXd& values, const Progress& progress = {});
/// Whether they are of that kind.
bool areSingleSteps(const std::vector<GridPlan>& plans);

/// Whether a part determines every parameter there, inside its bounds: what it does not show must not run away.
bool determinesAll(const FitProblem& part, const Eigen::VectorXd& values, const ReducedMisfit& there);

/// Whether the model misses all samples by hardly more than those of the part: they tell the same.
bool tellTheSame(const FitProblem& problem, double cost, const FitProblem& part, double costOfPart);

}  // namespace analogon
