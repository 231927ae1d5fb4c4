#include "core/effect/reading/start_value.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/range.hpp"
#include "core/flat/parameter_change.hpp"

namespace analogon {

bool isTunable(const FlatVariable& variable) {
    return variable.variability == FlatVariability::Parameter && variable.type == FlatType::Real && !variable.isFinal &&
           !variable.isStructural;
}

std::vector<std::string> startParameters(const FlatModel& model) {
    std::vector<ExpressionId> atStart, throughout;
    for (const FlatVariable& v : model.variables) {
        if (v.start.valid()) atStart.push_back(v.start);
        if (v.binding.valid()) throughout.push_back(v.binding);
    }
    for (const FlatEquation& e : model.initialEquations) atStart.insert(atStart.end(), {e.left, e.right});
    for (const FlatEquation& e : model.equations) throughout.insert(throughout.end(), {e.left, e.right});
    std::vector<bool> isElsewhere(model.variables.size(), false);
    for (const ExpressionId leaf : model.pool->leaves(throughout))
        isElsewhere[(*model.pool)[leaf].variable.value] = true;
    std::vector<std::string> names;
    for (const ExpressionId leaf : model.pool->leaves(atStart)) {
        const VariableId id = (*model.pool)[leaf].variable;
        const FlatVariable& v = model[id];
        if (isTunable(v) && !isElsewhere[id.value]) names.push_back(v.name);
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

Outcome<std::vector<ToldStart>> toldStarts(const EstimationTask& task, Role role) {
    const Outcome<FlatModel> flat = flatten(task.library, task.className);
    if (!flat) return flat.diagnostics();
    std::vector<ToldStart> starts;
    const std::vector<int> recordings = recordingsOf(task, role);
    for (const std::string& name : startParameters(*flat)) {
        const bool isShared = std::any_of(task.parameters.begin(), task.parameters.end(),
                                          [&](const FitParameter& p) { return p.name == name; });
        if (isShared) continue;
        for (std::size_t e = 0; e < recordings.size(); ++e) {
            const Recording& recording = task.recordings[static_cast<std::size_t>(recordings[e])];
            const auto told = std::find_if(recording.starts.begin(), recording.starts.end(),
                                           [&](const RecordingStart& s) { return s.parameter == name; });
            if (told == recording.starts.end()) {
                if (const std::optional<double> value = flat->parameterValue(flat->find(name)))
                    starts.push_back({recordings[e], static_cast<int>(e), name, *value});
            } else if (!told->isFitted) {
                starts.push_back({recordings[e], static_cast<int>(e), name, told->value});
            }
        }
    }
    for (std::size_t e = 0; e < recordings.size(); ++e)
        for (const RecordingStart& told : task.recordings[static_cast<std::size_t>(recordings[e])].starts)
            if (!told.isFitted && startedBy(*flat, told.parameter).valid())
                starts.push_back({recordings[e], static_cast<int>(e), told.parameter, told.value});
    return starts;
}

bool beginsElsewhere(const Eigen::VectorXd& residual, double deviation, double range) {
    constexpr Eigen::Index fewestSamples = 50;
    constexpr int samplesOfStart = 3;
    constexpr double clear = 3, leastShare = 0.05;  // deviations; of the range
    if (residual.size() < fewestSamples || std::isnan(residual[0])) return false;
    const double least = std::max(clear * deviation, leastShare * range);
    // a start value is wrong from the first sample on, not at the first sample alone
    int above = 0, below = 0;
    for (Eigen::Index k = 0; k < residual.size() && above + below < samplesOfStart; ++k) {
        if (std::isnan(residual[k])) continue;
        if (!(std::abs(residual[k]) > least)) return false;
        ++(residual[k] > 0 ? above : below);
    }
    return above == samplesOfStart || below == samplesOfStart;
}

bool beginsElsewhere(const OutputState& output, const ModelState& state) {
    constexpr double rounding = 1e-9;
    const auto left = state.residual.find(output.name);
    const Range range = rangeOf(output.measured);
    const double size = std::max(std::abs(range.low), std::abs(range.high));
    return left != state.residual.end() &&
           beginsElsewhere(output.simulated - output.measured, left->second.standardDeviation,
                           std::max(range.width(), rounding * size));
}

namespace {

/// Which of the fitted recordings begin elsewhere than the model does.
std::set<int> begunElsewhere(const NullModel& null, Against against) {
    std::set<int> elsewhere;
    for (const ResidualChannel& c : null.channels) {
        if (c.samples.empty() || c.samples.front() != 0) continue;
        const Eigen::VectorXd left = null.fit.optimum.residuals.segment(c.begin, c.end - c.begin);
        const double deviation =
            against == Against::Noise ? 1 : std::sqrt(left.squaredNorm() / static_cast<double>(left.size()));
        if (beginsElsewhere(left, deviation, rangeOf(c.measured).width())) elsewhere.insert(c.experiment);
    }
    return elsewhere;
}

/// All that recordings with a role begin with (`elsewhere`: their numbers among them): told start values, and the
/// states there that nothing decides.
std::vector<ToldStart> allStarts(const EstimationTask& task, Role role, const std::set<int>& elsewhere) {
    if (elsewhere.empty()) return {};
    const Outcome<FlatModel> flat = flatten(task.library, task.className);
    const Outcome<PreparedTask> prepared = prepare(task, {}, role);
    const Outcome<std::vector<ToldStart>> told = toldStarts(task, role);
    if (!flat || !prepared || !told) return {};
    std::vector<ToldStart> starts;
    for (const ToldStart& start : *told)
        if (elsewhere.contains(start.experiment)) starts.push_back(start);
    const std::set<std::uint32_t> decided = decidedAtStart(*flat);
    for (const int e : elsewhere) {
        const int r = prepared->fitRecordings[static_cast<std::size_t>(e)];
        const std::vector<RecordingStart>& own = task.recordings[static_cast<std::size_t>(r)].starts;
        for (const SignalInfo& state : prepared->system->states()) {
            const std::string name = startOf(state.name);
            const VariableId id = startedBy(*flat, name);
            if (!id.valid() || decided.contains(id.value)) continue;
            const ExpressionId start = (*flat)[id].start;
            if (start.valid() && !flat->pool->leaves(std::vector{start}).empty()) continue;  // a parameter of its own
            if (std::none_of(own.begin(), own.end(), [&](const RecordingStart& s) { return s.parameter == name; }))
                starts.push_back({r, e, name, state.value});
        }
    }
    for (ToldStart& start : starts) start.isOfMidRun = true;
    return starts;
}

}  // namespace

std::vector<ToldStart> startsBegunElsewhere(const NullModel& null, Against against) {
    return allStarts(null.variant.task, Role::Fit, begunElsewhere(null, against));
}

std::vector<ToldStart> startsOfChecks(const EstimationTask& task, const ModelState& state, bool allDo) {
    std::set<int> elsewhere;
    int check = -1;
    for (const ExperimentState& e : state.experiments) {
        if (e.role != Role::Validate) continue;
        ++check;
        const bool isElsewhere = std::any_of(e.outputs.begin(), e.outputs.end(),
                                             [&](const OutputState& o) { return beginsElsewhere(o, state); });
        if (!e.failure.failed && (allDo || isElsewhere)) elsewhere.insert(check);
    }
    return allStarts(task, Role::Validate, elsewhere);
}

void setFitted(EstimationTask& task, const ToldStart& start, bool isFitted) {
    std::vector<RecordingStart>& starts = task.recordings.edit()[static_cast<std::size_t>(start.recording)].starts;
    for (RecordingStart& s : starts)
        if (s.parameter == start.parameter) {
            s.isFitted = isFitted;
            return;
        }
    starts.push_back({start.parameter, start.value, isFitted});
}

void setFitted(EstimationTask& task, const std::vector<ToldStart>& starts, bool areFitted) {
    for (const ToldStart& start : starts) setFitted(task, start, areFitted);
}

}  // namespace analogon
