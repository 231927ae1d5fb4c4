#include "core/fit/estimation_task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/limits.hpp"
#include "core/base/range.hpp"
#include "core/fit/clock.hpp"
#include "core/fit/compiled_task.hpp"
#include "core/flat/parameter_change.hpp"

namespace analogon {

namespace {

/// Says what a wrong name may have meant.
Text didYouMean(const std::string& name, const std::vector<std::string>& known, const Text& none) {
    const std::string like = suggestion(name, known);
    if (!like.empty()) return phrase("did you mean {}?", like);
    return known.empty() ? none : Text();
}

std::vector<std::string> namesOf(const std::vector<SignalInfo>& signals) {
    std::vector<std::string> names;
    for (const SignalInfo& signal : signals) names.push_back(signal.name);
    return names;
}

/// Bounds, unit and start that the task leaves open come from the model.
FitParameter completed(FitParameter parameter, const System& system) {
    const int index = system.parameterIndex(parameter.name);
    if (index < 0) return parameter;
    const SignalInfo& info = system.parameters()[static_cast<std::size_t>(index)];
    if (parameter.min <= -1e300 && info.min) parameter.min = *info.min;
    if (parameter.max >= 1e300 && info.max) parameter.max = *info.max;
    if (parameter.unit.empty()) parameter.unit = info.unit;
    if (std::isnan(parameter.start)) parameter.start = info.value;
    return parameter;
}

/// Rows in the order of `signals`; NaN where a signal has no channel.
Eigen::MatrixXd inOrder(const std::vector<SignalInfo>& signals, const std::vector<std::string>& names,
                        const Eigen::MatrixXd& values, Eigen::Index samples) {
    Eigen::MatrixXd ordered(static_cast<Eigen::Index>(signals.size()), samples);
    for (std::size_t i = 0; i < signals.size(); ++i) {
        const auto found = std::find(names.begin(), names.end(), signals[i].name);
        const auto row = static_cast<Eigen::Index>(i);
        if (found == names.end())
            ordered.row(row).setConstant(std::numeric_limits<double>::quiet_NaN());
        else
            ordered.row(row) = values.row(found - names.begin());
    }
    return ordered;
}

/// 1 / noise where the noise is known, else 1 / range of the channel. Where it stands still: over its range in all
/// recordings that are fitted, its magnitude, or its nominal value. What is smaller than anything measured is 0.
double weightOf(const Eigen::Ref<const Eigen::RowVectorXd>& measured, double noise, const Range& elsewhere,
                double nominal) {
    if (noise > limits::smallestSize && std::isfinite(noise)) return 1.0 / noise;
    const Range range = rangeOf(measured);
    if (range.isEmpty()) return 0.0;  // nothing measured
    for (const double scale : {range.width(), elsewhere.width(), std::abs(range.high), nominal})
        if (scale > limits::smallestSize) return 1.0 / scale;
    return 1.0;
}

/// Whether a stamp may lie outside the recording, with a clock that is ahead by this or that.
bool isBeyond(const Recording& recording, std::size_t sample, double least, double most) {
    const double stamp = recording.time[sample];
    return stamp - most < recording.time.front() || stamp - least > recording.time.back();
}

class Preparation {
public:
    Preparation(const EstimationTask& task, SystemPtr system) : task_(task) { prepared_.system = std::move(system); }

    void addParameters() {
        for (const FitParameter& parameter : task_.parameters) {
            prepared_.problem.parameters.push_back(completed(parameter, *prepared_.system));
        }
    }

