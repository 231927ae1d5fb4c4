#include "core/effect/search/contenders.hpp"

#include <algorithm>
#include <tuple>

#include "core/effect/judge/judgement.hpp"
#include "core/effect/judge/prediction.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/model/sampling.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/flow_ranking.hpp"
#include "core/effect/search/refine.hpp"
#include "core/effect/search/trials.hpp"
#include "core/effect/search/verdicts.hpp"
#include "core/effect/search/without.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::prediction;
using threshold::acceptance::leastShare;
using threshold::judgement::asMuch;

bool mayBeIndicated(const PlacedEffect& placed) {
    return placed.effect.proposal.empty() && placed.freed.size() <= mostFreed;
}

void tell(const Journal& journal, const std::string& step, const std::string& key, const Prediction& p,
          const std::string& verdict) {
    Decision::Figures values{{"before", p.errorPercentBefore},
                             {"after", p.errorPercentAfter},
                             {"blocks", static_cast<double>(p.blocks)},
                             {"better_in", static_cast<double>(p.betterIn)},
                             {"clearly_in", static_cast<double>(p.clearlyIn)}};
    if (p.besideFlow) values.emplace_back("delta_bic_beside_flow", -*p.besideFlow);
    journal.add(step, key, values, verdict);
}

std::vector<Contender> contendersOf(const SearchContext& search, const NullModel& null,
                                    const std::vector<Trial>& trials) {
    const double interval = samplingInterval(null.variant.task);
    std::vector<Contender> contenders;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const Trial& t = trials[i];
        if (!t.ok || isProposal(t) || !mayBeIndicated(t.variant.effects.back()) || isAtBound(t) ||
            fightsAnother(null, t.fit) || !(t.evidence > equivalenceMargin))
            continue;
        const Prediction prediction = predict(null, t.fit);
        const bool isLate = isLongDeadTime(t.variant.effects.back(), t.fit, interval);
        const bool isClear = isClearlyBetter(prediction) && (!isLate || prediction.removed() > leastOfDeadTime);
        tell(search.journal, "contender", keyOf(t.screened.candidate.effect, t.screened.candidate.place), prediction,
             isClear ? "predicts" : "refused");
        if (isClear) contenders.push_back({i, prediction});
    }
    // a form that may follow others is indicated only where none of them predicts better
    const auto isFlexible = [&](const Contender& c) {
        return trials[c.trial].screened.candidate.effect.trial.flexible;
    };
    if (!std::all_of(contenders.begin(), contenders.end(), isFlexible)) std::erase_if(contenders, isFlexible);
    return contenders;
}

namespace {

/// Those that predict nearly as well as the best.
std::vector<Contender> nearlyBest(std::vector<Contender> contenders) {
    const auto removesLess = [](const Contender& a, const Contender& b) {
        return a.prediction.removed() < b.prediction.removed();
    };
    const double most = std::max_element(contenders.begin(), contenders.end(), removesLess)->prediction.removed();
    std::erase_if(contenders, [&](const Contender& c) { return c.prediction.removed() < nearlyAsWell * most; });
    return contenders;
}

/// Of those that predict nearly as well with as many parameters as the one that was chosen, and are met as often: the
/// one that is clearly likelier than it beside a flow that nobody measured, which leads least squares astray; else that
/// one.
Contender likeliestOf(const SearchContext& search, const NullModel& null, const std::vector<Contender>& alike,
                      const Contender& chosen, const std::vector<Trial>& trials) {
    std::vector<std::size_t> rivals;
    for (const Contender& c : alike)
        if (simplicity(trials[c.trial]) == simplicity(trials[chosen.trial])) rivals.push_back(c.trial);
    const std::optional<std::size_t> likelier = clearlyLikelier(search, null, trials, rivals, chosen.trial);
    const auto it = std::find_if(alike.begin(), alike.end(), [&](const Contender& c) { return c.trial == likelier; });
    return it == alike.end() ? chosen : *it;
}

}  // namespace

void chooseAmong(const SearchContext& search, const NullModel& null, const std::vector<Contender>& contenders,
                 First first, Round& round) {
    const double interval = samplingInterval(null.variant.task);
    const std::vector<Contender> alike = nearlyBest(contenders);
    const auto order = [&](const Contender& c) {
        const Trial& t = round.trials[c.trial];
        const bool isLate = isLongDeadTime(t.variant.effects.back(), t.fit, interval);
        const double missed = -c.prediction.removed();
        return std::tuple(isLate, first == First::Best ? missed : 0, simplicity(t), missed);
    };
    Contender chosen = *std::min_element(alike.begin(), alike.end(),
                                         [&](const Contender& a, const Contender& b) { return order(a) < order(b); });
    if (first == First::Simplest) chosen = likeliestOf(search, null, alike, chosen, round.trials);
    round.chosen = chosen.trial;
    round.members.clear();
    for (const Contender& c : alike) round.members.push_back(c.trial);
    const Trial& trial = round.trials[chosen.trial];
    round.acceptance = examine(search, null, trial, round.threshold);
    round.refused.behind =
        phrase("predicts less well what was left out than {}", nameOf(round.candidate(chosen.trial)));
}

