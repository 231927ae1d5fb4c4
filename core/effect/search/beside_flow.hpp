#pragma once

#include <optional>

#include "core/effect/judge/node.hpp"
#include "core/effect/search/round.hpp"

/// Effects that are likelier than a flow alone that nobody measured.
namespace analogon {

class SearchContext;

struct LikeliestBesideFlow {
    /// Empty: none is clearly likelier than the flow alone, or an equation without a name is by far.
    std::optional<Node> node{};
    bool isAnyClear{};  // of the trials, names and equations
};

/// A node with that trial of a round which, refitted, is likeliest beside a flow that nobody measured. Such a flow
/// drives the parameters of a least-squares fit astray, and what explains most by it is then another effect than what
/// is there; by likelihood, with the flow as part of the noise (`Disturbance`), the effects come into their order.
/// The round's choice is the node's new effect then.
LikeliestBesideFlow withLikeliestBesideFlow(SearchContext& search, const Node& node, Round& round);

/// What was found beside a flow as the one effect of the model as given (`base`), where it is clearly likelier beside
/// its flow than all the effects of a node beside theirs: least squares may have begun that with another one. Nothing:
/// it is not, or was not sought, or the node has that effect.
std::optional<Node> likelierThan(const SearchContext& search, const NullModel& base, const Node& node);

}  // namespace analogon
