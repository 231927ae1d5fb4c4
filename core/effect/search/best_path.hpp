#pragma once

#include <optional>
#include <vector>

#include "core/effect/judge/node.hpp"
#include "core/effect/search/round.hpp"

/// Where a search may begin, and which of its ends is the best.
namespace analogon {

class SearchContext;

/// Whether nothing is left to find: noise alone behind no more than so many named effects.
bool isExplained(const Node& path, std::size_t most);

/// Where the first choices leave structure, the search begins again with what came next: two effects that hide each
/// other may not show in the order of their size. Several effects may only imitate what has no name: a short law that
/// leaves next to nothing is the better account.
Outcome<Node> bestPathFrom(SearchContext& search, NullModel& base);

}  // namespace analogon
