#pragma once

#include <vector>

#include "core/effect/screen.hpp"

namespace analogon {

/// Noise of a channel in which neighbouring samples say the same.
struct ColouredNoise {
    std::string output, experiment;
    double memory{};  // integrated correlation time [s]
};

/// What a model leaves on its outputs.
struct Leftovers {
    std::vector<Remainder> structure;  // that noise does not explain
    std::vector<ColouredNoise> noise;  // not white, and yet nothing else; only where there is no structure
};

/// What is left in the residual, channel by channel: with which measured or simulated quantity it moves (partial
/// correlation with the noise made white and the parameters' freedom taken out), and when it is strongest. What is
/// stationary, moves with nothing and shows on one channel alone is noise, of whatever colour.
Leftovers leftovers(const NullModel& null, const SimulationOptions& simulation);

}  // namespace analogon
