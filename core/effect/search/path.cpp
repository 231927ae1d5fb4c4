#include "core/effect/search/path.hpp"

#include <algorithm>
#include <optional>

#include "core/effect/judge/judgement.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/search/beside_flow.hpp"
#include "core/effect/search/contenders.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/exchange.hpp"
#include "core/effect/search/interrupted.hpp"
#include "core/effect/search/pair.hpp"
#include "core/effect/search/prune.hpp"
#include "core/effect/search/recordings.hpp"
#include "core/effect/search/redraw.hpp"
#include "core/effect/search/refine.hpp"
#include "core/effect/search/trials.hpp"
#include "core/effect/search/verdicts.hpp"

namespace analogon {

bool isWithinForms(const Node& node, double evidence) {
    double explained = 0;
    for (const Step& each : node.steps) explained += each.acceptance.evidence;
    return evidence < errorOfForms(explained);
}

namespace {

/// Adds what a round has chosen, and what was chosen together with it (`other`), to a path; false where no fit with it
/// can be done: the model without it stands.
bool addChoices(SearchContext& search, Node& path, const Round& round, const std::optional<Round>& other) {
    const std::size_t stood = path.steps.size();
    path.steps.push_back(stepOf(search, path.null, round));
    if (other) {
        noteAll(search, path, *other);
        path.steps.push_back(stepOf(search, path.null, *other));
    }
    for (std::size_t i = stood; i < path.steps.size(); ++i) {
        const Candidate& chosen = path.steps[i].winner.screened.candidate;
        search.journal.test("choose", keyOf(chosen.effect, chosen.place), path.steps[i].acceptance, "chosen");
    }
    const Variant wider = path.steps.back().winner.variant;
    // the noise shows better with every effect that is explained
    Outcome<NullModel> next = fitNull(wider, path.null.noise, NoiseLevel::Estimate, search.fit, search.progress);
    if (!next) next = fitNull(wider, path.null.noise, NoiseLevel::Keep, search.fit, search.progress);
    if (!next) {
        for (; path.steps.size() > stood; path.steps.pop_back())
            setVerdict(search, path, path.steps.back().winner.screened.candidate, Verdict::NotSignificant,
                       phrase("could not be fitted: {}", next.diagnostics().front().message));
        return false;
    }
    path.null = std::move(*next);
    return true;
}

/// What the round has chosen, weighed against what was chosen before it.
void weighAgain(SearchContext& search, Node& path) {
    sharpen(search, path);
    reconsider(search, path);
    crossOver(search, path);
    removeUnneeded(search, path, 1);  // a single one has just passed its tests
    treatAlike(search, path);
}

/// The errors of a node on all samples, where the search works on fewer. Counts as no work of the search.
std::optional<ModelState> errorsOnAll(const SearchContext& search, const NullModel& null) {
    if (search.readings.thinning.isWhole()) return std::nullopt;
    const WorkScope nobody(nullptr);
    const Outcome<Variant> all = onAllSamples(search.readings, null);
    if (!all) return std::nullopt;
    Outcome<ModelState> state = stateOf(*all, null.fit, search.options.fit.simulation, search.progress, Detail::Errors);
    if (!state || search.progress.stopRequested()) return std::nullopt;
    return std::move(*state);
}

/// Whether a node leaves structure and predicts no better than what was found to do so beside the model as given.
bool isBehindLikeliest(const SearchContext& search, const Node& node) {
    const std::optional<Whole>& likeliest = search.frontier.best.likeliest;
    if (!likeliest || isNoise(node.null)) return false;
    // of recordings that were read in another way they are not compared
    const Linearisation &there = likeliest->node.null.fit.optimum, &here = node.null.fit.optimum;
    return there.residuals.size() == here.residuals.size() && !predictsBetter(search, node, likeliest->node);
}

/// A node to be reported, with its state.
Whole wholeOf(const SearchContext& search, const Node& node, ModelState state, bool predicts) {
    Whole whole{node, search.readings, predicts};
    whole.node.state = std::move(state);
    whole.errorsOnAll = errorsOnAll(search, node.null);
    whole.isBehindLikeliest = isBehindLikeliest(search, node);
    return whole;
}

/// Keeps the node as `best` where it is better than the best so far. Returns its error [%] of the fitted data; empty:
/// stopped meanwhile.
std::optional<double> keepBest(SearchContext& search, const Node& path, std::optional<Whole>& best) {
    Outcome<ModelState> after = stateOf(path.null.variant, path.null.fit, search.fit.simulation, search.progress);
    if (!after || search.progress.stopRequested()) return std::nullopt;
    const Frontier& frontier = search.frontier;
    const double error = errorPercentOf(*after, Role::Fit);
    const bool isBetter = !frontier.best.whole || error < errorPercentOf(*frontier.best.whole->node.state, Role::Fit);
    if (!isBetter || hasProposal(path.null)) return error;
    const bool predicts = frontier.origin && predictsClearlyBetter(search, path.null, *frontier.origin);
    search.frontier.best.unweighed.reset();
    if (&best == &search.frontier.best.whole) search.frontier.keepClear();
    best = wholeOf(search, path, std::move(*after), predicts);
    keepSoFar(search, path.candidates);
    return error;
}

/// Keeps the node where it is the best so far; true where the search has been there before.
bool visit(SearchContext& search, Node& path) {
    Frontier& frontier = search.frontier;
    const std::optional<double> error = keepBest(search, path, frontier.best.whole);
    if (!error) return false;
    frontier.bestError = std::min(frontier.bestError, *error);
    if (!hasProposal(path.null)) frontier.best.unweighed.reset();  // else the best of named effects stays
    Stay here = stayAt(search, path.null, *error);
    const auto before = std::find_if(frontier.stays.visited.begin(), frontier.stays.visited.end(),
                                     [&](const Stay& s) { return s.isLike(here); });
    const bool isThere = before != frontier.stays.visited.end();
    path.meetsAnother = isThere && before->path != search.journal.path;
    if (!isThere) frontier.stays.visited.push_back(std::move(here));
    return isThere;
}

/// One round beside a path; false where the path ends.
bool goOnByOne(SearchContext& search, Node& path, Round round) {
    Frontier& frontier = search.frontier;
    const bool isFirst = search.journal.round == 1;
    if (!isFirst) decide(search, path.null, round);
    frontier.beginsAnew = !isFirst && allowForRecordings(search, path.null, round);
    if (frontier.beginsAnew) return false;
    std::optional<Round> other;
    if (!round.chosen)
        other = chosenTogether(search, path, round);
    else if (isWithinForms(path, std::max(round.acceptance.evidence, round.acceptance.effective)))
        round.passOver(phrase("explains no more than the forms of the effects that were found may be wrong by"));
    if (search.progress.stopRequested()) return false;
    noteAll(search, path, round);
    if (!round.chosen || !addChoices(search, path, round, other)) return false;
    keepBest(search, path, frontier.best.unweighed);
    weighAgain(search, path);
    frontier.beginsAnew = takesEdgesForDelays(search, path.null);
    if (frontier.beginsAnew || visit(search, path)) return false;
    if (!frontier.opening) frontier.opening = path;
    return true;
}

}  // namespace

void goOn(SearchContext& search, Node& path, Round first) {
    Journal& journal = search.journal;
    ++journal.path;
    journal.round = 0;
    journal.model("path", path.null, "begun");
    if (path.null.variant.effects.empty()) search.frontier.origin = path.null;
    for (journal.round = 1; journal.round <= search.options.maxRounds && !search.progress.stopRequested();
         ++journal.round) {
        Round round = journal.round == 1 ? std::move(first) : tryAll(search, path.null);
        if (search.progress.stopRequested() || !goOnByOne(search, path, std::move(round))) break;
    }
    journal.model("path", path.null,
                  search.frontier.beginsAnew ? "begins anew beside the recordings"
                  : path.meetsAnother        ? "meets another"
                                             : "ended");
}

Node pathFrom(SearchContext& search, const NullModel& base, Round round, std::size_t begin) {
    round.passOver(phrase("the search came to a better end from {}", nameOf(round.candidate(begin))));
    round.choose(base, begin, examine(search, base, round.trials[begin], round.threshold));
    Node path{base, {}};
    goOn(search, path, std::move(round));
    return path;
}

void seekLikeliest(SearchContext& search, const NullModel& base, const Round& first) {
    Frontier& frontier = search.frontier;
    const Node bare{base, {}};
    Round round = first;
    frontier.best.first = {};  // of recordings that may have been read in another way
    frontier.best.likeliest.reset();
    std::optional<Node> found =
        firstThatHolds(search, bare, contendersOf(search, base, round.trials), round, [](const Node&) { return true; });
    bool isFlowAlone = false;
    if (!found && !search.progress.stopRequested()) {
        LikeliestBesideFlow likeliest = withLikeliestBesideFlow(search, bare, round);
        found = std::move(likeliest.node);
        isFlowAlone = !likeliest.isAnyClear;
    }
    if (search.progress.stopRequested()) return;
    frontier.best.first = {base.fit.optimum.residuals, first.screened.size(), found, isFlowAlone};
    if (!found) return;
    Outcome<ModelState> state = stateOf(found->null.variant, found->null.fit, search.fit.simulation, search.progress);
    if (!state || search.progress.stopRequested()) return;
    frontier.best.likeliest = wholeOf(search, *found, std::move(*state), true);
    frontier.best.likeliest->isBehindLikeliest = false;
    for (std::optional<Whole>* other : {&frontier.best.whole, &frontier.best.clear, &frontier.best.unweighed})
        if (*other) (*other)->isBehindLikeliest = isBehindLikeliest(search, (*other)->node);
    keepSoFar(search, found->candidates);
}

Node bareOf(SearchContext& search, const NullModel& base, Round first, const Text& why) {
    first.passOver(why);
    Node bare{base, {}};
    search.journal.round = 1;
    noteAll(search, bare, first);
    return bare;
}

}  // namespace analogon
