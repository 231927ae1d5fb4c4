#pragma once

#include <vector>

#include "core/effect/finding.hpp"
#include "core/study/study.hpp"

namespace analogon {

/// What the recordings of a study hold of its outputs, as long as no model says anything of them: times within the
/// range that is used [s], and measured values in the unit of the file (NaN: not measured); nothing is simulated.
/// Recordings and columns that cannot be read are left out; estimationTask tells why.
std::vector<ExperimentState> measuredExperiments(const Study& study);

}  // namespace analogon
