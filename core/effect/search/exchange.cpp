#include "core/effect/search/exchange.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/parallel.hpp"
#include "core/effect/judge/judgement.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/trials.hpp"
#include "core/effect/search/verdicts.hpp"
#include "core/effect/search/without.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::exchange;

namespace {

/// Whether both are the same fault of a measured or a commanded signal: an offset and an offset, a lag and a lag.
bool isSameFault(const EffectClass& a, const EffectClass& b) {
    return !a.placement.signalSide.empty() && !b.placement.signalSide.empty() && a.proposal.empty() &&
           faultOf(a) == faultOf(b);
}

/// While much is left, what is likelier than an effect and does as well as the best comes first.
void likelierFirst(const NullModel& null, const EffectClass& old, std::vector<Trial>& trials) {
    const Trial& best = trials.front();
    if (!(reducedChi(best.fit) > largeResidual)) return;
    const auto isLikelier = [&](const Trial& t) {
        return t.ok && !isProposal(t) && !isAtBound(t) && t.freed() == best.freed() &&
               plausibility(t.screened.candidate.effect) < plausibility(old) &&
               isLike(t, best.evidence, independentShare(null, best.fit));
    };
    const auto first = std::find_if(trials.begin(), trials.end(), isLikelier);
    if (first != trials.end()) std::rotate(trials.begin(), first, first + 1);
}

/// What explains no less than an effect that stands for so much evidence, as far as the data tell, with fewer
/// parameters comes first, unless something else is clearly better. True: one does.
bool simplerFirst(const NullModel& null, double evidence, int freed, std::vector<Trial>& trials) {
    const Trial& best = trials.front();
    const double weight = independentShare(null, best.fit);
    if (weight * (best.evidence - evidence) > equivalenceMargin) return false;
    auto simplest = trials.end();
    for (auto t = trials.begin(); t != trials.end(); ++t) {
        if (!t->ok || isProposal(*t) || isAtBound(*t) || fightsAnother(null, t->fit)) continue;
        if (isLike(*t, evidence, weight) && t->freed() < (simplest == trials.end() ? freed : simplest->freed()))
            simplest = t;
    }
    if (simplest == trials.end()) return false;
    std::rotate(trials.begin(), simplest, simplest + 1);
    return true;
}

}  // namespace

bool isExchanged(const RivalCase& rival) {
    const bool isHardlyTold = rival.weight * rival.gain < equivalenceMargin || rival.isAtTheEndOfMuch;
    return rival.isSimplerEqual || rival.isLikelierEqual ||
           (rival.gain > leastGain && !(rival.likelier < 0 && isHardlyTold));
}

bool isLike(const Trial& trial, double evidence, double weight) {
    return trial.evidence > leastLike * evidence && weight * (evidence - trial.evidence) < equivalenceMargin;
}

namespace {

/// An effect of a node that may be exchanged, beside the model without it.
struct Contested {
    const Node& node;
    std::size_t effect;
    const NullModel& rest;

