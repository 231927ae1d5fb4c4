#include "core/fit/problem.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace analogon {

namespace {

bool isFitted(const FitExperiment& experiment, Eigen::Index output) {
    return output < experiment.weights.size() && experiment.weights[output] > 0.0;
}

/// System parameter that each fit parameter drives in one experiment; -1: none. A parameter of this experiment
/// alone goes before one of the same name for all.
std::vector<int> drivenParameters(const FitProblem& problem, int experiment) {
    const System& system = *problem.experiments[static_cast<std::size_t>(experiment)].system;
    std::vector<int> driven(problem.parameters.size(), -1);
    std::vector<bool> isTaken(static_cast<std::size_t>(system.parameterCount()), false);
    for (const bool own : {true, false}) {
        for (std::size_t i = 0; i < driven.size(); ++i) {
            const FitParameter& parameter = problem.parameters[i];
            if (own ? parameter.experiment != experiment : parameter.experiment >= 0) continue;
            const int index = system.parameterIndex(parameter.name);
            if (index < 0 || isTaken[static_cast<std::size_t>(index)]) continue;
            isTaken[static_cast<std::size_t>(index)] = true;
            driven[i] = index;
        }
    }
    return driven;
}

/// The simulation of one experiment at these values; with `columns`, one direction per fit parameter that acts in it.
SimulationTask taskFor(const FitProblem& problem, int experiment, const Eigen::VectorXd& values,
                       std::vector<Eigen::Index>* columns) {
    const FitExperiment& recorded = problem.experiments[static_cast<std::size_t>(experiment)];
    const std::vector<int> driven = drivenParameters(problem, experiment);
    SimulationTask task;
    task.system = recorded.system.get();
    task.inputs = &recorded.inputs;
    task.parameters = recorded.parameters;
    for (std::size_t i = 0; i < driven.size(); ++i) {
        if (driven[i] < 0) continue;
        task.parameters[static_cast<std::size_t>(driven[i])] = values[static_cast<Eigen::Index>(i)];
        if (columns) columns->push_back(static_cast<Eigen::Index>(i));
    }
    if (!columns) return task;
    task.directions.setZero(static_cast<Eigen::Index>(task.parameters.size()),
                            static_cast<Eigen::Index>(columns->size()));
    for (std::size_t j = 0; j < columns->size(); ++j) {
        task.directions(driven[static_cast<std::size_t>((*columns)[j])], static_cast<Eigen::Index>(j)) = 1.0;
    }
    return task;
}

std::string describe(const SimulationFailure& failure, const std::string& experiment) {
    std::string text =
        fmt::format("experiment '{}' failed at t = {:.6g} s: {}", experiment, failure.time, failure.reason);
    if (!failure.variable.empty()) text += fmt::format(" ({})", failure.variable);
    return text;
}

/// Writes the rows of one output; returns the row after them.
Eigen::Index fillRows(const FitExperiment& experiment, const Trajectory& trajectory, Eigen::Index output,
                      const std::vector<Eigen::Index>& columns, Eigen::Index row, Linearisation& result) {
    const double weight = experiment.weights[output];
    const auto samples = experiment.measured.cols();
    const auto measured = experiment.measured.row(output);
    const bool isComplete = !measured.hasNaN();
    if (isComplete) {
        result.residuals.segment(row, samples) = weight * (trajectory.outputs.row(output) - measured).transpose();
    } else {
        Eigen::Index to = row;
        for (Eigen::Index k = 0; k < samples; ++k) {
            if (!std::isnan(measured[k]))
                result.residuals[to++] = weight * (trajectory.outputs(output, k) - measured[k]);
        }
    }
    Eigen::Index end = row + samples;
    if (!isComplete) end = row + samples - measured.array().isNaN().count();
    for (std::size_t j = 0; j < columns.size(); ++j) {
        const auto tangent = trajectory.tangents[static_cast<std::size_t>(output)].col(static_cast<Eigen::Index>(j));
        if (isComplete) {
            result.jacobian.col(columns[j]).segment(row, samples) = weight * tangent;
            continue;
        }
        Eigen::Index to = row;
        for (Eigen::Index k = 0; k < samples; ++k) {
            if (!std::isnan(measured[k])) result.jacobian(to++, columns[j]) = weight * tangent[k];
        }
    }
    return end;
}

}  // namespace

int FitProblem::residualCount() const {
    Eigen::Index count = 0;
    for (const FitExperiment& experiment : experiments) {
        for (Eigen::Index o = 0; o < experiment.measured.rows(); ++o) {
            if (isFitted(experiment, o)) {
                count += experiment.measured.cols() - experiment.measured.row(o).array().isNaN().count();
            }
        }
    }
    return static_cast<int>(count);
}

GridPlan planFor(const FitProblem& problem, int experiment, const Eigen::VectorXd& values,
                 const SimulationOptions& options, const Progress& progress, const GridPlan* inForce) {
    return planGrid(taskFor(problem, experiment, values, nullptr), options, progress, inForce);
}

Linearisation linearise(const FitProblem& problem, const Eigen::VectorXd& values, bool withJacobian,
                        const std::vector<GridPlan>& plans, const SimulationOptions& options,
                        const Progress& progress) {
    Linearisation result;
    const Eigen::Index rows = problem.residualCount();
    result.residuals.setConstant(rows, std::numeric_limits<double>::quiet_NaN());
    if (withJacobian)
        result.jacobian = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(problem.parameters.size()));
    Eigen::Index row = 0;
    for (std::size_t e = 0; e < problem.experiments.size(); ++e) {
        const FitExperiment& experiment = problem.experiments[e];
        std::vector<Eigen::Index> columns;  // column of the Jacobian of each direction
        const SimulationTask task = taskFor(problem, static_cast<int>(e), values, withJacobian ? &columns : nullptr);
        if (options.engine == Engine::Adaptive) {
            result.trajectories.push_back(simulateAdaptive(task, options, progress));
        } else {
            const GridPlan plan = e < plans.size() ? plans[e] : planGrid(task, options, progress);
            result.trajectories.push_back(simulateGrid(task, plan, options, progress));
        }
        const Trajectory& trajectory = result.trajectories.back();
        if (trajectory.failure.failed) {
            result.failure = describe(trajectory.failure, experiment.name);
            return result;
        }
        for (Eigen::Index o = 0; o < experiment.measured.rows(); ++o) {
            if (isFitted(experiment, o)) row = fillRows(experiment, trajectory, o, columns, row, result);
        }
        if (!result.residuals.head(row).allFinite() || (withJacobian && !result.jacobian.topRows(row).allFinite())) {
            result.failure = fmt::format("experiment '{}': the sensitivities are not finite", experiment.name);
            return result;
        }
    }
    result.ok = true;
    return result;
}

}  // namespace analogon
