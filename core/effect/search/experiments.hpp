#pragma once

#include "core/effect/judge/node.hpp"
#include "core/effect/tell/next_experiment.hpp"

/// Experiments that would tell effects apart.
namespace analogon {

class SearchContext;

/// What an experiment would say about two effects (`names`): how far apart they would be, or that another quantity has
/// to be measured.
Text whatItTells(const ProposedExperiment& next, const Text& names);

/// For effects of which the recordings leave open what they are: what to run next, and how far that would tell.
Text proposeExperiments(SearchContext& search, const Node& node);

}  // namespace analogon