    const PlacedEffect& placed() const { return node.null.variant.effects[effect]; }
    const Step& step() const { return node.steps[effect]; }
    int freed() const { return static_cast<int>(placed().freed.size()); }
    /// Evidence that the model gains where a trial takes its place.
    double gainOf(const Trial& t) const { return gainOver(node.null, t.sumOfSquares(), t.freed() - freed()); }
};

/// Of a kind that is known to do worse, another class (surroundings of unknown temperature) may do as well.
bool isKnown(const Contested& old, const Candidate& c) {
    const std::vector<Alternative>& known = old.step().alternatives;
    return std::any_of(known.begin(), known.end(), [&](const Alternative& a) {
        return a.kind == c.effect.kind && a.at == c.place.at &&
               (a.equivalent || !c.effect.placement.signalSide.empty());
    });
}

/// The same fault of another signal, which may have been far from it as long as what stands beside both was missing.
bool isAtAnotherSignal(const Contested& old, const Candidate& c) {
    const std::vector<Alternative>& known = old.step().alternatives;
    return isSameFault(c.effect, old.placed().effect) && !(c.place == old.placed().place) &&
           std::none_of(known.begin(), known.end(), [&](const Alternative& a) {
               return a.kind == c.effect.kind && a.at == c.place.at && a.equivalent;
           });
}

bool isRival(const Contested& old, const Candidate& c, Rivals wanted, const EffectPlace* elsewhere) {
    const PlacedEffect& placed = old.placed();
    if (elsewhere != nullptr) return c.effect.className == placed.effect.className && c.place == *elsewhere;
    const bool isOther = c.effect.className != placed.effect.className && c.effect.proposal.empty();
    if (wanted == Rivals::New)
        return isAtAnotherSignal(old, c) ||
               (isOther && c.place.connector == placed.place.connector && !isKnown(old, c));
    // at a signal's place, what goes there too is taken for it most easily; no round may have told so
    if (isOther && !placed.effect.placement.signalSide.empty() && c.place == placed.place) return true;
    const std::vector<Candidate>& rivals = old.step().rivals;
    return std::any_of(rivals.begin(), rivals.end(), [&](const Candidate& rival) {
        return c.effect.className == rival.effect.className && c.place == rival.place;
    });
}

/// The rivals of an effect, screened beside the model without it.
std::vector<Screened> screenRivals(SearchContext& search, const Contested& old, Rivals wanted,
                                   const EffectPlace* elsewhere) {
    const Outcome<std::vector<Candidate>> places = candidatesIn(search, old.rest.variant);
    if (!places) return {};
    std::vector<Candidate> rivals;
    std::copy_if(places->begin(), places->end(), std::back_inserter(rivals),
                 [&](const Candidate& c) { return isRival(old, c, wanted, elsewhere); });
    std::vector<Screened> screened(rivals.size());
    parallelFor(static_cast<int>(rivals.size()), search.options.threads, [&](int i) {
        const Candidate& rival = rivals[static_cast<std::size_t>(i)];
        search.say("reconsider", phrase("{} at {} for {}", rival.effect.kind, rival.place.at, old.placed().effect.kind),
                   -1);
        screened[static_cast<std::size_t>(i)] = screen(old.rest, rival, search.fit.simulation, search.progress);
    });
    return screened;
}

/// Those of them that are worth it refitted, best first.
std::vector<Trial> tryRivals(SearchContext& search, const Contested& old, const std::vector<Screened>& screened,
                             Rivals wanted) {
    // at the end few are left to try: also those whose slope has the wrong sign, beside parameters that took their part
    const auto isWorthATrial = [&](const Screened& s) {
        return s.failure.empty() && (s.score() > 0 || (wanted == Rivals::New && s.isWrongSign()));
    };
    std::vector<const Screened*> chosen;
    for (const Screened& s : screened)
        if (isWorthATrial(s)) chosen.push_back(&s);
    std::vector<Trial> trials = tryThese(search, old.rest, chosen, 2 * trialIterations, startsPerTrial);
    continueBest(search, old.rest, trials);
    for (Trial& t : trials)
        if (t.ok && mayFollowOthers(old.rest, t)) t.ok = false, t.failure = followsOthers();
    rank(old.rest, trials);
    retryNear(search, old.rest, old.node.null.variant.values, old.node.null.sumOfSquares(), trials);
    search.journal.trials("rival of " + keyOf(old.placed().effect, old.placed().place), old.rest, trials);
    return trials;
}

/// How a trial compares, as one of the alternatives of what stands for so much evidence.
Alternative alternativeTo(double evidence, const Trial& t, double weight) {
    const Candidate& c = t.screened.candidate;
    return {c.effect.kind, c.place.at, evidence - t.evidence, isLike(t, evidence, weight)};
}

/// Alternatives of an effect are judged beside the other effects of today: best first, as they are told.
void judgeAlternatives(const std::vector<Trial>& trials, double own, double weight,
                       std::vector<Alternative>& alternatives) {
    std::erase_if(alternatives, [&](const Alternative& a) {
        return std::any_of(trials.begin(), trials.end(), [&](const Trial& t) {
            const Candidate& c = t.screened.candidate;
            return a.kind == c.effect.kind && a.at == c.place.at;
        });
    });
    for (const Trial& t : trials)
        if (t.ok && !isProposal(t)) alternatives.push_back(alternativeTo(own, t, weight));
}

/// Whether the best rival takes the place of an effect that has so much evidence of its own. What the data hardly tell
/// apart is not exchanged for the less likely, nor, at the end, beside much that is left.
bool isBetterRival(const Contested& old, const Trial& best, double own, double weight, bool isSimplerEqual,
                   Rivals wanted) {
    const double gain = old.gainOf(best);
    const int likelier = plausibility(old.placed().effect) - plausibility(best.screened.candidate.effect);
    const bool leavesMuch = reducedChi(best.fit) > largeResidual;
    const bool isLikelierEqual = leavesMuch && likelier > 0 && best.freed() == old.freed() &&
                                 best.evidence > leastLike * own && -weight * gain < equivalenceMargin;
    if (!isExchanged({gain, weight, likelier, isSimplerEqual, isLikelierEqual, leavesMuch && wanted == Rivals::New}))
        return false;
    const double decrease = old.rest.sumOfSquares() - old.node.null.sumOfSquares(),
                 bestDecrease = old.rest.sumOfSquares() - best.sumOfSquares();
    return !(leavesMuch && best.freed() > old.freed() && decrease > nearlyAsMuch * bestDecrease);
}

/// The step by which the first of these trials takes the place of an effect.
Step stepInstead(const SearchContext& search, const Contested& old, std::vector<Trial>& trials, double weight) {
    Trial& best = trials.front();
    const double gain = old.gainOf(best);
    Step step;
    step.acceptance = examine(search, old.rest, best, 0);
    step.alternatives.push_back(
        {old.placed().effect.kind, old.placed().place.at, gain, weight * gain < equivalenceMargin});
    for (std::size_t i = 1; i < trials.size(); ++i)
        if (trials[i].ok && !isProposal(trials[i]))
            step.alternatives.push_back(alternativeTo(best.evidence, trials[i], weight));
    for (const Candidate& c : old.step().rivals)
        if (c.effect.className != best.screened.candidate.effect.className ||
            c.place.at != best.screened.candidate.place.at)
            step.rivals.push_back(c);
    step.rivals.push_back({old.placed().effect, old.placed().place});
    step.winner = std::move(best);
    return step;
}

}  // namespace

