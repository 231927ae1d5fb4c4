#include "core/effect/search/indicate.hpp"

#include <algorithm>

#include "core/effect/judge/judgement.hpp"
#include "core/effect/judge/prediction.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/search/beside_flow.hpp"
#include "core/effect/search/contenders.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/exchange.hpp"
#include "core/effect/search/prune.hpp"
#include "core/effect/search/storage.hpp"
#include "core/effect/search/trials.hpp"
#include "core/effect/search/verdicts.hpp"
#include "core/effect/search/without.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

namespace {

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
            const Prediction prediction =
                predictAsChosen(*step.prediction, *rest, node.null, static_cast<int>(placed.freed.size()),
                                search.fit.simulation, search.progress);
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
        if (node.steps[i].prediction && !node.steps[i].prediction->besideFlow) rest = without(search, node.null, i);
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

std::size_t candidateCount(const SearchContext& search, const Node& node) {
    const Outcome<std::vector<Candidate>> candidates = candidatesIn(search, node.null.variant);
    return candidates ? candidates->size() : 0;
}

/// Adds what predicts best beside a node, or else, as the first effect of all, what is likeliest beside a flow that
/// nobody measured; false where nothing does clearly better than it.
bool addOne(SearchContext& search, Node& node) {
    const SoughtFirst& known = search.frontier.best.first;
    const bool isKnown = node.steps.empty() && known.isBeside(node.null);
    std::optional<Node> next;
    if (isKnown && known.candidates == candidateCount(search, node)) {
        next = known.node;
    } else {
        Round round = tryAll(search, node.null);
        if (search.progress.stopRequested()) return false;
        next = firstThatHolds(search, node, contendersOf(search, node.null, round.trials), round,
                              [](const Node&) { return true; });
        if (!next && node.steps.empty())
            next = isKnown ? known.node : withLikeliestBesideFlow(search, node, round).node;
    }
    if (!next || search.progress.stopRequested()) return false;
    node = std::move(*next);
    return true;
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
        // beside a flow that hides the first effect, what predicts better may make up for the flow
        if (grown.steps.back().prediction && grown.steps.back().prediction->besideFlow) break;
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
        if (hasEffect(effects, e) || !mayBeIndicated(e)) continue;
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

}  // namespace

void indicate(SearchContext& search, const NullModel& base, Node& node, const std::vector<Node>& ends) {
    if (isNoise(node.null) || isColouredNoise(search, node.null) || search.progress.stopRequested()) return;
    search.frontier.isIndicating = true;
    if (std::optional<Node> likelier = likelierThan(search, base, node)) {
        keepWhatPredicts(search, *likelier);
        if (!likelier->steps.empty() && !search.progress.stopRequested()) {
            node = std::move(*likelier);
            return;
        }
    }
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
    const bool isExchanged = storageForDeadTimes(search, best);
    if (isExchanged) best = grownFrom(search, std::move(best));
    const auto isNew = [&] { return best.steps.size() >= node.steps.size() + (isExchanged ? 0 : 1); };
    if (!isNew()) return;
    confirm(search, best);
    if (!isNew() || search.progress.stopRequested()) return;
    search.journal.model("indicate", best.null, "taken");
    node = std::move(best);
}

}  // namespace analogon
