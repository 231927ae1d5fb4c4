#include "core/effect/search/beside_flow.hpp"

#include <algorithm>

#include "core/effect/judge/disturbance.hpp"
#include "core/effect/judge/judgement.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/search/contenders.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/flow_ranking.hpp"
#include "core/effect/search/trials.hpp"
#include "core/effect/search/verdicts.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using threshold::acceptance::clearEvidence;
using threshold::prediction::nearlyAsWell;

namespace {

/// The simplest of the names that are as likely as the likeliest, with these as its class. False where none is clear,
/// or where an equation without a name is far likelier.
bool choose(const SearchContext& search, const NullModel& null, const std::vector<LikelyTrial>& likely, Round& round) {
    const auto named = std::find_if(likely.begin(), likely.end(),
                                    [&](const LikelyTrial& l) { return !isProposal(round.trials[l.trial]); });
    if (named == likely.end() || !(named->evidence > clearEvidence) ||
        named->evidence < nearlyAsWell * likely.front().evidence)
        return false;
    std::vector<std::size_t> members;
    for (auto l = named; l != likely.end() && named->evidence - l->evidence < equivalenceMargin; ++l)
        if (!isProposal(round.trials[l->trial])) members.push_back(l->trial);
    round.chosen = *std::min_element(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
        return simplicity(round.trials[a]) < simplicity(round.trials[b]);
    });
    round.members = std::move(members);
    round.acceptance = examine(search, null, round.trials[*round.chosen], round.threshold);
    round.refused.behind =
        phrase("less likely than {} beside a flow that nobody measured", nameOf(round.candidate(*round.chosen)));
    return true;
}

}  // namespace

LikeliestBesideFlow withLikeliestBesideFlow(SearchContext& search, const Node& node, Round& round) {
    const std::vector<LikelyTrial> likely = rankedBesideFlow(search, node.null, round.trials);
    if (search.progress.stopRequested()) return {};
    for (const LikelyTrial& l : likely) {
        const Candidate& c = round.candidate(l.trial);
        search.journal.add("beside disturbance", keyOf(c.effect, c.place), {{"delta_bic", -l.evidence}}, "ranked");
    }
    LikeliestBesideFlow found{{}, !likely.empty() && likely.front().evidence > clearEvidence};
    if (!choose(search, node.null, likely, round)) return found;
    Prediction chosen;
    chosen.besideFlow = likely.front().evidence;
    found.node = withChoice(search, node, round, chosen);
    if (found.node) noteAll(search, *found.node, round);
    return found;
}

std::optional<Node> likelierThan(const SearchContext& search, const NullModel& base, const Node& node) {
    const SoughtFirst& first = search.frontier.best.first;
    if (node.steps.empty() || isNoise(node.null) || !first.node || !first.isBeside(base)) return std::nullopt;
    const Node& one = *first.node;
    const bool isOfFlow = one.steps.back().prediction && one.steps.back().prediction->besideFlow;
    if (!isOfFlow || hasEffect(node.null.variant.effects, one.null.variant.effects.front())) return std::nullopt;
    const auto besideFlow = [&](const Node& of) -> std::optional<BesideDisturbance> {
        const Outcome<NullModel> model =
            fitNull(of.null.variant, base.noise, NoiseLevel::Keep, search.fit, search.progress);
        if (!model || model->fit.optimum.residuals.size() != base.fit.optimum.residuals.size()) return std::nullopt;
        return besideDisturbance(*model, search.fit.simulation, search.progress);
    };
    const std::optional<BesideDisturbance> own = besideFlow(node), other = besideFlow(one);
    if (!own || !other || search.progress.stopRequested()) return std::nullopt;
    const int more = one.null.parameterCount() - node.null.parameterCount();
    const double evidence = evidenceBeside(*own, *other, base.fit.optimum.residuals.size(), more);
    const bool isLikelier = evidence > clearEvidence;
    search.journal.model("beside disturbance", node.null, isLikelier ? "less likely than one effect" : "likelier");
    return isLikelier ? std::optional(one) : std::nullopt;
}

}  // namespace analogon
