#pragma once

#include "core/effect/judge/node.hpp"

/// What the newest effects are drawn like, once they are chosen.
namespace analogon {

class SearchContext;

/// Whether the data ask for a form that is drawn sharper: by the sums of squares with the form as it was, and sharper.
bool isBetterSharp(double before, double sharper);

/// What the newest effect rounds off for the sake of the integration (the change of sign of a friction, the corner of a
/// limit) is drawn sharper as long as the data ask for it: the rest would pass for an effect of its own.
void sharpen(SearchContext& search, Node& node);

/// Where much is left that nothing explains, a channel that shows an effect of its sensor clearly and one of the same
/// kind that does not are more likely two equal sensors than two different ones: the effect is put in front of both,
/// with the same parameters, unless the data speak against it. So are two inputs that feed the same kind of block.
void treatAlike(SearchContext& search, Node& node);

}  // namespace analogon
