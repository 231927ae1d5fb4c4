#pragma once

#include <vector>

#include "core/effect/block/law_probe.hpp"

namespace analogon {

/// Short laws that explain much of the residual to first order, for a flow that a node of the model lacks or for what a
/// sensor adds to its reading: single terms and the best pair of each place from powers, thresholds, waves and products
/// of the place's own quantities and of the inputs, states and outputs of the model. The coefficients carry the unit
/// that makes a term what is missing. What they are worth shows when they are fitted. Best first; the classes are
/// numbered on from `before`, the laws written already.
std::vector<Law> likelyLaws(const NullModel& null, int before, const SimulationOptions& simulation, int threads,
                            const Progress& progress);

}  // namespace analogon
