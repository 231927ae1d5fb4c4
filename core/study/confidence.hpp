#pragma once

#include <string>
#include <vector>

#include "core/effect/catalogue/finding.hpp"

namespace analogon {

/// A fault for each of these names that is not fitted in the task; "all" stands for every one.
Diagnostics checkProfiled(const EstimationTask& task, const std::vector<std::string>& names);

/// Adds to the estimates of a fitted model what they are worth beyond their standard errors: errors robust to
/// correlated residuals and, for the parameters named (or "all"), the interval of the profile. Where the model cannot
/// be fitted again, or it is stopped before, the estimates stay as they are.
void addConfidence(const EstimationTask& task, const std::vector<std::string>& profiled, const FitOptions& options,
                   ModelState& state, const Progress& progress = {});

}  // namespace analogon
