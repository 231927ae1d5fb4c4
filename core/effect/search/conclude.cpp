#include "core/effect/search/conclude.hpp"

#include <algorithm>
#include <cmath>

#include "core/effect/judge/judgement.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/exchange.hpp"
#include "core/effect/search/laws.hpp"
#include "core/effect/search/prune.hpp"
#include "core/effect/search/refine.hpp"
#include "core/effect/search/verdicts.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::conclude;
using threshold::acceptance::leastShare;

namespace {

/// Whether several effects explain much together of which none is missed much: a flexible sum of what bends alike
/// stands for something that has no name.
bool onlyImitate(const NullModel& base, const Node& node) {
    if (node.steps.size() < fewestOfImitation) return false;
    const double chi2Decrease = sumInUnitsOf(node.null, base) - node.null.sumOfSquares();
    return std::all_of(node.steps.begin(), node.steps.end(),
                       [&](const Step& s) { return s.chi2Decrease < leastShare * chi2Decrease; });
}

}  // namespace

double misfitIn(const NullModel& base, const NullModel& model) {
    const double rows = static_cast<double>(base.fit.optimum.residuals.size());
    return sumInUnitsOf(base, model) + model.parameterCount() * std::log(rows);
}

void takeOutAll(const SearchContext& search, Node& node, const NullModel& base, const Text& why) {
    for (const PlacedEffect& e : node.null.variant.effects)
        setVerdict(search, node, e, Verdict::NotSignificant, takenOut(why));
    node.steps.clear();
    node.null = base;
}

Conclusion conclude(SearchContext& search, Node& node, const NullModel& base, bool mayAddLaw) {
    const bool hasWeak = std::any_of(node.steps.begin(), node.steps.end(),
                                     [](const Step& s) { return !isBeyondDoubt(s.acceptance.evidence); });
    if (!isNoise(node.null) || hasWeak) removeUnneeded(search, node, 0, true);
    search.journal.model("conclude", node.null, "asked");
    if (onlyImitate(base, node))
        takeOutAll(search, node, base,
                   phrase("of several effects that explain much together none is missed: they only imitate it"));
    if (mayAddLaw && !isNoise(node.null) && !search.progress.stopRequested()) {
        const Node before = node;
        if (addLaw(search, node)) {
            removeUnneeded(search, node, 0, true);
            // beside a law a fit may end elsewhere, where what was needed seems not to be
            const bool isBetter = misfitIn(base, node.null) < misfitIn(base, before.null);
            search.journal.model("law beside names", node.null, isBetter ? "kept" : "taken back");
            if (!isBetter) node = before;
        }
    }
    // where a proposal explains all, what it made needless only imitated it
    const bool leavesMuch = reducedChi(node.null.fit) > largeResidual;
    if (leavesMuch) setAsideBehindProposal(search, node);
    if (!isNoise(node.null)) removeOutweighed(search, node, leastOfRest);
    const bool hadProposal = hasProposal(node.null);
    const double with = misfitIn(base, node.null), left = excess(node.null);
    const std::vector<PlacedEffect> beside = node.null.variant.effects;
    Conclusion conclusion = takeOutProposals(search, node);
    if (hadProposal) {
        if (leavesMuch) bringBackDisplaced(search, node, left);
        removeUnneeded(search, node, 0, true);  // what was seen only beside a proposal is not kept without it
        if (!isNoise(node.null))
            removeOutweighed(search, node, conclusion.proposed.empty() ? leastOfRest : leastBesideOffered);
    }
    unite(search, node);
    if (isNoise(node.null) || reducedChi(node.null.fit) > largeResidual) completeClasses(search, node);
    treatAlike(search, node);
    tellBesideNames(search, node, beside, conclusion);
    conclusion.leavesMuch = leavesMuch;
    conclusion.misfit = conclusion.proposed.empty() ? misfitIn(base, node.null) : with;
    search.journal.model("conclude", node.null, "concluded");
    return conclusion;
}

}  // namespace analogon
