#pragma once

#include <optional>
#include <vector>

#include "core/effect/judge/node.hpp"
#include "core/effect/search/round.hpp"

/// Where a search may begin, and which of its ends is the best.
namespace analogon {

class SearchContext;

/// Whether so many other beginnings, or the work of all trials so far (steps), are enough; the first is always tried.
bool isEnoughTried(std::size_t beginnings, double work);

/// Whether a model is near enough to its recordings for two effects that hide each other to show in its slopes: by what
/// it leaves in units of the noise, or by the error [%] that the search has come to.
bool isNearEnoughForPairs(double reducedChi, double errorPercent);

/// Whether a model leaves so little above the noise that another path would hardly find something.
bool leavesLittle(const NullModel& null);

/// Whether nothing is left to find: noise alone behind no more than so many named effects.
bool isExplained(const Node& path, std::size_t most);

/// Where the first choices leave structure, the search begins again with what came next: two effects that hide each
/// other may not show in the order of their size. Several effects may only imitate what has no name: a short law that
/// leaves next to nothing is the better account.
Outcome<Node> bestPathFrom(SearchContext& search, NullModel& base);

}  // namespace analogon
