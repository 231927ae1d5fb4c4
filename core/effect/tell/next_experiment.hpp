#pragma once

#include <optional>
#include <string>

#include "core/effect/block/trial.hpp"

namespace analogon {

/// A programme of one input after which two models would differ.
struct ProposedExperiment {
    Text programme;       // in words: "input v as a slow ramp from 0 V to 12 V and back over 20 s"
    double separation{};  // of the rival refitted to it, in standard deviations
};

/// Of the inputs that moved in the recordings, within the range they had there: the programme that the rival, adjusted
/// as well as it can be without leaving the recordings at hand, explains worst when the chosen model is true
/// (T-optimality: Atkinson & Fedorov 1975, Biometrika 62; the adjustment to first order). Length, sampling, sensors and
/// their noise are those of the first fitted recording. Nothing when no programme could be simulated.
std::optional<ProposedExperiment> nextExperiment(const NullModel& chosen, const Trial& rival,
                                                 const SimulationOptions& simulation, const Progress& progress);

}  // namespace analogon
