#pragma once

#include <vector>

#include "core/effect/block/screen.hpp"

namespace analogon {

/// Candidates that are screened in one model, by their indices: of one class, joined to nodes, and shown by their slope
/// at strength 0 alone. Switched off they do nothing to each other, so that one model that holds them all, prepared and
/// simulated once, gives the traces that each has by itself. Every other candidate is alone.
std::vector<std::vector<std::size_t>> screenedTogether(const std::vector<Candidate>& candidates);

/// The same as screen() of each, in one model where that can be simulated and has no states more than without them.
std::vector<Screened> screenTogether(const NullModel& null, const std::vector<Candidate>& candidates,
                                     const SimulationOptions& simulation, const Progress& progress);

}  // namespace analogon
