#pragma once

namespace analogon {

/// Beside others a channel of a weight beyond these counts for nothing, or for all: their squares are added up.
inline constexpr double leastWeight = 1e-6, mostWeight = 1e6;

/// Whether an output can have this weight in a fit; 0 leaves it out.
inline bool isWeight(double weight) { return weight == 0 || (weight >= leastWeight && weight <= mostWeight); }

}  // namespace analogon
