#include "core/effect/start_value.hpp"

#include <algorithm>

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
    return starts;
}

void setFitted(EstimationTask& task, const ToldStart& start, bool isFitted) {
    std::vector<RecordingStart>& starts = task.recordings[static_cast<std::size_t>(start.recording)].starts;
    for (RecordingStart& s : starts)
        if (s.parameter == start.parameter) {
            s.value = start.value;
            s.isFitted = isFitted;
            return;
        }
    starts.push_back({start.parameter, start.value, isFitted});
}

}  // namespace analogon
