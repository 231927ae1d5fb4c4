#include "core/study/run.hpp"

#include <algorithm>
#include <chrono>

#include "core/base/stop.hpp"
#include "core/base/stopwatch.hpp"
#include "core/base/unless_stopped.hpp"
#include "core/fit/clock.hpp"
#include "core/flat/parameter_change.hpp"
#include "core/measure/channel_place.hpp"
#include "core/study/confidence.hpp"
#include "core/study/default_bounds.hpp"
#include "core/study/recorded.hpp"
#include "core/study/study_with.hpp"
#include "core/study/validate.hpp"

namespace analogon {
namespace {

namespace fs = std::filesystem;

constexpr const char* proposalFile = "proposed.mo";

/// What a study tells of a start value; of a variable ("rotor.w") it is that of its start value ("rotor.w.start").
/// Where it tells nothing, what is told from now on.
StudyStart& startIn(StudyExperiment& experiment, const std::string& parameter) {
    const auto told = std::find_if(experiment.initial.begin(), experiment.initial.end(), [&](const auto& start) {
        return start.first == parameter || startOf(start.first) == parameter;
    });
    return told == experiment.initial.end() ? experiment.initial[parameter] : told->second;
}

/// Where recordings were found to begin elsewhere than the study had told: at these values, and those that only
/// validate wherever they do beside a model.
void completeStarts(Study& study, const ModelState& state) {
    std::vector<StudyExperiment*> fitted;
    for (StudyExperiment& x : study.experiments)
        if (x.isUsed && x.role == Role::Fit) fitted.push_back(&x);
    for (const FitEstimate& e : state.parameters) {
        if (e.experiment < 0 || e.experiment >= static_cast<int>(fitted.size())) continue;
        StudyStart& start = startIn(*fitted[static_cast<std::size_t>(e.experiment)], e.name);
        if (!std::holds_alternative<FittedStart>(start)) start = e.value;
    }
    for (StudyExperiment& x : study.experiments)
        for (const ExperimentState& checked : state.experiments)
            if (x.role == Role::Validate && checked.role == Role::Validate && checked.name == x.name)
                for (const FitEstimate& e : checked.starts) startIn(x, e.name) = FittedStart{};
}

/// The study with a model that was fitted, its values in the text and its parameters among the fitted ones.
Study withModel(const Study& study, const ModelState& state) {
    Study completed = study;
    completed.models[completed.modelFile] = state.modelText;
    for (const FitEstimate& e : state.parameters)
        if (e.experiment < 0) {
            StudyParameter& p = completed.parameters[e.name];
            p.value.reset();  // the model's text holds it now
            if (isClock(e.name)) p.value = e.value;
        }
    completeStarts(completed, state);
    return completed;
}

void mapInput(Study& study, const std::string& input, const std::string& channel) {
    for (StudyExperiment& x : study.experiments) {
        const std::shared_ptr<const Table> file = fileTable(study.tables, x);
        const ChannelName name = file ? channelOf(*file, channel) : ChannelName{channel};
        x.inputs[input].column = name.column;
        x.inputs[input].group = name.group;
    }
}

/// What was told with inputs held is so in a study that says it.
Study withHeld(Study study, const std::vector<std::string>& inputs) {
    for (StudyExperiment& x : study.experiments)
        for (const std::string& input : inputs)
            if (const auto mapping = x.inputs.find(input); mapping != x.inputs.end())
                mapping->second.interpolation = Interpolation::Hold;
    return study;
}

/// The study with effects wired in.
Study completedStudy(const Study& study, const Finding& finding) {
    Study completed = withHeld(withModel(study, finding.final), finding.heldInputs);
    for (const AddedEffect& e : finding.effects)
        if (!e.wired.newInput.empty()) mapInput(completed, e.wired.newInput, e.wired.channel);
    return completed;
}

/// The study with the equations that are proposed, too, their blocks beside those that it has.
std::optional<Study> proposedStudy(const Study& study, const Finding& finding) {
    if (!finding.unexplained.proposed) return std::nullopt;
    Study proposed = withHeld(withModel(study, finding.unexplained.proposed->state), finding.heldInputs);
    for (const auto& [input, channel] : finding.unexplained.proposed->newInputs) mapInput(proposed, input, channel);
    if (const std::string blocks = proposedBlocks(finding); !blocks.empty()) {
        std::string& text = proposed.models[proposalFile];
        text += (text.empty() ? "" : "\n") + blocks;
    }
    return proposed;
}

RunResult fitted(const Study& study, ModelState state) {
    RunResult result;
    result.finding.baseline = state;
    result.finding.final = std::move(state);
    result.completed = completedStudy(study, result.finding);
    return result;
}

Diagnostic stopped(const ExperimentState& e) {
    Text message = phrase("the simulation of experiment \"{}\" stopped at t = {:.6g} s: {}{}", e.name, e.failure.time,
                          Text(e.failure.reason, {}, e.failure.reason),
                          e.failure.variable.empty() ? "" : " (" + e.failure.variable + ")");
    if (!e.failure.cause.empty()) message = phrase("{}: {}", message, e.failure.cause);
    return numericalError(std::move(message), phrase("look at the values of the parameters near that variable"));
}

bool hasFailed(const ExperimentState& e) { return e.failure.failed && e.failure.reason != "cancelled"; }

/// Simulations that stopped. After a fit, a recording that only validates is told in a remark and costs nothing else.
Diagnostics failures(ModelState& state, bool isFitted) {
    Diagnostics faults;
    for (const ExperimentState& e : state.experiments) {
        if (!hasFailed(e)) continue;
        if (e.role == Role::Fit || !isFitted)
            faults.push_back(stopped(e));
        else
            state.remarks.push_back(stopped(e).message);
    }
    return faults;
}

/// What was found, and whether it is all.
void markInterrupted(Finding& finding, bool isInterrupted) {
    finding.end.interrupted = isInterrupted;
    if (leavesTracesOut(finding))
        finding.warnings.push_back(phrase("the traces are long and were not written, since the run was interrupted"));
}

/// Bounds that nobody has given are a part of what a result rests on: they are told in its report, and there alone.
Diagnostics withBoundsInReport(Diagnostics remarks, ModelState& state) {
    const auto isOfBounds = [](const Diagnostic& remark) { return isDefaultBoundsRemark(remark.message); };
    for (const Diagnostic& remark : remarks)
        if (isOfBounds(remark)) state.remarks.push_back(remark.message);
    std::erase_if(remarks, isOfBounds);
    return remarks;
}

/// Whether a simulation was stopped before its end.
bool isCutShort(const ModelState& state) {
    return std::any_of(state.experiments.begin(), state.experiments.end(),
                       [](const ExperimentState& e) { return e.failure.failed && e.failure.reason == "cancelled"; });
}

}  // namespace

bool leavesTracesOut(const Finding& finding, Traces traces) {
    constexpr std::size_t most = 100'000;  // samples of outputs
    std::size_t count = 0;
    for (const ExperimentState& e : finding.baseline.experiments) count += e.time.size() * e.outputs.size();
    const bool isStopped =
        finding.end.interrupted && !finding.end.isAtLimitOfWork;  // from outside: whoever did wants an end
    return (isStopped || traces == Traces::Short) && count > most;
}

std::string proposedBlocks(const Finding& finding) {
    std::string text;
    for (const Remainder& r : finding.unexplained.remainders)
        if (!r.proposal.block.empty()) text += (text.empty() ? "" : "\n") + r.proposal.block;
    return text;
}

namespace {

/// The task of a study that is valid for a purpose, with what is remarked on it.
Outcome<EstimationTask> validTask(const Study& study, const RunOptions& options, Purpose purpose) {
    Outcome<ValidStudy> valid = validated(withLibraries(study, options.libraryPaths), purpose);
    if (!valid) return valid.diagnostics();
    return {std::move(valid->task), valid.diagnostics()};
}

}  // namespace

Outcome<EstimationTask> taskOf(const Study& study, const RunOptions& options) {
    return estimationTask(withLibraries(study, options.libraryPaths));
}

Outcome<RunResult> runSimulate(const Study& study, const RunOptions& options, const Progress& progress) {
    const std::stop_source nobody;  // the traces end where they are stopped, and what is around them is made
    const StopScope scope(nobody.get_token());
    Outcome<EstimationTask> task = validTask(study, options, Purpose::Simulate);
    if (!task) return task.diagnostics();
    Outcome<ModelState> state = simulateModel(*task, options.discover.fit.simulation, progress);
    if (!state) return state.diagnostics();
    if (Diagnostics faults = failures(*state, false); !faults.empty()) return faults;
    RunResult result = fitted(study, std::move(*state));
    markInterrupted(result.finding, isCutShort(result.finding.final));
    return {std::move(result), task.diagnostics()};
}

Outcome<RunResult> runFit(const Study& study, const RunOptions& options, const Progress& progress) {
    const auto begin = std::chrono::steady_clock::now();
    Outcome<EstimationTask> task = unlessStopped(progress, [&] { return validTask(study, options, Purpose::Fit); });
    if (!task) return task.diagnostics();
    if (Diagnostics faults = checkProfiled(*task, options.profiled); !faults.empty()) return faults;
    FitOptions alone = options.discover.fit;
    alone.goesOnAtKinks = alone.goesOnInValleys = true;
    alone.integrationShare = 1e-3;  // a misfit of an integration that errs by this is its least one within 1e-6
    Outcome<ModelState> state = fitModel(*task, alone, progress);
    if (!state) return state.diagnostics();
    if (Diagnostics faults = failures(*state, true); !faults.empty()) return faults;
    Diagnostics remarks = withBoundsInReport(task.diagnostics(), *state);
    const auto told = [&](bool isInterrupted) {
        RunResult result = fitted(study, *state);
        markInterrupted(result.finding, isInterrupted);
        result.finding.end.seconds = secondsSince(begin);
        return result;
    };
    if (!progress.stopRequested()) {
        if (options.keep) options.keep(told(true));
        addConfidence(*task, options.profiled, options.discover.fit, *state, progress);
    }
    return {told(progress.stopRequested()), std::move(remarks)};
}

Outcome<RunResult> runDiscover(const Study& study, const RunOptions& options, const Progress& progress) {
    Outcome<EstimationTask> task =
        unlessStopped(progress, [&] { return validTask(study, options, Purpose::Discover); });
    if (!task) return task.diagnostics();
    const auto told = [&study](Finding finding) {
        RunResult result;
        result.finding = std::move(finding);
        markInterrupted(result.finding, result.finding.end.interrupted);
        result.completed = completedStudy(study, result.finding);
        result.proposed = proposedStudy(study, result.finding);
        return result;
    };
    DiscoverOptions search = options.discover;
    if (options.keep) search.keep = [&](Finding finding) { options.keep(told(std::move(finding))); };
    Outcome<Finding> finding = discover(*task, search, progress);
    if (!finding) return finding.diagnostics();
    if (Diagnostics faults = failures(finding->final, true); !faults.empty()) return faults;
    Diagnostics remarks = withBoundsInReport(task.diagnostics(), finding->final);
    return {told(std::move(*finding)), std::move(remarks)};
}

}  // namespace analogon
