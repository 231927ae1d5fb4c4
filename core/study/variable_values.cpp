#include "core/study/variable_values.hpp"

#include <algorithm>

namespace analogon {

namespace {

/// The experiment with the start values of what is fitted.
SimulationTask taskAtStart(const FitProblem& problem, std::size_t experiment) {
    SimulationTask task = taskOf(problem.experiments[experiment]);
    for (const FitParameter& p : problem.parameters) {
        if (p.experiment >= 0 && p.experiment != static_cast<int>(experiment)) continue;
        const int at = task.system->parameterIndex(p.name);
        if (at >= 0) task.parameters[static_cast<std::size_t>(at)] = p.start;
    }
    return task;
}

Outcome<Done> checkNames(const System& system, const std::vector<std::string>& names) {
    const std::vector<int> handles = system.observe(names);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (handles[i] < 0)
            return error(phrase("the model has no variable {}", names[i]), {},
                         phrase("take it out of the plot, or choose another one"));
    return Done{};
}

}  // namespace

Outcome<VariableValues> variableValues(const Study& study, const std::string& experiment,
                                       const std::vector<std::string>& names, const Progress& progress) {
    Study alone = study;  // a fault of another recording is no reason to show nothing
    std::erase_if(alone.experiments, [&](const StudyExperiment& e) { return e.name != experiment; });
    if (alone.experiments.empty()) return error(phrase("the study has no experiment {}", experiment));
    alone.experiments.front().isUsed = true;
    const Role role = alone.experiments.front().role;
    const Outcome<EstimationTask> task = estimationTask(alone, UnusedColumns::Leave);
    if (!task) return task.diagnostics();
    const Outcome<PreparedTask> prepared = prepare(*task, {}, role);
    if (!prepared) return prepared.diagnostics();
    if (const Outcome<Done> known = checkNames(*prepared->system, names); !known) return known.diagnostics();
    SimulationTask simulation = taskAtStart(prepared->problem, 0);
    simulation.observe = names;
    const Trajectory run = simulate(simulation, {}, progress);
    if (run.failure.failed)
        return numericalError(phrase("the simulation of experiment \"{}\" stopped at t = {:.6g} s: {}", experiment,
                                     run.failure.time, Text(run.failure.reason, {}, run.failure.reason)),
                              phrase("look at the values of the parameters near that variable"));
    VariableValues result{task->recordings.front().time, {}};
    for (Eigen::Index i = 0; i < run.observed.rows(); ++i) {
        const Eigen::RowVectorXd row = run.observed.row(i);
        result.values.emplace_back(row.begin(), row.end());
    }
    return result;
}

}  // namespace analogon
