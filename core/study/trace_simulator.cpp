#include "core/study/trace_simulator.hpp"

#include <algorithm>
#include <cmath>

#include "core/study/fit_traces.hpp"

namespace analogon {

namespace {

/// What is simulated to its end has an error in percent, unless the channel is 0 throughout.
template <class Part>
double meanOf(const std::vector<Part>& parts, double Part::*error) {
    return meanError(parts, error, [&](const Part& part) { return !std::isnan(part.*error); });
}

SimulatedExperiment tracesOf(const FitExperiment& experiment, const Trajectory& trajectory) {
    SimulatedExperiment result{experiment.name, {}, 0};
    for (Eigen::Index o = 0; o < experiment.measured.rows(); ++o) {
        if (experiment.measured.row(o).array().isNaN().all()) continue;
        const Eigen::RowVectorXd simulated = trajectory.outputs.row(o);
        result.outputs.push_back({experiment.system->outputs()[static_cast<std::size_t>(o)].name,
                                  {simulated.data(), simulated.data() + simulated.size()},
                                  errorFigures(simulated, experiment.measured.row(o)).errorPercent});
    }
    result.errorPercent = meanOf(result.outputs, &SimulatedTrace::errorPercent);
    return result;
}

}  // namespace

SimulatedTraces tracesOf(const FitProblem& problem, const std::vector<Trajectory>& trajectories) {
    SimulatedTraces traces;
    for (std::size_t e = 0; e < problem.experiments.size(); ++e)
        traces.experiments.push_back(tracesOf(problem.experiments[e], trajectories[e]));
    traces.errorPercent = meanOf(traces.experiments, &SimulatedExperiment::errorPercent);
    return traces;
}

Outcome<TraceSimulator> TraceSimulator::make(const Study& study, const RunOptions& options) {
    Outcome<EstimationTask> task = taskOf(study, options);
    if (!task) return task.diagnostics();
    Outcome<PreparedTask> prepared = prepare(*task);
    if (!prepared) return prepared.diagnostics();
    return TraceSimulator(std::move(prepared->problem), options.discover.fit.simulation);
}

std::optional<SimulatedTraces> TraceSimulator::at(const std::vector<Progress::Value>& values,
                                                  const Progress& progress) const {
    const auto& parameters = problem_.parameters;
    if (values.size() != parameters.size()) return std::nullopt;
    Eigen::VectorXd point(static_cast<Eigen::Index>(parameters.size()));
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const int e = parameters[i].experiment;
        const std::string experiment = e < 0 ? std::string() : problem_.experiments[static_cast<std::size_t>(e)].name;
        const auto found = std::find_if(values.begin(), values.end(), [&](const Progress::Value& v) {
            return v.name == parameters[i].name && v.experiment == experiment;
        });
        if (found == values.end()) return std::nullopt;
        point[static_cast<Eigen::Index>(i)] = found->value;
    }

    const Linearisation line = linearise(problem_, point, false, {}, options_, progress);
    if (!line.ok) return std::nullopt;
    return tracesOf(problem_, line.trajectories);
}

}  // namespace analogon
