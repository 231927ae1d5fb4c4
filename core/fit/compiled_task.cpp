#include "core/fit/compiled_task.hpp"

#include <algorithm>

#include "core/eval/event_parts.hpp"
#include "core/fit/clock.hpp"
#include "core/flat/free_ordinates.hpp"
#include "core/flat/messages.hpp"
#include "core/flat/parameter_change.hpp"

namespace analogon {

namespace {

/// Parameters that must stay symbolic: fitted, start values of any recording, and what the caller asks for.
std::vector<std::string> namesToKeep(const EstimationTask& task, const std::vector<std::string>& alsoKeep) {
    std::vector<std::string> keep;
    const auto add = [&](const std::string& name) {
        if (std::find(keep.begin(), keep.end(), name) == keep.end()) keep.push_back(name);
    };
    for (const FitParameter& parameter : task.parameters)
        if (!isClock(parameter.name)) add(parameter.name);
    for (const Recording& recording : task.recordings) {
        for (const RecordingStart& start : recording.starts) add(start.parameter);
    }
    for (const std::string& name : alsoKeep) add(name);
    return keep;
}

/// Each name must be a parameter that may be changed.
Diagnostics checkNames(const FlatModel& model, const std::vector<std::string>& names) {
    Diagnostics faults;
    std::vector<std::string> known;
    for (const FlatVariable& variable : model.variables) {
        if (variable.variability == FlatVariability::Parameter && variable.type == FlatType::Real &&
            !variable.isFinal) {
            known.push_back(variable.name);
        }
    }
    for (const std::string& name : names) {
        const VariableId id = model.find(name);
        if (!id.valid()) {
            faults.push_back(error(phrase("{} has no parameter {}", model.name, name), {}, didYouMean(name, known)));
            continue;
        }
        const FlatVariable& variable = model[id];
        if (variable.variability != FlatVariability::Parameter) {
            faults.push_back(error(phrase("{} is no parameter and cannot be fitted or set", name), variable.declared,
                                   didYouMean(name, known)));
        } else if (variable.type != FlatType::Real) {
            faults.push_back(
                error(phrase("{} is not a Real parameter and cannot be fitted or set", name), variable.declared));
        } else if (variable.isFoundAtStart) {
            faults.push_back(error(phrase("{} follows from an initial equation and cannot be fitted or set", name),
                                   variable.value.valid() ? variable.value : variable.declared));
        } else if (variable.isFinal) {
            faults.push_back(error(phrase("{} is final and cannot be fitted or set", name),
                                   variable.value.valid() ? variable.value : variable.declared));
        } else if (variable.isStructural) {
            faults.push_back(error(phrase("{} has shaped the equations (an array size or a condition) and cannot be "
                                          "fitted or set for one experiment",
                                          name),
                                   variable.value.valid() ? variable.value : variable.declared));
        }
    }
    return faults;
}

}  // namespace

Outcome<CompiledTask> compiled(const EstimationTask& task, const std::vector<std::string>& alsoKeep) {
    const std::vector<std::string> keep = namesToKeep(task, alsoKeep);
    std::vector<std::string> free = keep;
    if (task.change) free.push_back(task.change->parameter);
    Outcome<FlatModel> flat = flatten(task.library, task.className, free);
    if (!flat) return flat.diagnostics();
    if (task.change && task.change->input.empty())
        flat = withChange(std::move(*flat), task.change->parameter, task.change->width);
    else if (task.change)
        flat = withDependence(std::move(*flat), task.change->parameter, task.change->input);
    if (flat) flat = withStarts(std::move(*flat), keep);
    if (flat && task.imposed) flat = withImposed(std::move(*flat), task.imposed->variable, task.imposed->input);
    if (!flat) return flat.diagnostics();
    const auto model = std::make_shared<const FlatModel>(std::move(*flat));
    if (Diagnostics faults = checkNames(*model, keep); hasError(faults)) return faults;
    std::vector<std::string> symbolic = keep;
    for (const std::string& name : keep)
        if (model->find(toldOf(name)).valid()) symbolic.push_back(toldOf(name));
    if (!model->events.refusals.empty()) {  // it has events of its own: when, pre, sample
        Structure seen;
        Outcome<SystemPtr> system = buildWithEvents(*model, symbolic, seen);
        if (!system) return system.diagnostics();
        Diagnostics remarks = seen.warnings;
        return {CompiledTask{seen.model, std::move(seen), std::move(*system)}, std::move(remarks)};
    }
    Outcome<Structure> structure = analyse(model, {symbolic});
    if (!structure) return structure.diagnostics();
    Outcome<SystemPtr> system = System::build(*structure);
    if (!system) return system.diagnostics();
    Diagnostics remarks = structure->warnings;
    return {CompiledTask{model, std::move(*structure), std::move(*system)}, std::move(remarks)};
}

}  // namespace analogon
