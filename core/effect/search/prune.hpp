#pragma once

#include "core/effect/judge/node.hpp"

/// Takes effects out again that the model does not miss.
namespace analogon {

class SearchContext;

/// Whether what is left is noise, of which a part has a memory; where a record is too short to tell, it is not.
bool isColouredNoise(const SearchContext& search, const NullModel& null);

/// The error that is left without the effect of a step, by the model refitted without it.
void tellErrorWithout(const SearchContext& search, Step& step, const NullModel& without);

/// Takes each effect out again and keeps only those that are missed. As many as there are threads are judged at once;
/// what was judged beside one that is taken out is judged anew.
void removeUnneeded(SearchContext& search, Node& node, std::size_t least, bool isLast = false);

/// Takes out the names that explain little against what is left beside them, least first: the others are judged without
/// it.
void removeOutweighed(SearchContext& search, Node& node, double share);

/// Of the last refit, an effect whose strength as it would be reported is not distinguishable from 0 is taken out of
/// the model of the search; false: there is none.
bool dropIndistinct(SearchContext& search, const NullModel& last, const ModelState& state, Node& node);

/// Means of neighbouring samples blur what is faster than they are, and an effect can mend just that. On all samples
/// each must be missed as well; true: one was not, and is taken out of the model of the search.
bool dropUnmissed(SearchContext& search, const NullModel& last, Node& node);

}  // namespace analogon
