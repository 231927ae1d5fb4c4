#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/eval/system.hpp"
#include "core/flat/flat_model.hpp"
#include "core/library/library.hpp"
#include "core/simulate/event_run.hpp"

/// A class by itself, without a recording: simulated with its events over the time that it says itself.
namespace analogon {

/// StartTime, StopTime, Interval and Tolerance of the annotation `experiment` (Modelica 3.6, section 18.4); those of
/// the nearest base where the class has none. Without any, 0 … 1 s.
EventRunOptions experimentOf(const Library& library, const LibraryClass& cls);

/// Every number of the model that changes in time, and the slopes of its states, "der(x)".
std::vector<std::string> tracedNames(const FlatModel& model, const System& system);

struct ClassRun {
    std::vector<std::string> names;  // of the columns of the trajectory
    EventTrajectory trajectory;
    int states{};
    double interval{};  // [s] between the rows
};

/// With more than `mostValues` values the rows are further apart than is asked for, as long as there are 2500.
/// Faults: the equations cannot be ordered or compiled; the time ends before it begins; the simulation stops.
Outcome<ClassRun> runAlone(const FlatModel& model, const std::function<std::vector<std::string>(const System&)>& wanted,
                           const EventRunOptions& options, const Progress& progress = {},
                           std::size_t mostValues = std::numeric_limits<std::size_t>::max());

}  // namespace analogon
