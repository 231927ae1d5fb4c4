#pragma once

#include <vector>

#include "core/effect/judge/node.hpp"

/// Effects that are indicated: structure remains beside them, and with them the model foretells clearly better what it
/// was not fitted to.
namespace analogon {

class SearchContext;

/// Adds such names to the end of a search, each refitted with all parameters. They are sought one by one beside the
/// node, and among the names with which paths ended (`ends`, before anything was taken out of them); of what comes of
/// both, what predicts best stays. Where noise is left, or nothing predicts clearly better, the node stays as it is.
/// One effect that, beside a flow, is clearly likelier as the only one of the model as given (`base`) takes its place.
void indicate(SearchContext& search, const NullModel& base, Node& node, const std::vector<Node>& ends);

}  // namespace analogon
