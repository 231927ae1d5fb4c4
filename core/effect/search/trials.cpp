#include "core/effect/search/trials.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <numeric>

#include "core/base/parallel.hpp"
#include "core/effect/block/screen_together.hpp"
#include "core/effect/judge/judgement.hpp"
#include "core/effect/model/taken_values.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/probe_twin.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::rounds;
using threshold::likely::mostAgain;
using threshold::likely::mostFitted;

namespace {

/// What a fit took, in steps of the explicit method.
double workOf(const FitResult& fit) {
    double steps = 0;
    for (const Trajectory& t : fit.optimum.trajectories) steps += t.plan.work() * static_cast<double>(t.outputs.cols());
    return steps * fit.simulations;
}

/// Those whose further starts may change what is chosen: they promise to reach this share of the best evidence, or have
/// reached it.
std::vector<TrialStarts*> contenders(const NullModel& null, const std::vector<std::unique_ptr<TrialStarts>>& begun,
                                     double share) {
    const Trial* best = nullptr;
    for (const auto& each : begun)
        if (const Trial& t = each->best(); t.ok && (best == nullptr || t.sumOfSquares() < best->sumOfSquares()))
            best = &t;
    std::vector<TrialStarts*> all;
    for (const auto& each : begun)
        if (each->hasNext()) all.push_back(each.get());
    if (best == nullptr) return all;
    const EvidenceScale evidence(null, best->fit);
    const double enough = std::max(0.0, share * evidence.of(best->sumOfSquares(), best->freed()));
    std::erase_if(all, [&](const TrialStarts* each) {
        if (!each->best().ok) return false;
        const double reached = std::min(each->promised(), each->best().sumOfSquares());
        return evidence.of(reached, each->best().freed()) < enough;
    });
    return all;
}

/// Traces that the screening of a candidate takes.
std::size_t tracesOf(const EffectClass& effect) {
    std::size_t count = std::max<std::size_t>(1, effect.trial.secant.size());
    for (const auto& [name, values] : effect.parameters.shape) count *= values.size();
    return count;
}

/// Indices, the largest cost first: no thread is left alone with a long task at the end.
std::vector<int> longestFirst(const std::vector<std::size_t>& costs) {
    std::vector<int> order(costs.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return costs[static_cast<std::size_t>(a)] > costs[static_cast<std::size_t>(b)];
    });
    return order;
}

/// What the data cannot tell from a named effect of the wrong physical sign is no more physical under no name: a drag
/// that differs with the direction, of a shaft that turns one way only, is a viscous friction that drives.
void refuseTwinsOfWrongSign(std::vector<Screened>& screened) {
    for (Screened& equation : screened) {
        if (equation.candidate.effect.proposal.empty()) continue;
        for (const Screened& named : screened) {
            if (!named.candidate.effect.proposal.empty() || !named.isWrongSign() ||
                named.candidate.place.connector != equation.candidate.place.connector)
                continue;
            for (Probe& p : equation.probes)
                if (isTwin(p, named)) p.plain.wrongSign = p.whitened.wrongSign = true;
        }
    }
}

/// Begins these trials once more at other values of the model's parameters; what does better takes its place.
void retryFrom(SearchContext& search, const NullModel& null, const std::vector<ParameterValue>& values,
               const std::vector<std::size_t>& chosen, int iterations, std::vector<Trial>& trials) {
    std::vector<Screened> begun;
    for (const std::size_t i : chosen) {
        Screened screened = trials[i].screened;
        screened.begin = screened.begin.value_or(null.variant.values);
        takeValues(*screened.begin, values);
        begun.push_back(std::move(screened));
    }
    std::vector<const Screened*> all;
    for (const Screened& s : begun) all.push_back(&s);
    std::vector<Trial> again = tryThese(search, null, all, iterations, startsPerTrial);
    for (std::size_t i = 0; i < again.size(); ++i)
        if (again[i].ok && again[i].sumOfSquares() < trials[chosen[i]].sumOfSquares())
            trials[chosen[i]] = std::move(again[i]);
}

