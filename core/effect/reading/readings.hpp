#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/effect/model/thin.hpp"
#include "core/effect/reading/faulty_sample.hpp"
#include "core/effect/reading/input_clock.hpp"
#include "core/effect/reading/input_noise.hpp"
#include "core/effect/reading/likeliest_edges.hpp"
#include "core/effect/reading/start_value.hpp"

/// How the recordings are read: what was found wrong with them, and the study's task with that.
namespace analogon {

/// Inputs that do not run as they are recorded: late columns, jumps between two samples.
struct RedrawnInputs {
    std::vector<InputClock> clocks{};
    std::vector<InputEdge> edges{};
    Recordings stamped{};     // of the searched task, as they are without the clocks
    Recordings asRecorded{};  // of the full task, as they are without either; empty: nothing is redrawn
    std::optional<std::pair<double, double>> errorsOnTime{};  // [%] with both: fitted, validated (negative: none)
};

struct Readings {
    Variant searched;  // what the search works with: shortened by `thinning`
    Variant full;      // on every sample: what is reported
    Thinning thinning{};
    std::vector<FaultySamples> faults{};
    std::vector<ToldStart> freedStarts{};   // that were told wrongly
    std::vector<ToldStart> checkStarts{};   // estimated from recordings that only validate
    std::vector<NoisyInput> noisyInputs{};  // that the searched task has without their noise
    RedrawnInputs drawn{};
    bool takesAsGiven{};  // no recording is to be redrawn

    /// Those of the search before clocks were set or jumps placed.
    const Recordings& recordingsAsGiven() const { return drawn.edges.empty() ? drawn.stamped : drawn.asRecorded; }
    void takeRecordingsAsGiven() {
        searched.task.recordings = recordingsAsGiven();
        full.task.recordings = drawn.asRecorded;
        drawn.asRecorded.clear();
        drawn.clocks.clear();
        drawn.edges.clear();
    }
};

/// A model with all that is read on every sample, at its values.
inline Outcome<Variant> onAllSamples(const Readings& readings, const NullModel& null) {
    return withEffects(readings.full, null.variant.effects, null.variant.values);
}

}  // namespace analogon
