#include "core/effect/search/redraw.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/effect/judge/caution.hpp"
#include "core/effect/model/sampling.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/without.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::redraw;
using threshold::acceptance::leastEvidence;
using threshold::acceptance::leastShare;
using threshold::judgement::leastOfRest;
using threshold::rounds::nearlyTheSame;

namespace {

/// The inputs as they run between their samples by what the outputs say beside parameters that have come so far, and
/// what that explains; nothing where it does not count.
std::optional<Redrawn> redrawn(const SearchContext& search, const NullModel& null, const NullModel& there,
                               bool areAlike, double threshold) {
    int told = 0;
    std::vector<InputEdge> likely =
        likeliestEdges(there, inputEdges(null.variant.task), areAlike, search.fit.simulation, search.options.threads,
                       search.progress, told);
    if (told == 0) return std::nullopt;
    search.say("reconsider", phrase("jumps of the inputs"), -1);
    Variant drawn = null.variant;
    drawn.values = there.variant.values;
    place(drawn.task, likely);
    std::optional<Allowed> with = allowed(search, null, drawn, told, threshold);
    if (!with) return std::nullopt;
    // what jumps explain lies behind jumps: no doubt of them
    const Acceptance& gain = with->gain;
    const bool counts =
        std::max(gain.evidence, gain.effective) > std::max(leastEvidence, threshold) && gain.share > leastOfRest;
    if (!counts) return std::nullopt;
    return Redrawn{std::move(likely), std::move(drawn), std::move(*with)};
}

/// The model with the jumps of its inputs where the outputs say that they are; so in all that is fitted from here on.
bool refitPlaced(SearchContext& search, NullModel& null, Variant placed, std::vector<InputEdge> edges) {
    Outcome<NullModel> next = fitNull(placed, null.noise, NoiseLevel::Estimate, search.fit, search.progress);
    if (!next || search.progress.stopRequested()) return false;
    null = std::move(*next);
    if (search.readings.drawn.asRecorded.empty())
        search.readings.drawn.asRecorded = search.readings.full.task.recordings;
    place(search.readings.searched.task, edges);
    place(search.readings.full.task, edges);
    for (const InputEdge& e : edges)
        search.journal.add("reading", "edge " + e.input,
                           {{"recording", e.recording}, {"sample", e.sample}, {"part", e.part}, {"bend", e.bend}},
                           "accepted");
    search.readings.drawn.edges = std::move(edges);
    return true;
}

}  // namespace

std::optional<Late> findClocks(const SearchContext& search, const NullModel& null, double threshold, double most) {
    if (search.readings.takesAsGiven || !search.readings.drawn.edges.empty() ||
        search.work.clockChanges >= mostPasses || hasProposal(null))
        return std::nullopt;
    const Recordings& stamped =
        search.readings.drawn.clocks.empty() ? search.readings.searched.task.recordings : search.readings.drawn.stamped;
    search.say("reconsider", phrase("clocks of the inputs"), -1);
    const double interval = samplingInterval(null.variant.task);
    // the parameters made up for the lateness: with them it moves on
    NullModel there = null;
    std::optional<Late> found;
    std::vector<std::vector<std::string>> groups = clockGroups(null.variant.task, stamped);
    for (int pass = 0; pass < mostPasses; ++pass) {
        std::size_t group = 0;
        const std::vector<InputClock> clocks =
            likeliestClocks(there, stamped, found ? found->clocks : search.readings.drawn.clocks, groups,
                            search.fit.simulation, search.progress, group);
        if (clocks.empty()) break;
        groups = {groups[group]};
        Variant drawn = null.variant;
        drawn.values = there.variant.values;
        analogon::setClocks(drawn.task.recordings.edit(), stamped, clocks);
        std::optional<Allowed> with = allowed(search, null, drawn, static_cast<int>(clocks.size()), threshold);
        const double before = found ? found->with.gain.effective : 0;
        if (!with || !with->gain.isSignificant || !(with->gain.effective > before)) break;
        there = null.with(drawn, with->fit);
        there.variant.values = valuesOf(with->fit);
        found = Late{clocks, std::move(drawn), std::move(*with)};
    }
    if (!found) return std::nullopt;
    // less than a sample is what every mean over one is late by, and met far more often than an effect that looks alike
    const bool isOfLogger =
        std::all_of(found->clocks.begin(), found->clocks.end(), [&](const InputClock& c) { return c.late < interval; });
    const Eigen::VectorXd& left = found->with.fit.optimum.residuals;
    const double chi2Decrease = null.sumOfSquares() - left.squaredNorm();
    const double margin = equivalenceMargin * left.squaredNorm() / static_cast<double>(left.size());
    if (!isOfLogger && explainedByPickUp(null, found->clocks) - chi2Decrease > margin) return std::nullopt;
    const Acceptance& gain = found->with.gain;
    const bool counts = std::max(gain.evidence, gain.effective) > std::max(leastEvidence, threshold) &&
                        gain.share > leastOfRest && gain.effective > (isOfLogger ? nearlyTheSame : 1) * most;
    return counts ? std::move(found) : std::nullopt;
}

