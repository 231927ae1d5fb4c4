#pragma once

#include "core/effect/search/proposals.hpp"

/// The end of a path: all is taken out of it that is not missed, or no more than a disturbance.
namespace analogon {

class SearchContext;

/// What a model leaves, in units of the noise of the model as given, and what its parameters cost (BIC).
double misfitIn(const NullModel& base, const NullModel& model);

/// Back to the model without effects.
void takeOutAll(const SearchContext& search, Node& node, const NullModel& base, const Text& why);

/// Takes out of what a path ends with all that is not missed, or no more than a disturbance, and the equations without
/// a name, which are returned.
Conclusion conclude(SearchContext& search, Node& node, const NullModel& base, bool mayAddLaw);

}  // namespace analogon
