/// Two effects that hide each other: neither need show alone, and the strongest alone need not be one of them.
#include <algorithm>

#include "core/effect/judge/reason.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/search/search.hpp"

namespace analogon {
namespace {

constexpr std::size_t mostScreened = 60;   // that are paired
constexpr std::size_t mostMembers = 4;     // that are tried because of a pair
constexpr std::size_t mostForGranted = 2;  // for another to be sought beside each
constexpr double nearlyBest = 0.95;        // of what the best pair explains, for another to be looked at

/// Two of a list that explain this much together.
struct Pair {
    std::size_t stronger, weaker;
    double explained;
};

/// The pairs that explain nearly as much as the best, best first.
std::vector<Pair> bestPairs(const std::vector<const Screened*>& effects, const Eigen::VectorXd& residual) {
    std::vector<Pair> pairs;
    for (std::size_t a = 0; a < effects.size(); ++a)
        for (std::size_t b = a + 1; b < effects.size(); ++b) {
            const Candidate &x = effects[a]->candidate, &y = effects[b]->candidate;
            if (x.place.at == y.place.at && x.effect.kind == y.effect.kind) continue;
            pairs.push_back({a, b,
                             explainedTogether(effects[a]->probes.front().plain.directions,
                                               effects[b]->probes.front().plain.directions, residual)});
        }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& p, const Pair& q) { return p.explained > q.explained; });
    std::erase_if(pairs, [&](const Pair& p) { return p.explained < nearlyBest * pairs.front().explained; });
    return pairs;
}

bool isSame(const Candidate& a, const Candidate& b) {
    return a.effect.className == b.effect.className && a.place == b.place;
}

}  // namespace

/// A trial of the fault of one effect at the signal of another, beside a model without either.
std::optional<Trial> Search::trialOf(const NullModel& rest, const std::string& fault, const EffectPlace& place) {
    const Outcome<std::vector<Candidate>> candidates = candidatesIn(rest.variant);
    if (!candidates) return std::nullopt;
    const auto found = std::find_if(candidates->begin(), candidates->end(), [&](const Candidate& c) {
        return c.place == place && c.effect.proposal.empty() && faultOf(c.effect) == fault;
    });
    if (found == candidates->end()) return std::nullopt;
    say("reconsider", phrase("{} at {}", found->effect.kind, place.at), -1);
    const Screened screened = screen(rest, *found, search_.fit.simulation, progress_);
    if (!screened.failure.empty()) return std::nullopt;
    std::vector<Trial> trials = tryThese(rest, {&screened}, 2 * trialIterations, startsPerTrial);
    if (progress_.stopRequested() || trials.empty() || !trials.front().ok) return std::nullopt;
    return std::move(trials.front());
}

/// A lag of one signal and a dead time of another look much like the dead time of the one and the lag of the other, and
/// no exchange of one alone leads from there to here: the newest effect is tried the other way round with each before
/// it.
void Search::crossOver(NullModel& null) {
    if (!(levelOf(null.fit) < mostForPairs)) return;
    for (std::size_t i = 0; i + 1 < null.variant.effects.size() && !progress_.stopRequested(); ++i) {
        const PlacedEffect a = null.variant.effects[i], b = null.variant.effects.back();
        const bool areFaults = !a.effect.signalSide.empty() && !b.effect.signalSide.empty() &&
                               a.effect.proposal.empty() && b.effect.proposal.empty() && a.twins.empty() &&
                               b.twins.empty();
        if (!areFaults || a.place == b.place || faultOf(a.effect) == faultOf(b.effect)) continue;
        std::vector<PlacedEffect> others = null.variant.effects;
        others.pop_back();
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        const std::optional<NullModel> rest = refittedWith(null, others);
        if (!rest) continue;
        std::optional<Trial> first = trialOf(*rest, faultOf(b.effect), a.place);
        if (!first) continue;
        Outcome<NullModel> between = fitNull(first->variant, null.noise, NoiseLevel::Keep, search_.fit, progress_);
        if (!between) continue;
        std::optional<Trial> second = trialOf(*between, faultOf(a.effect), b.place);
        if (!second) continue;
        Outcome<NullModel> crossed = fitNull(second->variant, null.noise, NoiseLevel::Keep, search_.fit, progress_);
        const bool isTaken = crossed && gainOver(null, crossed->sumOfSquares(),
                                                 crossed->parameterCount() - null.parameterCount()) > equivalenceMargin;
        if (crossed) traceModel("cross over", *crossed, isTaken ? "taken" : "set aside");
        if (!isTaken) continue;
        steps_.pop_back();
        steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(i));
        const auto take = [&](const NullModel& before, Trial trial) {
            Step step;
            step.order = ++choices_;
            step.acceptance = examine(before, trial.fit, trial.freed(), 0);
            step.winner = std::move(trial);
            steps_.push_back(std::move(step));
        };
        take(*rest, std::move(*first));
        take(*between, std::move(*second));
        const Candidate &one = steps_[steps_.size() - 2].winner.screened.candidate,
                        &other = steps_.back().winner.screened.candidate;
        for (const PlacedEffect& old : {a, b})
            setVerdict(old, Verdict::Weaker,
                       phrase("{} and {} explain more in place of both", nameOf(one), nameOf(other)));
        setVerdict(one, Verdict::Chosen, {});
        setVerdict(other, Verdict::Chosen, {});
        null = std::move(*crossed);
        return;
    }
}

