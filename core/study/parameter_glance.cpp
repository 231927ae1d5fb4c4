#include "core/study/parameter_glance.hpp"

#include <algorithm>

#include "core/study/fit_traces.hpp"

namespace analogon {

Outcome<ParameterGlance> ParameterGlance::make(const Study& study, const std::string& parameter,
                                               const Progress& progress) {
    Study turned = study;
    turned.parameters[parameter].fit = true;
    const Outcome<EstimationTask> task = estimationTask(turned, UnusedColumns::Leave);
    if (!task) return task.diagnostics();
    Outcome<PreparedTask> prepared = prepare(*task);
    if (!prepared) return prepared.diagnostics();
    ParameterGlance glance;
    glance.problem_ = std::move(prepared->problem);
    glance.start_ = glance.problem_.startValues();
    const auto& parameters = glance.problem_.parameters;
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const FitParameter& p) { return p.name == parameter && p.experiment < 0; });
    if (found == parameters.end()) return error(phrase("the model has no parameter {} that may change", parameter));
    glance.turned_ = found - parameters.begin();
    for (std::size_t e = 0; e < glance.problem_.experiments.size(); ++e)
        glance.plans_.push_back(planFor(glance.problem_, static_cast<int>(e), glance.start_, {}, progress));
    return glance;
}

std::optional<SimulatedTraces> ParameterGlance::at(double value, const Progress& progress) const {
    Eigen::VectorXd point = start_;
    point[turned_] = value;
    SimulationOptions options;
    options.isGlance = true;
    Linearisation line = linearise(problem_, point, false, plans_, options, progress);
    if (!line.ok) line = linearise(problem_, point, false, {}, {}, progress);  // it may need finer steps there
    if (!line.ok) return std::nullopt;
    return tracesOf(problem_, line.trajectories);
}

}  // namespace analogon
