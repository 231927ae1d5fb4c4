#include "core/effect/search/discover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/base/number_text.hpp"
#include "core/base/stop.hpp"
#include "core/base/stopwatch.hpp"
#include "core/base/unit.hpp"
#include "core/effect/catalogue/kinds.hpp"
#include "core/effect/course/dependence.hpp"
#include "core/effect/judge/caution.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/judge/remainder.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/model/thin.hpp"
#include "core/effect/reading/held_command.hpp"
#include "core/effect/search/search.hpp"

namespace analogon {
namespace {

constexpr double integrationShare = 2e-3, coarsestTolerance = 3e-5;  // of the noise, and of a channel's range at most
constexpr long mostSteps = 5'000'000;  // of the adaptive engine in one simulation: a minute's, as a rule
constexpr int otherStarts = 7;
constexpr double startsWithin = 4;  // of the values in the study, by this factor
constexpr std::size_t fewestOfImitation = 3;
constexpr double shareOfImitation = 0.05;  // of what they explain together

/// The options with limits in work alone: what is found depends on no clock, and on no other load of the machine.
DiscoverOptions limitedInWork(DiscoverOptions options) {
    SimulationOptions& simulation = options.fit.simulation;
    simulation.wallClockLimit = std::numeric_limits<double>::infinity();
    simulation.stepLimit = std::min(simulation.stepLimit, mostSteps);
    return options;
}

/// What a model leaves, in units of the noise of the model as given, and what its parameters cost (BIC).
double misfitIn(const NullModel& base, const NullModel& model) {
    const double rows = static_cast<double>(base.fit.optimum.residuals.size());
    return sumInUnitsOf(base, model) + model.parameterCount() * std::log(rows);
}

/// Where and when a proposal shows when nothing else is left: at its sensor, or where the noise has a memory.
void tellWhere(Remainder& r, const std::vector<ColouredNoise>& noise, const ModelState& state) {
    const auto fitted = std::find_if(state.experiments.begin(), state.experiments.end(),
                                     [](const ExperimentState& e) { return e.role == Role::Fit; });
    if (!noise.empty()) {
        r.output = noise.front().output;
        r.experiment = noise.front().experiment;
    } else if (fitted != state.experiments.end()) {
        r.output = fitted->outputs.front().name;
        r.experiment = fitted->name;
    }
    if (r.node.starts_with(outputPrefix)) r.output = r.node.substr(outputPrefix.size());
    for (const ExperimentState& e : state.experiments)
        if (e.name == r.experiment && r.to <= r.from) r.from = e.time.front(), r.to = e.time.back();
}

/// Puts proposals first among what is left; the strongest channel tells when it shows and what it moves with.
void offer(std::vector<Remainder> proposed, const std::vector<ColouredNoise>& noise, const ModelState& state,
           std::vector<Remainder>& left) {
    for (Remainder& r : proposed) {
        if (left.empty()) {
            tellWhere(r, noise, state);
            continue;
        }
        const auto strongest = std::max_element(
            left.begin(), left.end(), [](const Remainder& a, const Remainder& b) { return a.evidence < b.evidence; });
        r.output = strongest->output;
        r.experiment = strongest->experiment;
        if (r.to <= r.from) {
            r.from = strongest->from;
            r.to = strongest->to;
        }
        r.movesWith = strongest->movesWith;
    }
    left.insert(left.begin(), std::make_move_iterator(proposed.begin()), std::make_move_iterator(proposed.end()));
}

/// The same for a parameter that changes, where anything is left at all: what it accounts for may else pass for noise
/// with a memory.
void offerAlone(Remainder change, const std::vector<ColouredNoise>& noise, const ModelState& state,
                std::vector<Remainder>& left) {
    if (!left.empty() || !noise.empty()) offer({std::move(change)}, noise, state, left);
}

/// A parameter of another value, or one that changes, as a proposal at its component.
Remainder changing(const std::string& parameter, double evidence, Text equation) {
    Remainder r;
    r.node = parameter.substr(0, parameter.rfind('.'));
    r.evidence = evidence;
    r.proposedEquation = std::move(equation);
    return r;
}

Remainder remainderOf(const Change& c, double end) {
    Remainder r =
        changing(c.parameter, c.explained,
                 fmt::format("{} = if time < {:.4g} then {:.4g} else {:.4g}", c.parameter, c.time, c.before, c.after));
    r.from = c.time;
    r.to = end;
    return r;
}

/// Of all recordings that were not fitted, each in the condition that suits it best [%]; -1: there are none.
double leastOf(const std::vector<CheckOfChange>& checks) {
    const auto all = [](const CheckOfChange&) { return true; };
    return checks.empty() ? -1
                          : meanError(
                                checks, [](const CheckOfChange& c) { return c.least(); }, all);
}

/// In which condition a recording that was not fitted seems to have been taken.
Text remarkOf(const CheckOfChange& c, const std::string& parameter) {
    return phrase(
        "on '{}', which was not fitted, the error is {:.3g} % with the value of {} before that change, {:.3g} % with "
        "the one after it, and {:.3g} % with the change at the same time",
        c.experiment, c.before, parameter, c.after, c.alike);
}

/// The proposals, first among what is left, account for what is not there any more beside them.
void keepWhatIsLeft(const NullModel& with, std::size_t proposals, const SimulationOptions& simulation,
                    std::vector<Remainder>& left) {
    if (left.size() <= proposals) return;
    const std::vector<Remainder> beside = leftovers(with, simulation).structure;
    left.erase(std::remove_if(left.begin() + static_cast<std::ptrdiff_t>(proposals), left.end(),
                              [&](const Remainder& r) {
                                  return std::none_of(beside.begin(), beside.end(), [&](const Remainder& b) {
                                      return b.output == r.output && b.experiment == r.experiment;
                                  });
                              }),
               left.end());
}

Text estimateText(const HeldInstead& h) { return Text::number(valueText(h.value, h.standardError)); }

Text remarkOf(const HeldInstead& h, const std::string& effect, const std::string& at) {
    return h.byBound ? phrase(
                           "{} at {} explains no more than {} beyond its bound of {:.5g}: {}{} instead; "
                           "keep the bound only if it is known for certain",
                           effect, at, h.parameter, h.held, estimateText(h), behindNumber(h.unit))
                     : phrase(
                           "{} at {} explains no more than another value of {}, which is held at {:.5g}: {}{} "
                           "instead; hold it only if it is known for certain",
                           effect, at, h.parameter, h.held, estimateText(h), behindNumber(h.unit));
}

Text remarkOf(const HeldInstead& h) {
    return h.byBound ? phrase(
                           "{} beyond its bound of {:.5g} explains more than any effect: {}{} fits; widen "
                           "the bound",
                           h.parameter, h.held, estimateText(h), behindNumber(h.unit))
                     : phrase(
                           "another value of {} explains more than any effect: it is held at {:.5g}, and {}{} "
                           "fits; correct it, or let it be fitted",
                           h.parameter, h.held, estimateText(h), behindNumber(h.unit));
}

/// What explains as much as the value that is told first.
Text remarkOfEqual(const HeldInstead& h) {
    return phrase("{} of {}{} instead of {:.5g} explains as much: the data do not tell which is wrong", h.parameter,
                  estimateText(h), behindNumber(h.unit), h.held);
}

Remainder remainderOf(const HeldInstead& h) {
    Remainder r = changing(h.parameter, h.explained, phrase("{} = {:.5g}", h.parameter, h.value));
    r.errorFitWith = h.errorFitWith;
    r.errorValidateWith = h.errorValidateWith;
    return r;
}

Remainder remainderOf(const Dependence& d) {
    return changing(d.parameter, d.explained,
                    fmt::format("{} = {:.4g} {} {:.4g}*({} - {:.4g})", d.parameter, d.value, d.slope < 0 ? "-" : "+",
                                std::abs(d.slope / d.range), d.channel, d.middle));
}

/// Where an effect stands as well, with the same parameters.
void addTwins(Finding& finding, const PlacedEffect& placed, AddedEffect effect) {
    for (std::size_t t = 0; t < placed.twins.size(); ++t) {
        effect.at = placed.twins[t].at;
        effect.instance = placed.twinInstances[t];
        effect.alternatives.clear();
        finding.effects.push_back(effect);
        finding.warnings.push_back(
            placed.effect.signalSide == "output"
                ? phrase("{} stands at {} and {} with one set of parameters: equal sensors, and the data do not "
                         "tell them apart",
                         effect.kind, placed.place.at, effect.at)
                : phrase("{} stands at {} and {} with one set of parameters: they feed equal blocks, and the data "
                         "do not tell them apart",
                         effect.kind, placed.place.at, effect.at));
    }
}

constexpr std::chrono::milliseconds forTelling{80};  // of work, after a stop, for what is still to be simulated

/// After a stop: work that is cut short, and leaves things as they were, where it takes longer than anybody waits.
template <class Work>
void soon(const Work& work) {
    const StopAfter limit(forTelling);
    const StopScope scope(limit.token());
    try {
        work();
    } catch (const Stopped&) {
    }
}

/// Of records so long that what is made for a simulation takes longer than anybody waits.
bool areLong(const EstimationTask& task) {
    constexpr Eigen::Index most = 200'000;  // samples of outputs
    Eigen::Index count = 0;
    for (const Recording& r : task.recordings) count += static_cast<Eigen::Index>(r.time.size()) * r.outputs.rows();
    return count > most;
}

/// What a fit that was stopped came to: with its traces where they are simulated soon, else with its values alone.
Outcome<ModelState> stateSoFar(const NullModel& null, const SimulationOptions& simulation) {
    std::optional<Outcome<ModelState>> state;
    if (!areLong(null.variant.task)) soon([&] { state = stateOf(null.variant, null.fit, simulation, {}); });
    if (!state) state = valuesAlone(null.variant, null.fit);
    return std::move(*state);
}

/// What a search reports that was stopped in its first fit.
Outcome<Finding> fittedSoFar(const NullModel& null, const SimulationOptions& simulation) {
    if (null.fit.estimates.empty()) return error(phrase("cancelled"));
    Outcome<ModelState> state = stateSoFar(null, simulation);
    if (!state) return state.diagnostics();
    Finding finding;
    finding.baseline = finding.final = std::move(*state);
    finding.kind = FindingKind::Interrupted;
    finding.interrupted = true;
    return finding;
}

}  // namespace

namespace {

/// Where the model cannot be simulated at its start values, it is fitted from others within the bounds.
FitOptions fromAnywhere(FitOptions options) {
    constexpr int others = 128;
    options.otherStarts = others;
    return options;
}

}  // namespace

Search::Search(const EstimationTask& task, const DiscoverOptions& options, const Progress& progress)
    : full_{task, {}, {}},
      thinning_(thinningFor(task, mostSearchedSamples)),
      base_{thinned(task, thinning_), {}, {}},
      options_(limitedInWork(options)),
      search_(options_),
      asked_(progress.stopToken(), [this] { end_.request_stop(); }),
      progress_(end_.get_token(), [&progress](const Progress::Report& report) { progress.report(report); }) {}

AddedEffect Search::describe(const NullModel& last, const ModelState& state, const PlacedEffect& placed,
                             const Step& step) const {
    AddedEffect effect;
    effect.kind = placed.effect.kind;
    effect.className = placed.effect.className;
    effect.description = placed.effect.description;
    effect.at = placed.place.at;
    effect.way = placed.effect.way;
    effect.instance = placed.instance;
    effect.newInput = placed.newInput;
    effect.channel = placed.place.spare;
    // an interrupted search may have a state of before the last refit
    const std::string& strength = placed.freed.front().name;
    const bool isInState = std::any_of(state.parameters.begin(), state.parameters.end(),
                                       [&](const FitEstimate& e) { return e.name == strength; });
    for (const FitParameter& p : placed.freed)
        for (const FitEstimate& e : isInState ? state.parameters : last.fit.estimates)
            if (e.name == p.name)
                effect.parameters.push_back(
                    {p.name.substr(placed.instance.size() + 1), e.value, e.standardError, e.unit});
    for (const auto& [name, value] : placed.values) {
        const auto unit = placed.effect.units.find(name);
        effect.parameters.push_back({name, value, std::nan(""), unit == placed.effect.units.end() ? "" : unit->second});
    }
    effect.evidence.score = step.acceptance.explained;
    effect.evidence.pValue = pValue(step.acceptance.explained, static_cast<int>(placed.freed.size()), step.tried);
    effect.evidence.deltaBic = -step.acceptance.evidence;
    effect.evidence.heldOut = step.acceptance.heldOut;
    // what stands in the model as well is no other explanation, nor is another class of it; and each is named once
    for (const Alternative& a : step.alternatives)
        if (!stands(last.variant, a.kind, a.at) &&
            std::none_of(effect.alternatives.begin(), effect.alternatives.end(),
                         [&](const Alternative& b) { return b.kind == a.kind && b.at == a.at; }))
            effect.alternatives.push_back({a.kind, a.at, effect.evidence.deltaBic + a.deltaBic, a.equivalent});
    return effect;
}

/// Whether several effects explain much together of which none is missed much: a flexible sum of what bends alike
/// stands for something that has no name.
bool Search::onlyImitate(const NullModel& base, const NullModel& null) const {
    if (steps_.size() < fewestOfImitation) return false;
    const double fall = sumInUnitsOf(null, base) - null.sumOfSquares();
    return std::all_of(steps_.begin(), steps_.end(), [&](const Step& s) { return s.fall < shareOfImitation * fall; });
}

/// Back to the model without effects.
void Search::takeOutAll(NullModel& null, const NullModel& base, const Text& why) {
    for (const PlacedEffect& e : null.variant.effects) setVerdict(e, Verdict::NotSignificant, takenOut(why));
    steps_.clear();
    null = base;
}

/// What the search had no time to hold against the rest must be clear by itself.
bool Search::isClear(const Path& path) const {
    return isNoise(path.null) || std::all_of(path.steps.begin(), path.steps.end(), [](const Step& s) {
               return isMissed(s.acceptance) && isClearlyMissed(s.acceptance) && s.acceptance.heldOut > leastHeldOut;
           });
}

/// The model as given, and with the effects of a path that is not the end of the search.
Finding Search::tellWhole(const Path& path, const FlatModel* valued) const {
    Finding finding = *begun_;
    finding.final = *path.state;
    addEffects(finding, path.null, path.steps, {}, valued);
    finding.kind = finding.effects.empty() ? FindingKind::Interrupted
                   : isNoise(path.null)    ? FindingKind::Effect
                                           : FindingKind::Partial;
    finding.interrupted = true;
    return finding;
}

/// Adds the effects of a model to what is found of it, with the parameters that `valued` (the model's equations with
/// their values; null: not at hand) knows beside those that were fitted. Returns what else their values may be.
std::vector<Text> Search::addEffects(Finding& finding, const NullModel& null, const std::vector<Step>& steps,
                                     const HeldValues& held, const FlatModel* valued) const {
    std::vector<Text> heldRemarks;
    for (std::size_t i = 0; i < steps.size() && i < null.variant.effects.size(); ++i) {
        const PlacedEffect& placed = null.variant.effects[i];
        AddedEffect effect = describe(null, finding.final, placed, steps[i]);
        if (valued) addOtherParameters(*valued, placed, effect.parameters);
        // what the model is without this effect, and with it; the others are there in both
        effect.evidence.errorPercentBefore =
            steps[i].errorWithout >= 0 ? steps[i].errorWithout : errorPercentOf(finding.baseline, Role::Fit);
        effect.evidence.errorPercentAfter =
            errorsOnTime_ ? errorsOnTime_->first : errorPercentOf(finding.final, Role::Fit);
        if (const auto values = held.find(steps[i].order); values != held.end())
            for (const HeldInstead& h : values->second) {
                effect.valuesInstead.push_back(h.text());
                heldRemarks.push_back(remarkOf(h, effect.kind, effect.at));
            }
        finding.effects.push_back(effect);
        addTwins(finding, placed, std::move(effect));
    }
    return heldRemarks;
}

/// Hands on what there is to tell until now.
void Search::keepSoFar() const {
    if (!options_.keep || !begun_) return;
    Finding finding = whole_ && isClear(*whole_) ? tellWhole(*whole_, nullptr) : *begun_;
    finding.candidates = candidates_;
    settleVerdicts(finding, finding.candidates);
    options_.keep(std::move(finding));
}

/// What a search that was stopped reports: the best model that was whole, since what came after it may be half a refit;
/// else the model as given. It had no time to say what is left.
Outcome<Finding> Search::foundSoFar() {
    if (!begun_) {
        Outcome<Finding> fitted = fittedSoFar(first_, options_.fit.simulation);
        if (!fitted) return fitted;
        begun_ = std::move(*fitted);
    }
    const bool hasEffects = whole_ && isClear(*whole_);
    if (hasEffects) {
        soon([&] {
            Path& path = *whole_;
            if (!checkStarts_.empty()) {
                setFitted(path.null.variant.task, checkStarts_, true);
                Outcome<ModelState> found = stateOf(path.null.variant, path.null.fit, options_.fit.simulation, {});
                if (found && !isStopped()) path.state = std::move(*found);
            }
            reportAsRecorded(path.null, *path.state);
        });
        candidates_ = whole_->candidates;
    }
    std::optional<FlatModel> valued;
    if (hasEffects)
        soon([&] {
            if (Outcome<FlatModel> flat = flattened(whole_->null.variant.task, whole_->state->modelText); flat)
                valued = std::move(*flat);
        });
    Finding finding = hasEffects ? tellWhole(*whole_, valued ? &*valued : nullptr) : *begun_;
    const Text why = takenOut(phrase("the search was stopped before it was borne out"));
    for (CandidateResult& c : candidates_)
        if (c.verdict == Verdict::Chosen &&
            std::none_of(finding.effects.begin(), finding.effects.end(),
                         [&](const AddedEffect& e) { return e.kind == c.kind && e.at == c.at; })) {
            c.verdict = Verdict::NotSignificant;
            c.reason = why;
        }
    settleVerdicts(finding, candidates_);
    finding.candidates = std::move(candidates_);
    return finding;
}

/// Where the search has placed the jumps of the inputs or set their clocks, the errors are told with the recordings as
/// they are.
void Search::reportAsRecorded(const NullModel& null, ModelState& state) {
    if (asRecorded_.empty()) return;
    Variant plain = full_;
    for (std::size_t r = 0; r < asRecorded_.size(); ++r) {
        Recording& recording = plain.task.recordings[r];
        const Recording& from = asRecorded_[r];
        recording.time = from.time;
        recording.inputs = from.inputs;
        recording.outputs = from.outputs;
        recording.spares = from.spares;
    }
    Outcome<Variant> whole = withEffects(plain, null.variant.effects, null.variant.values);
    if (!whole) return;
    Outcome<ModelState> told = stateOf(*whole, null.fit, options_.fit.simulation, Progress());
    if (!told || isStopped()) return;
    errorsOnTime_ = {errorPercentOf(state, Role::Fit), validationErrorOf(state)};
    state.experiments = std::move(told->experiments);
    state.residual = std::move(told->residual);
}

/// Takes out of what a path ends with all that is not missed, or no more than a disturbance, and the equations without
/// a name, which are returned.
Search::Conclusion Search::conclude(NullModel& null, const NullModel& base, bool mayAddLaw) {
    const bool hasWeak =
        std::any_of(steps_.begin(), steps_.end(), [](const Step& s) { return s.acceptance.evidence < beyondDoubt; });
    if (!isNoise(null) || hasWeak) removeUnneeded(null, 0, true);
    traceModel("conclude", null, "asked");
    if (onlyImitate(base, null))
        takeOutAll(null, base,
                   phrase("of several effects that explain much together none is missed: they only imitate it"));
    if (mayAddLaw && !isNoise(null) && !progress_.stopRequested()) {
        Path before{null, steps_, displaced_, candidates_, {}};
        if (addLaw(null)) {
            removeUnneeded(null, 0, true);
            // beside a law a fit may end elsewhere, where what was needed seems not to be
            const bool isBetter = misfitIn(base, null) < misfitIn(base, before.null);
            traceModel("law beside names", null, isBetter ? "kept" : "taken back");
            if (!isBetter) {
                exchange(before);
                null = std::move(before.null);
            }
        }
    }
    // where a proposal explains all, what it made needless only imitated it
    const bool leavesMuch = levelOf(null.fit) > largeResidual;
    if (leavesMuch) setAsideBehindProposal(null);
    if (!isNoise(null)) removeOutweighed(null, leastOfRest);
    const bool hadProposal = hasProposal(null);
    const double with = misfitIn(base, null), left = excess(null);
    const std::vector<PlacedEffect> beside = null.variant.effects;
    Conclusion conclusion = takeOutProposals(null);
    if (hadProposal) {
        if (leavesMuch) bringBackDisplaced(null, left);
        removeUnneeded(null, 0, true);  // what was seen only beside a proposal is not kept without it
        if (!isNoise(null)) removeOutweighed(null, conclusion.proposed.empty() ? leastOfRest : leastBesideOffered);
    }
    unite(null);
    if (isNoise(null) || levelOf(null.fit) > largeResidual) completeClasses(null);
    treatAlike(null);
    tellBesideNames(null, beside, conclusion);
    conclusion.leavesMuch = leavesMuch;
    conclusion.misfit = conclusion.proposed.empty() ? misfitIn(base, null) : with;
    traceModel("conclude", null, "concluded");
    return conclusion;
}

/// A fit may end at another optimum than the best, and what it leaves there is no missing effect. True: the model and
/// all that follows begin where start values near the given ones led to less.
bool Search::beginElsewhere(NullModel& null) {
    if (isNoise(null) || null.fit.estimates.empty() || isDirect(options_.fit.method)) return false;
    FitOptions around = options_.fit;
    around.starts = 1 + otherStarts;
    around.startsWithin = startsWithin;
    around.simulation = limited(null, around.simulation);
    const std::optional<FitResult> other = fitBeside(null, base_, around, progress_);
    if (!other || progress_.stopRequested()) return false;
    const double fall = null.sumOfSquares() - other->optimum.residuals.squaredNorm();
    if (!(fall > equivalenceMargin)) return false;
    Variant begin = base_;
    begin.values = valuesOf(*other);
    Outcome<NullModel> better = fitNull(begin, null.noise, NoiseLevel::Estimate, options_.fit, progress_);
    if (!better) return false;
    base_.values = full_.values = begin.values;
    null = std::move(*better);
    traceModel("other starts", null, "better");
    return true;
}

/// What is found where numbers are in another unit than the recordings say: whatever an effect would explain beside
/// them is that.
Finding Search::besideMistake(Finding finding, const NullModel& null, const MistakenUnit& mistake) const {
    finding.kind = FindingKind::Unexplained;
    finding.remainders = leftovers(null, options_.fit.simulation).structure;
    const Text channels = channelWords(full_.task, mistake);
    finding.notSearched =
        mistake.asLikely.empty()
            ? phrase("the numbers of {} look like {} and not like the {} that is told", channels, mistake.likely,
                     mistake.unit)
            : phrase(
                  "the numbers of {} look like {} (or {}: other parameters make up for it) and not like the {} that "
                  "is told",
                  channels, mistake.likely, listed(mistake.asLikely), mistake.unit);
    const Variant read{readAsLikely(full_.task, mistake), {}, mistake.read.variant.values};
    if (const Outcome<ModelState> state =
            stateOf(read, mistake.read.fit, options_.fit.simulation, progress_, Detail::Errors)) {
        const double was = errorPercentOf(finding.baseline, Role::Fit), is = errorPercentOf(*state, Role::Fit);
        const double wasUnfitted = validationErrorOf(finding.baseline), isUnfitted = validationErrorOf(*state);
        Text errors = phrase("read so, the model as it is leaves an error of {:.3g} % instead of {:.3g} %", is, was);
        if (isUnfitted >= 0)
            errors += phrase(", and of {:.3g} % instead of {:.3g} % on recordings that were not fitted", isUnfitted,
                             wasUnfitted);
        finding.notSearched = phrase("{}: {}; correct the header, or give the unit in the study, and search again",
                                     finding.notSearched, errors);
    }
    finding.warnings.push_back(finding.notSearched);
    for (Text& remark : recordingRemarks(null)) finding.warnings.push_back(std::move(remark));
    return finding;
}

Outcome<Finding> Search::run() {
    const auto begin = std::chrono::steady_clock::now();
    const auto found = [this]() -> Outcome<Finding> {
        try {
            const StopScope scope(progress_.stopToken());
            Outcome<Finding> whole = searched();
            stopPoint();  // what was passed over since then may have changed what it says
            return whole;
        } catch (const Stopped&) {
            const std::stop_source nobody;  // asks what is told now to stop, whatever is in force outside
            const StopScope scope(nobody.get_token());
            return foundSoFar();
        }
    };
    Outcome<Finding> finding = found();
    if (!finding) return finding;
    finding->seconds = secondsSince(begin);
    traceFinding(*finding);
    return finding;
}

Outcome<Finding> Search::searched() {
    Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(base_.task.library);
    if (!catalogue) return catalogue.diagnostics();
    Finding finding;
    for (const Diagnostic& w : catalogue.diagnostics()) finding.warnings.push_back(format(w));
    catalogue_ = std::move(*catalogue);
    if (Diagnostics faults = unknownKinds(options_.kinds, catalogue_); !faults.empty()) return faults;
    if (!options_.kinds.empty())
        std::erase_if(catalogue_, [&](const EffectClass& e) {
            return std::find(options_.kinds.begin(), options_.kinds.end(), e.kind) == options_.kinds.end();
        });
    if (!options_.choices.empty())  // their places are chosen among those of these classes alone
        std::erase_if(catalogue_, [&](const EffectClass& e) {
            return std::none_of(options_.choices.begin(), options_.choices.end(),
                                [&](const EffectChoice& c) { return c.className == e.className; });
        });

    say("fit", base_.task.className, 0);
    first_.variant = base_;
    if (Outcome<Done> fitted = fitNull(first_, NoiseLevel::Estimate, fromAnywhere(options_.fit), progress_); !fitted)
        return fitted.diagnostics();
    Outcome<NullModel> null = first_;
    if (null->beginning) {  // what follows begins where the model can be simulated
        base_.values = full_.values = null->beginning->values;
        finding.warnings.push_back(null->beginning->remark);
    }
    std::optional<NullModel> onAll;
    const auto fitAll = [&]() -> Outcome<Done> {
        if (thinning_ < 2) return Done{};
        Outcome<NullModel> fitted = fitNull(full_, {}, NoiseLevel::Estimate, options_.fit, progress_);
        if (!fitted) return fitted.diagnostics();
        onAll = std::move(*fitted);
        return Done{};
    };
    Outcome<Done> isFitted = fitAll();
    if (!isFitted) return isFitted.diagnostics();
    traceModel("null fit", *null, "fitted");
    const bool hasFaults = leaveOutFaults(onAll ? *onAll : *null);
    if (hasFaults) null = fitNull(base_, {}, NoiseLevel::Estimate, options_.fit, progress_);
    if (!null) return null.diagnostics();
    const bool isElsewhere = beginElsewhere(*null);
    if (isElsewhere)
        finding.warnings.push_back(
            phrase("from the start values of the study the fit ends at a poorer optimum: the search begins at the best "
                   "of {} starts about them",
                   1 + otherStarts));
    if (onAll) {
        finding.warnings.push_back(
            phrase("long recordings: the search works on means of {} samples, the fit before "
                   "and after it on all of them",
                   thinning_));
        if (hasFaults || isElsewhere) isFitted = fitAll();
        if (!isFitted) return isFitted.diagnostics();
    }
    const NullModel& given = onAll ? *onAll : *null;
    Outcome<ModelState> state = stateOf(given.variant, given.fit, options_.fit.simulation, progress_);
    if (!state) return state.diagnostics();
    finding.baseline = std::move(*state);
    finding.final = finding.baseline;
    bestError_ = errorPercentOf(finding.baseline, Role::Fit);
    stopPoint();
    const auto begin = [&] {
        begun_ = finding;
        begun_->kind = FindingKind::Interrupted;
        begun_->interrupted = true;
    };
    begin();
    keepSoFar();

    Variant asGiven = given.variant;
    FitResult fitAsGiven = given.fit;
    fitAsGiven.optimum = {};
    NullModel base = *null;
    traceModel("null fit", base, "base");
    search_.fit.simulation.relativeTolerance =
        std::clamp(integrationShare * quietest(base), options_.fit.simulation.relativeTolerance, coarsestTolerance);
    const auto mistake = mistakenUnit(base, {base_.task, {}, {}}, search_.fit, progress_);
    // numbers in another unit may only make up for a record that begins elsewhere than the model
    const auto isOfBeginning = [&] {
        const std::optional<Begun> begun = findBeginning(base, Against::Noise, 0);
        return begun && begun->sumOfSquares < mistake->read.sumOfSquares();
    };
    const bool isMistaken = mistake && !isOfBeginning();
    if (mistake)
        trace("reading", "unit " + mistake->unit + " as " + mistake->likely,
              {{"sum_of_squares", mistake->read.sumOfSquares()}}, isMistaken ? "accepted" : "set aside");
    if (isMistaken) return besideMistake(std::move(finding), *null, *mistake);
    if (Text few = tooFewSamples(base); !few.empty()) {
        finding.kind = FindingKind::Unexplained;
        finding.warnings.push_back(few);
        finding.notSearched = std::move(few);
        return finding;
    }
    Outcome<Path> path = bestPath(base);
    if (!path) return path.diagnostics();
    null = std::move(path->null);
    steps_ = std::move(path->steps);
    displaced_ = std::move(path->displaced);
    candidates_ = std::move(path->candidates);

    freeChecks(*null);
    if (!checkStarts_.empty()) {
        setFitted(asGiven.task, checkStarts_, true);
        for (Variant* v : {&null->variant, &base.variant}) setFitted(v->task, checkStarts_, true);
        for (Path& other : otherEnds_) setFitted(other.null.variant.task, checkStarts_, true);
        // before and after are told alike
        if (Outcome<ModelState> told = stateOf(asGiven, fitAsGiven, options_.fit.simulation, Progress()))
            finding.final = finding.baseline = std::move(*told);
        stopPoint();
        begin();
    }
    settleChange(base, *null);
    if (change_ || dependence_) {
        takeOutAll(*null, base,
                   change_
                       ? phrase("{} that changes in mid run is the better account", change_->parameter)
                       : phrase("{} that moves with a recorded channel is the better account", dependence_->parameter));
        finding.final = finding.baseline;
    }
    Conclusion conclusion = conclude(*null, base, !change_ && !dependence_);
    const auto isOpenStill = [&] {
        return steps_.empty() && !isNoise(*null) && !change_ && !dependence_ && conclusion.leavesMuch &&
               !progress_.stopRequested();
    };
    // what explains most may be what a disturbance takes over best, or what stands on effects that are not missed; then
    // the next best path is judged
    for (Path& other : otherEnds_) {
        if (!isOpenStill()) break;
        if (!(misfitIn(base, other.null) < conclusion.misfit)) continue;
        exchange(other);
        Conclusion next = conclude(other.null, base, false);
        const bool isBetter = steps_.empty() ? !next.proposed.empty() && next.misfit < conclusion.misfit
                                             : misfitIn(base, other.null) < conclusion.misfit;
        traceModel("other end", other.null, isBetter ? "taken" : "set aside");
        if (!isBetter) {
            exchange(other);
            continue;
        }
        std::swap(*null, other.null);
        conclusion = std::move(next);
    }
    std::vector<Remainder> proposed = std::move(conclusion.proposed);
    stopPoint();
    holdUnneededStarts(*null);
    holdUnneededClocks(*null);
    std::vector<HeldInstead> heldWrongly = takeOutAllForHeld(*null, base);
    HeldValues held;
    if (heldWrongly.empty()) {
        held = heldValues(*null);
        heldWrongly = takeOutForHeld(*null, held);
    }
    if (!heldWrongly.empty()) {
        finding.final = finding.baseline;
        proposed.clear();  // what bent for the same reason
    }
    finding.nextExperiment = proposeExperiments(*null);
    const bool isOpen = proposed.empty() && !change_ && !dependence_ && !isNoise(*null);
    std::vector<std::string> places;
    if (isOpen) places = likeliestPlaces(*null, search_.fit.simulation, progress_);
    const auto isAsGiven = [&] {
        return steps_.empty() && freedStarts_.empty() && noisyInputs_.empty() && asRecorded_.empty();
    };
    // what is left with the inputs as recorded is their noise; it says nothing of the component
    std::optional<NullModel> quiet;
    // the search was content with less: on every sample, and integrated as exactly as was asked for
    const bool isOther = onAll || !noisyInputs_.empty();
    bool isFinal = isAsGiven();
    while (!isFinal) {
        stopPoint();
        if (!noisyInputs_.empty()) quiet = *null;
        Outcome<Variant> whole = null->variant;
        if (isOther) whole = withEffects(full_, null->variant.effects, null->variant.values);
        if (!whole) return whole.diagnostics();
        Outcome<NullModel> fitted = fitNull(*whole, onAll ? onAll->noise : null->noise,
                                            isOther ? NoiseLevel::Estimate : NoiseLevel::Keep, options_.fit, progress_);
        if (!fitted) {
            // what the search came to stands, integrated as it was there
            finding.warnings.push_back(
                phrase("the last fit failed, the search's own stands: {}", fitted.diagnostics().front().message));
            Outcome<ModelState> found = stateOf(null->variant, null->fit, search_.fit.simulation, progress_);
            if (!found) return found.diagnostics();
            finding.final = std::move(*found);
            break;
        }
        Outcome<ModelState> after = stateOf(fitted->variant, fitted->fit, options_.fit.simulation, progress_);
        if (!after) return after.diagnostics();
        if (dropIndistinct(*fitted, *after, *null) || (onAll && noisyInputs_.empty() && dropUnmissed(*fitted, *null))) {
            isFinal = isAsGiven();
            continue;
        }
        null = std::move(*fitted);
        traceModel("last fit", *null, "fitted");
        finding.final = std::move(*after);
        reportAsRecorded(*null, finding.final);
        isFinal = true;
    }
    if (isAsGiven()) null = onAll ? *onAll : base;
    const Outcome<FlatModel> valued = flattened(null->variant.task, finding.final.modelText);
    const std::vector<Text> heldRemarks = addEffects(finding, *null, steps_, held, valued ? &*valued : nullptr);
    stopPoint();
    Leftovers left = leftovers(quiet ? *quiet : *null, options_.fit.simulation);
    finding.remainders = std::move(left.structure);
    const bool isNoiseAlone = !change_ && !dependence_ && heldWrongly.empty();  // else that accounts for it
    for (const ColouredNoise& n : isNoiseAlone ? left.noise : std::vector<ColouredNoise>())
        finding.warnings.push_back(
            phrase("what is left on output '{}' of '{}' is noise with a memory ({:.2g} s): it moves with nothing "
                   "that is recorded or simulated, and is taken for noise of the measurement",
                   n.output, n.experiment, n.memory));
    for (const UnevenNoise& n : isNoiseAlone ? left.uneven : std::vector<UnevenNoise>())
        finding.warnings.push_back(
            phrase("the noise on output '{}' of '{}' comes and goes, by a factor of {:.2g}: in units of what it is "
                   "near each sample, what is left there is noise",
                   n.output, n.experiment, n.ratio));
    const bool isSmall = std::all_of(finding.remainders.begin(), finding.remainders.end(),
                                     [&](const Remainder& r) { return isWithinForms(r.evidence); });
    if (isSmall && proposed.empty() && !finding.remainders.empty()) {
        finding.warnings.push_back(
            phrase("what is left on output '{}' of '{}' is not quite noise, but far less than what was found "
                   "explains: the forms of its blocks (a rounded change of sign, an exact square) may leave as much",
                   finding.remainders.front().output, finding.remainders.front().experiment));
        finding.remainders.clear();
    }
    for (Remainder& r : finding.remainders) {
        // a sensor shows on its own output alone
        const bool isOfAnother = !places.empty() && places.front().starts_with(outputPrefix) &&
                                 places.front().substr(outputPrefix.size()) != r.output;
        if (places.empty() || isOfAnother) continue;
        r.node = places.front();
        r.equalNodes.assign(places.begin() + 1, places.end());
    }
    if (!proposed.empty()) {
        finding.warnings.insert(finding.warnings.end(), conclusion.sameByName.begin(), conclusion.sameByName.end());
        finding.proposed = std::move(conclusion.model);
    }
    const std::size_t offered = proposed.size();
    offer(std::move(proposed), left.noise, finding.final, finding.remainders);
    if (offered > 0 && conclusion.with)
        keepWhatIsLeft(*conclusion.with, offered, options_.fit.simulation, finding.remainders);
    const auto offerChange = [&](Remainder r, const auto& change) {
        offerAlone(std::move(r), left.noise, finding.final, finding.remainders);
        keepWhatIsLeft(base.with(change.variant, change.fit), 1, options_.fit.simulation, finding.remainders);
    };
    if (change_) {
        const double end = finding.final.experiments[static_cast<std::size_t>(change_->experiment)].time.back();
        Remainder r = remainderOf(*change_, end);
        finding.warnings.push_back(phrase("the condition seems to have changed in mid run: {} at about {:.4g} s",
                                          change_->parameter, change_->time));
        if (const Outcome<ErrorsOfChange> errors =
                errorsOf(*change_, full_.task.recordings, options_.fit.simulation, progress_)) {
            r.errorFitWith = errors->fitted;
            if (errors->checks.size() == recordingsOf(full_.task, Role::Validate).size())
                r.errorValidateWith = leastOf(errors->checks);
            for (const CheckOfChange& c : errors->checks) finding.warnings.push_back(remarkOf(c, change_->parameter));
        }
        offerChange(std::move(r), *change_);
    }
    if (!heldWrongly.empty()) {
        const HeldInstead& best = heldWrongly.front();
        offerAlone(remainderOf(best), left.noise, finding.final, finding.remainders);
        finding.warnings.push_back(remarkOf(best));
        std::transform(heldWrongly.begin() + 1, heldWrongly.end(), std::back_inserter(finding.warnings), remarkOfEqual);
    }
    if (dependence_) {
        Remainder r = remainderOf(*dependence_);
        if (const Outcome<ModelState> with =
                stateOf(dependence_->variant, dependence_->fit, options_.fit.simulation, progress_, Detail::Errors)) {
            r.errorFitWith = errorPercentOf(*with, Role::Fit);
            r.errorValidateWith = validationErrorOf(*with);
        }
        offerChange(std::move(r), *dependence_);
        finding.warnings.push_back(
            phrase("{} seems to move with the recorded channel {}", dependence_->parameter, dependence_->channel));
    }
    for (Remainder& r : finding.remainders)
        if (r.errorValidateWith >= 0) r.errorValidateWithout = errorPercentOf(finding.final, Role::Validate);
    settleVerdicts(finding, candidates_);
    finding.candidates = std::move(candidates_);
    const std::vector<Recording>& recorded = asRecorded_.empty() ? full_.task.recordings : asRecorded_;
    const std::vector<FaultySamples> unfitted = faultySamples(recorded, finding.final);
    const ModelState sound = withoutFaults(finding.final, unfitted);
    EstimationTask measured = full_.task;
    measured.recordings = recorded;
    leaveOut(measured, unfitted);
    for (const auto& sentences :
         {recordingRemarks(*null), faultRemarks(recorded, unfitted, finding.final, sound), extrapolations(measured),
          driftBetweenRecordings(*null), boundHits(null->fit), delaysBelowSampling(full_.task, finding.effects)})
        finding.warnings.insert(finding.warnings.end(), sentences.begin(), sentences.end());
    finding.warnings.insert(finding.warnings.end(), heldRemarks.begin(), heldRemarks.end());
    const bool leavesStructure = !finding.remainders.empty();
    finding.kind = !leavesStructure ? (finding.effects.empty() ? FindingKind::Adequate : FindingKind::Effect)
                                    : (finding.effects.empty() ? FindingKind::Unexplained : FindingKind::Partial);
    if (finding.kind == FindingKind::Effect && steps_.size() == 1 && !steps_.front().equation.empty())
        finding.warnings.push_back(
            phrase("an equation without a name explains as much as {} at {}, and the data do not tell them apart: {}",
                   finding.effects.front().kind, finding.effects.front().at, steps_.front().equation));
    for (Text& sentence : poorValidations(sound)) finding.warnings.push_back(std::move(sentence));
    if (leavesStructure)
        for (const auto& sentences : {wrongStarts(finding.final, Role::Fit), stuckReadings(full_.task)})
            finding.warnings.insert(finding.warnings.end(), sentences.begin(), sentences.end());
    return finding;
}

namespace {

struct HeldInputs {
    HeldReading reading;
    double errorOnLines{};  // [%]
};

/// The inputs of a task that are held by what a fit on straight lines, `null`, leaves.
std::optional<HeldInputs> heldInputs(NullModel& null, const FitOptions& options, const Progress& progress) {
    if (progress.stopRequested() || !fitNull(null, NoiseLevel::Estimate, options, progress)) return std::nullopt;
    const std::optional<HeldReading> reading = heldReading(null, options, progress);
    if (!reading) return std::nullopt;
    const Outcome<ModelState> state = stateOf(null.variant, null.fit, options.simulation, progress, Detail::Errors);
    if (!state) return std::nullopt;
    return HeldInputs{*reading, errorPercentOf(*state, Role::Fit)};
}

}  // namespace

Outcome<ModelState> fitModel(const EstimationTask& task, const FitOptions& options, const Progress& progress) {
    NullModel null;
    null.variant.task = task;
    const auto state = [&]() -> Outcome<ModelState> {
        try {
            const StopScope scope(progress.stopToken());
            if (Outcome<Done> fitted = fitNull(null, NoiseLevel::Estimate, fromAnywhere(options), progress); !fitted)
                return fitted.diagnostics();
            Outcome<ModelState> whole = stateOf(null.variant, null.fit, options.simulation, progress);
            stopPoint();
            return whole;
        } catch (const Stopped&) {
            if (null.fit.estimates.empty()) return error(phrase("cancelled"));
            const std::stop_source nobody;
            const StopScope scope(nobody.get_token());
            return stateSoFar(null, options.simulation);
        }
    };
    Outcome<ModelState> found = state();
    if (!found) return found;
    if (null.beginning) found->remarks.insert(found->remarks.begin(), null.beginning->remark);
    for (const Role role : {Role::Fit, Role::Validate})
        for (Text& sentence : wrongStarts(*found, role)) found->remarks.push_back(std::move(sentence));
    if (progress.stopRequested()) return found;
    if (const auto reading = heldReading(null, options, progress))
        for (Text& remark : heldRemarks(task, *reading, errorPercentOf(*found, Role::Fit), false))
            found->remarks.push_back(std::move(remark));
    return found;
}

Outcome<ModelState> simulateModel(const EstimationTask& task, const SimulationOptions& options,
                                  const Progress& progress) {
    const Variant variant{task, {}, {}};
    SimulationOptions watched = options;
    double shown = 0;  // what is simulated once more does not set the bar back
    watched.reached = [&](double part) {
        shown = std::max(shown, part);
        progress.report({"simulate", {}, shown});
    };
    watched.reached(0);
    Outcome<ModelState> state = stateOf(variant, {}, watched, progress);
    // the values at which a model stands say little: which reading is right is seen where they are fitted
    FitOptions fit;
    fit.simulation = options;
    if (!state || !anyLooksHeld(task)) return state;
    NullModel null;
    null.variant.task = task;
    if (const auto found = heldInputs(null, fit, progress))
        for (Text& remark : heldRemarks(task, found->reading, found->errorOnLines, false))
            state->remarks.push_back(std::move(remark));
    return state;
}

Outcome<Finding> discover(const EstimationTask& task, const DiscoverOptions& options, const Progress& progress) {
    NullModel onLines;
    onLines.variant.task = task;
    std::optional<HeldInputs> held;
    try {
        const StopScope scope(progress.stopToken());
        held = heldInputs(onLines, options.fit, progress);
        stopPoint();
    } catch (const Stopped&) {
        const std::stop_source nobody;
        const StopScope scope(nobody.get_token());
        return fittedSoFar(onLines, options.fit.simulation);
    }
    if (!held) return Search(task, options, progress).run();
    EstimationTask read = task;
    holdInputs(read, held->reading.inputs);
    Outcome<Finding> finding = Search(read, options, progress).run();
    if (!finding) return finding;
    finding->heldInputs = held->reading.inputs;
    std::vector<Text> remarks = heldRemarks(task, held->reading, held->errorOnLines, true);
    finding->warnings.insert(finding->warnings.begin(), remarks.begin(), remarks.end());
    return finding;
}

}  // namespace analogon
