#pragma once

#include "core/simulate/simulate.hpp"

namespace analogon {

/// Runs a system with events of its own (System::events) over an experiment, with exact tangents; where what it delays
/// has none, they are differences. `result` has its sizes and holds NaN; what is reached is filled in.
void runWithEvents(const SimulationTask& task, const SimulationOptions& options, const Progress& progress,
                   Trajectory& result);

}  // namespace analogon
