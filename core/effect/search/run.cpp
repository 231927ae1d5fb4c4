#include "core/effect/search/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "core/base/stop.hpp"
#include "core/base/stopwatch.hpp"
#include "core/effect/catalogue/kinds.hpp"
#include "core/effect/judge/caution.hpp"
#include "core/effect/judge/disturbance.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/search/beside_recordings.hpp"
#include "core/effect/search/conclude.hpp"
#include "core/effect/search/course_search.hpp"
#include "core/effect/search/experiments.hpp"
#include "core/effect/search/first_fit.hpp"
#include "core/effect/search/held_values.hpp"
#include "core/effect/search/indicate.hpp"
#include "core/effect/search/interrupted.hpp"
#include "core/effect/search/mistaken_reading.hpp"
#include "core/effect/search/prune.hpp"
#include "core/effect/search/reading_remarks.hpp"
#include "core/effect/search/recordings.hpp"
#include "core/effect/search/redraw.hpp"
#include "core/effect/search/starts.hpp"
#include "core/effect/search/without.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using threshold::paths::leastPatience;
using threshold::paths::mostOfAFit;

Outcome<Finding> Run::run() {
    const auto begin = std::chrono::steady_clock::now();
    const auto found = [this]() -> Outcome<Finding> {
        try {
            const StopScope scope(search_.progress.stopToken());
            Outcome<Finding> whole = searched();
            stopPoint();  // what was passed over since then may have changed what it says
            return whole;
        } catch (const Stopped&) {
            takeBestOnAll();
            const std::stop_source nobody;  // asks what is told now to stop, whatever is in force outside
            const StopScope scope(nobody.get_token());
            return foundSoFar(search_, first_);
        }
    };
    Outcome<Finding> finding = found();
    if (!finding) return finding;
    finding->end.seconds = secondsSince(begin);
    finding->end.isAtLimitOfWork = search_.work.isSpent();
    if (finding->end.isAtLimitOfWork)
        finding->warnings.push_back(phrase(
            "the search was ended after {:.0f} times the work of the fit of the model as given, and says what it had "
            "until then; with more patience (--patience {:.0f}) it goes on",
            search_.work.simulated.done() / fitWork_, 10 * search_.options.patience));
    search_.journal.add("work", "", {{"steps", search_.work.simulated.done()}, {"of_fit", fitWork_}}, "counted");
    search_.journal.finding(*finding);
    return finding;
}

/// The best node of a search that has come to the limit of its work, fitted to all samples.
void Run::takeBestOnAll() {
    if (!onAll_ || !search_.work.isSpent()) return;
    try {
        const WorkScope nobody(nullptr);  // what it was stopped at is told
        const StopScope scope(outside_.stopToken());
        fitBestOnAll(search_, *onAll_, outside_);
    } catch (const Stopped&) {
    }
}

Outcome<Finding> Run::searched() {
    for (const auto phase : {&Run::chooseCatalogue, &Run::fitAsGiven, &Run::tellAsGiven})
        if (const Outcome<Done> done = (this->*phase)(); !done) return done.diagnostics();
    if (isNotToBeSearched()) return std::move(end_.finding);
    if (const Outcome<Done> done = seekBestPath(); !done) return done.diagnostics();
    freeChecks();
    concludeBestPath();
    weighHeldValues();
    if (const Outcome<Done> done = fitAtLast(); !done) return done.diagnostics();
    return tellEnding(search_, std::move(end_));
}

