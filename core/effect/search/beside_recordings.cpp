#include "core/effect/search/beside_recordings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/effect/search/best_path.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/laws.hpp"
#include "core/effect/search/starts.hpp"

namespace analogon {
namespace {

/// Whether the recordings are drawn otherwise than they are given, beside effects that are much alike or with something
/// left.
bool isOddlyDrawn(const SearchContext& search, const Node& path) {
    if (search.readings.drawn.clocks.empty() && search.readings.drawn.edges.empty()) return false;
    const auto isOfTime = [&](const PlacedEffect& e) {
        const FitEstimate* strength = path.null.fit.find(e.freed.front().name);
        return !e.effect.placement.signalSide.empty() && strength != nullptr && strength->unit == "s";
    };
    const std::vector<PlacedEffect>& effects = path.null.variant.effects;
    return !isNoise(path.null) || std::any_of(effects.begin(), effects.end(), isOfTime);
}

/// Whether an account is better than another that tells so much of the recordings, or as good with less.
bool isSimpler(const SearchContext& search, const Node& plain, const Node& than, std::size_t told) {
    const double rows = static_cast<double>(plain.null.fit.optimum.residuals.size());
    const double gain =
        sumInUnitsOf(plain.null, than.null) - plain.null.sumOfSquares() +
        (than.null.parameterCount() + static_cast<double>(told) - plain.null.parameterCount()) * std::log(rows);
    const bool isShorter = !hasProposal(plain.null) && termsIn(search, plain.null) < termsIn(search, than.null) + told;
    return independentShare(plain.null, plain.null.fit) * gain > (isShorter ? -equivalenceMargin : equivalenceMargin);
}

/// The model as given beside the recordings as they are now.
Outcome<Done> beginAnew(SearchContext& search, NullModel& base) {
    search.frontier.beginsAnew = false;
    search.courses = {};
    search.frontier.opening.reset();
    search.frontier.stays = {};
    search.frontier.otherEnds.clear();
    base.variant.task.recordings = search.readings.searched.task.recordings;
    Outcome<NullModel> next = fitNull(base.variant, base.noise, NoiseLevel::Estimate, search.fit, search.progress);
    if (!next) return next.diagnostics();
    base = std::move(*next);
    return Done{};
}

/// The same beside what turns out to be wrong with a recording. What was chosen before it did was chosen beside that:
/// the search begins anew then.
Outcome<Node> bestPathBesideRecordings(SearchContext& search, NullModel& base) {
    for (;;) {
        Outcome<Node> path = bestPathFrom(search, base);
        if (!path || !search.frontier.beginsAnew || search.progress.stopRequested()) return path;
        const Outcome<Done> isBack = beginAnew(search, base);
        if (!isBack) return isBack.diagnostics();
    }
}

/// All that another reading of the recordings changes.
struct Whereabouts {
    NullModel base;
    Readings readings;
    Courses courses;
    std::vector<Node> otherEnds;
};

Whereabouts whereabouts(SearchContext& search, const NullModel& base) {
    return {base, search.readings, search.courses, std::move(search.frontier.otherEnds)};
}

void goBack(SearchContext& search, NullModel& base, Whereabouts to) {
    base = std::move(to.base);
    search.readings = std::move(to.readings);
    search.courses = std::move(to.courses);
    search.frontier.otherEnds = std::move(to.otherEnds);
}

/// The same of what is made up for the recordings. A clock that is set or a jump that is placed before the effects are
/// known may lead to wrong ones: where such an end is odd, it is held against that of a search with the recordings as
/// they are given.
Outcome<Node> bestPathOfDrawn(SearchContext& search, NullModel& base) {
    Outcome<Node> path = bestPathBesideRecordings(search, base);
    if (!path || search.progress.stopRequested() || !isOddlyDrawn(search, *path)) return path;
    Whereabouts drawn = whereabouts(search, base);
    Readings& readings = search.readings;
    readings.searched.task.recordings = drawn.readings.recordingsAsGiven();
    if (!readings.drawn.edges.empty() && !readings.noisyInputs.empty()) quieten(readings.searched.task);
    readings.full.task.recordings = readings.drawn.asRecorded;
    readings.drawn = {};
    readings.takesAsGiven = true;
    const Outcome<Done> isBack = beginAnew(search, base);
    std::optional<Node> plain;
    if (isBack)
        if (Outcome<Node> found = bestPathBesideRecordings(search, base)) plain = std::move(*found);
    readings.takesAsGiven = false;
    const RedrawnInputs& inputs = drawn.readings.drawn;
    const std::size_t jumps = inputs.edges.empty() || !areHeld(inputs.edges) ? inputs.edges.size() : 1;
    const bool isTaken =
        plain && !search.progress.stopRequested() && isSimpler(search, *plain, *path, inputs.clocks.size() + jumps);
    if (plain) search.journal.model("recordings as given", plain->null, isTaken ? "taken" : "set aside");
    if (isTaken) return std::move(*plain);
    goBack(search, base, std::move(drawn));
    return path;
}

}  // namespace

Outcome<Node> bestPath(SearchContext& search, NullModel& base) {
    Outcome<Node> path = bestPathOfDrawn(search, base);
    if (!path || search.progress.stopRequested() || isExplained(*path, 1)) return path;
    const std::optional<Begun> beginning = findBeginning(search, base, Against::Noise, 0);
    if (!beginning) return path;
    Whereabouts before = whereabouts(search, base);
    freeStarts(search, beginning->starts);
    base.variant.values = beginning->values;
    std::optional<Node> begun;
    if (beginAnew(search, base))
        if (Outcome<Node> found = bestPathOfDrawn(search, base)) begun = std::move(*found);
    const bool isTaken = begun && !search.progress.stopRequested() && isSimpler(search, *begun, *path, 0);
    if (begun) search.journal.model("beside starts", begun->null, isTaken ? "taken" : "set aside");
    if (isTaken) return std::move(*begun);
    goBack(search, base, std::move(before));
    return path;
}

}  // namespace analogon