/// The same round with trials of those that explain most together with another: the best alone may have left them no
/// place among what was tried.
Search::Round Search::withPairMembers(const NullModel& null, Round round) {
    std::vector<const Screened*> named;
    for (const Screened& s : round.screened)
        if (s.failure.empty() && s.score() > 0 && s.candidate.effect.proposal.empty()) named.push_back(&s);
    std::stable_sort(named.begin(), named.end(),
                     [](const Screened* a, const Screened* b) { return a->score() > b->score(); });
    if (named.size() > mostScreened) named.resize(mostScreened);
    std::vector<const Screened*> members;
    const auto add = [&](const Screened* s) {
        const auto isIt = [&](const Trial& t) { return isSame(t.screened.candidate, s->candidate); };
        if (std::any_of(round.trials.begin(), round.trials.end(), isIt)) return;
        if (members.size() < mostMembers && std::find(members.begin(), members.end(), s) == members.end())
            members.push_back(s);
    };
    for (const Pair& p : bestPairs(named, null.fit.optimum.residuals)) {
        add(named[p.stronger]);
        add(named[p.weaker]);
    }
    std::vector<Trial> more = tryThese(null, members, 2 * trialIterations, startsPerTrial);
    traceTrials("trial for a pair", null, more);
    round.trials.insert(round.trials.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    round.chosen.reset();
    round.members.clear();
    round.failsHeldOut.clear();
    round.tooFaint.clear();
    round.refused.clear();
    round.behind = phrase("explains less together with another than the pair with which the search began");
    rank(null, round.trials);
    return round;
}

/// Where one effect leaves another, what is left has a long memory: few of its samples are independent, and neither of
/// the two may show by itself, however much it explains. With one of them for granted another is sought; both are
/// chosen where they pass the tests together, and each is missed beside the other. The choice beside the round's own;
/// nothing: there are no two.
std::optional<Search::Round> Search::chosenTogether(const NullModel& null, Round& round) {
    std::vector<std::size_t> begins;
    for (const std::size_t i : round.tooFaint) {
        const double fall = null.sumOfSquares() - round.trials[i].sumOfSquares();
        if (begins.size() < mostForGranted && fall > goodPart * excess(null)) begins.push_back(i);
    }
    if (begins.empty() || isNoise(null) || isColouredNoise(null)) return std::nullopt;
    for (const std::size_t begin : begins) {
        const Trial& first = round.trials[begin];
        Outcome<NullModel> one = fitNull(first.variant, null.noise, NoiseLevel::Keep, search_.fit, progress_);
        if (!one) continue;
        Round second = tryAll(*one);
        if (progress_.stopRequested()) return std::nullopt;
        decide(*one, second);
        if (!second.chosen) continue;
        const Trial& last = second.trials[*second.chosen];
        Outcome<NullModel> both = fitNull(last.variant, null.noise, NoiseLevel::Keep, search_.fit, progress_);
        if (!both) continue;
        const Acceptance together = examine(null, both->fit, first.freed() + last.freed(), round.threshold);
        const bool pass = together.accepted() && !isWithinForms(std::max(together.evidence, together.effective));
        const Candidate &taken = first.screened.candidate, &beside = last.screened.candidate;
        traceTest("together", keyOf(taken.effect, taken.place) + " + " + keyOf(beside.effect, beside.place), together,
                  pass ? "accepted" : "refused");
        if (!pass) continue;
        const std::optional<NullModel> rest = without(*both, null.variant.effects.size());
        if (!rest) continue;
        const Acceptance missed = examine(*rest, both->fit, first.freed(), 0);
        traceTest("beside the other", keyOf(taken.effect, taken.place), missed,
                  missed.accepted() ? "accepted" : "refused");
        if (!missed.accepted()) continue;
        round.chosen = begin;
        round.members = equivalents(null, round.trials, begin);
        round.acceptance = missed;
        round.refused.erase(begin);
        round.behind = phrase("explains less than {}", nameOf(round.candidate(begin)));
        return second;
    }
    return std::nullopt;
}

/// The members of the pairs that explain most together, each pair by the one that explains more alone; at most `most`,
/// none of `taken`.
std::vector<std::size_t> Search::pairBeginnings(const NullModel& null, const Round& round, std::size_t most,
                                                const std::vector<Candidate>& taken) const {
    std::vector<std::size_t> named;
    std::vector<const Screened*> screened;
    for (std::size_t i = 0; i < round.trials.size(); ++i) {
        const Trial& t = round.trials[i];
        const auto isIt = [&](const Candidate& c) { return isSame(c, t.screened.candidate); };
        if (!t.ok || !(t.evidence > 0) || isProposal(t) || std::any_of(taken.begin(), taken.end(), isIt)) continue;
        named.push_back(i);
        screened.push_back(&t.screened);
    }
    std::vector<std::size_t> begins;
    const auto isThere = [&](std::size_t i) { return std::find(begins.begin(), begins.end(), i) != begins.end(); };
    for (const Pair& p : bestPairs(screened, null.fit.optimum.residuals)) {
        if (begins.size() == most) break;
        const std::size_t stronger = named[p.stronger], weaker = named[p.weaker];
        if (!isThere(stronger) && !isThere(weaker)) begins.push_back(stronger);
    }
    return begins;
}

}  // namespace analogon
