#pragma once

#include <optional>
#include <vector>

#include "core/effect/judge/node.hpp"

/// Equations without a name are offered and not added: the model ends without them.
namespace analogon {

class SearchContext;

/// What the end of a path comes to.
struct Conclusion {
    std::vector<Remainder> proposed;  // equations without a name
    std::optional<NullModel> with;    // the model with them; empty: there are none
    std::optional<ProposedModel> model;
    std::vector<Text> sameByName;  // effects that explain as much as one of these
    bool leavesMuch{};             // even with them
    double misfit{};               // with them
};

/// Proposals explain while the search goes on and are offered, not added: the model ends without them. What leaves
/// structure is offered only where it is more than a disturbance.
Conclusion takeOutProposals(SearchContext& search, Node& node);

/// Proposals are told as they are beside the names that are left; `before`: all effects when they were taken out.
void tellBesideNames(const SearchContext& search, const Node& node, const std::vector<PlacedEffect>& before,
                     Conclusion& conclusion);

/// What was chosen beside a proposal may only mend the proposal: it is taken out, to be looked at again without it.
/// What explains far more than all that is left does not.
void setAsideBehindProposal(SearchContext& search, Node& node);

/// Without the proposals, the named effects that they had made needless: each is kept if it is missed now. It only
/// imitates the proposals where it explains little against what is left, or leaves far more than they did.
void bringBackDisplaced(SearchContext& search, Node& node, double leftByProposals);

}  // namespace analogon
