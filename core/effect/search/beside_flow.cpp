#include "core/effect/search/beside_flow.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/effect/judge/disturbance.hpp"
#include "core/effect/judge/judgement.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/model/sampling.hpp"
#include "core/effect/search/contenders.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/trials.hpp"
#include "core/effect/search/verdicts.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using threshold::acceptance::clearEvidence;
using threshold::prediction::mostTries;
using threshold::prediction::nearlyAsWell;

namespace {

constexpr std::size_t oneFlow = 1;  // beside which trials are ranked; the chosen one is asked beside all there are

/// A trial, and the evidence for it beside a flow that nobody measured.
struct LikelyTrial {
    std::size_t trial{};
    double evidence{};
};

bool isLikelierThan(const LikelyTrial& a, const LikelyTrial& b) { return a.evidence > b.evidence; }

/// Trials of which the evidence beside a flow is asked, the best first; flow and parameters follow to first order.
std::vector<LikelyTrial> toFirstOrder(const SearchContext& search, const NullModel& null,
                                      const std::vector<Trial>& trials) {
    const double interval = samplingInterval(null.variant.task);
    const auto mayBe = [&](const Trial& t) {
        return t.ok && t.evidence > equivalenceMargin && !isAtBound(t) && !fightsAnother(null, t.fit) &&
               !drivesToBound(null.fit, t.fit) && !isLongDeadTime(t.variant.effects.back(), t.fit, interval);
    };
    std::vector<std::optional<FitResult>> fits(trials.size());
    parallelFor(static_cast<int>(trials.size()), search.options.threads, [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        if (mayBe(trials[i])) fits[i] = withSlopes(search, null, trials[i]);
    });
    const Disturbance disturbance(null, search.fit.simulation, search.progress);
    const double alone = disturbance.likeliest(null.fit.optimum).misfit;
    const double rows = static_cast<double>(null.fit.optimum.residuals.size());
    std::vector<LikelyTrial> likely;
    for (std::size_t i = 0; i < trials.size() && !search.progress.stopRequested(); ++i)
        if (fits[i] && fits[i]->optimum.residuals.size() == null.fit.optimum.residuals.size())
            likely.push_back(
                {i, alone - disturbance.likeliest(fits[i]->optimum).misfit - trials[i].freed() * std::log(rows)});
    std::stable_sort(likely.begin(), likely.end(), isLikelierThan);
    return likely;
}

/// Trials with flow and parameters where they are likeliest; those that cannot be fitted are left out.
std::vector<LikelyTrial> fittedBesideFlow(const SearchContext& search, const NullModel& null,
                                          const BesideDisturbance& alone, const std::vector<Trial>& trials,
                                          const std::vector<LikelyTrial>& likely) {
    std::vector<std::optional<BesideDisturbance>> beside(likely.size());
    parallelFor(static_cast<int>(likely.size()), search.options.threads, [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        const Variant& variant = trials[likely[i].trial].variant;
        if (const auto with = fitNull(variant, null.noise, NoiseLevel::Keep, search.fit, search.progress))
            beside[i] = besideDisturbanceAlso(alone, *with, search.fit.simulation, search.progress, oneFlow);
    });
    const Eigen::Index rows = null.fit.optimum.residuals.size();
    std::vector<LikelyTrial> all;
    for (std::size_t i = 0; i < likely.size(); ++i)
        if (const std::size_t trial = likely[i].trial; beside[i])
            all.push_back({trial, evidenceBeside(alone, *beside[i], rows, trials[trial].freed())});
    return all;
}

/// The first of them with flow and parameters where they are likeliest, the best first. What parameters that follow to
/// first order promise is as a rule more than what is left of it there: what promises no clear evidence, or less than
/// another has, is not asked.
std::vector<LikelyTrial> atTheirLikeliest(const SearchContext& search, const NullModel& null,
                                          const std::vector<Trial>& trials, std::vector<LikelyTrial> likely) {
    likely.resize(std::min(likely.size(), mostTries));
    std::erase_if(likely, [](const LikelyTrial& l) { return !(l.evidence > clearEvidence); });
    if (likely.empty()) return {};
    const BesideDisturbance alone = besideDisturbance(null, search.fit.simulation, search.progress, oneFlow);
    std::vector<LikelyTrial> best = fittedBesideFlow(search, null, alone, trials, {likely.front()});
    likely.erase(likely.begin());
    const double least = best.empty() ? clearEvidence : best.front().evidence - equivalenceMargin;
    std::erase_if(likely, [&](const LikelyTrial& l) { return l.evidence < least; });
    const std::vector<LikelyTrial> others = fittedBesideFlow(search, null, alone, trials, likely);
    best.insert(best.end(), others.begin(), others.end());
    std::stable_sort(best.begin(), best.end(), isLikelierThan);
    return best;
}

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
    const auto order = [&](std::size_t i) {
        return std::pair(round.trials[i].freed(), plausibility(round.candidate(i).effect));
    };
    round.chosen = *std::min_element(members.begin(), members.end(),
                                     [&](std::size_t a, std::size_t b) { return order(a) < order(b); });
    round.members = std::move(members);
    round.acceptance = examine(search, null, round.trials[*round.chosen], round.threshold);
    round.refused.behind =
        phrase("less likely than {} beside a flow that nobody measured", nameOf(round.candidate(*round.chosen)));
    return true;
}

}  // namespace

LikeliestBesideFlow withLikeliestBesideFlow(SearchContext& search, const Node& node, Round& round) {
    const std::vector<LikelyTrial> first = toFirstOrder(search, node.null, round.trials);
    const std::vector<LikelyTrial> likely = atTheirLikeliest(search, node.null, round.trials, first);
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

}  // namespace analogon
