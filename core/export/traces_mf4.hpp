#pragma once

#include <vector>

#include "core/effect/catalogue/finding.hpp"
#include "core/export/mf4_file.hpp"
#include "core/fit/estimation_task.hpp"

namespace analogon {

/// What was measured, what the model says, and the difference, a group each of every experiment; with the inputs as the
/// model gets them beside what was measured. A sample at which an output was not measured is NaN.
Outcome<std::vector<Mf4Group>> tracesOf(const ModelState& state, const EstimationTask& task);

}  // namespace analogon
