#pragma once

#include <vector>

#include "core/effect/block/screen.hpp"

namespace analogon {

/// Noise of a channel in which neighbouring samples say the same.
struct ColouredNoise {
    std::string output, experiment;
    double memory{};  // integrated correlation time [s]
};

/// Noise of a channel that comes and goes.
struct UnevenNoise {
    std::string output, experiment;
    double ratio{};  // of its standard deviation where it is strong to where it is weak
};

/// What a model leaves on its outputs.
struct Leftovers {
    std::vector<Remainder> structure;  // that noise does not explain
    // not white, and yet nothing else; only where there is no structure
    std::vector<ColouredNoise> noise;
    std::vector<UnevenNoise> uneven;

    bool isNoiseAlone() const { return structure.empty() && !(noise.empty() && uneven.empty()); }
};

/// What is left in the residual, channel by channel: with which measured or simulated quantity it moves (partial
/// correlation with the noise made white and the parameters' freedom taken out), and when it is strongest. What is
/// stationary, moves with nothing and shows on one channel alone is noise, of whatever colour; also what is so in units
/// of the noise near each sample, where that is stronger at times.
Leftovers leftovers(const NullModel& null, const SimulationOptions& simulation);

}  // namespace analogon