/// Where an equation without a name leaves next to nothing, the names at its place begin once more with what it found
/// of the model's parameters: from those of the model without either a fit may end elsewhere.
void retryNames(SearchContext& search, const NullModel& null, std::vector<Trial>& trials) {
    rank(null, trials);
    if (trials.empty() || !trials.front().ok || !isProposal(trials.front())) return;
    const Trial& equation = trials.front();
    if (reducedChi(equation.fit) > largeResidual) return;
    std::vector<std::size_t> names;
    for (std::size_t i = 1; i < trials.size() && names.size() < mostFitted; ++i) {
        if (!trials[i].ok || isProposal(trials[i])) continue;
        if (trials[i].screened.candidate.place.connector != equation.screened.candidate.place.connector) continue;
        names.push_back(i);
    }
    retryFrom(search, null, equation.variant.values, names, trialIterations, trials);
}

/// Where an equation without a name explains a little more than a name that rounds something off (a limit sets in over
/// a few percent), that may be all it explains more: the name is drawn sharper before they are held against each other.
/// So is one whose strength rests at its bound: what is rounded off begins before the limit, and moves it away.
void drawNamesSharper(SearchContext& search, const NullModel& null, std::vector<Trial>& trials) {
    rank(null, trials);
    if (trials.empty() || !trials.front().ok) return;
    const bool isBehindEquation = isProposal(trials.front());
    const double least = leastLike * trials.front().evidence;
    for (Trial& t : trials) {
        if (!t.ok || isProposal(t) || !(t.evidence > least) || search.progress.stopRequested()) continue;
        if (!isBehindEquation && !isAtBound(t)) continue;
        std::vector<PlacedEffect> effects = t.variant.effects;
        if (!drawSharper(effects.back())) continue;
        Outcome<Variant> variant = withEffects(search.readings.searched, effects, t.variant.values);
        if (!variant) continue;
        Trial sharper = t;
        sharper.variant = std::move(*variant);
        proceed(null, sharper, trialOptions(search.fit, trialIterations), search.progress);
        if (sharper.sumOfSquares() < t.sumOfSquares()) t = std::move(sharper);
    }
}

}  // namespace

Outcome<std::vector<Candidate>> candidatesIn(const SearchContext& search, const Variant& variant) {
    Outcome<std::vector<Candidate>> candidates = candidatesFor(variant, search.catalogue);
    // behind a source whose flow is proportional to a command it is the lag of that command, and is its class
    const bool areTwins = search.options.kinds.empty() && search.options.choices.empty();
    if (candidates && areTwins && !search.frontier.isIndicating)
        std::erase_if(*candidates, [](const Candidate& c) { return c.effect.placement.behindSource; });
    if (candidates && !search.options.choices.empty())
        std::erase_if(*candidates, [&](const Candidate& c) {
            const EffectChoice choice{c.effect.className, c.place.at};
            return std::find(search.options.choices.begin(), search.options.choices.end(), choice) ==
                   search.options.choices.end();
        });
    return candidates;
}

std::vector<Screened> screenAll(const SearchContext& search, const NullModel& null) {
    Outcome<std::vector<Candidate>> candidates = candidatesIn(search, null.variant);
    if (!candidates) return {};
    std::vector<Screened> screened(candidates->size());
    const std::vector<std::vector<std::size_t>> groups = screenedTogether(*candidates);
    std::vector<std::size_t> costs;
    for (const std::vector<std::size_t>& group : groups)
        costs.push_back(group.size() * tracesOf((*candidates)[group.front()].effect));
    const std::vector<int> order = longestFirst(costs);
    parallelFor(static_cast<int>(groups.size()), search.options.threads, [&](int k) {
        const std::vector<std::size_t>& group = groups[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])];
        std::vector<Candidate> members;
        for (const std::size_t i : group) members.push_back((*candidates)[i]);
        search.say("screen", phrase("{} at {}", members.front().effect.kind, members.front().place.at),
                   k / static_cast<double>(groups.size()));
        std::vector<Screened> all = screenTogether(null, members, search.fit.simulation, search.progress);
        for (std::size_t i = 0; i < group.size(); ++i) screened[group[i]] = std::move(all[i]);
    });
    refuseTwinsOfWrongSign(screened);
    return screened;
}

