#pragma once

#include "core/effect/judge/node.hpp"

/// Experiments that would tell effects apart.
namespace analogon {

class SearchContext;

/// For effects of which the recordings leave open what they are: what to run next, and how far that would tell.
Text proposeExperiments(SearchContext& search, const Node& node);

}  // namespace analogon