bool replace(SearchContext& search, Node& node, std::size_t effect, Rivals wanted, const EffectPlace* elsewhere) {
    const std::optional<NullModel> rest = without(search, node.null, effect);
    if (!rest) return false;
    const Contested old{node, effect, *rest};
    const std::vector<Screened> screened = screenRivals(search, old, wanted, elsewhere);
    std::vector<Trial> trials = tryRivals(search, old, screened, wanted);
    if (trials.empty() || !trials.front().ok || search.progress.stopRequested()) return false;
    const PlacedEffect placed = old.placed();
    const double known = trials.front().evidence - old.gainOf(trials.front());
    const bool isSimplerEqual = simplerFirst(node.null, known, old.freed(), trials);
    if (!isSimplerEqual) likelierFirst(node.null, placed.effect, trials);
    const Trial& best = trials.front();
    const double own = best.evidence - old.gainOf(best);
    const double weight = independentShare(node.null, best.fit);
    judgeAlternatives(trials, own, weight, node.steps[effect].alternatives);
    if (!isBetterRival(old, best, own, weight, isSimplerEqual, wanted)) return false;
    Outcome<NullModel> next = fitNull(best.variant, node.null.noise, NoiseLevel::Keep, search.fit, search.progress);
    if (!next) return false;

    Step step = stepInstead(search, old, trials, weight);
    step.order = ++search.journal.choices;
    step.tried = screened.size();
    const Candidate& winner = step.winner.screened.candidate;
    setVerdict(search, node, placed, Verdict::Weaker,
               isSimplerEqual ? phrase("{} explains nearly as much with fewer parameters", nameOf(winner))
                              : phrase("beside the other effects {} explains more in its place", nameOf(winner)));
    setVerdict(search, node, winner, Verdict::Chosen, {});
    if (hasProposal(*next) && placed.effect.proposal.empty()) node.displaced.push_back({placed, node.steps[effect]});
    node.null = std::move(*next);
    node.steps.erase(node.steps.begin() + static_cast<std::ptrdiff_t>(effect));
    node.steps.push_back(std::move(step));
    return true;
}

