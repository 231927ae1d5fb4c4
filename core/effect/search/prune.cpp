#include "core/effect/search/prune.hpp"

#include <algorithm>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/base/work.hpp"
#include "core/effect/judge/disturbance.hpp"
#include "core/effect/judge/judgement.hpp"
#include "core/effect/judge/prediction.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/judge/remainder.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/verdicts.hpp"
#include "core/effect/search/without.hpp"

namespace analogon {
void tellErrorWithout(const SearchContext& search, Step& step, const NullModel& without) {
    if (Outcome<ModelState> state =
            stateOf(without.variant, without.fit, search.fit.simulation, search.progress, Detail::Errors))
        step.errorWithout = errorPercentOf(*state, Role::Fit);
}

bool isColouredNoise(const SearchContext& search, const NullModel& null) {
    if (isNoise(null)) return false;
    return leftovers(null, search.fit.simulation).isNoiseAlone();
}

namespace {

/// Why an effect need not stay.
struct Need {
    Text whyNot;                                // empty: it has to
    std::optional<double> besideDisturbance{};  // evidence for it beside a disturbance, where that was asked
};

/// What `task` simulates, counted for nobody yet: what is judged at once with others may not be needed in the end, and
/// the work of a search is not to depend on how many are.
template <class Task>
double simulatedBy(const Task& task) {
    const WorkScope nobody(nullptr);
    const WorkCount own;
    task();
    return own.done();
}

/// The disturbance beside a model as it stands, found when first asked for, by any thread.
class DisturbanceOnce {
public:
    const BesideDisturbance& of(const SearchContext& search, const NullModel& null, std::size_t most) {
        const std::lock_guard lock(guard_);
        if (!known_)
            work_ =
                simulatedBy([&] { known_ = besideDisturbance(null, search.fit.simulation, search.progress, most); });
        return *known_;
    }
    /// Counts what it took, once.
    void count() { countWork(std::exchange(work_, 0.0)); }
    void forget() {
        known_.reset();
        work_ = 0;
    }

private:
    std::mutex guard_;
    std::optional<BesideDisturbance> known_;
    double work_{};
};

/// How a model does without one of its effects.
struct Judged {
    std::optional<NullModel> without;  // empty: it cannot be fitted
    Acceptance missed;
    Need need;
    double work{};  // what that took
};

/// Whether an effect, missed by so much, has to stay. `beside`: of the model as it stands, once it is
/// asked for. At the last, where something is left that nothing explains, the effect must be more than what a
/// disturbance takes over; where noise is left, a weak one must be likelier.
Need needOf(const SearchContext& search, const NullModel& null, std::size_t effect, const NullModel& without,
            const Acceptance& missed, bool isLast, DisturbanceOnce& beside) {
    const PlacedEffect& placed = null.variant.effects[effect];
    const bool leavesNoise = isNoise(null);
    if (!isMissed(missed)) return {whyRefused(missed, 0)};
    if (!isTold(placed, null.fit.estimates, missed, leavesNoise)) return {indistinct()};
    if (isAtBound(placed, null.fit)) return {atBound()};
    if (!isLast) return {};
    if (!leavesNoise && drivesToBound(without.fit, null.fit))
        return {
            phrase("with it a parameter of the model rests at a bound: it does the work of what is known to be there")};
    if (!(missed.heldOut > leastHeldOut)) return {whyRefused(missed, leastHeldOut)};
    if (leavesNoise && isBeyondDoubt(missed.evidence)) return {};
    // what is constant hardly differs from a flow that varies slowly, and noise with a memory is noise as well
    const bool isNoiseLeft = leavesNoise || isColouredNoise(search, null);
    const std::size_t most = isNoiseLeft ? 1 : mostDisturbances;
    const BesideDisturbance disturbed = besideDisturbance(without, search.fit.simulation, search.progress, most);
    const BesideDisturbance with = beside.of(search, null, most);
    const Eigen::Index rows = null.fit.optimum.residuals.size();
    const int freed = static_cast<int>(placed.freed.size());
    const bool isMore =
        isNoiseLeft ? isLikelier(disturbed, with, rows, freed) : isBorneOut(disturbed, with, rows, freed);
    return {isMore ? Text() : noMoreThanDisturbance(), evidenceBeside(disturbed, with, rows, freed)};
}

Judged judge(const SearchContext& search, const Node& node, std::size_t effect, bool isLast, DisturbanceOnce& beside) {
    const PlacedEffect& placed = node.null.variant.effects[effect];
    search.say("remove", phrase("{} at {}", placed.effect.kind, placed.place.at), -1);
    Judged judged{without(search, node.null, effect), {}, {}, {}};
    if (!judged.without) return judged;
    judged.missed = examine(*judged.without, node.null.fit, static_cast<int>(placed.freed.size()), 0);
    judged.need = needOf(search, node.null, effect, *judged.without, judged.missed, isLast, beside);
    return judged;
}

void tellJudged(const Journal& journal, const PlacedEffect& placed, const Judged& judged) {
    const Text& why = judged.need.whyNot;
    const std::string verdict = why.empty() ? "kept" : "taken out", key = keyOf(placed.effect, placed.place);
    journal.test("missed", key, judged.missed, verdict, why);
    if (judged.need.besideDisturbance)
        journal.add("beside disturbance", key, {{"delta_bic", -*judged.need.besideDisturbance}}, verdict);
}

}  // namespace

void removeUnneeded(SearchContext& search, Node& node, std::size_t least, bool isLast) {
    DisturbanceOnce beside;
    std::vector<Judged> judged;
    std::size_t first = 0;  // of these
    for (std::size_t i = 0; i < node.steps.size() && node.steps.size() > least && !search.progress.stopRequested();) {
        if (i >= first + judged.size()) {
            first = i;
            const auto atOnce = static_cast<std::size_t>(threadCount(search.options.threads));
            judged.assign(std::min(node.steps.size() - i, atOnce), {});
            parallelFor(static_cast<int>(judged.size()), search.options.threads, [&](int k) {
                const auto next = static_cast<std::size_t>(k);
                const double work =
                    simulatedBy([&] { judged[next] = judge(search, node, first + next, isLast, beside); });
                judged[next].work = work;
            });
        }
        Judged& own = judged[i - first];
        countWork(own.work);
        if (own.need.besideDisturbance) beside.count();
        if (!own.without) {
            ++i;
            continue;
        }
        const PlacedEffect& placed = node.null.variant.effects[i];
        tellJudged(search.journal, placed, own);
        if (own.need.whyNot.empty()) {
            node.steps[i].acceptance = own.missed;
            node.steps[i].chi2Decrease = own.without->sumOfSquares() - node.null.sumOfSquares();
            tellErrorWithout(search, node.steps[i], *own.without);
            ++i;
            continue;
        }
        setVerdict(search, node, placed, Verdict::NotSignificant, takenOut(own.need.whyNot));
        if (hasProposal(node.null) && placed.effect.proposal.empty()) node.displaced.push_back({placed, node.steps[i]});
        node.null = std::move(*own.without);
        beside.forget();
        node.steps.erase(node.steps.begin() + static_cast<std::ptrdiff_t>(i));
        judged.clear();
        first = i = 0;
    }
}

void removeOutweighed(SearchContext& search, Node& node, double share) {
    while (!search.progress.stopRequested()) {
        std::optional<std::size_t> least;
        for (std::size_t i = 0; i < node.steps.size(); ++i)
            if (node.null.variant.effects[i].effect.proposal.empty() &&
                (!least || node.steps[i].chi2Decrease < node.steps[*least].chi2Decrease))
                least = i;
        const Text why = explainsLittle();
        if (!least || outweighsRest(node.steps[*least].chi2Decrease, node.null, share) ||
            !takeOut(search, node, *least, why))
            return;
        removeUnneeded(search, node, 0, true);
    }
}

bool dropIndistinct(SearchContext& search, const NullModel& last, const ModelState& state, Node& node) {
    // where the fit found no errors at all they tell nothing of an effect
    if (std::none_of(state.parameters.begin(), state.parameters.end(),
                     [](const FitEstimate& e) { return std::isfinite(e.standardError); }))
        return false;
    const std::vector<PlacedEffect>& effects = last.variant.effects;
    for (std::size_t i = 0; i < effects.size(); ++i) {
        if (!isTold(effects[i], state.parameters, node.steps[i].acceptance, isNoise(last)) &&
            takeOut(search, node, i, indistinct()))
            return true;
    }
    return false;
}

bool dropUnmissed(SearchContext& search, const NullModel& last, Node& node) {
    std::optional<std::size_t> least;
    Text why;
    double leastEvidence = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < node.steps.size() && !search.progress.stopRequested(); ++i) {
        search.say("remove", phrase("{} at {}", last.variant.effects[i].effect.kind, last.variant.effects[i].place.at),
                   -1);
        std::optional<NullModel> rest = withoutOnAll(search, last, i);
        if (!rest) continue;
        if (node.steps[i].prediction) seekFromTheStart(search, search.readings.full, *rest);
        const Acceptance missed = examine(*rest, last.fit, static_cast<int>(last.variant.effects[i].freed.size()), 0);
        if (std::optional<Prediction>& indicated = node.steps[i].prediction) {
            indicated = predictAsChosen(*indicated, *rest, last, static_cast<int>(last.variant.effects[i].freed.size()),
                                        search.fit.simulation, search.progress);
            // the first order may not reach as far as a whole recording asks for
            if (!isClearlyBetter(*indicated) && !indicated->besideFlow)
                if (const auto exact = predictByRefits(*rest, last, search.fit, search.progress)) indicated = exact;
            if (isClearlyBetter(*indicated)) {
                tellErrorWithout(search, node.steps[i], *rest);
                continue;
            }
        }
        if (isMissed(missed) && !node.steps[i].prediction) {
            node.steps[i].acceptance = missed;
            tellErrorWithout(search, node.steps[i], *rest);
        } else if (missed.evidence < leastEvidence) {
            least = i;
            const std::optional<Prediction>& indicated = node.steps[i].prediction;
            why = phrase("on all samples instead of means of them: {}",
                         indicated ? predictsNoBetter(*indicated) : whyRefused(missed, 0));
            leastEvidence = missed.evidence;
        }
    }
    return least && !search.progress.stopRequested() && takeOut(search, node, *least, why);
}

}  // namespace analogon