    void addRecording(int index, const Eigen::VectorXd* noise) {
        const Recording& recording = task_.recordings[static_cast<std::size_t>(index)];
        const System& system = *prepared_.system;
        const std::size_t faultsBefore = faults_.size();
        checkChannels(recording, true, recording.inputNames, recording.inputs, system.inputs());
        checkChannels(recording, false, recording.outputNames, recording.outputs, system.outputs());
        if (faults_.size() > faultsBefore) return;

        FitExperiment experiment;
        experiment.name = recording.name;
        experiment.system = prepared_.system;
        for (const SignalInfo& input : system.inputs())
            if (std::find(recording.inputNames.begin(), recording.inputNames.end(), input.name) ==
                recording.inputNames.end())
                fault(recording, phrase("input {} has no channel", input.name), phrase("map a column to it"));
        setSignals(experiment, recording);
        for (const int i : experiment.inputs.heldInputs())
            if (system.isDifferentiated(i)) {
                const std::string& name = system.inputs()[static_cast<std::size_t>(i)].name;
                fault(
                    recording,
                    phrase("the model needs the slope of the input {}, which is held between its samples", name),
                    phrase(
                        "what jumps has no slope: give it \"interpolation\": \"linear\", or let the model filter it"));
            }
        experiment.weights = Eigen::VectorXd::Zero(system.outputCount());
        for (std::size_t i = 0; i < recording.outputNames.size(); ++i) {
            const int output = system.outputIndex(recording.outputNames[i]);
            const auto row = static_cast<Eigen::Index>(i);
            const double importance = row < recording.weights.size() ? recording.weights[row] : 1.0;
            const double deviation = noise && output < noise->size() ? (*noise)[output] : 0.0;
            experiment.weights[output] =
                importance * weightOf(experiment.measured.row(output), deviation, fittedRange(recording.outputNames[i]),
                                      system.outputs()[static_cast<std::size_t>(output)].nominal);
        }
        for (const SignalInfo& info : system.parameters()) experiment.parameters.push_back(info.value);
        addClocks(recording, experiment);
        addStarts(recording, experiment);
        prepared_.problem.experiments.push_back(std::move(experiment));
        prepared_.fitRecordings.push_back(index);
    }

    Outcome<PreparedTask> result(bool weightsAreNoise) {
        if (hasError(faults_)) return faults_;
        prepared_.problem.weightsAreNoise = weightsAreNoise;
        return std::move(prepared_);
    }

private:
    void fault(const Recording& recording, const Text& text, const Text& hint = {}) {
        faults_.push_back(error(phrase("experiment '{}': {}", recording.name, text), {}, hint));
    }

    Range fittedRange(const std::string& output) const {
        Range range;
        for (const Recording& r : task_.recordings) {
            const auto at = std::find(r.outputNames.begin(), r.outputNames.end(), output);
            const auto row = at - r.outputNames.begin();
            if (r.role == Role::Fit && row < r.outputs.rows()) range.take(rangeOf(r.outputs.row(row)));
        }
        return range;
    }

    void checkChannels(const Recording& recording, bool isInput, const std::vector<std::string>& names,
                       const Eigen::MatrixXd& values, const std::vector<SignalInfo>& signals) {
        const std::vector<std::string> known = namesOf(signals);
        for (const std::string& name : names) {
            if (std::find(known.begin(), known.end(), name) == known.end()) {
                fault(recording,
                      isInput ? phrase("the model has no input {}", name) : phrase("the model has no output {}", name),
                      didYouMean(name, known,
                                 isInput ? phrase("the model has no inputs") : phrase("the model has no outputs")));
            }
        }
        if (values.rows() != static_cast<Eigen::Index>(names.size()) ||
            (!names.empty() && values.cols() != static_cast<Eigen::Index>(recording.time.size()))) {
            const std::size_t samples = recording.time.size();
            fault(recording, isInput ? phrase("{} inputs over {} samples are named, but {} x {} values are given",
                                              names.size(), samples, values.rows(), values.cols())
                                     : phrase("{} outputs over {} samples are named, but {} x {} values are given",
                                              names.size(), samples, values.rows(), values.cols()));
        }
    }

    /// What a clock stamps before the recording begins or after it ends, wherever it may be within its bounds, has
    /// nothing simulated to compare with.
    void addClocks(const Recording& recording, FitExperiment& experiment) {
        for (const RecordingClock& clock : recording.clocks) {
            const int output = prepared_.system->outputIndex(clock.output);
            if (output < 0) continue;
            experiment.clocks.push_back({output, clock.offset});
            double least = clock.offset, most = clock.offset;
            for (const FitParameter& p : task_.parameters)
                if (p.name == clockOf(clock.output)) {
                    least = p.min;
                    most = p.max;
                }
            for (std::size_t k = 0; k < recording.time.size(); ++k)
                if (isBeyond(recording, k, least, most))
                    experiment.measured(output, static_cast<Eigen::Index>(k)) =
                        std::numeric_limits<double>::quiet_NaN();
        }
    }