bool Visited::add(const Node& node) { return sets_.insert(keysOf(node.null.variant.effects)).second; }

namespace {

/// Replaces an effect where that leads to effects that were not there together before: of equals each may take the
/// place of the other, without an end.
bool replaceByNew(SearchContext& search, Node& node, std::size_t effect, Visited& visited) {
    Node next = node;
    const bool isReplaced = replace(search, next, effect, Rivals::Known);
    if (isReplaced && !visited.add(next)) {
        search.journal.model("reconsider", next.null, "was there before");
        return false;
    }
    node = std::move(next);
    return isReplaced;
}

}  // namespace

bool reconsider(SearchContext& search, Node& node) {
    const auto hasRivals = [&](std::size_t i) {
        return !node.steps[i].rivals.empty() || !node.null.variant.effects[i].effect.placement.signalSide.empty();
    };
    Visited visited(node);
    bool changed = false;
    for (int pass = 0; pass < 2; ++pass) {
        bool changedNow = false;
        for (std::size_t i = 0; i + 1 < node.steps.size() && !search.progress.stopRequested();)
            if (hasRivals(i) && replaceByNew(search, node, i, visited))
                changedNow = true;
            else
                ++i;
        changed = changed || changedNow;
        if (!changedNow) break;
    }
    return changed;
}

namespace {

/// Where a part of an effect is next to nothing, another effect may stand for that part at a place of its own: where
/// one at that place does for both, it takes their place. True: it did.
bool doesForBoth(SearchContext& search, Node& node, std::size_t effect, std::size_t part) {
    const PlacedEffect &odd = node.null.variant.effects[effect], lesser = node.null.variant.effects[part];
    const bool mayGoThere = odd.effect.placement.ports.size() == lesser.effect.placement.ports.size() &&
                            odd.effect.placement.signalSide.empty() && lesser.effect.placement.signalSide.empty();
    if (!mayGoThere || odd.place == lesser.place || !lacksAPart(odd, node.null.fit)) return false;
    std::optional<NullModel> rest = without(search, node.null, part);
    if (!rest) return false;
    Node one = node;
    one.null = std::move(*rest);
    one.steps.erase(one.steps.begin() + static_cast<std::ptrdiff_t>(part));
    const std::size_t left = effect > part ? effect - 1 : effect;
    const bool isMoved = replace(search, one, left, Rivals::New, &lesser.place);
    const int more = one.null.parameterCount() - node.null.parameterCount();
    const bool isBetter = isMoved && gainOver(node.null, one.null.sumOfSquares(), more) > 0;
    if (isMoved) search.journal.model("unite", one.null, isBetter ? "taken" : "set aside");
    if (!isBetter) return false;
    const Candidate& both = one.steps.back().winner.screened.candidate;
    setVerdict(search, one, lesser, Verdict::Weaker,
               phrase("beside the other effects {} explains more in its place", nameOf(both)));
    node = std::move(one);
    return true;
}

}  // namespace

void unite(SearchContext& search, Node& node) {
    for (std::size_t i = 0; i < node.steps.size(); ++i)
        for (std::size_t part = 0; part < node.steps.size() && !search.progress.stopRequested(); ++part)
            if (part != i && doesForBoth(search, node, i, part)) return unite(search, node);
}

void completeClasses(SearchContext& search, Node& node) {
    std::size_t i = 0;
    for (std::size_t k = node.steps.size();
         k-- > 0 && !search.progress.stopRequested() && search.work.done <= threshold::paths::mostTrialWork;)
        if (!replace(search, node, i, Rivals::New)) ++i;  // what takes a place stands at the end
}

}  // namespace analogon
