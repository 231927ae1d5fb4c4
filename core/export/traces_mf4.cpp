#include "core/export/traces_mf4.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/flat/flat_model.hpp"

namespace analogon {

namespace {

std::vector<double> valuesOf(const Eigen::VectorXd& values) { return {values.data(), values.data() + values.size()}; }

class TraceGroups {
public:
    TraceGroups(const EstimationTask& task, const FlatModel& model) : task_(task), model_(model) {}

    void add(const ExperimentState& experiment, std::vector<Mf4Group>& groups) const {
        Mf4Group measured = group(experiment, "measured"), simulated = group(experiment, "simulated"),
                 residual = group(experiment, "residual");
        addInputs(experiment, measured);
        for (const OutputState& output : experiment.outputs) {
            const std::string said = descriptionOf(output.name);
            measured.channels.push_back({output.name, output.unit, said, valuesOf(output.measured)});
            simulated.channels.push_back({output.name, output.unit, said, valuesOf(output.simulated)});
            residual.channels.push_back({output.name, differenceUnit(output.unit), "measured minus simulated",
                                         valuesOf(output.measured - output.simulated)});
        }
        for (Mf4Group* const each : {&measured, &simulated, &residual}) groups.push_back(std::move(*each));
    }

private:
    static Mf4Group group(const ExperimentState& experiment, const char* kind) {
        return {fmt::format("{} {}", experiment.name, kind),
                fmt::format("experiment \"{}\", role {}: {}", experiment.name,
                            experiment.role == Role::Fit ? "fit" : "validate", kind),
                {{"time", "s", "", experiment.time}}};
    }

    /// A difference of temperatures has no zero.
    static std::string differenceUnit(const std::string& unit) {
        return unit == "degC" || unit == "°C" ? std::string("K") : unit;
    }

    std::string descriptionOf(const std::string& variable) const {
        const VariableId id = model_.find(variable);
        return id.valid() ? model_[id].description : std::string();
    }

    void addInputs(const ExperimentState& experiment, Mf4Group& group) const {
        for (const Recording& recording : task_.recordings) {
            if (recording.name != experiment.name || recording.time.size() != experiment.time.size()) continue;
            for (std::size_t i = 0; i < recording.inputNames.size(); ++i) {
                const std::string& name = recording.inputNames[i];
                const VariableId id = model_.find(name);
                const std::string said = descriptionOf(name), held = recording.isHeld(name) ? ", held" : "";
                group.channels.push_back({name, id.valid() ? model_.unitOf(model_[id]) : std::string(),
                                          "input of the model" + held + (said.empty() ? "" : ": " + said),
                                          valuesOf(recording.inputs.row(static_cast<Eigen::Index>(i)).transpose())});
            }
        }
    }

    const EstimationTask& task_;
    const FlatModel& model_;
};

}  // namespace

Outcome<std::vector<Mf4Group>> tracesOf(const ModelState& state, const EstimationTask& task) {
    const Outcome<FlatModel> model = flatten(task.library, task.className);
    if (!model) return model.diagnostics();
    std::vector<Mf4Group> groups;
    for (const ExperimentState& experiment : state.experiments) TraceGroups(task, *model).add(experiment, groups);
    return groups;
}

}  // namespace analogon