/// The effects of the libraries that are asked for.
Outcome<Done> Run::chooseCatalogue() {
    Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(search_.readings.searched.task.library);
    if (!catalogue) return catalogue.diagnostics();
    for (const Diagnostic& w : catalogue.diagnostics()) end_.finding.warnings.push_back(format(w));
    const std::vector<std::string>& kinds = search_.options.kinds;
    const std::vector<EffectChoice>& choices = search_.options.choices;
    if (Diagnostics faults = unknownKinds(kinds, *catalogue); !faults.empty()) return faults;
    if (!kinds.empty())
        std::erase_if(*catalogue, [&](const EffectClass& e) {
            return std::find(kinds.begin(), kinds.end(), e.kind) == kinds.end();
        });
    if (!choices.empty())  // their places are chosen among those of these classes alone
        std::erase_if(*catalogue, [&](const EffectClass& e) {
            return std::none_of(choices.begin(), choices.end(),
                                [&](const EffectChoice& c) { return c.className == e.className; });
        });
    search_.catalogue = std::move(*catalogue);
    return Done{};
}

Outcome<Done> Run::fitOnAll() {
    if (search_.readings.thinning.isWhole()) return Done{};
    Outcome<NullModel> fitted =
        fitNull(search_.readings.full, {}, NoiseLevel::Estimate, search_.options.fit, search_.progress);
    if (!fitted) return fitted.diagnostics();
    onAll_ = std::move(*fitted);
    return Done{};
}

namespace {

/// Root mean square of what a model leaves of each output [its unit].
std::map<int, double> leftOf(const NullModel& model) {
    std::map<int, double> squares, counts;
    const std::vector<int> recordings = recordingsOf(model.variant.task, Role::Fit);
    for (const ResidualChannel& c : model.channels) {
        const auto recording = static_cast<std::size_t>(recordings[static_cast<std::size_t>(c.experiment)]);
        const double unit = model.noise[recording][c.output];
        squares[c.output] += unit * unit * model.fit.optimum.residuals.segment(c.begin, c.end - c.begin).squaredNorm();
        counts[c.output] += c.end - c.begin;
    }
    for (auto& [output, square] : squares) square = std::sqrt(square / counts[output]);
    return squares;
}

}  // namespace

/// Whether means of neighbouring samples blur what the model follows: it leaves more of an output than on all samples,
/// of which means leave less noise.
bool Run::isBlurred(const NullModel& onMeans) const {
    if (!onAll_ || search_.readings.thinning.factor < 2) return false;
    const std::map<int, double> means = leftOf(onMeans), all = leftOf(*onAll_);
    return std::any_of(means.begin(), means.end(), [&](const auto& left) {
        const auto there = all.find(left.first);
        return there != all.end() && left.second > largeResidual * there->second;
    });
}

Text Run::shortened() const {
    const Thinning& thinning = search_.readings.thinning;
    if (!thinning.isFirstPart)
        return phrase(
            "long recordings: the search works on means of {} samples, the fit before and after it on all of them",
            thinning.factor);
    const Text part = phrase(
        "long recordings, in which means of neighbouring samples would blur what is fast: the search works on their "
        "first part, the fit before and after it on all of them");
    if (thinning.factor < 2) return part;
    return phrase("{} (on means of {} samples)", part, thinning.factor);
}

