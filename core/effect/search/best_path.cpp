#include "core/effect/search/best_path.hpp"

#include <algorithm>
#include <cmath>

#include "core/effect/judge/judgement.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/course_search.hpp"
#include "core/effect/search/laws.hpp"
#include "core/effect/search/pair.hpp"
#include "core/effect/search/path.hpp"
#include "core/effect/search/prune.hpp"
#include "core/effect/search/recordings.hpp"
#include "core/effect/search/trials.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::paths;

namespace {

/// What is tried first of all. Noise with a memory is no missing effect, but a weak one may lie in it.
Round firstRound(SearchContext& search, NullModel& base) {
    Round first = tryAll(search, base);
    if (search.progress.stopRequested()) return first;
    decide(search, base, first);
    while (allowForRecordings(search, base, first)) {
        first = tryAll(search, base);
        decide(search, base, first);
    }
    if (first.chosen && !isClearlyMissed(first.acceptance) && isColouredNoise(search, base))
        first.passOver(phrase("what is left is noise with a memory, and this explains too little of it"));
    return first;
}

/// The other effects with which the search may begin: they pass the same tests alone.
std::vector<std::size_t> otherBeginnings(const SearchContext& search, const NullModel& null, const Round& round) {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < round.trials.size() && others.size() < otherPaths; ++i) {
        const Trial& t = round.trials[i];
        if (!t.ok || isProposal(t) || isAtBound(t) || mayFollowOthers(null, t) ||
            t.evidence < rivalShare * round.trials[*round.chosen].evidence)
            continue;
        if (i == *round.chosen || std::find(round.members.begin(), round.members.end(), i) != round.members.end())
            continue;
        if (examine(search, null, t, round.threshold).accepted()) others.push_back(i);
    }
    return others;
}

/// Whether a path ends better than another: of two accounts that are as good and as simple, the one by names.
bool isBetter(const SearchContext& search, const Node& path, const Node& than) {
    const auto misfit = [](const Node& p) {
        const double rows = static_cast<double>(p.null.fit.optimum.residuals.size());
        return p.null.sumOfSquares() + p.null.parameterCount() * std::log(rows);
    };
    const double gain = independentShare(path.null, path.null.fit) * (misfit(than) - misfit(path));
    const bool isNamed = hasProposal(than.null) && !hasProposal(path.null) && isNoise(path.null) &&
                         termsIn(search, path.null) <= termsIn(search, than.null);
    return gain > (isNamed ? -equivalenceMargin : equivalenceMargin);
}

/// Whether a path with an equation is no simpler than one of names, and explains no more than these forms may be wrong
/// by.
bool isOnlyOfForm(const SearchContext& search, const NullModel& base, const Node& path, const Node& named) {
    if (!hasProposal(path.null) || hasProposal(named.null) || termsIn(search, path.null) < termsIn(search, named.null))
        return false;
    const double explained = sumInUnitsOf(named.null, base) - named.null.sumOfSquares();
    const double more = named.null.sumOfSquares() - sumInUnitsOf(named.null, path.null);
    return more < errorOfForms(explained);
}

/// Keeps the better of two paths, and the other among the ends; one that leads where another went adds nothing.
void keepBetter(SearchContext& search, Node& best, Node path, const NullModel& base) {
    if (path.meetsAnother) return;
    const bool isTaken = isBetter(search, path, best) && !isOnlyOfForm(search, base, path, best);
    search.journal.model("end of path", path.null, isTaken ? "better" : "set aside");
    if (isTaken) std::swap(best, path);
    search.frontier.otherEnds.push_back(std::move(path));
}

/// Begins with what explains most of all that is left and fails only on the blocks left out: those are refitted to
/// first order, which far from the optimum tells little. Where such a path leads to noise, what it found is borne out.
void addUnprovenPaths(SearchContext& search, Node& best, const NullModel& base, const Round& first) {
    std::size_t tried = 0;
    for (const std::size_t begin : first.refused.failsHeldOut) {
        if (search.progress.stopRequested() || isNoise(best.null) || isEnoughTried(tried, search.work.done)) return;
        const double chi2Decrease = base.sumOfSquares() - first.trials[begin].sumOfSquares();
        if (!isGoodPart(chi2Decrease, base)) continue;
        ++tried;
        Node path = pathFrom(search, base, first, begin);
        if (search.frontier.beginsAnew) return;
        if (isNoise(path.null) && !hasProposal(path.null)) keepBetter(search, best, std::move(path), base);
    }
}

/// Begins with the halves of pairs, also where one equation took the place of names: it may stand for two that hide
/// each other.
void addPairPaths(SearchContext& search, Node& best, const NullModel& base, const Round& first,
                  const std::vector<Candidate>& taken) {
    constexpr std::size_t aPair = 2;
    const bool isNear = isNearEnoughForPairs(reducedChi(best.null.fit), search.frontier.bestError);
    if (isExplained(best, aPair) || !isNear || search.progress.stopRequested()) return;
    const Round wider = search.work.done > mostTrialWork ? first : withPairMembers(search, base, first);
    for (const std::size_t begin : pairBeginnings(base, wider, otherPaths, taken)) {
        if (search.progress.stopRequested() || isExplained(best, aPair) || search.work.done > mostTrialWork) return;
        Node path = pathFrom(search, base, wider, begin);
        if (search.frontier.beginsAnew) return;
        if (path.steps.size() > 1) keepBetter(search, best, std::move(path), base);  // else it has passed no test alone
    }
}

/// The path that goes on from this one with a law that leaves next to nothing; none where no law does.
std::optional<Node> withLaw(SearchContext& search, Node begin) {
    if (!addLaw(search, begin) || !(reducedChi(begin.null.fit) < largeResidual)) return std::nullopt;
    removeUnneeded(search, begin, 1);
    Round next = tryAll(search, begin.null);
    decide(search, begin.null, next);
    goOn(search, begin, std::move(next));
    return begin;
}

