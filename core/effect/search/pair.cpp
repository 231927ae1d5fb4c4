#include "core/effect/search/pair.hpp"

#include <algorithm>

#include "core/effect/judge/judgement.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/path.hpp"
#include "core/effect/search/prune.hpp"
#include "core/effect/search/trials.hpp"
#include "core/effect/search/verdicts.hpp"
#include "core/effect/search/without.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::pairs;
using threshold::likely::mostFitted;
using threshold::paths::otherPaths;
using threshold::rounds::nearlyTheSame;

namespace {

/// Two of a list that explain this much together.
struct Pair {
    std::size_t stronger, weaker;
    double explained;
};

/// The pairs that explain nearly as much as the best, best first.
std::vector<Pair> bestPairs(const std::vector<const Screened*>& effects) {
    std::vector<Pair> pairs;
    for (std::size_t a = 0; a < effects.size(); ++a)
        for (std::size_t b = a + 1; b < effects.size(); ++b) {
            const Candidate &x = effects[a]->candidate, &y = effects[b]->candidate;
            if (x.place.at == y.place.at && x.effect.kind == y.effect.kind) continue;
            pairs.push_back(
                {a, b, explainedTogether(effects[a]->probes.front().plain, effects[b]->probes.front().plain)});
        }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& p, const Pair& q) { return p.explained > q.explained; });
    std::erase_if(pairs, [&](const Pair& p) { return p.explained < nearlyTheSame * pairs.front().explained; });
    return pairs;
}

bool isSame(const Candidate& a, const Candidate& b) {
    return a.effect.className == b.effect.className && a.place == b.place;
}

/// A trial of the fault of one effect at the signal of another, beside a model without either.
std::optional<Trial> trialOf(SearchContext& search, const NullModel& rest, const std::string& fault,
                             const EffectPlace& place) {
    const Outcome<std::vector<Candidate>> candidates = candidatesIn(search, rest.variant);
    if (!candidates) return std::nullopt;
    const auto found = std::find_if(candidates->begin(), candidates->end(), [&](const Candidate& c) {
        return c.place == place && c.effect.proposal.empty() && faultOf(c.effect) == fault;
    });
    if (found == candidates->end()) return std::nullopt;
    search.say("reconsider", phrase("{} at {}", found->effect.kind, place.at), -1);
    const Screened screened = screen(rest, *found, search.fit.simulation, search.progress);
    if (!screened.failure.empty()) return std::nullopt;
    std::vector<Trial> trials = tryThese(search, rest, {&screened}, 2 * trialIterations, startsPerTrial);
    if (search.progress.stopRequested() || trials.empty() || !trials.front().ok) return std::nullopt;
    return std::move(trials.front());
}

}  // namespace

void crossOver(SearchContext& search, Node& node) {
    if (!(reducedChi(node.null.fit) < mostForPairs)) return;
    for (std::size_t i = 0; i + 1 < node.null.variant.effects.size() && !search.progress.stopRequested(); ++i) {
        const PlacedEffect a = node.null.variant.effects[i], b = node.null.variant.effects.back();
        const bool areFaults = !a.effect.placement.signalSide.empty() && !b.effect.placement.signalSide.empty() &&
                               a.effect.proposal.empty() && b.effect.proposal.empty() && a.twins.empty() &&
                               b.twins.empty();
        if (!areFaults || a.place == b.place || faultOf(a.effect) == faultOf(b.effect)) continue;
        std::vector<PlacedEffect> others = node.null.variant.effects;
        others.pop_back();
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        const std::optional<NullModel> rest = refittedWith(search, node.null, others);
        if (!rest) continue;
        std::optional<Trial> first = trialOf(search, *rest, faultOf(b.effect), a.place);
        if (!first) continue;
        Outcome<NullModel> between =
            fitNull(first->variant, node.null.noise, NoiseLevel::Keep, search.fit, search.progress);
        if (!between) continue;
        std::optional<Trial> second = trialOf(search, *between, faultOf(a.effect), b.place);
        if (!second) continue;
        Outcome<NullModel> crossed =
            fitNull(second->variant, node.null.noise, NoiseLevel::Keep, search.fit, search.progress);
        const bool isTaken =
            crossed && gainOver(node.null, crossed->sumOfSquares(),
                                crossed->parameterCount() - node.null.parameterCount()) > equivalenceMargin;
        if (crossed) search.journal.model("cross over", *crossed, isTaken ? "taken" : "set aside");
        if (!isTaken) continue;
        node.steps.pop_back();
        node.steps.erase(node.steps.begin() + static_cast<std::ptrdiff_t>(i));
        const auto take = [&](const NullModel& before, Trial trial) {
            Step step;
            step.order = ++search.journal.choices;
            step.acceptance = examine(search, before, trial, 0);
            step.winner = std::move(trial);
            node.steps.push_back(std::move(step));
        };
        take(*rest, std::move(*first));
        take(*between, std::move(*second));
        const Candidate &one = node.steps[node.steps.size() - 2].winner.screened.candidate,
                        &other = node.steps.back().winner.screened.candidate;
        for (const PlacedEffect& old : {a, b})
            setVerdict(search, node, old, Verdict::Weaker,
                       phrase("{} and {} explain more in place of both", nameOf(one), nameOf(other)));
        setVerdict(search, node, one, Verdict::Chosen, {});
        setVerdict(search, node, other, Verdict::Chosen, {});
        node.null = std::move(*crossed);
        return;
    }
}

