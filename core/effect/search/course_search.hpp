#pragma once

#include "core/effect/search/round.hpp"

/// Parameters that change, in mid run or with a recorded channel, beside what the search for effects comes to.
namespace analogon {

class SearchContext;

/// A parameter that changed in mid run is imitated by many slow effects; none of them is it.
void seekChange(SearchContext& search, const NullModel& base);

/// Whether one change leaves noise alone and is a better account than these effects, by so much evidence.
bool isChangeAll(SearchContext& search, const NullModel& base, const NullModel& with,
                 double leastGain = equivalenceMargin);

/// Whether one change leaves noise alone where the effect that the first round chose leaves far too much for it to be
/// half of a pair: none is added to it then.
bool isChangeAlone(SearchContext& search, const NullModel& base, const Round& first);

/// Keeps the better of the changes where it is a better account than the effects that were found.
void settleChange(SearchContext& search, const NullModel& base, const NullModel& with);

}  // namespace analogon
