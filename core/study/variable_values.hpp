#pragma once

#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/study/study.hpp"

namespace analogon {

/// What the model says of some of its variables over one recording.
struct VariableValues {
    std::vector<double> time;                 // [s] of the samples, within the range that is used
    std::vector<std::vector<double>> values;  // of each variable that was asked for; NaN: none
};

/// Simulates one experiment of a study at the values it has (start values that are to be fitted at those that they
/// start from) and records variables of the flat model, of whatever kind, in their own units.
/// Faults: those of the study; there is no such experiment or variable; the simulation stopped.
Outcome<VariableValues> variableValues(const Study& study, const std::string& experiment,
                                       const std::vector<std::string>& names, const Progress& progress = {});

}  // namespace analogon
