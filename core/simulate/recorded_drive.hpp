#pragma once

#include <functional>
#include <vector>

#include "core/simulate/event_run.hpp"
#include "core/simulate/event_tangents.hpp"
#include "core/simulate/recorded_signals.hpp"

namespace analogon {

/// What a run of a model with events beside a recording has more than that of a class by itself: signals that drive it,
/// parameters, tangents, and samples that are looked at.
struct RecordedDrive {
    RecordedSignals signals;
    std::vector<double> parameters{};  // of the system; those of slots are not looked at
    EventTangents* tangents{};         // null: none
    double reached{};                  // [s] where the run stands
    bool isCancelled{}, isTooLong{};
    /// Sees each sample; `outputs` are those of the system. False: something has no value.
    std::function<bool(int sample, const EventPoint& point, Workspace& workspace, const std::vector<double>& outputs)>
        take{};
};

/// A run from the first sample to the last. At a sample at which something jumps, what is behind the jump is seen.
/// Faults: as simulateWithEvents().
Outcome<EventTrajectory> simulateRecorded(const HybridModel& model, const System& system, RecordedDrive& drive,
                                          const EventRunOptions& options, const Progress& progress);

}  // namespace analogon
