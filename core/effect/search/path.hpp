#pragma once

#include <vector>

#include "core/effect/judge/node.hpp"
#include "core/effect/search/round.hpp"

/// Effects added one after the other: what is missed stays, what came second is tried again beside the others.
namespace analogon {

class SearchContext;

/// Whether so much evidence is no more than the forms of the effects may be wrong by.
bool isWithinForms(const Node& node, double evidence);

/// Adds one effect a round until nothing passes its tests. The first round is given.
void goOn(SearchContext& search, Node& path, Round first);

/// The path that begins with another of the first trials.
Node pathFrom(SearchContext& search, const NullModel& base, Round round, std::size_t begin);

/// What predicts clearly better beside the model as given, or else is likelier than a flow alone that nobody measured,
/// of the first round: kept in the frontier, for the last pass and for a search that is interrupted.
void seekLikeliest(SearchContext& search, const NullModel& base, const Round& first);

/// The path before its first choice, with what was tried.
Node bareOf(SearchContext& search, const NullModel& base, Round first, const Text& why);

}  // namespace analogon
