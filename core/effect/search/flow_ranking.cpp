#include "core/effect/search/flow_ranking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/parallel.hpp"
#include "core/effect/block/trial_parameters.hpp"
#include "core/effect/judge/disturbance.hpp"
#include "core/effect/judge/judgement.hpp"
#include "core/effect/model/sampling.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/trials.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using threshold::acceptance::clearEvidence;
using threshold::prediction::mostTries;

namespace {

constexpr std::size_t oneFlow = 1;  // beside which trials are ranked; the chosen one is asked beside all there are

bool isLikelierThan(const LikelyTrial& a, const LikelyTrial& b) { return a.evidence > b.evidence; }

/// Those of some trials of which the evidence beside a flow is asked, the best first; flow and parameters follow to
/// first order.
std::vector<LikelyTrial> toFirstOrder(const SearchContext& search, const NullModel& null,
                                      const std::vector<Trial>& trials, const std::vector<std::size_t>& some) {
    const double interval = samplingInterval(null.variant.task);
    const auto mayBe = [&](const Trial& t) {
        return t.ok && t.evidence > equivalenceMargin && !isAtBound(t) && !fightsAnother(null, t.fit) &&
               !drivesToBound(null.fit, t.fit) && !isLongDeadTime(t.variant.effects.back(), t.fit, interval);
    };
    std::vector<std::optional<FitResult>> fits(trials.size());
    parallelFor(static_cast<int>(some.size()), search.options.threads, [&](int k) {
        const std::size_t i = some[static_cast<std::size_t>(k)];
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
        const Trial& trial = trials[likely[i].trial];
        if (const auto with = fitNull(trial.variant, null.noise, NoiseLevel::Keep, search.fit, search.progress))
            beside[i] = besideDisturbanceAlso(alone, *with, search.fit.simulation, search.progress, oneFlow,
                                              offeredByWhitened(trial));
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

}  // namespace

std::vector<LikelyTrial> rankedBesideFlow(const SearchContext& search, const NullModel& null,
                                          const std::vector<Trial>& trials) {
    std::vector<std::size_t> all(trials.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return atTheirLikeliest(search, null, trials, toFirstOrder(search, null, trials, all));
}

std::optional<std::size_t> clearlyLikelier(const SearchContext& search, const NullModel& null,
                                           const std::vector<Trial>& trials, const std::vector<std::size_t>& rivals,
                                           std::size_t than) {
    if (rivals.size() < 2) return std::nullopt;
    const std::vector<LikelyTrial> first = toFirstOrder(search, null, trials, rivals);
    const std::vector<LikelyTrial> likely = atTheirLikeliest(search, null, trials, first);
    if (likely.empty() || search.progress.stopRequested()) return std::nullopt;
    double evidence = -std::numeric_limits<double>::infinity();
    for (const std::vector<LikelyTrial>& known : {first, likely})
        for (const LikelyTrial& l : known)
            if (l.trial == than) evidence = l.evidence;
    const bool isClear = likely.front().evidence > evidence + clearEvidence;
    return isClear ? std::optional(likely.front().trial) : std::nullopt;
}

}  // namespace analogon
