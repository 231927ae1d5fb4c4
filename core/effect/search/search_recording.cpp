/// What lies in the recordings and not in the component: start values that were told wrongly look like an offset, a lag
/// or a dead zone, the noise of a recorded input like a limit or a play that cuts it off.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/number_text.hpp"
#include "core/base/parallel.hpp"
#include "core/effect/judge/caution.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/model/sampling.hpp"
#include "core/effect/model/thin.hpp"
#include "core/effect/reading/input_noise.hpp"
#include "core/effect/reading/likeliest_edges.hpp"
#include "core/effect/search/search.hpp"

namespace analogon {
namespace {

constexpr std::size_t mostStarts = 12;  // that are tried
constexpr int mostPasses = 3;
constexpr double leastOfJumps = 20, shareOfJumps = 0.5;  // evidence; of what stays unexplained
constexpr double nearlyAll = 0.95, farFromAll = 0.05;    // of what an effect explains
constexpr double isLateByMean = 1;                       // sampling intervals, at most
constexpr int mostClockChanges = 3;
constexpr double leastMoved = 3;  // standard errors, by which a state is elsewhere than the model begins

Text remarkOn(const std::vector<InputEdge>& edges) {
    if (areHeld(edges))
        return phrase(
            "the inputs jump just before the next sample ({} jumps): they are held in between and do not run straight "
            "from sample to sample, or reach the component half a sample late, which looks nearly the same; the "
            "parameters reckon with it, the errors that are reported do not",
            edges.size());
    return phrase(
        "the inputs jump between two samples ({} jumps), and the outputs tell when: the parameters reckon with it, the "
        "errors that are reported are with straight lines from sample to sample; record faster, or log the moment of "
        "each jump",
        edges.size());
}

/// Whether a check determines what it was estimated to begin with: that of an angle tells nothing where nothing depends
/// on it.
bool isDetermined(const ToldStart& start, const ModelState& state) {
    int check = -1;
    for (const ExperimentState& e : state.experiments) {
        if (e.role != Role::Validate || ++check != start.experiment) continue;
        return std::any_of(e.starts.begin(), e.starts.end(), [&](const FitEstimate& estimate) {
            return estimate.name == start.parameter && std::isfinite(estimate.standardError) &&
                   estimate.standardError > 0;
        });
    }
    return false;
}

}  // namespace

/// Leaves out, in all that the search fits from here on, the samples that are faults of the measurement by what a fit
/// on every sample leaves; true: there are such.
bool Search::leaveOutFaults(const NullModel& fitted) {
    faults_ = faultySamples(fitted);
    leaveOut(full_.task, faults_);
    for (const FaultySamples& f : faults_)
        trace("reading", "faulty samples " + f.output, {{"recording", f.recording}, {"begin", f.begin}, {"end", f.end}},
              "left out");
    if (!faults_.empty()) base_.task = thinned(full_.task, thinning_);
    return !faults_.empty();
}

/// The fit of a model that allows for something wrong with a recording, and what it explains.
std::optional<Search::Allowed> Search::allowed(const NullModel& null, const Variant& variant, int freed,
                                               double threshold) const {
    if (progress_.stopRequested()) return std::nullopt;
    const FitOptions options = trialOptions(search_.fit, search_.fit.maxIterations);
    std::optional<FitResult> fit = fitBeside(null, variant, options, progress_);
    if (!fit) return std::nullopt;
    const Acceptance gain = examine(null, *fit, freed, threshold);
    return Allowed{std::move(*fit), gain};
}

/// Allows for what is wrong with a recording, where that explains more than what this round has chosen. True when it
/// did: the round is to be repeated beside it.
bool Search::allowForRecordings(NullModel& null, const Round& round) {
    double most = round.chosen ? round.acceptance.effective : 0;
    const auto explainsMore = [&](const std::string& reading, const Variant& variant, int freed) {
        const std::optional<Allowed> there = allowed(null, variant, freed, round.threshold);
        if (!there) return false;
        const bool isMore = there->gain.isSignificant && there->gain.isWorthwhile && there->gain.effective > most;
        traceTest("reading", reading, there->gain, isMore ? "explains more" : "refused");
        if (isMore) most = there->gain.effective;
        return isMore;
    };
    std::vector<ToldStart> freed;
    std::vector<ParameterValue> values = null.variant.values;  // from which they are fitted
    // what is left beside effects may be larger at the start by chance
    const Against against = null.variant.effects.empty() ? Against::Noise : Against::Residual;
    std::optional<Begun> begun = findBeginning(null, against, round.threshold);
    if (begun && begun->gain.effective > most) {
        most = begun->gain.effective;
        freed = std::move(begun->starts);
        values = std::move(begun->values);
    }
    const Outcome<std::vector<ToldStart>> told = toldStarts(null.variant.task);
    if (!begun && told && told->size() <= mostStarts)
        for (const ToldStart& start : *told) {
            say("reconsider", start.parameter, -1);
            Variant variant = null.variant;
            setFitted(variant.task, start, true);
            if (explainsMore("start " + start.parameter, variant, 1)) freed = {start};
        }
    Variant quiet = null.variant;
    const std::vector<NoisyInput> noisy = noisyInputs_.empty() ? quieten(quiet.task) : std::vector<NoisyInput>();
    if (!noisy.empty()) {
        say("reconsider", phrase("noise of the inputs"), -1);
        if (explainsMore("noise of inputs", quiet, static_cast<int>(noisy.size())))
            return refitQuiet(null, std::move(quiet), noisy);
    }
    std::optional<Late> late;
    Drawings drawn;
    const bool canPlace = canPlaceEdges(null);
    parallelFor(2, options_.threads, [&](int i) {
        if (i == 1)
            late = findClocks(null, round.threshold, most);
        else if (canPlace)
            drawn = drawings(null, round.threshold);
    });
    if (late) most = late->with.gain.effective;
    if (canPlace && placeEdges(null, std::move(drawn), round.threshold, most)) return true;
    if (late) return refitLate(null, std::move(*late));
    return !freed.empty() && refitWith(null, freed, values);
}

/// The inputs earlier than they are stamped, where that explains more than so much. Jumps that were placed stay.
std::optional<Search::Late> Search::findClocks(const NullModel& null, double threshold, double most) const {
    if (takesAsGiven_ || !edges_.empty() || clockChanges_ >= mostClockChanges || hasProposal(null)) return std::nullopt;
    const std::vector<Recording>& stamped = clocks_.empty() ? base_.task.recordings : stamped_;
    say("reconsider", phrase("clocks of the inputs"), -1);
    const double interval = samplingInterval(null.variant.task);
    // the parameters made up for the lateness: with them it moves on
    NullModel there = null;
    std::optional<Late> found;
    std::vector<std::vector<std::string>> groups = clockGroups(null.variant.task, stamped);
    for (int pass = 0; pass < mostPasses; ++pass) {
        std::size_t group = 0;
        const std::vector<InputClock> clocks = likeliestClocks(there, stamped, found ? found->clocks : clocks_, groups,
                                                               search_.fit.simulation, progress_, group);
        if (clocks.empty()) break;
        groups = {groups[group]};
        Variant drawn = null.variant;
        drawn.values = there.variant.values;
        analogon::setClocks(drawn.task.recordings, stamped, clocks);
        std::optional<Allowed> with = allowed(null, drawn, static_cast<int>(clocks.size()), threshold);
        const double before = found ? found->with.gain.effective : 0;
        if (!with || !with->gain.isSignificant || !(with->gain.effective > before)) break;
        there = null.with(drawn, with->fit);
        there.variant.values = valuesOf(with->fit);
        found = Late{clocks, std::move(drawn), std::move(*with)};
    }
    if (!found) return std::nullopt;
    // less than a sample is what every mean over one is late by, and met far more often than an effect that looks alike
    const bool isOfLogger = std::all_of(found->clocks.begin(), found->clocks.end(),
                                        [&](const InputClock& c) { return c.late < isLateByMean * interval; });
    const Eigen::VectorXd& left = found->with.fit.optimum.residuals;
    const double fall = null.sumOfSquares() - left.squaredNorm();
    const double margin = equivalenceMargin * left.squaredNorm() / static_cast<double>(left.size());
    if (!isOfLogger && explainedByPickUp(null, found->clocks) - fall > margin) return std::nullopt;
    const Acceptance& gain = found->with.gain;
    const bool counts = std::max(gain.evidence, gain.effective) > std::max(leastOfJumps, threshold) &&
                        gain.share > shareOfJumps && gain.effective > (isOfLogger ? nearlyAll : 1) * most;
    return counts ? std::move(found) : std::nullopt;
}

/// The model beside inputs at their true times; so in all that is fitted from here on.
bool Search::refitLate(NullModel& null, Late late) {
    late.variant.values = valuesOf(late.with.fit);
    Outcome<NullModel> next = fitNull(late.variant, null.noise, NoiseLevel::Estimate, search_.fit, progress_);
    if (!next || progress_.stopRequested()) return false;
    null = std::move(*next);
    for (const InputClock& clock : late.clocks)
        trace("reading", "clock " + clock.input,
              {{"late", clock.late},
               {"evidence", late.with.gain.evidence},
               {"effective", late.with.gain.effective},
               {"share", late.with.gain.share}},
              "accepted");
    if (clocks_.empty()) stamped_ = base_.task.recordings;
    if (asRecorded_.empty()) asRecorded_ = full_.task.recordings;
    analogon::setClocks(base_.task.recordings, stamped_, late.clocks);
    analogon::setClocks(full_.task.recordings, asRecorded_, late.clocks);
    clocks_ = std::move(late.clocks);
    ++clockChanges_;
    return true;
}

/// Takes the columns as they are stamped where, beside the effects found since, being late explains nothing that
/// counts.
void Search::holdUnneededClocks(NullModel& null) {
    if (clocks_.empty() || !edges_.empty() || progress_.stopRequested()) return;
    Variant variant = null.variant;
    analogon::setClocks(variant.task.recordings, stamped_, {});
    Outcome<NullModel> stamped = fitNull(variant, null.noise, NoiseLevel::Keep, search_.fit, progress_);
    if (!stamped || progress_.stopRequested()) return;
    const Acceptance missed = examine(*stamped, null.fit, static_cast<int>(clocks_.size()), 0);
    const bool isNeededStill = missed.isSignificant && missed.isWorthwhile;
    traceTest("reading", "clocks of inputs", missed, isNeededStill ? "kept" : "taken back");
    if (isNeededStill) return;
    takeRecordingsAsGiven();
    null = std::move(*stamped);
}

/// Those of the search before clocks were set or jumps placed.
const std::vector<Recording>& Search::recordingsAsGiven() const { return edges_.empty() ? stamped_ : asRecorded_; }

void Search::takeRecordingsAsGiven() {
    base_.task.recordings = recordingsAsGiven();
    full_.task.recordings = asRecorded_;
    asRecorded_.clear();
    clocks_.clear();
    edges_.clear();
}

/// Beside an equation that only stands for something the jumps would mend it.
bool Search::canPlaceEdges(const NullModel& null) const {
    return !takesAsGiven_ && edges_.empty() && thinning_ == 1 && !hasProposal(null);
}

/// The inputs as they run between their samples by what the outputs say beside parameters that have come so far, and
/// what that explains; nothing where it does not count.
std::optional<Search::Redrawn> Search::redrawn(const NullModel& null, const NullModel& there, bool areAlike,
                                               double threshold) const {
    int told = 0;
    std::vector<InputEdge> likely = likeliestEdges(there, inputEdges(null.variant.task), areAlike,
                                                   search_.fit.simulation, options_.threads, progress_, told);
    if (told == 0) return std::nullopt;
    say("reconsider", phrase("jumps of the inputs"), -1);
    Variant drawn = null.variant;
    drawn.values = there.variant.values;
    place(drawn.task, likely);
    std::optional<Allowed> with = allowed(null, drawn, told, threshold);
    if (!with) return std::nullopt;
    // what jumps explain lies behind jumps: no doubt of them
    const Acceptance& gain = with->gain;
    const bool counts =
        std::max(gain.evidence, gain.effective) > std::max(leastOfJumps, threshold) && gain.share > shareOfJumps;
    if (!counts) return std::nullopt;
    return Redrawn{std::move(likely), std::move(drawn), std::move(*with)};
}

/// Each way to draw the inputs beside the parameters as they are: the jumps alone, all alike, and all one by one.
Search::Drawings Search::drawings(const NullModel& null, double threshold) const {
    Drawings both;
    parallelFor(2, options_.threads,
                [&](int i) { both[static_cast<std::size_t>(i)] = redrawn(null, null, i == 1, threshold); });
    return both;
}

/// Draws the inputs as they run between their samples, where that explains more than so much. `first`: see drawings().
bool Search::placeEdges(NullModel& null, Drawings first, double threshold, double most) {
    Variant placed;
    std::vector<InputEdge> edges;
    for (const bool areAlike : {true, false}) {
        // the parameters made up for the jumps where they were: with them the jumps move on
        NullModel there = null;
        double before = 0;
        for (int pass = 0; pass < mostPasses; ++pass) {
            std::optional<Redrawn> next =
                pass == 0 ? std::move(first[areAlike]) : redrawn(null, there, areAlike, threshold);
            if (!next || !(next->with.gain.effective > before)) break;
            before = next->with.gain.effective;
            Variant moved = null.variant;
            moved.values = valuesOf(next->with.fit);
            there = null.with(std::move(moved), std::move(next->with.fit));
            // a command that is held looks like a dead time of half a sample, and is met far more often
            if (!(before > (areHeld(next->edges) ? nearlyAll : 1) * most)) {
                if (before < farFromAll * most) break;
                continue;
            }
            most = std::max(most, before);
            edges = std::move(next->edges);
            placed = std::move(next->variant);
        }
    }
    return !edges.empty() && refitPlaced(null, std::move(placed), std::move(edges));
}

/// A dead time or a lag of an input that is shorter than a sample may be no more than how the input runs between its
/// samples: the search then begins anew beside that.
bool Search::takesEdgesForDelays(const NullModel& null) {
    if (!canPlaceEdges(null) || inputEdges(null.variant.task).empty()) return false;
    const double interval = samplingInterval(null.variant.task);
    for (std::size_t i = 0; i < null.variant.effects.size() && edges_.empty() && !progress_.stopRequested(); ++i) {
        const PlacedEffect& placed = null.variant.effects[i];
        const FitEstimate* strength = null.fit.find(placed.freed.front().name);
        if (placed.effect.signalSide != "input" || strength == nullptr) continue;
        if (strength->unit != "s" || !(strength->value < interval)) continue;
        std::optional<NullModel> rest = without(null, i);
        if (!rest) continue;
        const Acceptance missed = examine(*rest, null.fit, static_cast<int>(placed.freed.size()), 0);
        if (placeEdges(*rest, drawings(*rest, 0), 0, missed.effective)) return true;
    }
    return false;
}

/// The model with the jumps of its inputs where the outputs say that they are; so in all that is fitted from here on.
bool Search::refitPlaced(NullModel& null, Variant placed, std::vector<InputEdge> edges) {
    Outcome<NullModel> next = fitNull(placed, null.noise, NoiseLevel::Estimate, search_.fit, progress_);
    if (!next || progress_.stopRequested()) return false;
    null = std::move(*next);
    if (asRecorded_.empty()) asRecorded_ = full_.task.recordings;
    place(base_.task, edges);
    place(full_.task, edges);
    for (const InputEdge& e : edges)
        trace("reading", "edge " + e.input,
              {{"recording", e.recording}, {"sample", e.sample}, {"part", e.part}, {"bend", e.bend}}, "accepted");
    edges_ = std::move(edges);
    return true;
}

/// The model beside inputs without their noise; so in all that the search fits from here on.
bool Search::refitQuiet(NullModel& null, Variant quiet, const std::vector<NoisyInput>& noisy) {
    Outcome<NullModel> next = fitNull(quiet, null.noise, NoiseLevel::Estimate, search_.fit, progress_);
    if (!next || progress_.stopRequested()) return false;
    null = std::move(*next);
    quieten(base_.task);
    if (!clocks_.empty()) {
        EstimationTask stamped = base_.task;
        stamped.recordings = std::move(stamped_);
        quieten(stamped);
        stamped_ = std::move(stamped.recordings);
    }
    for (const NoisyInput& input : noisy)
        trace("reading", "noise of " + input.name, {{"recording", input.recording}, {"deviation", input.deviation}},
              "accepted");
    noisyInputs_ = noisy;
    return true;
}

/// Where a record begins that does not begin where the model does: all its states at once, of which those stay that
/// are told apart from where the model begins.
std::optional<Search::Begun> Search::findBeginning(const NullModel& null, Against against, double threshold) const {
    std::vector<ToldStart> starts = startsBegunElsewhere(null, against);
    if (starts.size() > mostStarts) return std::nullopt;
    while (!starts.empty()) {
        say("reconsider", starts.front().parameter, -1);
        Variant variant = null.variant;
        for (const ToldStart& start : starts) setFitted(variant.task, start, true);
        const auto count = static_cast<int>(starts.size());
        std::optional<Allowed> with = allowed(null, variant, count, threshold);
        if (null.variant.effects.empty()) {
            variant.values.clear();  // parameters that made up for the start may lead nowhere
            if (std::optional<Allowed> anew = allowed(null, variant, count, threshold);
                anew && (!with || anew->fit.objective < with->fit.objective))
                with = std::move(anew);
        }
        if (!with) return std::nullopt;
        const auto isLikeTold = [&](const ToldStart& start) {
            const FitEstimate* e = with->fit.find(start.parameter, start.experiment);
            return e == nullptr || !(std::abs(e->value - start.value) > leastMoved * e->standardError);
        };
        if (std::erase_if(starts, isLikeTold) > 0) continue;
        if (!with->gain.isSignificant || !with->gain.isWorthwhile) return std::nullopt;
        return Begun{std::move(starts), with->gain, valuesOf(with->fit), with->fit.optimum.residuals.squaredNorm()};
    }
    return std::nullopt;
}

/// The model with start values fitted, or held where they were told to be.
Outcome<NullModel> Search::fittedWith(Variant variant, const std::vector<Eigen::VectorXd>& noise,
                                      const std::vector<ToldStart>& starts, bool isFitted) const {
    setFitted(variant.task, starts, isFitted);
    for (const ToldStart& start : starts)
        if (!isFitted)
            std::erase_if(variant.values, [&](const ParameterValue& v) {
                return v.experiment == start.experiment && v.name == start.parameter;
            });
    return fitNull(variant, noise, isFitted ? NoiseLevel::Estimate : NoiseLevel::Keep, search_.fit, progress_);
}

/// Start values are fitted in all that the search fits from here on.
void Search::freeStarts(const std::vector<ToldStart>& starts) {
    setFitted(base_.task, starts, true);
    setFitted(full_.task, starts, true);
    for (const ToldStart& start : starts)
        trace("reading", "start " + start.parameter, {{"recording", start.recording}, {"told", start.value}},
              "accepted");
    freedStarts_.insert(freedStarts_.end(), starts.begin(), starts.end());
}

bool Search::refitWith(NullModel& null, const std::vector<ToldStart>& starts, std::vector<ParameterValue> values) {
    Variant variant = null.variant;
    variant.values = std::move(values);
    Outcome<NullModel> next = fittedWith(std::move(variant), null.noise, starts, true);
    if (!next || progress_.stopRequested()) return false;
    freeStarts(starts);
    null = std::move(*next);
    return true;
}

/// Whether the model needs a start value to be fitted, beside the effects found since; `held`: the model without.
bool Search::isNeeded(const ToldStart& start, const NullModel& null, const NullModel& held) const {
    // in mid run any state is somewhere else, were it for a sample alone
    const auto rows = static_cast<double>(null.fit.optimum.residuals.size());
    if (start.isOfMidRun) return held.sumOfSquares() - null.sumOfSquares() > equivalenceMargin + std::log(rows);
    const Acceptance missed = examine(held, null.fit, 1, 0);
    const auto isMore = [&] {
        return isBorneOut(besideDisturbance(held, search_.fit.simulation, progress_),
                          besideDisturbance(null, search_.fit.simulation, progress_), null.fit.optimum.residuals.size(),
                          1);
    };
    return missed.isSignificant && missed.isWorthwhile && (isNoise(null) || isMore());
}

/// Holds those start values again that explain nothing that counts.
void Search::holdUnneededStarts(NullModel& null) {
    for (const ToldStart& start : std::vector<ToldStart>(freedStarts_)) {
        Outcome<NullModel> held = fittedWith(null.variant, null.noise, {start}, false);
        if (progress_.stopRequested()) return;
        if (!held || isNeeded(start, null, *held)) continue;
        trace("reading", "start " + start.parameter, {{"recording", start.recording}, {"told", start.value}},
              "taken back");
        setFitted(base_.task, {start}, false);
        setFitted(full_.task, {start}, false);
        std::erase_if(freedStarts_, [&](const ToldStart& s) {
            return s.recording == start.recording && s.parameter == start.parameter;
        });
        null = std::move(*held);
    }
}

/// Recordings that only validate were often cut out of longer ones: where they begin elsewhere than the model, the
/// states they begin with are estimated from them, beside whatever model. A search that was stopped tells its errors
/// so, too.
void Search::freeChecks(const NullModel& null) {
    Outcome<Variant> whole = withEffects(full_, null.variant.effects, null.variant.values);
    if (!whole) return;
    const auto checked = [&] { return stateOf(*whole, null.fit, search_.fit.simulation, Progress(), Detail::Errors); };
    const Outcome<ModelState> told = checked();
    if (!told) return;
    const bool allDo =
        std::any_of(freedStarts_.begin(), freedStarts_.end(), [](const ToldStart& s) { return s.isOfMidRun; });
    std::vector<ToldStart> starts = startsOfChecks(full_.task, *told, allDo);
    if (starts.empty()) return;
    setFitted(whole->task, starts, true);
    const Outcome<ModelState> freed = checked();
    if (!freed) return;
    // what is no beginning is not mended by another one
    const std::vector<ToldStart> still = startsOfChecks(full_.task, *freed, false);
    std::erase_if(starts, [&](const ToldStart& start) {
        const bool isOfNoBeginning =
            std::any_of(still.begin(), still.end(), [&](const ToldStart& s) { return s.recording == start.recording; });
        return isOfNoBeginning || !isDetermined(start, *freed);
    });
    setFitted(base_.task, starts, true);
    setFitted(full_.task, starts, true);
    for (const ToldStart& start : starts)
        trace("reading", "start of a check " + start.parameter, {{"recording", start.recording}}, "estimated");
    checkStarts_ = std::move(starts);
}

/// What people should know of what was allowed for in the recordings.
std::vector<Text> Search::recordingRemarks(const NullModel& null) const {
    std::vector<Text> remarks = faultRemarks(full_.task.recordings, faults_);
    for (const NoisyInput& input : noisyInputs_)
        remarks.push_back(
            phrase("the input '{}' of '{}' is recorded with noise ({:.2g} rms) that drives the model and not the "
                   "component: the search has smoothed it, the errors that are reported are with it; record it with "
                   "less noise, or smooth it",
                   input.name, full_.task.recordings[static_cast<std::size_t>(input.recording)].name, input.deviation));
    for (const InputClock& clock : clocks_) {
        const double samples = clock.late / samplingInterval(full_.task);
        remarks.push_back(phrase(
            "the input '{}' is stamped {:.3g} s late ({:.2g} samples; a mean over the last sample is late by half "
            "of one): the search reckons with it, the errors that are reported do not; set it in the study as "
            "its \"clock\": {:.3g}",
            clock.input, clock.late, samples, clock.late));
    }
    if (!clocks_.empty() && errorsOnTime_)
        remarks.push_back(
            errorsOnTime_->second >= 0
                ? phrase("with its inputs on time the model has an error of {:.2f} %, and of {:.2f} % on "
                         "recordings that were not fitted",
                         errorsOnTime_->first, errorsOnTime_->second)
                : phrase("with its inputs on time the model has an error of {:.2f} %", errorsOnTime_->first));
    if (!edges_.empty()) remarks.push_back(remarkOn(edges_));
    std::map<int, std::vector<std::string>> ofChecks;
    for (const ToldStart& start : checkStarts_) ofChecks[start.recording].push_back(start.parameter);
    for (const auto& [recording, names] : ofChecks)
        remarks.push_back(
            phrase("'{}' does not begin where the model was told: what it begins with is estimated from it alone, and "
                   "its errors are with that ({}; say so in the study with \"initial\": \"fit\")",
                   full_.task.recordings[static_cast<std::size_t>(recording)].name, listed(names)));
    for (const ToldStart& start : freedStarts_)
        for (const FitEstimate& e : null.fit.estimates) {
            if (e.name != start.parameter || e.experiment != start.experiment) continue;
            const Recording& recording = full_.task.recordings[static_cast<std::size_t>(start.recording)];
            remarks.push_back(
                phrase("'{}' does not begin where the model was told: {} is {}{}{} there, not {:.5g}; "
                       "it is fitted for this recording (\"initial\": \"fit\")",
                       recording.name, start.parameter, Text::number(valueText(e.value, e.standardError)),
                       e.unit.empty() ? "" : " ", e.unit, start.value));
        }
    return remarks;
}

}  // namespace analogon
