#pragma once

#include <vector>

#include "core/effect/screen.hpp"

namespace analogon {

/// What is left in the residual that noise does not explain, channel by channel: with which measured or simulated
/// quantity it moves (partial correlation with the noise made white and the parameters' freedom taken out), and
/// when it is strongest. Empty: nothing is left.
std::vector<Remainder> remainders(const NullModel& null, const SimulationOptions& simulation);

}  // namespace analogon
