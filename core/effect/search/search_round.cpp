/// One round of the search: screen every candidate, refit those that promise most, decide.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/parallel.hpp"
#include "core/effect/judge/caution.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/model/sampling.hpp"
#include "core/effect/search/search.hpp"

namespace analogon {
namespace {

constexpr int mostContinued = 4;           // times, while a fit that has not converged still tells more
constexpr double twinCorrelation = 0.999;  // projected traces more alike than this are twins
constexpr double falseAlarmQuantile = 0.99;
constexpr double leastOfOnce = 100;  // evidence for what the blocks left out do not bear out
constexpr std::size_t mostRivals = 5, mostAlternatives = 6;
constexpr std::size_t mostRetried = 4;
constexpr double nearlyTheSame = 0.95;   // of the evidence, for what differs between the samples alone
constexpr std::size_t mostNear = 3;      // trials that begin once more
constexpr double nearShare = 0.2;        // of what the best explains, that they may explain less
constexpr double formOfProposal = 0.02;  // of what an equation explains, that its form may be wrong by
constexpr int glanceIterations = 5;      // of the whole catalogue, to see who deserves a trial

/// What a fit took, in steps of the explicit method.
double workOf(const FitResult& fit) {
    double steps = 0;
    for (const Trajectory& t : fit.optimum.trajectories) steps += t.plan.work() * static_cast<double>(t.outputs.cols());
    return steps * fit.simulations;
}

/// Whether an effect at an input only shifts it by less than a sample interval: how the input went on in between is not
/// recorded, and a dead time and a lag differ in nothing else.
bool isBetweenSamples(const Trial& trial, double interval) {
    const EffectClass& effect = trial.screened.candidate.effect;
    const auto unit = effect.units.find(effect.strength);
    if (effect.signalSide != "input" || unit == effect.units.end() || unit->second != "s") return false;
    const FitEstimate* strength = trial.fit.find(trial.variant.effects.back().freed.front().name);
    return strength != nullptr && strength->value < interval;
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
    std::size_t count = std::max<std::size_t>(1, effect.secant.size());
    for (const auto& [name, values] : effect.shape) count *= values.size();
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

/// Whether two probes promise the same: one direction each, and that alike.
bool isTwin(const Probe& a, const Probe& b) {
    const Eigen::MatrixXd &one = a.plain.directions, &other = b.plain.directions;
    return one.cols() == 1 && other.cols() == 1 && std::abs(one.col(0).dot(other.col(0))) > twinCorrelation;
}

/// Whether any probe of a candidate promises the same as this one.
bool isTwin(const Probe& probe, const Screened& candidate) {
    return std::any_of(candidate.probes.begin(), candidate.probes.end(),
                       [&](const Probe& other) { return isTwin(probe, other); });
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

}  // namespace

/// The trials of an equation at all places where it, or a law with as many terms, explains as much, `best` the best of
/// them. What has no name is not known so exactly that a small part of what it explains would tell two places apart.
/// First is that where most parts of the model meet: whatever it stands for may be in any of them.
std::vector<std::size_t> Search::equalPlaces(const NullModel& null, const std::vector<Trial>& trials,
                                             std::size_t best) const {
    const auto isFlowByLaw = [&](const Trial& t) {
        const EffectClass& effect = t.screened.candidate.effect;
        return effect.signalSide.empty() && laws_.contains(effect.className);
    };
    const Trial& first = trials[best];
    const double weight = independentShare(null, first.fit);
    const double margin = std::max(equivalenceMargin, formOfProposal * first.evidence);
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

Outcome<std::vector<Candidate>> Search::candidatesIn(const Variant& variant) const {
    Outcome<std::vector<Candidate>> candidates = candidatesFor(variant, catalogue_);
    if (candidates && !options_.choices.empty())
        std::erase_if(*candidates, [this](const Candidate& c) {
            const EffectChoice choice{c.effect.className, c.place.at};
            return std::find(options_.choices.begin(), options_.choices.end(), choice) == options_.choices.end();
        });
    return candidates;
}

std::vector<Screened> Search::screenAll(const NullModel& null) {
    Outcome<std::vector<Candidate>> candidates = candidatesIn(null.variant);
    if (!candidates) return {};
    std::vector<Screened> screened(candidates->size());
    std::vector<std::size_t> costs;
    for (const Candidate& c : *candidates) costs.push_back(tracesOf(c.effect));
    const std::vector<int> order = longestFirst(costs);
    parallelFor(static_cast<int>(screened.size()), options_.threads, [&](int k) {
        const auto i = static_cast<std::size_t>(order[static_cast<std::size_t>(k)]);
        const Candidate& c = (*candidates)[i];
        say("screen", phrase("{} at {}", c.effect.kind, c.place.at), k / static_cast<double>(screened.size()));
        screened[i] = screen(null, c, search_.fit.simulation, progress_);
    });
    refuseTwinsOfWrongSign(screened);
    return screened;
}

std::vector<Trial> Search::tryThese(const NullModel& null, const std::vector<const Screened*>& chosen, int iterations,
                                    int starts) {
    FitOptions quick = trialOptions(search_.fit, iterations);
    quick.simulation = limited(null, quick.simulation);
    std::vector<std::unique_ptr<TrialStarts>> begun(chosen.size());
    std::vector<std::size_t> costs;
    for (const Screened* s : chosen) costs.push_back(s->probes.size());
    const std::vector<int> order = longestFirst(costs);
    parallelFor(static_cast<int>(chosen.size()), options_.threads, [&](int k) {
        const auto i = static_cast<std::size_t>(order[static_cast<std::size_t>(k)]);
        const Screened& s = *chosen[i];
        say("trial", phrase("{} at {}", s.candidate.effect.kind, s.candidate.place.at),
            k / static_cast<double>(chosen.size()));
        auto& own = begun[i];
        own = std::make_unique<TrialStarts>(null, s, quick, starts, progress_);
        if (own->hasNext()) own->takeNext();
    });
    const std::vector<TrialStarts*> again = contenders(null, begun, rivalShare);
    parallelFor(static_cast<int>(again.size()), options_.threads, [&](int i) {
        TrialStarts& own = *again[static_cast<std::size_t>(i)];
        while (own.hasNext()) own.takeNext();
    });
    std::vector<Trial> trials;
    for (const auto& each : begun) trials.push_back(std::move(*each).best());
    for (const Trial& t : trials) work_ += workOf(t.fit);
    if (options_.mostWork > 0 && work_ > options_.mostWork) end_.request_stop();
    return trials;
}

/// Refits the candidates that promise most by either score; where the residual is large against the noise, all. Beside
/// noise alone, what promises less than would tell it apart (`leastScore`) is not worth a trial. Ranked.
std::vector<Trial> Search::tryBest(const NullModel& null, std::vector<Screened>& screened, double leastScore) {
    std::vector<const Screened*> order;
    for (const Screened& s : screened)
        if (s.failure.empty() && s.score() > 0 && std::max(s.score(), s.whitenedScore()) > leastScore)
            order.push_back(&s);
    std::stable_sort(order.begin(), order.end(),
                     [](const Screened* a, const Screened* b) { return a->score() > b->score(); });
    std::vector<const Screened*> byWhitened = order;
    std::stable_sort(byWhitened.begin(), byWhitened.end(),
                     [](const Screened* a, const Screened* b) { return a->whitenedScore() > b->whitenedScore(); });
    std::vector<const Screened*> chosen;
    const auto choose = [&](const std::vector<const Screened*>& from, int count) {
        for (const Screened* s : from) {
            if (count == 0) break;
            if (std::find(chosen.begin(), chosen.end(), s) != chosen.end()) continue;
            chosen.push_back(s);
            --count;
        }
    };
    // proposals compete, but do not take the place of a named effect
    const auto isEquation = [](const Screened* s) { return !s->candidate.effect.proposal.empty(); };
    std::vector<const Screened*> proposals;
    std::copy_if(order.begin(), order.end(), std::back_inserter(proposals), isEquation);
    std::erase_if(order, isEquation);
    std::erase_if(byWhitened, isEquation);
    choose(order, options_.refitted);
    choose(byWhitened, options_.refitted / 2);
    choose(proposals, options_.refitted / 3);
    std::vector<Trial> trials = tryThese(null, chosen, trialIterations, startsPerTrial);

    // an equation at the place of the best name, which promises nearly as much, is held against it
    if (const Trial* best = leastLeft(trials); best != nullptr && !isProposal(*best)) {
        std::vector<const Screened*> there;
        for (const Screened* s : proposals)
            if (s->candidate.place.connector == best->screened.candidate.place.connector &&
                s->score() > leastLike * best->screened.score() &&
                std::find(chosen.begin(), chosen.end(), s) == chosen.end())
                there.push_back(s);
        std::vector<Trial> equations = tryThese(null, there, trialIterations, startsPerTrial);
        chosen.insert(chosen.end(), there.begin(), there.end());
        trials.insert(trials.end(), std::make_move_iterator(equations.begin()),
                      std::make_move_iterator(equations.end()));
    }

    double smallest = null.sumOfSquares();
    for (const Trial& t : trials)
        if (t.ok) smallest = std::min(smallest, t.sumOfSquares());
    const double level = std::sqrt(smallest / static_cast<double>(null.fit.optimum.residuals.size()));
    if (level > largeResidual && !progress_.stopRequested()) {
        const std::size_t before = chosen.size();
        choose(order, static_cast<int>(order.size()));
        std::vector<Trial> others =
            tryThese(null, {chosen.begin() + static_cast<std::ptrdiff_t>(before), chosen.end()}, glanceIterations, 1);
        trials.insert(trials.end(), std::make_move_iterator(others.begin()), std::make_move_iterator(others.end()));
    }
    continueBest(null, trials);
    retryNames(null, trials);
    drawNamesSharper(null, trials);
    rank(null, trials);
    if (!trials.empty() && trials.front().ok)
        retryNear(null, trials.front().variant.values, trials.front().sumOfSquares(), trials);
    return trials;
}

/// Where an equation without a name leaves next to nothing, the names at its place begin once more with what it found
/// of the model's parameters: from those of the model without either a fit may end elsewhere.
void Search::retryNames(const NullModel& null, std::vector<Trial>& trials) {
    rank(null, trials);
    if (trials.empty() || !trials.front().ok || !isProposal(trials.front())) return;
    const Trial& equation = trials.front();
    if (levelOf(equation.fit) > largeResidual) return;
    std::vector<std::size_t> names;
    for (std::size_t i = 1; i < trials.size() && names.size() < mostRetried; ++i) {
        if (!trials[i].ok || isProposal(trials[i])) continue;
        if (trials[i].screened.candidate.place.connector != equation.screened.candidate.place.connector) continue;
        names.push_back(i);
    }
    retryFrom(null, equation.variant.values, names, trialIterations, trials);
}

/// Where an equation without a name explains a little more than a name that rounds something off (a limit sets in over
/// a few percent), that may be all it explains more: the name is drawn sharper before they are held against each other.
/// So is one whose strength rests at its bound: what is rounded off begins before the limit, and moves it away.
void Search::drawNamesSharper(const NullModel& null, std::vector<Trial>& trials) {
    rank(null, trials);
    if (trials.empty() || !trials.front().ok) return;
    const bool isBehindEquation = isProposal(trials.front());
    const double least = leastLike * trials.front().evidence;
    for (Trial& t : trials) {
        if (!t.ok || isProposal(t) || !(t.evidence > least) || progress_.stopRequested()) continue;
        if (!isBehindEquation && !isAtBound(t)) continue;
        std::vector<PlacedEffect> effects = t.variant.effects;
        if (!drawSharper(effects.back())) continue;
        Outcome<Variant> variant = withEffects(base_, effects, t.variant.values);
        if (!variant) continue;
        Trial sharper = t;
        sharper.variant = std::move(*variant);
        proceed(null, sharper, trialOptions(search_.fit, trialIterations), progress_);
        if (sharper.sumOfSquares() < t.sumOfSquares()) t = std::move(sharper);
    }
}

/// Begins these trials once more at other values of the model's parameters; what does better takes its place.
void Search::retryFrom(const NullModel& null, const std::vector<ParameterValue>& values,
                       const std::vector<std::size_t>& chosen, int iterations, std::vector<Trial>& trials) {
    std::vector<Screened> begun;
    for (const std::size_t i : chosen) {
        Screened screened = trials[i].screened;
        for (ParameterValue& own : screened.wired.values)
            for (const ParameterValue& found : values)
                if (found.name == own.name && found.experiment == own.experiment) own.value = found.value;
        begun.push_back(std::move(screened));
    }
    std::vector<const Screened*> all;
    for (const Screened& s : begun) all.push_back(&s);
    std::vector<Trial> again = tryThese(null, all, iterations, startsPerTrial);
    for (std::size_t i = 0; i < again.size(); ++i)
        if (again[i].ok && again[i].sumOfSquares() < trials[chosen[i]].sumOfSquares())
            trials[chosen[i]] = std::move(again[i]);
}

/// What does nearly as well as the best may only have been fitted from farther away, and what promises as much but ends
/// worse than it began has lost its way: it begins once more where the best has led the other parameters (`values`),
/// which left so much.
void Search::retryNear(const NullModel& null, const std::vector<ParameterValue>& values, double sumOfSquares,
                       std::vector<Trial>& trials) {
    const double fall = null.sumOfSquares() - sumOfSquares;
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < trials.size() && near.size() < mostNear; ++i) {
        if (!trials[i].ok || isProposal(trials[i])) continue;
        const double behind = trials[i].sumOfSquares() - sumOfSquares;
        const bool isLost = behind > fall && trials[i].screened.score() > leastLike * trials.front().screened.score();
        if (behind > equivalenceMargin && (behind < nearShare * fall || isLost)) near.push_back(i);
    }
    if (near.empty() || progress_.stopRequested()) return;
    retryFrom(null, values, near, 2 * trialIterations, trials);
    rank(null, trials);
}

/// Takes the trials that a short fit brought to the front further.
void Search::continueBest(const NullModel& null, std::vector<Trial>& trials) {
    rank(null, trials);
    FitOptions options = trialOptions(search_.fit, 2 * trialIterations);
    options.simulation = limited(null, options.simulation);
    const int count = std::min<int>(options_.refitted, static_cast<int>(trials.size()));
    parallelFor(count, options_.threads, [&](int i) {
        Trial& t = trials[static_cast<std::size_t>(i)];
        for (int k = 0; k < mostContinued && t.ok && t.fit.status == FitStatus::IterationLimit; ++k) {
            const double before = t.sumOfSquares();
            proceed(null, t, options, progress_);
            if (!(before - t.sumOfSquares() > equivalenceMargin)) break;
        }
    });
}

std::vector<std::size_t> Search::equivalents(const NullModel& null, const std::vector<Trial>& trials,
                                             std::size_t best) const {
    std::vector<std::size_t> members{best};
    const Complement& complement = null.scores().plain;
    const auto direction = [&](const Trial& t) {
        const Eigen::MatrixXd rest = complement(Eigen::MatrixXd(t.screened.probes.front().column));
        return Eigen::VectorXd(rest.col(0).normalized());
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

void Search::note(const Screened& s, Verdict verdict, const Text& why, std::optional<double> deltaBic,
                  const Text& failure) {
    CandidateResult c;
    c.kind = s.candidate.effect.kind;
    c.at = s.candidate.place.at;
    c.className = s.candidate.effect.className;
    c.score = s.score();
    c.strength = s.probes.empty() ? 0 : s.probes.front().strength();
    c.deltaBic = deltaBic;
    c.verdict = verdict;
    c.absorbedBy = s.absorbedBy;
    c.round = round_;
    c.failure = failure;
    c.reason = why;
    trace("judge", keyOf(s.candidate.effect, s.candidate.place),
          {{"score", c.score}, {"delta_bic", deltaBic.value_or(std::nan(""))}}, name(verdict), why);
    candidates_.push_back(std::move(c));
}

/// Screens every candidate and refits those that promise most.
Search::Round Search::tryAll(const NullModel& null) {
    Round round;
    round.screened = screenAll(null);
    if (progress_.stopRequested()) return round;
    std::vector<Eigen::MatrixXd> directions;
    for (const Screened& s : round.screened)
        if (!s.probes.empty() && !s.isAbsorbed()) directions.push_back(s.probes.front().plain.directions);
    const double logRows = std::log(static_cast<double>(null.fit.optimum.residuals.size()));
    round.leastScore = isNoise(null) ? equivalenceMargin : 0;
    parallelFor(2, options_.threads, [&](int i) {
        if (i == 0)
            round.trials = tryBest(null, round.screened, round.leastScore);
        else
            round.threshold = noiseThreshold(directions, logRows, falseAlarmQuantile, 1);
    });
    traceRound(null, round);
    return round;
}

/// The best that passes its tests; what lies close to it is its class, of which the simplest is taken.
void Search::decide(const NullModel& null, Round& round) const {
    const std::vector<Trial>& trials = round.trials;
    struct Judged {
        std::size_t trial;
        Acceptance acceptance;
    };
    std::optional<Judged> proposal, unconfirmed;
    for (std::size_t i = 0; i < trials.size() && !round.chosen; ++i) {
        if (!trials[i].ok || trials[i].evidence < equivalenceMargin) break;
        if (isAtBound(trials[i]))
            round.refused[i] = atBound();
        else if (isProposal(trials[i]) && proposal)
            round.refused[i] = phrase("explains less than {}", nameOf(round.candidate(proposal->trial)));
        else if (!isProposal(trials[i]) && fightsAnother(null, trials[i].fit))
            round.refused[i] = fights();
        if (round.refused.contains(i)) continue;
        const Judged judged{i, examine(null, trials[i].fit, trials[i].freed(), round.threshold)};
        const Acceptance& acceptance = judged.acceptance;
        if (!acceptance.accepted()) round.refused[i] = whyRefused(acceptance, acceptance.leastHeldOutAsked);
        if (isProposal(trials[i])) {
            if (acceptance.accepted())
                proposal = judged;
            else if (!unconfirmed && acceptance.isSignificant && levelOf(trials[i].fit) <= largeResidual)
                unconfirmed = judged;
            continue;
        }
        round.acceptance = acceptance;
        if (acceptance.accepted())
            round.chosen = i;
        else if (acceptance.isSignificant && !acceptance.holdsOut)
            round.failsHeldOut.insert(i);
        else if (!acceptance.isSignificant && !acceptance.isAtEdges && acceptance.heldOut > leastHeldOut &&
                 acceptance.isWorthwhile)
            round.tooFaint.push_back(i);
    }
    if (round.chosen) {
        round.behind = phrase("explains less than {}", nameOf(round.candidate(*round.chosen)));
        preferSimple(null, round);
    }
    // An equation that leaves next to nothing refutes the names that explain far less, even where only one part of the
    // record tells of it. So does what happens once, where no name passes and it leaves noise.
    if (!proposal && unconfirmed) {
        const Trial& equation = trials[unconfirmed->trial];
        const double share = independentShare(null, equation.fit);
        const bool stands = round.chosen
                                ? share * (equation.evidence - trials[*round.chosen].evidence) > 3 * equivalenceMargin
                                : share * equation.evidence > leastOfOnce && isNoise(null.channels, equation.fit);
        if (stands) proposal = unconfirmed;
    }
    if (!proposal) return;
    // Where an equation without a name explains clearly more than any name, none of the names fits.
    if (beatsNames(null, trials, proposal->trial, round.chosen)) {
        if (round.chosen)
            round.refused[*round.chosen] = phrase("{}, an equation without a name, is the better account",
                                                  nameOf(round.candidate(proposal->trial)));
        const std::vector<std::size_t> places = equalPlaces(null, trials, proposal->trial);
        if (const std::size_t first = places.front(); first != proposal->trial) {
            const Judged there{first, examine(null, trials[first].fit, trials[first].freed(), round.threshold)};
            if (there.acceptance.accepted() || !proposal->acceptance.accepted()) proposal = there;
        }
        round.chosen = proposal->trial;
        round.acceptance = proposal->acceptance;
        round.members = equivalents(null, trials, proposal->trial);
        // told beside it are the names that take more to explain as much, and its other places
        std::erase_if(round.members, [&](std::size_t i) {
            return i != proposal->trial && trials[i].freed() <= trials[proposal->trial].freed();
        });
        for (const std::size_t i : places)
            if (i != proposal->trial) round.members.push_back(i);
    } else {
        round.refused[proposal->trial] =
            round.chosen ? phrase("an equation without a name, and not clearly a better account than {}",
                                  nameOf(round.candidate(*round.chosen)))
                         : withinChance(trials[proposal->trial].evidence, 2 * equivalenceMargin);
    }
}

void Search::Round::passOver(const Text& why) {
    if (chosen) refused[*chosen] = why;
    chosen.reset();
    members.clear();
}

/// While much is left whatever is taken, one step explains with its flexible parameters what belongs to others: the
/// simplest that explains nearly as much goes first.
void Search::preferSimple(const NullModel& null, Round& round) const {
    const std::vector<Trial>& trials = round.trials;
    const Trial& best = trials[*round.chosen];
    const double fall = null.sumOfSquares() - best.sumOfSquares();
    const bool leavesMuch = levelOf(best.fit) > largeResidual;
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
        const bool isNearly = leavesMuch && null.sumOfSquares() - trials[i].sumOfSquares() > nearlyAsMuch * fall;
        if ((isMember && (isSimpler || isLikelier)) || (isNearly && isSimpler)) simpler.push_back(i);
    }
    std::stable_sort(simpler.begin(), simpler.end(),
                     [&](std::size_t a, std::size_t b) { return trials[a].freed() < trials[b].freed(); });
    for (const std::size_t i : simpler) {
        const Acceptance a = examine(null, trials[i].fit, trials[i].freed(), round.threshold);
        if (!a.accepted()) {
            round.refused[i] = whyRefused(a, a.leastHeldOutAsked);
            continue;
        }
        round.refused[*round.chosen] =
            trials[i].freed() < best.freed()
                ? phrase("{} explains nearly as much with fewer parameters", nameOf(round.candidate(i)))
                : phrase("{} explains nearly as much, and is met more often", nameOf(round.candidate(i)));
        round.chosen = i;
        round.acceptance = a;
        round.members = equivalents(null, trials, i);
        break;
    }
}

/// The step that the round has decided on, with what came near it.
Search::Step Search::stepOf(const NullModel& null, const Round& round) {
    const std::vector<Trial>& trials = round.trials;
    const std::size_t chosen = *round.chosen;
    const auto isMember = [&](std::size_t i) {
        return std::find(round.members.begin(), round.members.end(), i) != round.members.end();
    };
    const auto alternative = [&](std::size_t i, bool isEquivalent) {
        const Candidate& c = trials[i].screened.candidate;
        return Alternative{c.effect.kind, c.place.at, trials[chosen].evidence - trials[i].evidence, isEquivalent};
    };
    Step s;
    s.order = ++choices_;
    s.winner = trials[chosen];
    s.acceptance = round.acceptance;
    s.tried = round.screened.size();
    for (const std::size_t m : round.members) {
        if (m == chosen) continue;
        s.alternatives.push_back(alternative(m, true));
        s.rivals.push_back(trials[m].screened.candidate);
    }
    const EffectPlace& place = trials[chosen].screened.candidate.place;
    const double weight = independentShare(null, trials[chosen].fit);
    // best first: what comes before the chosen one explains more, though not by enough to refute a name
    const auto explainsAsMuch = [&](std::size_t i) {
        const Trial &equation = trials[i], &name = trials[chosen];
        if (i < chosen) return true;
        return equation.freed() <= name.freed() && isLike(equation, name.evidence, weight) &&
               std::none_of(equation.screened.probes.begin(), equation.screened.probes.end(),
                            [&](const Probe& p) { return isTwin(p, name.screened); });
    };
    for (std::size_t i = 0; i < trials.size() && s.equation.empty() && !isProposal(trials[chosen]); ++i)
        if (trials[i].ok && isProposal(trials[i]) && trials[i].screened.candidate.place.connector == place.connector &&
            explainsAsMuch(i))
            s.equation = withValues(equationOf(trials[i].variant.effects.back()),
                                    estimatesOf(trials[i].variant.effects.back(), trials[i].fit));
    for (std::size_t i = 0; i < trials.size(); ++i) {
        if (!trials[i].ok || isMember(i) || i == chosen) continue;
        // what goes to the same place is taken for it most easily, however many places did better
        const bool isNear = trials[i].screened.candidate.place.connector == place.connector;
        if ((s.rivals.size() < mostRivals || isNear) && trials[i].evidence > rivalShare * trials[chosen].evidence)
            s.rivals.push_back(trials[i].screened.candidate);
        if (s.alternatives.size() < mostAlternatives) s.alternatives.push_back(alternative(i, false));
    }
    return s;
}

/// The round's line for every candidate of the table.
void Search::noteAll(const Round& round) {
    std::set<std::string> refitted;
    for (std::size_t i = 0; i < round.trials.size(); ++i) {
        const Trial& t = round.trials[i];
        refitted.insert(keyOf(t.screened.candidate.effect, t.screened.candidate.place));
        Verdict verdict = Verdict::NotSignificant;
        const auto refused = round.refused.find(i);
        Text why = refused != round.refused.end()   ? refused->second
                   : t.evidence < equivalenceMargin ? withinChance(t.evidence, equivalenceMargin)
                                                    : round.behind;
        if (!t.ok) {
            verdict = Verdict::Failed;
            why =
                t.failure.empty() ? phrase("no fit with it could begin") : phrase("could not be fitted: {}", t.failure);
        } else if (round.chosen && i == *round.chosen) {
            verdict = Verdict::Chosen;
            why = {};
        } else if (std::find(round.members.begin(), round.members.end(), i) != round.members.end()) {
            verdict = Verdict::Equivalent;
            why = phrase("the data cannot tell it from {}", nameOf(round.candidate(*round.chosen)));
        } else if (round.failsHeldOut.contains(i)) {
            verdict = Verdict::FailsHeldOut;
        } else if (round.chosen && t.evidence > equivalenceMargin) {
            verdict = Verdict::Weaker;
        }
        note(t.screened, verdict, why, t.ok ? std::optional<double>(-t.evidence) : std::nullopt,
             t.ok ? Text() : t.failure);
    }
    for (const Screened& s : round.screened) {
        if (refitted.contains(keyOf(s.candidate.effect, s.candidate.place))) continue;
        const Verdict verdict = !s.failure.empty()                                  ? Verdict::Failed
                                : s.isAbsorbed()                                    ? Verdict::Absorbed
                                : s.isWrongSign()                                   ? Verdict::WrongSign
                                : round.chosen && s.score() > 2 * equivalenceMargin ? Verdict::Weaker
                                                                                    : Verdict::NotSignificant;
        note(s, verdict, whyNotRefitted(s, round.leastScore), std::nullopt, s.failure);
    }
}

/// What was chosen on the way and is not in the end is no choice, nor are its equals.
void Search::settleVerdicts(const Finding& finding, std::vector<CandidateResult>& candidates) {
    const auto isAmong = [](const auto& all, const CandidateResult& c) {
        return std::any_of(all.begin(), all.end(), [&](const auto& x) { return x.kind == c.kind && x.at == c.at; });
    };
    const auto isThere = [&](const CandidateResult& c) {
        return isAmong(finding.effects, c) ||
               std::any_of(finding.remainders.begin(), finding.remainders.end(),
                           [&](const Remainder& r) { return r.proposedClass == c.className && r.node == c.at; });
    };
    const auto isEqual = [&](const CandidateResult& c) {
        return isAmong(finding.effects, c) ||
               std::any_of(finding.effects.begin(), finding.effects.end(),
                           [&](const AddedEffect& e) { return isAmong(e.alternatives, c); }) ||
               std::any_of(finding.remainders.begin(), finding.remainders.end(), [&](const Remainder& r) {
                   return r.proposedClass == c.className &&
                          std::find(r.equalNodes.begin(), r.equalNodes.end(), c.at) != r.equalNodes.end();
               });
    };
    for (CandidateResult& c : candidates) {
        if (c.verdict == Verdict::Chosen && !isThere(c)) {
            c.verdict = Verdict::NotSignificant;
            c.reason = phrase("was not kept to the end of the search");
        }
        if (c.verdict == Verdict::Equivalent && !isEqual(c)) {
            c.verdict = Verdict::Weaker;
            c.reason = phrase("is no equal of anything that was kept: {}", c.reason);
        }
    }
}

}  // namespace analogon