    /// What is told to begin somewhere does so, whatever an initial equation of the model says.
    void tellStart(const std::string& parameter, FitExperiment& experiment) const {
        const int told = prepared_.system->parameterIndex(toldOf(parameter));
        if (told >= 0) experiment.parameters[static_cast<std::size_t>(told)] = 1;
    }

    void addStarts(const Recording& recording, FitExperiment& experiment) {
        for (const FitParameter& parameter : task_.parameters) tellStart(parameter.name, experiment);
        const System& system = *prepared_.system;
        const int number = static_cast<int>(prepared_.problem.experiments.size());
        for (const RecordingStart& start : recording.starts) {
            const bool isShared = std::any_of(task_.parameters.begin(), task_.parameters.end(),
                                              [&](const FitParameter& p) { return p.name == start.parameter; });
            const int index = system.parameterIndex(start.parameter);
            if (isShared) {
                fault(recording,
                      phrase("{} is fitted for all experiments and has a start of its own here", start.parameter),
                      phrase("remove one of the two"));
            } else if (!std::isfinite(start.value)) {
                fault(recording, phrase("the start value of {} is not a number", start.parameter));
            } else {
                experiment.parameters[static_cast<std::size_t>(index)] = start.value;
                tellStart(start.parameter, experiment);
                if (!start.isFitted) continue;
                FitParameter parameter;
                parameter.name = start.parameter;
                parameter.start = start.value;
                parameter.experiment = number;
                prepared_.problem.parameters.push_back(completed(std::move(parameter), system));
            }
        }
    }

    const EstimationTask& task_;
    PreparedTask prepared_;
    Diagnostics faults_;
};

}  // namespace

void blankBeyond(Recording& recording, const std::string& output, double least, double most) {
    const auto found = std::find(recording.outputNames.begin(), recording.outputNames.end(), output);
    if (found == recording.outputNames.end()) return;
    for (std::size_t k = 0; k < recording.time.size(); ++k)
        if (isBeyond(recording, k, least, most))
            recording.outputs(found - recording.outputNames.begin(), static_cast<Eigen::Index>(k)) =
                std::numeric_limits<double>::quiet_NaN();
}

void setSignals(FitExperiment& experiment, const Recording& recording) {
    const System& system = *experiment.system;
    const auto samples = static_cast<Eigen::Index>(recording.time.size());
    experiment.inputs.time = recording.time;
    experiment.inputs.values = inOrder(system.inputs(), recording.inputNames, recording.inputs, samples);
    experiment.inputs.held.clear();
    for (std::size_t i = 0; i < system.inputs().size() && !recording.held.empty(); ++i)
        experiment.inputs.held.push_back(recording.isHeld(system.inputs()[i].name) ? 1 : 0);
    experiment.measured = inOrder(system.outputs(), recording.outputNames, recording.outputs, samples);
}

Outcome<PreparedTask> prepare(const EstimationTask& task, const std::vector<Eigen::VectorXd>& noise, Role role,
                              const std::vector<std::string>& alsoKeep) {
    const Outcome<CompiledTask> model = compiled(task, alsoKeep);
    if (!model) return model.diagnostics();
    double samples = 0;
    for (const Recording& recording : task.recordings)
        if (recording.role == role) samples += static_cast<double>(recording.time.size());
    const System& system = *model->system;
    const auto enough = limits::checkTraces(samples, system.inputs().size(), system.outputs().size());
    if (!enough) return enough.diagnostics();
    Preparation preparation(task, model->system);
    preparation.addParameters();
    for (std::size_t r = 0; r < task.recordings.size(); ++r) {
        if (task.recordings[r].role != role) continue;
        preparation.addRecording(static_cast<int>(r), r < noise.size() ? &noise[r] : nullptr);
    }
    return preparation.result(!noise.empty());
}

}  // namespace analogon