bool refitLate(SearchContext& search, NullModel& null, Late late) {
    late.variant.values = valuesOf(late.with.fit);
    Outcome<NullModel> next = fitNull(late.variant, null.noise, NoiseLevel::Estimate, search.fit, search.progress);
    if (!next || search.progress.stopRequested()) return false;
    null = std::move(*next);
    for (const InputClock& clock : late.clocks)
        search.journal.add("reading", "clock " + clock.input,
                           {{"late", clock.late},
                            {"evidence", late.with.gain.evidence},
                            {"effective", late.with.gain.effective},
                            {"share", late.with.gain.share}},
                           "accepted");
    if (search.readings.drawn.clocks.empty()) search.readings.drawn.stamped = search.readings.searched.task.recordings;
    if (search.readings.drawn.asRecorded.empty())
        search.readings.drawn.asRecorded = search.readings.full.task.recordings;
    analogon::setClocks(search.readings.searched.task.recordings.edit(), search.readings.drawn.stamped, late.clocks);
    analogon::setClocks(search.readings.full.task.recordings.edit(), search.readings.drawn.asRecorded, late.clocks);
    search.readings.drawn.clocks = std::move(late.clocks);
    ++search.work.clockChanges;
    return true;
}

void holdUnneededClocks(SearchContext& search, NullModel& null) {
    if (search.readings.drawn.clocks.empty() || !search.readings.drawn.edges.empty() || search.progress.stopRequested())
        return;
    Variant variant = null.variant;
    analogon::setClocks(variant.task.recordings.edit(), search.readings.drawn.stamped, {});
    Outcome<NullModel> stamped = fitNull(variant, null.noise, NoiseLevel::Keep, search.fit, search.progress);
    if (!stamped || search.progress.stopRequested()) return;
    const Acceptance missed = examine(*stamped, null.fit, static_cast<int>(search.readings.drawn.clocks.size()), 0);
    const bool isNeededStill = missed.isSignificant && missed.isWorthwhile;
    search.journal.test("reading", "clocks of inputs", missed, isNeededStill ? "kept" : "taken back");
    if (isNeededStill) return;
    search.readings.takeRecordingsAsGiven();
    null = std::move(*stamped);
}

bool canPlaceEdges(const SearchContext& search, const NullModel& null) {
    return !search.readings.takesAsGiven && search.readings.drawn.edges.empty() && search.readings.thinning.isWhole() &&
           !hasProposal(null);
}

Drawings drawings(const SearchContext& search, const NullModel& null, double threshold) {
    Drawings both;
    parallelFor(2, search.options.threads,
                [&](int i) { both[static_cast<std::size_t>(i)] = redrawn(search, null, null, i == 1, threshold); });
    return both;
}

bool placeEdges(SearchContext& search, NullModel& null, Drawings first, double threshold, double most) {
    Variant placed;
    std::vector<InputEdge> edges;
    for (const bool areAlike : {true, false}) {
        // the parameters made up for the jumps where they were: with them the jumps move on
        NullModel there = null;
        double before = 0;
        for (int pass = 0; pass < mostPasses; ++pass) {
            std::optional<Redrawn> next =
                pass == 0 ? std::move(first[areAlike]) : redrawn(search, null, there, areAlike, threshold);
            if (!next || !(next->with.gain.effective > before)) break;
            before = next->with.gain.effective;
            Variant moved = null.variant;
            moved.values = valuesOf(next->with.fit);
            there = null.with(std::move(moved), std::move(next->with.fit));
            // a command that is held looks like a dead time of half a sample, and is met far more often
            if (!(before > (areHeld(next->edges) ? nearlyTheSame : 1) * most)) {
                if (before < leastShare * most) break;
                continue;
            }
            most = std::max(most, before);
            edges = std::move(next->edges);
            placed = std::move(next->variant);
        }
    }
    return !edges.empty() && refitPlaced(search, null, std::move(placed), std::move(edges));
}

bool takesEdgesForDelays(SearchContext& search, const NullModel& null) {
    if (!canPlaceEdges(search, null) || inputEdges(null.variant.task).empty()) return false;
    const double interval = samplingInterval(null.variant.task);
    for (std::size_t i = 0;
         i < null.variant.effects.size() && search.readings.drawn.edges.empty() && !search.progress.stopRequested();
         ++i) {
        const PlacedEffect& placed = null.variant.effects[i];
        const FitEstimate* strength = null.fit.find(placed.freed.front().name);
        if (placed.effect.placement.signalSide != "input" || strength == nullptr) continue;
        if (strength->unit != "s" || !(strength->value < interval)) continue;
        std::optional<NullModel> rest = without(search, null, i);
        if (!rest) continue;
        const Acceptance missed = examine(*rest, null.fit, static_cast<int>(placed.freed.size()), 0);
        if (placeEdges(search, *rest, drawings(search, *rest, 0), 0, missed.effective)) return true;
    }
    return false;
}

}  // namespace analogon