std::vector<Trial> tryThese(SearchContext& search, const NullModel& null, const std::vector<const Screened*>& chosen,
                            int iterations, int starts, TrialSize size) {
    FitOptions quick = trialOptions(search.fit, iterations);
    quick.simulation = limited(null, quick.simulation);
    std::vector<std::unique_ptr<TrialStarts>> begun(chosen.size());
    std::vector<std::size_t> costs;
    for (const Screened* s : chosen) costs.push_back(s->probes.size());
    const std::vector<int> order = longestFirst(costs);
    parallelFor(static_cast<int>(chosen.size()), search.options.threads, [&](int k) {
        const auto i = static_cast<std::size_t>(order[static_cast<std::size_t>(k)]);
        const Screened& s = *chosen[i];
        search.say("trial", phrase("{} at {}", s.candidate.effect.kind, s.candidate.place.at),
                   k / static_cast<double>(chosen.size()));
        auto& own = begun[i];
        own = std::make_unique<TrialStarts>(null, s, quick, starts, search.progress);
        if (own->hasNext()) own->takeNext();
        if (size == TrialSize::Lean) own->dropSlopes();
    });
    const std::vector<TrialStarts*> again = contenders(null, begun, rivalShare);
    parallelFor(static_cast<int>(again.size()), search.options.threads, [&](int i) {
        TrialStarts& own = *again[static_cast<std::size_t>(i)];
        while (own.hasNext()) own.takeNext();
    });
    std::vector<Trial> trials;
    for (const auto& each : begun) trials.push_back(std::move(*each).best());
    for (const Trial& t : trials) search.work.add(workOf(t.fit));
    search.checkWork();
    return trials;
}

std::optional<FitResult> withSlopes(const SearchContext& search, const NullModel& null, const Trial& trial) {
    if (!trial.isLean) return trial.fit;
    FitResult whole = trial.fit;
    const Outcome<PreparedTask> prepared = prepareAt(trial.variant, null.noise);
    if (!prepared) return std::nullopt;
    Linearisation at = linearise(prepared->problem, whole.values, true, whole.plans,
                                 limited(null, search.fit.simulation), search.progress);
    if (!at.ok) return std::nullopt;
    whole.optimum = std::move(at);
    return whole;
}

Acceptance examine(const SearchContext& search, const NullModel& null, const Trial& trial, double threshold) {
    if (!trial.isLean) return examine(null, trial.fit, trial.freed(), threshold);
    const std::optional<FitResult> whole = withSlopes(search, null, trial);
    return whole ? examine(null, *whole, trial.freed(), threshold) : Acceptance{};
}

void continueFit(Trial& trial, const std::function<void(Trial&)>& step) {
    for (int k = 0; k < mostContinued && trial.ok && trial.fit.status == FitStatus::IterationLimit; ++k) {
        const double before = trial.sumOfSquares();
        step(trial);
        if (!(before - trial.sumOfSquares() > equivalenceMargin)) break;
    }
}

void continueBest(const SearchContext& search, const NullModel& null, std::vector<Trial>& trials) {
    rank(null, trials);
    FitOptions options = trialOptions(search.fit, 2 * trialIterations);
    options.simulation = limited(null, options.simulation);
    const int count = std::min<int>(search.options.refitted, static_cast<int>(trials.size()));
    parallelFor(count, search.options.threads, [&](int i) {
        continueFit(trials[static_cast<std::size_t>(i)], [&](Trial& t) { proceed(null, t, options, search.progress); });
    });
}

void retryNear(SearchContext& search, const NullModel& null, const std::vector<ParameterValue>& values,
               double sumOfSquares, std::vector<Trial>& trials) {
    const double chi2Decrease = null.sumOfSquares() - sumOfSquares;
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < trials.size() && near.size() < mostAgain; ++i) {
        if (!trials[i].ok || isProposal(trials[i])) continue;
        const double behind = trials[i].sumOfSquares() - sumOfSquares;
        const bool isLost =
            behind > chi2Decrease && trials[i].screened.score() > leastLike * trials.front().screened.score();
        if (behind > equivalenceMargin && (behind < nearShare * chi2Decrease || isLost)) near.push_back(i);
    }
    if (near.empty() || search.progress.stopRequested()) return;
    retryFrom(search, null, values, near, 2 * trialIterations, trials);
    rank(null, trials);
}