/// The model as given, fitted to sound samples from where it comes to its best optimum.
Outcome<Done> Run::fitAsGiven() {
    Readings& readings = search_.readings;
    std::vector<Text>& warnings = end_.finding.warnings;
    search_.say("fit", readings.searched.task.className, 0);
    first_.variant = readings.searched;
    const FitOptions fromAnywhere = beginningAnywhere(search_.options.fit);
    if (Outcome<Done> fitted = fitNull(first_, NoiseLevel::Estimate, fromAnywhere, search_.progress); !fitted)
        return fitted.diagnostics();
    Outcome<NullModel> null = first_;
    if (null->beginning) {  // what follows begins where the model can be simulated
        readings.searched.values = readings.full.values = null->beginning->values;
        warnings.push_back(null->beginning->remark);
    }
    if (const Outcome<Done> fitted = fitOnAll(); !fitted) return fitted.diagnostics();
    while (isBlurred(*null)) {
        readings.thinning = finer(readings.thinning);
        readings.searched.task = thinned(readings.full.task, readings.thinning);
        null = fitNull(readings.searched, {}, NoiseLevel::Estimate, fromAnywhere, search_.progress);
        if (!null) return null.diagnostics();
    }
    fitWork_ = search_.work.simulated.done();  // without what other starts and faulty samples cost
    search_.journal.model("null fit", *null, "fitted");
    const bool isAtRest = !anyOutputMoves(readings.full.task);
    const bool hasFaults = !isAtRest && leaveOutFaults(search_, onAll_ ? *onAll_ : *null);
    if (hasFaults) null = fitNull(readings.searched, {}, NoiseLevel::Estimate, search_.options.fit, search_.progress);
    if (!null) return null.diagnostics();
    const bool isElsewhere = !isAtRest && beginElsewhere(search_, *null);
    if (isElsewhere)
        warnings.push_back(
            phrase("from the start values of the study the fit ends at a poorer optimum: the search begins at the best "
                   "of {} starts about them",
                   1 + otherStarts));
    if (onAll_) {
        warnings.push_back(shortened());
        if (hasFaults || isElsewhere)
            if (const Outcome<Done> fitted = fitOnAll(); !fitted) return fitted.diagnostics();
    }
    end_.base = std::move(*null);
    return Done{};
}

void Run::keepAsInterrupted() {
    search_.frontier.begun = end_.finding;
    search_.frontier.begun->kind = FindingKind::Interrupted;
    search_.frontier.begun->end.interrupted = true;
}

Outcome<Done> Run::tellAsGiven() {
    const NullModel& given = onAll_ ? *onAll_ : end_.base;
    const SimulationOptions& simulation = search_.options.fit.simulation;
    Outcome<ModelState> state = stateOf(given.variant, given.fit, simulation, search_.progress);
    if (!state) return state.diagnostics();
    end_.finding.baseline = end_.finding.final = std::move(*state);
    search_.frontier.bestError = errorPercentOf(end_.finding.baseline, Role::Fit);
    asGiven_ = {given.variant, given.fit};
    asGiven_.fit.optimum = {};
    stopPoint();
    keepAsInterrupted();
    keepSoFar(search_, {});
    search_.journal.model("null fit", end_.base, "base");
    search_.work.limitSimulated(workAllowed(search_.options.patience, fitWork_));
    search_.fit.simulation.relativeTolerance = toleranceBeside(end_.base, simulation.relativeTolerance);
    return Done{};
}

/// Whether a reading may only make up for a record that begins elsewhere than the model.
bool Run::isOfBeginning(const NullModel& read) const {
    const std::optional<Begun> begun = findBeginning(search_, end_.base, Against::Noise, 0);
    return begun && begun->sumOfSquares < read.sumOfSquares();
}

/// Whether numbers are in another unit than the recordings say; what is found is told of that then.
bool Run::isOfMistakenUnit() {
    const Variant given{search_.readings.searched.task, {}, {}};
    const auto mistake = mistakenUnit(end_.base, given, search_.fit, search_.progress);
    if (!mistake) return false;
    const bool isAccepted = !isOfBeginning(mistake->read);
    search_.journal.add("reading", "unit " + mistake->unit + " as " + mistake->likely,
                        {{"sum_of_squares", mistake->read.sumOfSquares()}}, isAccepted ? "accepted" : "set aside");
    if (isAccepted) end_.finding = besideMistake(search_, std::move(end_.finding), end_.base, *mistake);
    return isAccepted;
}

