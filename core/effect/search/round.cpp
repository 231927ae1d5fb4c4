#include "core/effect/search/round.hpp"

#include <algorithm>
#include <cmath>

#include "core/effect/judge/judgement.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/model/sampling.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/probe_twin.hpp"
#include "core/effect/search/trials.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::rounds;
using threshold::acceptance::farMore;
using threshold::law::formShare;

namespace {

/// Whether an effect at an input only shifts it by less than a sample interval: how the input went on in between is not
/// recorded, and a dead time and a lag differ in nothing else.
bool isBetweenSamples(const Trial& trial, double interval) {
    const EffectClass& effect = trial.screened.candidate.effect;
    const auto unit = effect.parameters.units.find(effect.parameters.strength);
    if (effect.placement.signalSide != "input" || unit == effect.parameters.units.end() || unit->second != "s")
        return false;
    const FitEstimate* strength = trial.fit.find(trial.variant.effects.back().freed.front().name);
    return strength != nullptr && strength->value < interval;
}

/// While much is left whatever is taken, one step explains with its flexible parameters what belongs to others: the
/// simplest that explains nearly as much goes first.
void preferSimple(const SearchContext& search, const NullModel& null, Round& round) {
    const std::vector<Trial>& trials = round.trials;
    const Trial& best = trials[*round.chosen];
    const double chi2Decrease = null.sumOfSquares() - best.sumOfSquares();
    const bool leavesMuch = reducedChi(best.fit) > largeResidual;
    round.members = equivalents(null, trials, *round.chosen);
    std::vector<std::size_t> simpler;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        if (!trials[i].ok || isProposal(trials[i]) || isAtBound(trials[i]) || fightsAnother(null, trials[i].fit))
            continue;
        const bool isSimpler = trials[i].freed() < best.freed();
        const bool isLikelier =
            leavesMuch && trials[i].freed() == best.freed() &&
            plausibility(trials[i].screened.candidate.effect) < plausibility(best.screened.candidate.effect);
        const bool isMember = std::find(round.members.begin(), round.members.end(), i) != round.members.end();
        const bool isNearly =
            leavesMuch && null.sumOfSquares() - trials[i].sumOfSquares() > nearlyAsMuch * chi2Decrease;
        if ((isMember && (isSimpler || isLikelier)) || (isNearly && isSimpler)) simpler.push_back(i);
    }
    std::stable_sort(simpler.begin(), simpler.end(),
                     [&](std::size_t a, std::size_t b) { return trials[a].freed() < trials[b].freed(); });
    for (const std::size_t i : simpler) {
        const Acceptance a = examine(search, null, trials[i], round.threshold);
        if (!a.accepted()) {
            round.refused.why[i] = whyRefused(a, a.asked.heldOut);
            continue;
        }
        round.refused.why[*round.chosen] =
            trials[i].freed() < best.freed()
                ? phrase("{} explains nearly as much with fewer parameters", nameOf(round.candidate(i)))
                : phrase("{} explains nearly as much, and is met more often", nameOf(round.candidate(i)));
        round.choose(null, i, a);
        break;
    }
}

}  // namespace

std::vector<std::size_t> equalPlaces(const SearchContext& search, const NullModel& null,
                                     const std::vector<Trial>& trials, std::size_t best) {
    const auto isFlowByLaw = [&](const Trial& t) {
        const EffectClass& effect = t.screened.candidate.effect;
        return effect.placement.signalSide.empty() && search.laws.contains(effect.className);
    };
    const Trial& first = trials[best];
    const double weight = independentShare(null, first.fit);
    const double margin = std::max(equivalenceMargin, formShare * first.evidence);
    std::vector<std::size_t> equal{best};
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const Trial& t = trials[i];
        if (i == best || !t.ok || isAtBound(t) || !(weight * (first.evidence - t.evidence) < margin)) continue;
        const bool isSameEquation = t.screened.candidate.effect.className == first.screened.candidate.effect.className;
        if (isSameEquation || (isFlowByLaw(t) && isFlowByLaw(first) && t.freed() == first.freed())) equal.push_back(i);
    }
    mostPartsFirst(null.variant, equal,
                   [&](std::size_t i) -> const std::string& { return trials[i].screened.candidate.place.connector; });
    return equal;
}

