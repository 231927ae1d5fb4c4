#include "core/effect/search/indicate.hpp"

#include <algorithm>
#include <tuple>

#include "core/effect/judge/judgement.hpp"
#include "core/effect/judge/prediction.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/model/sampling.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/exchange.hpp"
#include "core/effect/search/prune.hpp"
#include "core/effect/search/refine.hpp"
#include "core/effect/search/trials.hpp"
#include "core/effect/search/verdicts.hpp"
#include "core/effect/search/without.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::prediction;
using threshold::acceptance::leastShare;
using threshold::likely::mostAgain;

namespace {

/// Whether an effect is a dead time of more than a few samples. Heat and flows come late by storage as a rule, and what
/// is stored smooths them, too.
bool isLongDeadTime(const PlacedEffect& placed, const FitResult& fit, double interval) {
    if (faultOf(placed.effect) != "delay") return false;
    const FitEstimate* delay = fit.find(placed.freed.front().name);
    return delay != nullptr && delay->value > mostSamplesOfDelay * interval;
}

bool hasLongDeadTime(const NullModel& null) {
    const double interval = samplingInterval(null.variant.task);
    return std::any_of(null.variant.effects.begin(), null.variant.effects.end(),
                       [&](const PlacedEffect& e) { return isLongDeadTime(e, null.fit, interval); });
}

void tell(const Journal& journal, const std::string& step, const std::string& key, const Prediction& p,
          const std::string& verdict) {
    journal.add(step, key,
                {{"before", p.errorPercentBefore},
                 {"after", p.errorPercentAfter},
                 {"blocks", static_cast<double>(p.blocks)},
                 {"better_in", static_cast<double>(p.betterIn)},
                 {"clearly_in", static_cast<double>(p.clearlyIn)}},
                verdict);
}

/// How the model predicts without one of its effects, and with all.
struct Missed {
    std::size_t effect{};
    NullModel without;
    Prediction prediction;
};

/// Takes out what is not established and does not make the model predict clearly better, least first: the others are
/// judged without it.
void keepWhatPredicts(SearchContext& search, Node& node) {
    while (!search.progress.stopRequested()) {
        std::optional<Missed> least;
        for (std::size_t i = 0; i < node.steps.size() && !search.progress.stopRequested(); ++i) {
            search.checkWork();
            Step& step = node.steps[i];
            if (!step.prediction) continue;
            const PlacedEffect& placed = node.null.variant.effects[i];
            std::optional<NullModel> rest = without(search, node.null, i);
            if (!rest) continue;
            seekFromTheStart(search, search.readings.searched, *rest);
            const Prediction prediction = predict(*rest, node.null.fit);
            const bool isClear = isClearlyBetter(prediction) && !isAtBound(placed, node.null.fit);
            tell(search.journal, "predict", keyOf(placed.effect, placed.place), prediction, isClear ? "kept" : "asked");
            step.prediction = prediction;
            step.acceptance = examine(*rest, node.null.fit, static_cast<int>(placed.freed.size()), 0);
            step.chi2Decrease = rest->sumOfSquares() - node.null.sumOfSquares();
            tellErrorWithout(search, step, *rest);
            if (isClear || (least && least->prediction.removed() < prediction.removed())) continue;
            least = Missed{i, std::move(*rest), prediction};
        }
        if (!least || search.progress.stopRequested()) return;
        setVerdict(search, node, node.null.variant.effects[least->effect], Verdict::NotSignificant,
                   takenOut(predictsNoBetter(least->prediction)));
        node.null = std::move(least->without);
        node.steps.erase(node.steps.begin() + static_cast<std::ptrdiff_t>(least->effect));
    }
}

/// Each effect that is indicated is asked once more by refits without every part; what fails is taken out.
void confirm(SearchContext& search, Node& node) {
    for (std::size_t i = 0; i < node.steps.size() && !search.progress.stopRequested();) {
        const PlacedEffect& placed = node.null.variant.effects[i];
        std::optional<NullModel> rest;
        if (node.steps[i].prediction) rest = without(search, node.null, i);
        if (rest) seekFromTheStart(search, search.readings.searched, *rest);
        std::optional<Prediction> exact;
        if (rest) exact = predictByRefits(*rest, node.null, search.fit, search.progress);
        if (!exact) {
            ++i;
            continue;
        }
        const bool isClear = isClearlyBetter(*exact);
        tell(search.journal, "confirm", keyOf(placed.effect, placed.place), *exact, isClear ? "kept" : "taken out");
        node.steps[i].prediction = exact;
        if (isClear) {
            ++i;
            continue;
        }
        setVerdict(search, node, placed, Verdict::NotSignificant, takenOut(predictsNoBetter(*exact)));
        node.null = std::move(*rest);
        node.steps.erase(node.steps.begin() + static_cast<std::ptrdiff_t>(i));
        keepWhatPredicts(search, node);
        i = 0;
    }
}

/// A trial that makes the model predict clearly better.
struct Contender {
    std::size_t trial{};
    Prediction prediction;
};

std::vector<Contender> contendersOf(const SearchContext& search, const NullModel& null,
                                    const std::vector<Trial>& trials) {
    std::vector<Contender> contenders;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const Trial& t = trials[i];
        if (!t.ok || isProposal(t) || t.variant.effects.back().freed.size() > mostFreed || isAtBound(t) ||
            fightsAnother(null, t.fit) || !(t.evidence > equivalenceMargin))
            continue;
        const Prediction prediction = predict(null, t.fit);
        const bool isClear = isClearlyBetter(prediction);
        tell(search.journal, "contender", keyOf(t.screened.candidate.effect, t.screened.candidate.place), prediction,
             isClear ? "predicts" : "refused");
        if (isClear) contenders.push_back({i, prediction});
    }
    // a form that may follow others is indicated only where none of them predicts better
    const auto isFlexible = [&](const Contender& c) { return trials[c.trial].screened.candidate.effect.flexible; };
    if (!std::all_of(contenders.begin(), contenders.end(), isFlexible)) std::erase_if(contenders, isFlexible);
    return contenders;
}