/// Whether channels are exchanged, or one is of the wrong sign; what is found is told of that then.
bool Run::isOfMistakenWiring() {
    const Variant given{search_.readings.searched.task, {}, {}};
    const std::vector<MistakenWiring> alike = mistakenWirings(end_.base, given, search_.fit, search_.progress);
    if (alike.empty()) return false;
    const bool isAccepted = !isOfBeginning(alike.front().read);
    for (const MistakenWiring& mistake : alike)
        search_.journal.add(
            "reading",
            (mistake.isOfSign() ? "sign of " : "exchanged ") + fmt::format("{}", fmt::join(mistake.channels, ", ")),
            {{"recording", mistake.recordings.front()}, {"sum_of_squares", mistake.read.sumOfSquares()}},
            isAccepted ? "accepted" : "set aside");
    if (isAccepted) end_.finding = besideMistake(search_, std::move(end_.finding), end_.base, alike);
    return isAccepted;
}

bool Run::isNotToBeSearched() {
    Text why = nothingMoves(search_.readings.full.task, end_.finding.baseline);
    if (why.empty() && (isOfMistakenUnit() || isOfMistakenWiring())) return true;
    if (why.empty()) why = tooFewSamples(end_.base);
    if (why.empty()) return false;
    end_.finding.kind = FindingKind::Unexplained;
    end_.finding.warnings.push_back(why);
    end_.finding.end.notSearched = std::move(why);
    return true;
}

Outcome<Done> Run::seekBestPath() {
    Outcome<Node> best = bestPath(search_, end_.base);
    if (!best) return best.diagnostics();
    end_.node = std::move(*best);
    return Done{};
}

/// Recordings that only validate begin where they are estimated to, in all that is told from here on.
void Run::freeChecks() {
    analogon::freeChecks(search_, end_.node.null);
    const std::vector<ToldStart>& starts = search_.readings.checkStarts;
    if (starts.empty()) return;
    setFitted(asGiven_.variant.task, starts, true);
    for (NullModel* model : {&end_.node.null, &end_.base}) setFitted(model->variant.task, starts, true);
    for (Node& other : search_.frontier.otherEnds) setFitted(other.null.variant.task, starts, true);
    // before and after are told alike
    if (Outcome<ModelState> told = stateOf(asGiven_.variant, asGiven_.fit, search_.options.fit.simulation, Progress()))
        end_.finding.final = end_.finding.baseline = std::move(*told);
    stopPoint();
    keepAsInterrupted();
}

/// Whether nothing was found where much is left.
bool Run::isOpen() const {
    return end_.node.steps.empty() && !isNoise(end_.node.null) && search_.courses.areEmpty() &&
           end_.conclusion.leavesMuch && !search_.progress.stopRequested();
}

/// What the best path comes to, or a parameter that is not constant in its place. What explains most may be what a
/// disturbance takes over best, or what stands on effects that are not missed; then the next best path is judged.
void Run::concludeBestPath() {
    const NullModel& base = end_.base;
    const Courses& courses = search_.courses;
    std::vector<Node> ends{end_.node};
    ends.insert(ends.end(), search_.frontier.otherEnds.begin(), search_.frontier.otherEnds.end());
    if (search_.frontier.best.whole) ends.push_back(search_.frontier.best.whole->node);
    settleCourses(search_, base, end_.node.null);
    if (!courses.areEmpty()) {
        takeOutAll(search_, end_.node, base, betterAccount(courses));
        end_.finding.final = end_.finding.baseline;
    }
    end_.conclusion = conclude(search_, end_.node, base, courses.areEmpty());
    for (Node& other : search_.frontier.otherEnds) {
        if (!isOpen()) break;
        if (!(misfitIn(base, other.null) < end_.conclusion.misfit)) continue;
        Conclusion next = conclude(search_, other, base, false);
        const bool isBetter = other.steps.empty() ? !next.proposed.empty() && next.misfit < end_.conclusion.misfit
                                                  : misfitIn(base, other.null) < end_.conclusion.misfit;
        search_.journal.model("other end", other.null, isBetter ? "taken" : "set aside");
        if (!isBetter) continue;
        end_.node = std::move(other);
        end_.conclusion = std::move(next);
    }
    if (courses.areEmpty() && end_.conclusion.proposed.empty()) indicate(search_, base, end_.node, ends);
}