void passOver(const Round& round, std::vector<Contender>& contenders) {
    const auto failed = std::find_if(contenders.begin(), contenders.end(),
                                     [&](const Contender& c) { return c.trial == *round.chosen; });
    if (failed == contenders.end()) return;
    const double left = failed->prediction.errorPercentAfter;
    std::erase_if(contenders, [&](const Contender& c) {
        const auto [less, more] = std::minmax({c.prediction.errorPercentAfter, left});
        const bool isAlike =
            less > asMuch * more && round.trials[c.trial].freed() == round.trials[*round.chosen].freed();
        return c.trial == *round.chosen || isAlike;
    });
}

namespace {

/// A model beside the noise of another, which its residual is to be held against.
Outcome<NullModel> besideNoiseOf(const SearchContext& search, const NullModel& model, const NullModel& other) {
    return fitNull(model.variant, other.noise, NoiseLevel::Keep, search.fit, search.progress);
}

}  // namespace

std::optional<Node> withChoice(SearchContext& search, const Node& node, const Round& round, const Prediction& chosen) {
    Node next = node;
    Step step = stepOf(search, node.null, round);
    step.prediction = chosen;
    Outcome<NullModel> fitted =
        fitNull(step.winner.variant, node.null.noise, NoiseLevel::Estimate, search.fit, search.progress);
    if (!fitted || search.progress.stopRequested()) return std::nullopt;
    next.null = std::move(*fitted);
    next.steps.push_back(std::move(step));
    sharpen(search, next);
    seekFromTheStart(search, search.readings.searched, next.null);
    const Outcome<NullModel> before = besideNoiseOf(search, node.null, next.null);
    if (!before || search.progress.stopRequested()) return std::nullopt;
    const int freed = static_cast<int>(next.null.variant.effects.back().freed.size());
    Prediction prediction = predictAsChosen(chosen, *before, next.null, freed, search.fit.simulation, search.progress);
    if (isClearlyBetter(prediction) && !prediction.besideFlow)
        if (const auto exact = predictByRefits(*before, next.null, search.fit, search.progress)) prediction = *exact;
    const bool isClear = isClearlyBetter(prediction) && !search.progress.stopRequested();
    const Candidate& candidate = round.candidate(*round.chosen);
    tell(search.journal, "predict", keyOf(candidate.effect, candidate.place), prediction,
         isClear ? "taken" : "set aside");
    next.steps.back().prediction = prediction;
    return isClear ? std::optional(std::move(next)) : std::nullopt;
}

std::optional<Node> firstThatHolds(SearchContext& search, const Node& node, std::vector<Contender> contenders,
                                   Round& round, const std::function<bool(const Node&)>& accepts) {
    for (std::size_t tries = 0; tries < mostTries && !contenders.empty() && !search.progress.stopRequested(); ++tries) {
        chooseAmong(search, node.null, contenders, tries == 0 ? First::Simplest : First::Best, round);
        if (std::optional<Node> next = withChoice(search, node, round, Prediction{}); next && accepts(*next)) {
            noteAll(search, *next, round);
            return next;
        }
        passOver(round, contenders);
    }
    return std::nullopt;
}

bool predictsClearlyBetter(const SearchContext& search, const NullModel& with, const NullModel& without) {
    const Outcome<NullModel> before = besideNoiseOf(search, without, with);
    return before && before->fit.optimum.residuals.size() == with.fit.optimum.residuals.size() &&
           isClearlyBetter(predict(*before, with.fit));
}

namespace {

bool hasLongDeadTime(const NullModel& null) {
    const double interval = samplingInterval(null.variant.task);
    return std::any_of(null.variant.effects.begin(), null.variant.effects.end(),
                       [&](const PlacedEffect& e) { return isLongDeadTime(e, null.fit, interval); });
}

}  // namespace

bool predictsBetter(const SearchContext& search, const Node& node, const Node& than) {
    const Outcome<NullModel> other = besideNoiseOf(search, than.null, node.null);
    if (!other) return true;
    const Prediction p = predict(*other, node.null.fit);
    const bool isLate = hasLongDeadTime(node.null), isOtherLate = hasLongDeadTime(than.null);
    if (isLate != isOtherLate)
        return p.removed() > (isLate ? leastOfDeadTime : -leastOfDeadTime / (1 - leastOfDeadTime));
    const bool isSimpler = node.null.parameterCount() < than.null.parameterCount();
    return p.removed() > (isSimpler ? -leastShare : leastShare);
}

}  // namespace analogon
