#include "core/effect/course/change.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/range.hpp"
#include "core/effect/block/trial.hpp"
#include "core/effect/catalogue/likeliest.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/thresholds.hpp"
#include "core/fit/clock.hpp"
#include "core/flat/parameter_change.hpp"

namespace analogon {

using namespace threshold::course;

namespace {

constexpr int momentsTried = 40;  // moments that are tried over a recording, then again around the best

/// Rows of one experiment at or after a moment.
Eigen::VectorXd from(const NullModel& null, const std::vector<double>& time, int experiment, double moment,
                     const Eigen::VectorXd& column) {
    Eigen::VectorXd later = Eigen::VectorXd::Zero(column.size());
    for (const ResidualChannel& c : null.channels) {
        if (c.experiment != experiment) continue;
        for (int row = c.begin; row < c.end; ++row)
            if (time[static_cast<std::size_t>(c.samples[static_cast<std::size_t>(row - c.begin)])] >= moment)
                later[row] = column[row];
    }
    return later;
}

/// For each parameter the change that explains most of the residual to first order, best first (Chow 1960: the
/// regression before and after a break). The trace of a change is taken as the parameter's slope from then on, which
/// leaves out how the states move over to it.
std::vector<Change> likelyChanges(const NullModel& null) {
    const Eigen::MatrixXd& jacobian = null.fit.optimum.jacobian;
    const Eigen::VectorXd& residual = null.fit.optimum.residuals;
    const OrthogonalProjector& complement = null.scores().plain;
    std::vector<Change> likely;
    int experiment = 0;
    for (const Recording& recording : null.variant.task.recordings) {
        if (recording.role != Role::Fit) continue;
        const std::vector<double>& time = recording.time;
        const double begin = time.front(), span = time.back() - time.front();
        for (Eigen::Index j = 0; j < jacobian.cols(); ++j) {
            const FitEstimate& estimate = null.fit.estimates[static_cast<std::size_t>(j)];
            if (estimate.experiment >= 0 || isClock(estimate.name))
                continue;  // a start value, or no quantity of the model
            Change best;
            const auto take = [&](double moment) {
                const Eigen::VectorXd column = from(null, time, experiment, moment, jacobian.col(j));
                const ColumnScore score = scoreColumns(complement, residual, column, false);
                if (score.visible > leastVisible && score.explained > best.explained)
                    best = {estimate.name,   experiment, moment, estimate.value, estimate.value + score.strengths[0],
                            score.explained, {},         {}};
            };
            for (int k = 0; k <= momentsTried; ++k)
                take(begin + span * (margin + (1 - 2 * margin) * k / static_cast<double>(momentsTried)));
            if (best.parameter.empty()) continue;
            const double around = best.time, step = span / momentsTried;
            for (int k = -10; k <= 10; ++k) take(around + step * k / 10.0);
            likely.push_back(std::move(best));
        }
        ++experiment;
    }
    std::stable_sort(likely.begin(), likely.end(),
                     [](const Change& a, const Change& b) { return a.explained > b.explained; });
    return likely;
}

/// How sharply a change is drawn, in one fit after the other [s].
using Widths = std::vector<double>;

double samplingOf(const std::vector<double>& time) {
    return (time.back() - time.front()) / static_cast<double>(time.size() - 1);
}

/// From a good part of the recording to one sample. The slope of a moment is felt only as far as the change is drawn
/// wide: where the outputs follow a parameter at once (a resistance), a moment that is many samples off would move by
/// one sample a step.
Widths everSharper(const std::vector<double>& time) {
    const double sample = samplingOf(time);
    Widths widths;
    for (double width = (time.back() - time.front()) / momentsTried; width > 2 * sample; width /= 4)
        widths.push_back(width);
    widths.push_back(sample);
    return widths;
}

/// The change fitted together with all parameters of the model.
std::optional<Change> fitted(const NullModel& null, const std::vector<FitParameter>& parameters, const Change& likely,
                             const Widths& widths, const FitOptions& options, const Progress& progress) {
    const std::vector<double>& time = fittedRecording(null.variant.task, likely.experiment).time;
    const double span = time.back() - time.front();
    Variant variant = null.variant;
    FitParameter step, moment;
    step.name = stepOf(likely.parameter);
    const Range steps = stepsOf(parameters, likely.parameter, likely.before);
    step.min = std::min(steps.low, 0.0);
    step.max = std::max(steps.high, 0.0);
    step.scale = ParameterScale::Linear;
    step.start = std::clamp(likely.after - likely.before, 0.9 * step.min, 0.9 * step.max);
    moment.name = momentOf(likely.parameter);
    moment.start = likely.time;
    moment.min = time.front() + margin * span;
    moment.max = time.back() - margin * span;
    moment.scale = ParameterScale::Linear;
    step.experiment = moment.experiment = likely.experiment;
    variant.task.parameters.push_back(step);
    variant.task.parameters.push_back(moment);
    std::optional<FitResult> result;
    for (const double width : widths) {
        variant.task.change = ParameterChange{likely.parameter, width};
        if (result) variant.values = valuesOf(*result);
        result = fitBeside(null, variant, options, progress);
        if (!result) return std::nullopt;
    }
    Change change = likely;
    for (const FitEstimate& e : result->estimates) {
        if (e.name == likely.parameter) change.before = e.value;
        if (e.name == step.name) change.after = e.value;
        if (e.name == moment.name) change.time = e.value;
    }
    change.after += change.before;
    change.explained = null.sumOfSquares() - result->optimum.residuals.squaredNorm();
    variant.values = valuesOf(*result);
    change.variant = std::move(variant);
    change.fit = std::move(*result);
    return change;
}

/// The value of after throughout, in every recording.
Variant heldAfter(const Change& change) {
    Variant held = change.variant;
    for (ParameterValue& v : held.values)
        if (v.name == change.parameter) v.value = change.after;
    return held;
}

/// The change at its moment in every recording.
Variant changedInAll(const Change& change) {
    Variant all = change.variant;
    const auto isOfChange = [&](const std::string& name) {
        return name == stepOf(change.parameter) || name == momentOf(change.parameter);
    };
    for (FitParameter& p : all.task.parameters)
        if (isOfChange(p.name)) p.experiment = -1;
    for (ParameterValue& v : all.values)
        if (isOfChange(v.name)) v.experiment = -1;
    return all;
}

}  // namespace

double explainedByChange(const NullModel& null) {
    const std::vector<Change> likely = likelyChanges(null);
    return likely.empty() ? 0 : likely.front().explained;
}

Range stepsOf(const std::vector<FitParameter>& parameters, const std::string& parameter, double value) {
    Range after{-1e300, 1e300};
    for (const FitParameter& p : parameters)
        if (p.name == parameter) after = {p.min, p.max};
    if (after.low >= 0) after.low = std::max(after.low, mostShrunk * value);
    if (after.high <= 0) after.high = std::min(after.high, mostShrunk * value);
    return {after.low - value, after.high - value};
}

std::optional<Change> bestChange(const NullModel& null, FitOptions options, int threads, const Progress& progress) {
    options.simulation = limited(null, options.simulation);
    const Outcome<PreparedTask> prepared = prepareAt(null.variant, null.noise);
    if (!prepared) return std::nullopt;
    const FitOptions roughly = trialOptions(options, options.maxIterations);  // most are only compared
    const auto fit = [&](const Change& likely) {
        const double sample = samplingOf(fittedRecording(null.variant.task, likely.experiment).time);
        return fitted(null, prepared->problem.parameters, likely, {sample}, roughly, progress);
    };
    std::optional<Change> best;
    std::vector<Change> likely = likelyChanges(null);
    keepLikeliest(likely);
    takeBest(likely, best, threads, progress, fit);
    if (!best) return best;
    // a moment is found by steps too short to cross what happens between two manoeuvres
    const std::vector<double>& time = fittedRecording(null.variant.task, best->experiment).time;
    std::vector<Change> near;
    for (const double away : {-4.0, -2.0, -1.0, 1.0, 2.0, 4.0}) {
        const double moment = best->time + away * (time.back() - time.front()) / momentsTried;
        if (moment <= time.front() || moment >= time.back()) continue;
        near.push_back(*best);
        near.back().time = moment;
    }
    takeBest(near, best, threads, progress, fit);
    const std::optional<Change> exact =
        fitted(null, prepared->problem.parameters, *best, everSharper(time), options, progress);
    return exact && exact->explained > best->explained ? exact : best;
}

Outcome<ErrorsOfChange> errorsOf(const Change& change, const std::vector<Recording>& recordings,
                                 const SimulationOptions& simulation, const Progress& progress) {
    ErrorsOfChange errors;
    std::vector<ModelState> states;
    for (Variant variant : {change.variant, heldAfter(change), changedInAll(change)}) {
        variant.task.recordings = recordings;
        variant.plans.clear();
        Outcome<ModelState> state = stateOf(variant, change.fit, simulation, progress, Detail::Errors);
        if (!state) return state.diagnostics();
        states.push_back(std::move(*state));
    }
    const ModelState &before = states[0], &after = states[1], &alike = states[2];
    errors.fitted = errorPercentOf(before, Role::Fit);  // its own step is there: only a check is without it
    const auto isWhole = [&](std::size_t e) {           // a simulation that is stopped or fails tells nothing
        return std::all_of(states.begin(), states.end(), [&](const ModelState& s) {
            return e < s.experiments.size() && !s.experiments[e].failure.failed;
        });
    };
    for (std::size_t e = 0; e < before.experiments.size(); ++e)
        if (before.experiments[e].role == Role::Validate && isWhole(e))
            errors.checks.push_back({before.experiments[e].name, before.experiments[e].errorPercent,
                                     after.experiments[e].errorPercent, alike.experiments[e].errorPercent});
    return errors;
}

}  // namespace analogon