/// Start values, clocks and held parameters are asked once more beside the effects that were found; and what to run
/// next.
void Run::weighHeldValues() {
    stopPoint();
    Node& node = end_.node;
    holdUnneededStarts(search_, node.null);
    holdUnneededClocks(search_, node.null);
    end_.heldWrongly = takeOutAllForHeld(search_, node, end_.base);
    if (end_.heldWrongly.empty()) {
        end_.held = heldValues(search_, node);
        end_.heldWrongly = takeOutForHeld(search_, node, end_.held);
    }
    if (!end_.heldWrongly.empty()) {
        end_.finding.final = end_.finding.baseline;
        end_.conclusion.proposed.clear();  // what bent for the same reason
    }
    end_.finding.nextExperiment = proposeExperiments(search_, node);
    if (end_.conclusion.proposed.empty() && search_.courses.areEmpty() && !isNoise(node.null))
        end_.source = likeliestSource(node.null, search_.fit.simulation, search_.progress);
}

bool Run::isAsGiven() const {
    const Readings& readings = search_.readings;
    return end_.node.steps.empty() && readings.freedStarts.empty() && readings.noisyInputs.empty() &&
           readings.drawn.asRecorded.empty();
}

/// What the search came to stands, integrated as it was there.
Outcome<Done> Run::keepOwnFit(const Text& why) {
    const NullModel& own = end_.node.null;
    end_.finding.warnings.push_back(phrase("the last fit failed, the search's own stands: {}", why));
    Outcome<ModelState> found = stateOf(own.variant, own.fit, search_.fit.simulation, search_.progress);
    if (!found) return found.diagnostics();
    search_.journal.model("last fit", own, "failed");
    end_.finding.final = std::move(*found);
    return Done{};
}

/// The search was content with less: the model that is reported is fitted on every sample, and integrated as exactly as
/// was asked for. What it does not need there is taken out of it.
Outcome<Done> Run::fitAtLast() {
    Node& node = end_.node;
    Readings& readings = search_.readings;
    const FitOptions& exact = search_.options.fit;
    const bool isQuiet = !readings.noisyInputs.empty(), isOther = onAll_ || isQuiet;
    while (!isAsGiven()) {
        stopPoint();
        // what is left with the inputs as recorded is their noise; it says nothing of the component
        if (isQuiet) end_.beforeReading = node.null;
        Outcome<Variant> whole = node.null.variant;
        if (isOther) whole = onAllSamples(readings, node.null);
        if (!whole) return whole.diagnostics();
        Outcome<NullModel> fitted = fitNull(*whole, onAll_ ? onAll_->noise : node.null.noise,
                                            isOther ? NoiseLevel::Estimate : NoiseLevel::Keep, exact, search_.progress);
        if (!fitted) return keepOwnFit(fitted.diagnostics().front().message);
        if (!isOther && isAstray(*fitted, node.null)) return keepOwnFit(phrase("it came to a far poorer optimum"));
        if (isOther &&
            std::any_of(node.steps.begin(), node.steps.end(), [](const Step& step) { return step.prediction; }))
            seekFromTheStart(search_, readings.full, *fitted);
        Outcome<ModelState> after = stateOf(fitted->variant, fitted->fit, exact.simulation, search_.progress);
        if (!after) return after.diagnostics();
        if (dropIndistinct(search_, *fitted, *after, node)) continue;
        if (onAll_ && !isQuiet && dropUnmissed(search_, *fitted, node)) continue;
        node.null = std::move(*fitted);
        search_.journal.model("last fit", node.null, "fitted");
        end_.finding.final = std::move(*after);
        reportAsRecorded(search_, node.null, end_.finding.final);
        return Done{};
    }
    node.null = onAll_ ? *onAll_ : end_.base;
    return Done{};
}

}  // namespace analogon
