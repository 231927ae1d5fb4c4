#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/study/run.hpp"
#include "core/study/variable_values.hpp"

/// The model of a study by itself, without a recording: its inputs come from sources within it.
namespace analogon {

/// What stands for a recording in the result: "Simulation", with a number where a recording is called so.
std::string freeRunName(const Study& study);

/// When the simulation ends that the annotation `experiment` of the model asks for [s]; 1 where it says nothing.
double freeRunStop(const Library& library, const std::string& className);

/// Simulates the model at its present values until `stop` [s] (none: as freeRunStop() says), with its events. The
/// result has one experiment, freeRunName(), that only validates: the outputs of the model, or, where it has none, its
/// states; nothing is measured of them (NaN). Before and behind an event both values are there, at one time.
/// Faults: those of the model; each input that nothing drives; the simulation stops, or its end is not after its start.
Outcome<RunResult> runFreely(const Study& study, std::optional<double> stop, const RunOptions& options,
                             const Progress& progress = {});

/// A run over recordings with that of the model by itself in front.
RunResult withFreeRun(RunResult recorded, const RunResult& free);

/// The same for variables of whatever kind, in their own units. Fault beside those: there is no such variable.
Outcome<VariableValues> freeVariableValues(const Study& study, std::optional<double> stop,
                                           const std::vector<std::string>& names, const Progress& progress = {});

}  // namespace analogon