std::vector<std::size_t> equivalents(const NullModel& null, const std::vector<Trial>& trials, std::size_t best) {
    std::vector<std::size_t> members{best};
    const auto direction = [](const Trial& t) {
        const Probe& probe = t.screened.probes.front();
        return Eigen::VectorXd(probe.plain.directions->cast<double>() * probe.strengthIn);
    };
    const Eigen::VectorXd own = direction(trials[best]);
    const double weight = independentShare(null, trials[best].fit);
    const double interval = samplingInterval(null.variant.task);
    const bool isShift = isBetweenSamples(trials[best], interval);
    for (std::size_t i = 0; i < trials.size(); ++i) {
        if (i == best || !trials[i].ok || isProposal(trials[i])) continue;
        if (trials[i].evidence < leastLike * trials[best].evidence) continue;
        const double gap = weight * std::abs(trials[best].evidence - trials[i].evidence);
        if (isShift && isBetweenSamples(trials[i], interval) &&
            trials[i].screened.candidate.place == trials[best].screened.candidate.place &&
            trials[i].evidence > nearlyTheSame * trials[best].evidence) {
            members.push_back(i);
            continue;
        }
        if (gap < equivalenceMargin ||
            (gap < 3 * equivalenceMargin && std::abs(own.dot(direction(trials[i]))) > twinCorrelation))
            members.push_back(i);
    }
    return members;
}

LeastPromise leastPromise(const NullModel& null, double threshold) {
    if (isNoise(null)) return {equivalenceMargin, 1};
    return {threshold, independentShare(null, null.fit)};
}

Round tryAll(SearchContext& search, const NullModel& null) {
    Round round;
    round.screened = screenAll(search, null);
    if (search.progress.stopRequested()) return round;
    std::vector<SharedColumns> directions;
    for (const Screened& s : round.screened)
        if (!s.probes.empty() && !s.isAbsorbed()) directions.push_back(s.probes.front().plain.directions);
    const double logRows = std::log(static_cast<double>(null.fit.optimum.residuals.size()));
    round.threshold = noiseThreshold(directions, logRows, falseAlarmQuantile, 1);
    round.least = leastPromise(null, round.threshold);
    round.trials = tryBest(search, null, round.screened, round.least);
    search.journal.tried(null, round);
    return round;
}

