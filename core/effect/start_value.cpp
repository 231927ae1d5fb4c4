#include "core/effect/start_value.hpp"

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

Outcome<std::vector<ToldStart>> toldStarts(const EstimationTask& task) {
    const Outcome<FlatModel> flat = flatten(task.library, task.className);
    if (!flat) return flat.diagnostics();
    std::vector<ToldStart> starts;
    const std::vector<int> fitted = recordingsOf(task, Role::Fit);
    for (const std::string& name : startParameters(*flat)) {
        const bool isShared = std::any_of(task.parameters.begin(), task.parameters.end(),
                                          [&](const FitParameter& p) { return p.name == name; });
        if (isShared) continue;
        for (std::size_t e = 0; e < fitted.size(); ++e) {
            const Recording& recording = task.recordings[static_cast<std::size_t>(fitted[e])];
            const auto told = std::find_if(recording.starts.begin(), recording.starts.end(),
                                           [&](const RecordingStart& s) { return s.parameter == name; });
            if (told == recording.starts.end()) {
                if (const std::optional<double> value = flat->parameterValue(flat->find(name)))
                    starts.push_back({fitted[e], static_cast<int>(e), name, *value});
            } else if (!told->isFitted) {
                starts.push_back({fitted[e], static_cast<int>(e), name, told->value});
            }
        }
    }
    for (std::size_t e = 0; e < fitted.size(); ++e)
        for (const RecordingStart& told : task.recordings[static_cast<std::size_t>(fitted[e])].starts)
            if (!told.isFitted && startedBy(*flat, told.parameter).valid())
                starts.push_back({fitted[e], static_cast<int>(e), told.parameter, told.value});
    return starts;
}

namespace {

/// Which of the fitted recordings begin elsewhere than the model does.
std::set<int> begunElsewhere(const NullModel& null, Against against) {
    constexpr Eigen::Index samplesOfStart = 3;
    constexpr double clear = 3, leastShare = 0.05;  // deviations of noise or residual; of the range
    std::set<int> elsewhere;
    for (const ResidualChannel& c : null.channels) {
        if (c.samples.size() < 50 || c.samples.front() != 0) continue;
        const Eigen::VectorXd left = null.fit.optimum.residuals.segment(c.begin, c.end - c.begin);
        const double deviation =
            against == Against::Noise ? 1 : std::sqrt(left.squaredNorm() / static_cast<double>(left.size()));
        const double least = std::max(clear * deviation, leastShare * rangeOf(c.measured).width());
        const auto first = left.head(samplesOfStart);
        if (first.minCoeff() > least || first.maxCoeff() < -least) elsewhere.insert(c.experiment);
    }
    return elsewhere;
}

}  // namespace

std::vector<ToldStart> startsBegunElsewhere(const NullModel& null, Against against) {
    const std::set<int> elsewhere = begunElsewhere(null, against);
    if (elsewhere.empty()) return {};
    const EstimationTask& task = null.variant.task;
    const Outcome<FlatModel> flat = flatten(task.library, task.className);
    const Outcome<PreparedTask> prepared = prepare(task);
    const Outcome<std::vector<ToldStart>> told = toldStarts(task);
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

void setFitted(EstimationTask& task, const ToldStart& start, bool isFitted) {
    std::vector<RecordingStart>& starts = task.recordings[static_cast<std::size_t>(start.recording)].starts;
    for (RecordingStart& s : starts)
        if (s.parameter == start.parameter) {
            s.isFitted = isFitted;
            return;
        }
    starts.push_back({start.parameter, start.value, isFitted});
}

}  // namespace analogon