/// Those that predict nearly as well as the best.
std::vector<Contender> nearlyBest(std::vector<Contender> contenders) {
    const auto removesLess = [](const Contender& a, const Contender& b) {
        return a.prediction.removed() < b.prediction.removed();
    };
    const double most = std::max_element(contenders.begin(), contenders.end(), removesLess)->prediction.removed();
    std::erase_if(contenders, [&](const Contender& c) { return c.prediction.removed() < nearlyAsWell * most; });
    return contenders;
}

/// The simplest of those that predict nearly as well as the best stands for all of them.
void chooseAmong(const SearchContext& search, const NullModel& null, const std::vector<Contender>& contenders,
                 Round& round) {
    const double interval = samplingInterval(null.variant.task);
    const std::vector<Contender> alike = nearlyBest(contenders);
    const auto order = [&](const Contender& c) {
        const Trial& t = round.trials[c.trial];
        const bool isLate = isLongDeadTime(t.variant.effects.back(), t.fit, interval);
        return std::tuple(isLate, t.freed(), plausibility(t.screened.candidate.effect), -c.prediction.removed());
    };
    const Contender& chosen = *std::min_element(
        alike.begin(), alike.end(), [&](const Contender& a, const Contender& b) { return order(a) < order(b); });
    round.chosen = chosen.trial;
    round.members.clear();
    for (const Contender& c : alike) round.members.push_back(c.trial);
    const Trial& trial = round.trials[chosen.trial];
    round.acceptance = examine(search, null, trial, round.threshold);
    round.behind = phrase("predicts less well what was left out than {}", nameOf(round.candidate(chosen.trial)));
}

/// A model beside the noise of another, which its residual is to be held against.
Outcome<NullModel> besideNoiseOf(const SearchContext& search, const NullModel& model, const NullModel& other) {
    return fitNull(model.variant, other.noise, NoiseLevel::Keep, search.fit, search.progress);
}

/// A node with what a round has chosen, refitted; nothing where the whole does not predict clearly better than it did
/// before: a trial that has not come to its end may seem to.
std::optional<Node> withChoice(SearchContext& search, const Node& node, const Round& round) {
    Node next = node;
    Step step = stepOf(search, node.null, round);
    step.prediction.emplace();
    Outcome<NullModel> fitted =
        fitNull(step.winner.variant, node.null.noise, NoiseLevel::Estimate, search.fit, search.progress);
    if (!fitted || search.progress.stopRequested()) return std::nullopt;
    next.null = std::move(*fitted);
    next.steps.push_back(std::move(step));
    sharpen(search, next);
    seekFromTheStart(search, search.readings.searched, next.null);
    const Outcome<NullModel> before = besideNoiseOf(search, node.null, next.null);
    if (!before || search.progress.stopRequested()) return std::nullopt;
    Prediction prediction = predict(*before, next.null.fit);
    if (isClearlyBetter(prediction))
        if (const auto exact = predictByRefits(*before, next.null, search.fit, search.progress)) prediction = *exact;
    const bool isClear = isClearlyBetter(prediction) && !search.progress.stopRequested();
    const Candidate& chosen = round.candidate(*round.chosen);
    tell(search.journal, "predict", keyOf(chosen.effect, chosen.place), prediction, isClear ? "taken" : "set aside");
    return isClear ? std::optional(std::move(next)) : std::nullopt;
}

