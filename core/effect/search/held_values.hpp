#pragma once

#include <map>
#include <vector>

#include "core/effect/tell/added_effects.hpp"

/// Values of held parameters that explain as much as an effect, or more than all of them.
namespace analogon {

class SearchContext;

/// Values of held parameters that would explain as much as an effect.
HeldValues heldValues(SearchContext& search, const Node& node);

/// Other values of held parameters, the best and what the data do not tell from it, where they explain clearly more
/// than the one effect that was found, which only imitates them and is taken out; or all that is left, where nothing
/// was found.
std::vector<HeldInstead> takeOutForHeld(SearchContext& search, Node& node, const HeldValues& held);

/// One value that leaves no more than several effects, or one beside inputs that are late or jump between their
/// samples, is the simpler account of it. Such inputs alone are met more often than wrong values: it must leave clearly
/// less.
std::vector<HeldInstead> takeOutAllForHeld(SearchContext& search, Node& node, const NullModel& base);

}  // namespace analogon
