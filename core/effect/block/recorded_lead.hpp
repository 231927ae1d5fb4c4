#pragma once

#include <optional>
#include <vector>

#include "core/effect/model/null_model.hpp"

namespace analogon {

/// By how much a variable was ahead of its simulation at the samples of each fitted experiment, where an output tells
/// it: one that is proportional to it, or to its rate (an angle beside a recorded speed). `simulated`: the variable,
/// one row of samples per experiment of `problem`, which has the outputs of the model. Nothing: no output tells it.
std::optional<std::vector<Eigen::VectorXd>> recordedLead(const NullModel& null, const FitProblem& problem,
                                                         const std::vector<Eigen::VectorXd>& simulated);

}  // namespace analogon