/// Goes on from a path with a law; true where that is the better end. As many terms as there are names are no simpler,
/// and were chosen from far more.
bool addLawPath(SearchContext& search, Node& best, const NullModel& base, Node begin) {
    if (!isNoise(best.null) && leavesLittle(best.null)) return false;
    std::optional<Node> path = withLaw(search, std::move(begin));
    if (search.frontier.beginsAnew || !path) return false;
    const bool isTaken = isBetter(search, *path, best) && !isOnlyOfForm(search, base, *path, best);
    search.journal.model("end of path", path->null, isTaken ? "better" : "set aside");
    if (!isTaken) {
        search.frontier.otherEnds.push_back(std::move(*path));
        return false;
    }
    if (isNoise(best.null) && termsIn(search, path->null) >= termsIn(search, best.null)) return false;
    search.frontier.otherEnds.push_back(std::move(best));
    best = std::move(*path);
    return isNoise(best.null);
}

}  // namespace

bool isEnoughTried(std::size_t beginnings, double work) {
    return beginnings >= otherPaths || (beginnings > 0 && work > mostTrialWork);
}

bool isNearEnoughForPairs(double reducedChi, double errorPercent) {
    return reducedChi < mostForPairs || errorPercent < mostErrorForPairs;
}

bool leavesLittle(const NullModel& null) { return reducedChi(null.fit) < structuredResidual; }

bool isExplained(const Node& path, std::size_t most) {
    return isNoise(path.null) && !hasProposal(path.null) && path.null.variant.effects.size() <= most;
}

namespace {

/// How a first path has ended.
struct FirstEnd {
    bool isAtItsEnd{};  // an effect has a shape at its bound: surroundings as hot as they may be are those of others
    bool isOdd{};       // or lacks a part
};

FirstEnd firstEndOf(const Node& path) {
    const std::vector<PlacedEffect>& found = path.null.variant.effects;
    const bool isAtItsEnd = std::any_of(found.begin(), found.end(),
                                        [&](const PlacedEffect& e) { return hasShapeAtBound(e, path.null.fit); });
    return {isAtItsEnd, isAtItsEnd || std::any_of(found.begin(), found.end(),
                                                  [&](const PlacedEffect& e) { return lacksAPart(e, path.null.fit); })};
}

/// Begins with what failed on blocks left out, with a law, and with the other effects that pass the tests; false where
/// no pair needs to be tried behind them.
bool addOtherPaths(SearchContext& search, Node& best, const NullModel& base, const Round& first, FirstEnd end,
                   const std::vector<std::size_t>& others) {
    addUnprovenPaths(search, best, base, first);
    if (search.frontier.beginsAnew) return false;
    const bool isLawful =
        addLawPath(search, best, base,
                   bareOf(search, base, first, phrase("an equation without a name explains more in its place")));
    if (search.frontier.beginsAnew || (isLawful && termsIn(search, best.null) < 2)) return false;
    const auto placeOf = [&](std::size_t trial) { return first.trials[trial].screened.candidate.place; };
    for (std::size_t tried = 0; tried < others.size(); ++tried) {
        const bool isDone = !end.isOdd && leavesLittle(best.null);
        if (search.progress.stopRequested() || isDone || isEnoughTried(tried, search.work.done)) break;
        const std::size_t other = others[tried];
        // beside an effect that lacks a part and leaves noise it is what goes to the same place that it may stand for
        if (isNoise(best.null) && !end.isAtItsEnd && !(placeOf(other) == placeOf(*first.chosen))) continue;
        Node path = pathFrom(search, base, first, other);
        if (search.frontier.beginsAnew) return false;
        keepBetter(search, best, std::move(path), base);
    }
    return true;
}

}  // namespace

Outcome<Node> bestPathFrom(SearchContext& search, NullModel& base) {
    const Round first = firstRound(search, base);
    Node best{base, {}};
    if (search.progress.stopRequested()) return best;
    if (isCourseAlone(search, base, first))
        return bareOf(search, base, first, phrase("a parameter that changes is the better account"));
    std::vector<std::size_t> others;
    if (first.chosen) others = otherBeginnings(search, base, first);
    goOn(search, best, first);
    if (search.frontier.beginsAnew || search.progress.stopRequested()) return best;
    const bool hasMore = best.steps.size() > 1 || hasProposal(best.null);
    const FirstEnd end = firstEndOf(best);
    if (!hasMore && !end.isOdd && (isNoise(best.null) || isColouredNoise(search, best.null))) return best;
    if (!isNoise(best.null) && isCourseAll(search, base, best.null)) return best;
    if (!isNoise(best.null)) seekLikeliest(search, base, first);

    // where nothing beside the model as given is clearly likelier than a flow alone, another beginning leads no further
    const bool isFlowAlone = !isNoise(best.null) && search.frontier.best.first.isFlowAlone;
    if (!isFlowAlone && !addOtherPaths(search, best, base, first, end, others)) return best;
    std::vector<Candidate> taken;
    if (first.chosen) taken.push_back(first.trials[*first.chosen].screened.candidate);
    for (const std::size_t other : others) taken.push_back(first.trials[other].screened.candidate);
    addPairPaths(search, best, base, first, taken);
    if (search.frontier.beginsAnew || search.progress.stopRequested() || isNoise(best.null) || isFlowAlone ||
        search.work.done > mostTrialWork || !search.frontier.opening)
        return best;
    addLawPath(search, best, base, std::move(*search.frontier.opening));
    return best;
}

}  // namespace analogon
