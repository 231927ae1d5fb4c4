#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/eval/event_parts.hpp"
#include "core/flat/flat_model.hpp"
#include "core/simulate/event_run.hpp"

/// A class by itself, from its text to its trajectory.
namespace analogon::test {

struct Simulated {
    Diagnostics faults;
    std::vector<std::string> names;
    EventTrajectory trajectory;

    /// The last value at this time or before.
    double at(double time, const std::string& name) const {
        const auto column = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
        double value = std::nan("");
        for (std::size_t k = 0; k < trajectory.time.size() && trajectory.time[k] <= time + 1e-12; ++k)
            value = trajectory.rows[k].at(column);
        return value;
    }
    double last(const std::string& name) const { return at(1e300, name); }
};

/// The class M of a text, over some seconds.
inline Simulated runOf(const std::string& text, std::vector<std::string> names, double stop = 1,
                       double tolerance = 1e-8) {
    Simulated run;
    run.names = names;
    const auto library = Library().withSource(std::make_shared<const Source>("m.mo", text));
    if (!library) return run.faults = library.diagnostics(), run;
    const Outcome<FlatModel> flat = flatten(*library, "M");
    if (!flat) return run.faults = flat.diagnostics(), run;
    const Outcome<HybridModel> hybrid = partition(*flat);
    if (!hybrid) return run.faults = hybrid.diagnostics(), run;
    const Outcome<SystemPtr> system = systemBetween(*hybrid);
    if (!system) return run.faults = system.diagnostics(), run;
    EventRunOptions options;
    options.stop = stop;
    options.tolerance = tolerance;
    Outcome<EventTrajectory> done = simulateWithEvents(*hybrid, **system, names, options);
    if (!done) return run.faults = done.diagnostics(), run;
    run.trajectory = std::move(*done);
    return run;
}

#define ASSERT_RAN(run) ASSERT_TRUE((run).faults.empty()) << format((run).faults)

}  // namespace analogon::test