namespace {

using ScreenedList = std::vector<const Screened*>;

bool isAmong(const ScreenedList& list, const Screened* s) {
    return std::find(list.begin(), list.end(), s) != list.end();
}

bool isEquation(const Screened* s) { return !s->candidate.effect.proposal.empty(); }

/// The first of a list that are not among the chosen yet.
void choose(const ScreenedList& from, int count, ScreenedList& chosen) {
    for (const Screened* s : from) {
        if (count == 0) return;
        if (isAmong(chosen, s)) continue;
        chosen.push_back(s);
        --count;
    }
}

/// What promises more than so much by either score, the best first by each.
struct Promising {
    ScreenedList byScore, byWhitened;  // named effects
    ScreenedList equations;            // by score

    Promising(const std::vector<Screened>& screened, const LeastPromise& least) {
        for (const Screened& s : screened)
            if (s.failure.empty() && s.score() > 0 && least.isMetBy(s)) byScore.push_back(&s);
        std::stable_sort(byScore.begin(), byScore.end(),
                         [](const Screened* a, const Screened* b) { return a->score() > b->score(); });
        byWhitened = byScore;
        std::stable_sort(byWhitened.begin(), byWhitened.end(),
                         [](const Screened* a, const Screened* b) { return a->whitenedScore() > b->whitenedScore(); });
        std::copy_if(byScore.begin(), byScore.end(), std::back_inserter(equations), isEquation);
        std::erase_if(byScore, isEquation);
        std::erase_if(byWhitened, isEquation);
    }
};

/// Equations at the place of the best name which promise nearly as much: they are held against it.
ScreenedList equationsBesideBest(const Promising& promising, const std::vector<Trial>& trials,
                                 const ScreenedList& chosen) {
    ScreenedList there;
    const Trial* best = leastLeft(trials);
    if (best == nullptr || isProposal(*best)) return there;
    for (const Screened* s : promising.equations)
        if (s->candidate.place.connector == best->screened.candidate.place.connector &&
            s->score() > leastLike * best->screened.score() && !isAmong(chosen, s))
            there.push_back(s);
    return there;
}

/// Whether the best of the trials leaves so much that first-order scores may mislead.
bool leavesMuch(const NullModel& null, const std::vector<Trial>& trials) {
    double smallest = null.sumOfSquares();
    for (const Trial& t : trials)
        if (t.ok) smallest = std::min(smallest, t.sumOfSquares());
    return std::sqrt(smallest / static_cast<double>(null.fit.optimum.residuals.size())) > largeResidual;
}

void append(std::vector<Trial>& trials, std::vector<Trial> more) {
    trials.insert(trials.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

std::vector<Trial> tryBest(SearchContext& search, const NullModel& null, const std::vector<Screened>& screened,
                           const LeastPromise& least) {
    const Promising promising(screened, least);
    ScreenedList chosen;
    // proposals compete, but do not take the place of a named effect
    choose(promising.byScore, search.options.refitted, chosen);
    choose(promising.byWhitened, search.options.refitted / 2, chosen);
    choose(promising.equations, search.options.refitted / 3, chosen);
    std::vector<Trial> trials = tryThese(search, null, chosen, trialIterations, startsPerTrial);

    const ScreenedList beside = equationsBesideBest(promising, trials, chosen);
    if (!beside.empty()) append(trials, tryThese(search, null, beside, trialIterations, startsPerTrial));
    chosen.insert(chosen.end(), beside.begin(), beside.end());

    if (leavesMuch(null, trials) && !search.progress.stopRequested()) {
        ScreenedList others = chosen;
        choose(promising.byScore, static_cast<int>(promising.byScore.size()), others);
        others.erase(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(chosen.size()));
        append(trials, tryThese(search, null, others, coarseIterations, 1, TrialSize::Lean));
    }
    continueBest(search, null, trials);
    retryNames(search, null, trials);
    drawNamesSharper(search, null, trials);
    rank(null, trials);
    if (!trials.empty() && trials.front().ok)
        retryNear(search, null, trials.front().variant.values, trials.front().sumOfSquares(), trials);
    return trials;
}

}  // namespace analogon
