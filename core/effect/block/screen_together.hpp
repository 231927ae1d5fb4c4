#pragma once

#include <vector>

#include "core/effect/block/screen.hpp"

namespace analogon {

/// Candidates that are screened in one model, by their indices: of one class, in components or at their connectors,
/// with no states of their own. Switched off they do nothing to each other, so that one model that holds them all,
/// prepared once, gives the traces that each has by itself: the slopes of all at strength 0 in one simulation, the
/// secants in one each. Every other candidate is alone.
std::vector<std::vector<std::size_t>> screenedTogether(const std::vector<Candidate>& candidates);

/// The same as screen() of each, in one model where that can be simulated and has no states more than without them, in
/// several where it has: those whose own states they are by themselves, or the halves.
std::vector<Screened> screenTogether(const NullModel& null, const std::vector<Candidate>& candidates,
                                     const SimulationOptions& simulation, const Progress& progress);

}  // namespace analogon