namespace {

/// A trial and the tests it was put to.
struct Judged {
    std::size_t trial;
    Acceptance acceptance;
};

/// Equations without a name among the trials of a round.
struct JudgedEquations {
    std::optional<Judged> accepted;     // the best that passes the tests
    std::optional<Judged> unconfirmed;  // the best that fails only those that every part of the record must pass
};

/// Puts the trials to their tests, best first, until a named effect passes them.
JudgedEquations judgeTrials(const SearchContext& search, const NullModel& null, Round& round) {
    const std::vector<Trial>& trials = round.trials;
    const bool areAskedFor = !search.options.kinds.empty() || !search.options.choices.empty();
    JudgedEquations equations;
    for (std::size_t i = 0; i < trials.size() && !round.chosen; ++i) {
        if (!trials[i].ok || trials[i].evidence < equivalenceMargin) break;
        if (isAtBound(trials[i]))
            round.refused.why[i] = atBound();
        else if (!areAskedFor && mayFollowOthers(null, trials[i]))
            round.refused.why[i] = followsOthers();
        else if (isProposal(trials[i]) && equations.accepted)
            round.refused.why[i] = phrase("explains less than {}", nameOf(round.candidate(equations.accepted->trial)));
        else if (!isProposal(trials[i]) && fightsAnother(null, trials[i].fit))
            round.refused.why[i] = fights();
        if (round.refused.why.contains(i)) continue;
        const Judged judged{i, examine(search, null, trials[i], round.threshold)};
        const Acceptance& acceptance = judged.acceptance;
        if (!acceptance.accepted()) round.refused.why[i] = whyRefused(acceptance, acceptance.asked.heldOut);
        if (isProposal(trials[i])) {
            if (acceptance.accepted())
                equations.accepted = judged;
            else if (!equations.unconfirmed && acceptance.isSignificant && reducedChi(trials[i].fit) <= largeResidual)
                equations.unconfirmed = judged;
            continue;
        }
        round.acceptance = acceptance;
        if (acceptance.accepted())
            round.chosen = i;
        else if (acceptance.isSignificant && !acceptance.holdsOut)
            round.refused.failsHeldOut.insert(i);
        else if (!acceptance.isSignificant && !acceptance.isAtEdges && acceptance.heldOut > leastHeldOut &&
                 acceptance.isWorthwhile)
            round.refused.tooFaint.push_back(i);
    }
    return equations;
}

/// An equation that leaves next to nothing refutes the names that explain far less, even where only one part of the
/// record tells of it. So does what happens once, where no name passes and it leaves noise.
bool standsUnconfirmed(const NullModel& null, const Round& round, const Trial& equation) {
    const double share = independentShare(null, equation.fit);
    if (round.chosen) return share * (equation.evidence - round.trials[*round.chosen].evidence) > 3 * equivalenceMargin;
    return share * equation.evidence > farMore && isNoise(null.channels, equation.fit);
}

/// Chooses an equation, at the first of the places where it explains as much.
void chooseEquation(const SearchContext& search, const NullModel& null, Round& round, Judged equation) {
    const std::vector<Trial>& trials = round.trials;
    if (round.chosen)
        round.refused.why[*round.chosen] =
            phrase("{}, an equation without a name, is the better account", nameOf(round.candidate(equation.trial)));
    const std::vector<std::size_t> places = equalPlaces(search, null, trials, equation.trial);
    if (const std::size_t first = places.front(); first != equation.trial) {
        const Judged there{first, examine(search, null, trials[first], round.threshold)};
        if (there.acceptance.accepted() || !equation.acceptance.accepted()) equation = there;
    }
    round.choose(null, equation.trial, equation.acceptance);
    // told beside it are the names that take more to explain as much, and its other places
    std::erase_if(round.members, [&](std::size_t i) {
        return i != equation.trial && trials[i].freed() <= trials[equation.trial].freed();
    });
    for (const std::size_t i : places)
        if (i != equation.trial) round.members.push_back(i);
}

}  // namespace

void decide(const SearchContext& search, const NullModel& null, Round& round) {
    const auto [accepted, unconfirmed] = judgeTrials(search, null, round);
    if (round.chosen) {
        round.refused.behind = phrase("explains less than {}", nameOf(round.candidate(*round.chosen)));
        preferSimple(search, null, round);
    }
    std::optional<Judged> equation = accepted;
    if (!equation && unconfirmed && standsUnconfirmed(null, round, round.trials[unconfirmed->trial]))
        equation = unconfirmed;
    if (!equation) return;
    // where an equation without a name explains clearly more than any name, none of the names fits
    if (beatsNames(null, round.trials, equation->trial, round.chosen))
        return chooseEquation(search, null, round, *equation);
    round.refused.why[equation->trial] =
        round.chosen ? phrase("an equation without a name, and not clearly a better account than {}",
                              nameOf(round.candidate(*round.chosen)))
                     : withinChance(round.trials[equation->trial].evidence, 2 * equivalenceMargin);
}

void Round::choose(const NullModel& null, std::size_t trial, const Acceptance& tests) {
    chosen = trial;
    members = equivalents(null, trials, trial);
    acceptance = tests;
}

void Round::passOver(const Text& why) {
    if (chosen) refused.why[*chosen] = why;
    chosen.reset();
    members.clear();
}

}  // namespace analogon
