#pragma once

#include <optional>
#include <vector>

#include "core/effect/block/trial.hpp"

/// Trials of a round in the order of their evidence beside a flow that nobody measured, as a part of the noise.
namespace analogon {

class SearchContext;

/// A trial, and the evidence for it [BIC] beside the flow that is likeliest with it.
struct LikelyTrial {
    std::size_t trial{};
    double evidence{};
};

/// The first few that are clearly likelier than the model without them, the best first, with flow and parameters where
/// they are likeliest.
std::vector<LikelyTrial> rankedBesideFlow(const SearchContext& search, const NullModel& null,
                                          const std::vector<Trial>& trials);

/// The likeliest of `rivals` (places among the trials), where it is clearly likelier than one of them, `than`; else
/// nothing.
std::optional<std::size_t> clearlyLikelier(const SearchContext& search, const NullModel& null,
                                           const std::vector<Trial>& trials, const std::vector<std::size_t>& rivals,
                                           std::size_t than);

}  // namespace analogon