std::vector<const Screened*> worthPairing(const std::vector<Screened>& screened) {
    std::vector<const Screened*> named;
    for (const Screened& s : screened)
        if (s.failure.empty() && s.score() > 0 && s.candidate.effect.proposal.empty()) named.push_back(&s);
    std::stable_sort(named.begin(), named.end(),
                     [](const Screened* a, const Screened* b) { return a->score() > b->score(); });
    if (named.size() > mostScreened) named.resize(mostScreened);
    return named;
}

Round withPairMembers(SearchContext& search, const NullModel& null, Round round) {
    const std::vector<const Screened*> named = worthPairing(round.screened);
    std::vector<const Screened*> members;
    const auto add = [&](const Screened* s) {
        const auto isIt = [&](const Trial& t) { return isSame(t.screened.candidate, s->candidate); };
        if (std::any_of(round.trials.begin(), round.trials.end(), isIt)) return;
        if (members.size() < mostFitted && std::find(members.begin(), members.end(), s) == members.end())
            members.push_back(s);
    };
    for (const Pair& p : bestPairs(named)) {
        add(named[p.stronger]);
        add(named[p.weaker]);
    }
    std::vector<Trial> more = tryThese(search, null, members, 2 * trialIterations, startsPerTrial);
    search.journal.trials("trial for a pair", null, more);
    round.trials.insert(round.trials.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    round.chosen.reset();
    round.members.clear();
    round.refused = {};
    round.refused.behind = phrase("explains less together with another than the pair with which the search began");
    rank(null, round.trials);
    return round;
}

std::optional<Round> chosenTogether(SearchContext& search, const Node& node, Round& round) {
    const NullModel& null = node.null;
    std::vector<std::size_t> begins;
    for (const std::size_t i : round.refused.tooFaint) {
        const double chi2Decrease = null.sumOfSquares() - round.trials[i].sumOfSquares();
        if (begins.size() < otherPaths && isGoodPart(chi2Decrease, null)) begins.push_back(i);
    }
    if (begins.empty() || isNoise(null) || isColouredNoise(search, null)) return std::nullopt;
    for (const std::size_t begin : begins) {
        const Trial& first = round.trials[begin];
        Outcome<NullModel> one = fitNull(first.variant, null.noise, NoiseLevel::Keep, search.fit, search.progress);
        if (!one) continue;
        Round second = tryAll(search, *one);
        if (search.progress.stopRequested()) return std::nullopt;
        decide(search, *one, second);
        if (!second.chosen) continue;
        const Trial& last = second.trials[*second.chosen];
        Outcome<NullModel> both = fitNull(last.variant, null.noise, NoiseLevel::Keep, search.fit, search.progress);
        if (!both) continue;
        const Acceptance together = examine(null, both->fit, first.freed() + last.freed(), round.threshold);
        const bool pass = together.accepted() && !isWithinForms(node, std::max(together.evidence, together.effective));
        const Candidate &taken = first.screened.candidate, &beside = last.screened.candidate;
        search.journal.test("together", keyOf(taken.effect, taken.place) + " + " + keyOf(beside.effect, beside.place),
                            together, pass ? "accepted" : "refused");
        if (!pass) continue;
        const std::optional<NullModel> rest = without(search, *both, null.variant.effects.size());
        if (!rest) continue;
        const Acceptance missed = examine(*rest, both->fit, first.freed(), 0);
        search.journal.test("beside the other", keyOf(taken.effect, taken.place), missed,
                            missed.accepted() ? "accepted" : "refused");
        if (!missed.accepted()) continue;
        round.choose(null, begin, missed);
        round.refused.why.erase(begin);
        round.refused.behind = phrase("explains less than {}", nameOf(round.candidate(begin)));
        return second;
    }
    return std::nullopt;
}

std::vector<std::size_t> pairBeginnings(const NullModel& null, const Round& round, std::size_t most,
                                        const std::vector<Candidate>& taken) {
    std::vector<std::size_t> named;
    std::vector<const Screened*> screened;
    for (std::size_t i = 0; i < round.trials.size(); ++i) {
        const Trial& t = round.trials[i];
        const auto isIt = [&](const Candidate& c) { return isSame(c, t.screened.candidate); };
        if (!t.ok || !(t.evidence > 0) || isProposal(t) || mayFollowOthers(null, t) ||
            std::any_of(taken.begin(), taken.end(), isIt))
            continue;
        named.push_back(i);
        screened.push_back(&t.screened);
    }
    std::vector<std::size_t> begins;
    const auto isThere = [&](std::size_t i) { return std::find(begins.begin(), begins.end(), i) != begins.end(); };
    for (const Pair& p : bestPairs(screened)) {
        if (begins.size() == most) break;
        const std::size_t stronger = named[p.stronger], weaker = named[p.weaker];
        if (!isThere(stronger) && !isThere(weaker)) begins.push_back(stronger);
    }
    return begins;
}

}  // namespace analogon
