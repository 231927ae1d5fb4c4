#pragma once

#include "core/effect/judge/node.hpp"

/// The best path beside what turns out to be wrong with the recordings.
namespace analogon {

class SearchContext;

/// What the best path ends with. A record that was cut out of a longer one begins where the model does not: what is
/// made up for that is held against the same beside states that are fitted there.
Outcome<Node> bestPath(SearchContext& search, NullModel& base);

}  // namespace analogon