/// Adds what predicts best beside a node; false where nothing does clearly better than it.
bool addOne(SearchContext& search, Node& node) {
    Round round = tryAll(search, node.null);
    if (search.progress.stopRequested()) return false;
    std::vector<Contender> contenders = contendersOf(search, node.null, round.trials);
    for (std::size_t tries = 0; tries < mostAgain && !contenders.empty() && !search.progress.stopRequested(); ++tries) {
        chooseAmong(search, node.null, contenders, round);
        if (std::optional<Node> next = withChoice(search, node, round)) {
            noteAll(search, *next, round);
            node = std::move(*next);
            return true;
        }
        std::erase_if(contenders, [&](const Contender& c) { return c.trial == *round.chosen; });
    }
    return false;
}

/// From a node on, one by one.
Node grownFrom(SearchContext& search, Node node) {
    Node grown = std::move(node);
    while (!search.progress.stopRequested() && static_cast<int>(grown.steps.size()) < search.options.maxRounds) {
        if (isNoise(grown.null)) break;
        Node next = grown;
        ++search.journal.round;
        if (!addOne(search, next)) break;
        const std::size_t count = next.steps.size();
        keepWhatPredicts(search, next);
        search.journal.model("indicate", next.null, "grown");
        const bool isLarger = next.steps.size() == count;
        grown = std::move(next);
        if (!isLarger) break;  // what came in put another out: it would come back
    }
    return grown;
}

/// The names of an end, none of them proved, with those that stand in the node.
std::optional<Node> namesOf(SearchContext& search, const Node& node, const Node& end) {
    Node names = node;
    std::vector<PlacedEffect> effects = node.null.variant.effects;
    const std::size_t proved = effects.size();
    const std::vector<PlacedEffect>& found = end.null.variant.effects;
    for (std::size_t i = 0; i < found.size() && i < end.steps.size(); ++i) {
        const PlacedEffect& e = found[i];
        const bool isThere = std::any_of(effects.begin(), effects.end(), [&](const PlacedEffect& have) {
            return keyOf(have.effect, have.place) == keyOf(e.effect, e.place);
        });
        if (isThere || !e.effect.proposal.empty() || e.freed.size() > mostFreed) continue;
        effects.push_back(e);
        names.steps.push_back(end.steps[i]);
        names.steps.back().prediction.emplace();
    }
    if (effects.size() == proved) return std::nullopt;
    std::optional<NullModel> fitted = refittedWith(search, end.null, effects);
    if (!fitted) return std::nullopt;
    seekFromTheStart(search, search.readings.searched, *fitted);
    names.null = std::move(*fitted);
    return names;
}

/// Whether a node is the better account of another's recordings: by what it predicts, beside fewer parameters and
/// without a long dead time also where it predicts nearly as well.
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

}  // namespace

void indicate(SearchContext& search, Node& node, const std::vector<Node>& ends) {
    if (isNoise(node.null) || isColouredNoise(search, node.null) || search.progress.stopRequested()) return;
    search.frontier.isIndicating = true;
    Node best = grownFrom(search, node);
    search.journal.model("indicate", best.null, "one by one");
    Visited visited(best);
    bool isOfAnEnd = false;
    for (const Node& end : ends) {
        if (search.progress.stopRequested()) break;
        std::optional<Node> names = namesOf(search, node, end);
        if (!names || !visited.add(*names)) continue;
        keepWhatPredicts(search, *names);
        if (names->steps.size() == node.steps.size()) continue;
        const bool isBetter = predictsBetter(search, *names, best);
        search.journal.model("indicate", names->null, isBetter ? "better" : "set aside");
        if (!isBetter) continue;
        best = std::move(*names);
        isOfAnEnd = true;
    }
    if (isOfAnEnd) best = grownFrom(search, std::move(best));
    if (best.steps.size() == node.steps.size()) return;
    confirm(search, best);
    if (best.steps.size() == node.steps.size() || search.progress.stopRequested()) return;
    search.journal.model("indicate", best.null, "taken");
    node = std::move(best);
}

}  // namespace analogon
