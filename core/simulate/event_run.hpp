#pragma once

#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/base/progress.hpp"
#include "core/eval/system.hpp"
#include "core/structure/hybrid.hpp"

namespace analogon {

/// What a simulation of a class by itself runs over.
struct EventRunOptions {
    double start{0}, stop{1};  // [s]
    double interval{};         // of what is told; 0: a 500th of the whole
    double tolerance{1e-6};    // relative; absolute is that times a state's nominal value
    std::size_t mostEvents{1'000'000};
    double secondsLimit{600};  // of the clock
};

/// All that was asked for, at the grid and on both sides of each event.
struct EventTrajectory {
    std::vector<double> time;
    std::vector<std::vector<double>> rows;  // by time: one value a name
    std::vector<Diagnostic> remarks;        // assertions that warn
    long steps{}, events{};
};

/// Simulates a model with events: integration (CVODES) with the discrete quantities held, roots located; at an event
/// the discrete quantities are iterated to rest, pre(z) = z (Modelica 3.6, appendix B).
Outcome<EventTrajectory> simulateWithEvents(const HybridModel& model, const System& system,
                                            const std::vector<std::string>& names, const EventRunOptions& options,
                                            const Progress& progress = {});

}  // namespace analogon
