#include "core/effect/search/interrupted.hpp"

#include <algorithm>
#include <chrono>
#include <optional>

#include "core/base/stop.hpp"
#include "core/effect/judge/judgement.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/reading_remarks.hpp"
#include "core/effect/search/verdicts.hpp"
#include "core/effect/tell/added_effects.hpp"

namespace analogon {
namespace {

constexpr std::chrono::milliseconds forTelling{80};  // of work, after a stop, for what is still to be simulated

/// After a stop: work that is cut short, and leaves things as they were, where it takes longer than anybody waits.
template <class Work>
void soon(const Work& work) {
    const StopAfter limit(forTelling);
    const StopScope scope(limit.token());
    try {
        work();
    } catch (const Stopped&) {
    }
}

/// Of records so long that what is made for a simulation takes longer than anybody waits.
bool areLong(const EstimationTask& task) {
    constexpr Eigen::Index most = 200'000;  // samples of outputs
    Eigen::Index count = 0;
    for (const Recording& r : task.recordings) count += static_cast<Eigen::Index>(r.time.size()) * r.outputs.rows();
    return count > most;
}

/// What the search had no time to hold against the rest must be clear by itself, or predict clearly better as a whole.
bool isClear(const Whole& whole) {
    const Node& node = whole.node;
    if (whole.isBehindLikeliest) return false;
    return whole.predicts || isNoise(node.null) || std::all_of(node.steps.begin(), node.steps.end(), [](const Step& s) {
               return isMissed(s.acceptance) && isClearlyMissed(s.acceptance) && s.acceptance.heldOut > leastHeldOut;
           });
}

/// The model as given, and with the effects of a path that is not the end of the search.
Finding tellWhole(const SearchContext& search, const Node& node, const ModelState& state, const FlatModel* valued) {
    Finding finding = *search.frontier.begun;
    finding.final = state;
    const auto& onTime = search.readings.drawn.errorsOnTime;
    addEffects(finding, node, {}, valued, onTime ? onTime->first : -1);
    for (AddedEffect& e : finding.effects) e.confidence = Confidence::Indicated;  // the last tests are not made yet
    finding.kind = finding.effects.empty() ? FindingKind::Interrupted
                   : isNoise(node.null)    ? FindingKind::Effect
                                           : FindingKind::Partial;
    finding.end.interrupted = true;
    return finding;
}

/// What is told of a node, always of all samples; null: that is not known, or no better than the model as given.
const ModelState* stateToTell(const SearchContext& search, const Whole& whole) {
    if (whole.readings.thinning.isWhole()) return &*whole.node.state;
    const std::optional<ModelState>& state = whole.isOnAll ? whole.node.state : whole.errorsOnAll;
    const double given = errorPercentOf(search.frontier.begun->baseline, Role::Fit);
    return state && errorPercentOf(*state, Role::Fit) < given ? &*state : nullptr;
}

/// The node of a search on fewer samples as it is on all of them, with its bands where there is time for them.
void takeOnAll(const SearchContext& search, Whole& whole) {
    Node& node = whole.node;
    if (!whole.isOnAll) {
        Outcome<Variant> all = onAllSamples(whole.readings, node.null);
        if (!all) return;
        node.null.variant = std::move(*all);
        node.state = whole.errorsOnAll;
        whole.isOnAll = true;
    }
    if (areLong(node.null.variant.task)) return;
    soon([&] {
        Outcome<ModelState> state = stateOf(node.null.variant, node.null.fit, search.options.fit.simulation, {});
        if (state && !isStopped()) node.state = std::move(*state);
    });
}

}  // namespace

void fitBestOnAll(SearchContext& search, const NullModel& given, const Progress& progress) {
    Whole* const whole = search.frontier.toTell();
    if (whole == nullptr) return;
    Node& node = whole->node;
    const Outcome<Variant> all = onAllSamples(whole->readings, node.null);
    if (!all) return;
    Outcome<NullModel> fitted = fitNull(*all, given.noise, NoiseLevel::Estimate, search.options.fit, progress);
    if (!fitted || progress.stopRequested()) return;
    Outcome<ModelState> state = stateOf(fitted->variant, fitted->fit, search.options.fit.simulation, progress);
    if (!state || progress.stopRequested()) return;
    node.null = std::move(*fitted);
    node.state = std::move(*state);
    whole->isOnAll = true;
}

void Frontier::keepClear() {
    if (best.whole && isClear(*best.whole)) best.clear = *best.whole;
}

Whole* Frontier::toTell() {
    if (best.unweighed && isClear(*best.unweighed)) return &*best.unweighed;
    if (best.whole && isClear(*best.whole)) return &*best.whole;
    if (best.clear && isClear(*best.clear)) return &*best.clear;
    return best.likeliest ? &*best.likeliest : nullptr;
}

Outcome<ModelState> stateSoFar(const NullModel& null, const SimulationOptions& simulation) {
    std::optional<Outcome<ModelState>> state;
    if (!areLong(null.variant.task)) soon([&] { state = stateOf(null.variant, null.fit, simulation, {}); });
    if (!state) state = valuesAlone(null.variant, null.fit);
    return std::move(*state);
}

Outcome<Finding> fittedSoFar(const NullModel& null, const SimulationOptions& simulation) {
    if (null.fit.estimates.empty()) return error(phrase("cancelled"));
    Outcome<ModelState> state = stateSoFar(null, simulation);
    if (!state) return state.diagnostics();
    Finding finding;
    finding.baseline = finding.final = std::move(*state);
    finding.kind = FindingKind::Interrupted;
    finding.end.interrupted = true;
    return finding;
}

void keepSoFar(SearchContext& search, const std::vector<CandidateResult>& candidates) {
    if (!search.options.keep || !search.frontier.begun) return;
    const Whole* const best = search.frontier.toTell();
    const ModelState* const state = best != nullptr ? stateToTell(search, *best) : nullptr;
    Finding finding = state != nullptr ? tellWhole(search, best->node, *state, nullptr) : *search.frontier.begun;
    finding.candidates = candidates;
    settleVerdicts(finding, finding.candidates);
    search.options.keep(std::move(finding));
}

namespace {

/// The recordings as they were read when a node was reached; start values of checks stay estimated.
void readAsThen(SearchContext& search, const Whole& whole) {
    const std::vector<ToldStart> checks = std::move(search.readings.checkStarts);
    search.readings = whole.readings;
    search.readings.checkStarts = checks;
    setFitted(search.readings.full.task, checks, true);
}

/// The start values that were estimated for checks, and the recordings as they are, in what is told of a node.
void takeChecksAndRecordings(SearchContext& search, Node& node) {
    if (!search.readings.checkStarts.empty()) {
        setFitted(node.null.variant.task, search.readings.checkStarts, true);
        Outcome<ModelState> found = stateOf(node.null.variant, node.null.fit, search.options.fit.simulation, {});
        if (found && !isStopped()) node.state = std::move(*found);
    }
    reportAsRecorded(search, node.null, *node.state);
}

}  // namespace

Outcome<Finding> foundSoFar(SearchContext& search, const NullModel& first) {
    Frontier& frontier = search.frontier;
    if (!frontier.begun) {
        Outcome<Finding> fitted = fittedSoFar(first, search.options.fit.simulation);
        if (!fitted) return fitted;
        frontier.begun = std::move(*fitted);
    }
    Whole* whole = frontier.toTell();
    if (whole != nullptr && stateToTell(search, *whole) == nullptr) whole = nullptr;
    std::optional<FlatModel> valued;
    if (whole) {
        Node& node = whole->node;
        if (!whole->readings.thinning.isWhole()) takeOnAll(search, *whole);
        readAsThen(search, *whole);
        soon([&] { takeChecksAndRecordings(search, node); });
        soon([&] {
            if (Outcome<FlatModel> flat = flattened(node.null.variant.task, node.state->modelText); flat)
                valued = std::move(*flat);
        });
    }
    Finding finding =
        whole ? tellWhole(search, whole->node, *whole->node.state, valued ? &*valued : nullptr) : *frontier.begun;
    finding.candidates = whole ? whole->node.candidates : frontier.noted;
    const Text why = takenOut(phrase("the search was stopped before it was borne out"));
    for (CandidateResult& c : finding.candidates)
        if (c.verdict == Verdict::Chosen &&
            std::none_of(finding.effects.begin(), finding.effects.end(),
                         [&](const AddedEffect& e) { return e.kind == c.kind && e.at == c.at; })) {
            c.verdict = Verdict::NotSignificant;
            c.reason = why;
        }
    settleVerdicts(finding, finding.candidates);
    return finding;
}

}  // namespace analogon
