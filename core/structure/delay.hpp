#pragma once

#include "core/structure/structure.hpp"

namespace analogon {

/// A delayed signal that is made of inputs, time and parameters alone, delay(f(u, t), T), becomes
/// f(delay(u, T), t - T): a delay of a measured input, which may act on states. delay(delay(u, T1), T2) becomes
/// delay(u, T1 + T2). Unknowns on the way are followed through their explicit blocks.
void delayInputsInstead(Structure& structure);

/// The Delay nodes that the blocks use, each once.
std::vector<ExpressionId> delaysOf(const Structure& structure);

}  // namespace analogon
