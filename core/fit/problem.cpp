#include "core/fit/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>

#include "core/base/memory.hpp"
#include "core/base/parallel.hpp"
#include "core/fit/clock.hpp"
#include "core/fit/normal_equations.hpp"
#include "core/fit/row_writer.hpp"
#include "core/simulate/all_finite.hpp"

namespace analogon {

namespace {

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
    SimulationTask task = taskOf(recorded);
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

/// How much of an experiment is done: the runs that choose its steps are the first half, however many they are, the one
/// that is looked at is the second.
class PartsDone {
public:
    PartsDone(const SimulationOptions& options, std::size_t experiment, std::size_t experiments)
        : reached_(options.reached), experiment_(experiment), experiments_(experiments) {}

    SimulationOptions planning(SimulationOptions options) {
        if (reached_)
            options.reached = [this](double part) {
                if (part < last_) ++runs_;
                last_ = part;
                tell(0.5 * (1 - std::pow(0.5, runs_ + part)));
            };
        return options;
    }
    SimulationOptions simulating(SimulationOptions options, bool isPlanned) const {
        if (reached_) options.reached = [this, isPlanned](double part) { tell(isPlanned ? part : 0.5 + 0.5 * part); };
        return options;
    }

private:
    void tell(double part) const {
        reached_((static_cast<double>(experiment_) + part) / static_cast<double>(experiments_));
    }

    const std::function<void(double)>& reached_;
    std::size_t experiment_{}, experiments_{};
    double last_{};
    int runs_{};
};

/// One simulation with the experiment's plan of these, or one made here; what is thrown in it is a failure like any
/// other.
Trajectory simulated(const FitProblem& problem, std::size_t experiment, SimulationTask task,
                     const std::vector<GridPlan>& plans, SimulationOptions options, const Progress& progress,
                     SampleSink& sink) {
    try {
        if (problem.beforeSimulation) problem.beforeSimulation(task, options);
        const bool isPlanned = experiment < plans.size();
        PartsDone done(options, experiment, problem.experiments.size());
        if (options.engine == Engine::Adaptive) return simulateAdaptive(task, done.simulating(options, true), progress);
        std::optional<Trajectory> taken;
        const GridPlan plan = isPlanned ? plans[experiment]
                                        : planGrid(task, done.planning(options), progress,
                                                   problem.knownPlan(static_cast<int>(experiment)), &taken);
        if (taken) {
            taken->plan = plan;
            pour(*taken, 0, sink);
            return std::move(*taken);
        }
        return simulateGrid(task, plan, done.simulating(options, isPlanned), progress, &sink);
    } catch (const std::exception& fault) {
        Trajectory stopped;
        stopped.engine = options.engine;
        stopped.failure = {true, task.inputs->time.front(), {}, fault.what()};
        return stopped;
    }
}

/// Whether a parameter moves something in each experiment.
bool actsEverywhere(const FitProblem& problem, Eigen::Index parameter) {
    for (std::size_t e = 0; e < problem.experiments.size(); ++e)
        if (drivenParameters(problem, static_cast<int>(e))[static_cast<std::size_t>(parameter)] < 0) return false;
    return true;
}

Text describe(const SimulationFailure& failure, const std::string& experiment) {
    const Text reason(failure.reason, {}, failure.reason);  // one of a few
    const Text told = failure.variable.empty()
                          ? phrase("experiment '{}' failed at t = {:.6g} s: {}", experiment, failure.time, reason)
                          : phrase("experiment '{}' failed at t = {:.6g} s: {} ({})", experiment, failure.time, reason,
                                   failure.variable);
    return failure.cause.empty() ? told : phrase("{}: {}", told, failure.cause);
}

std::vector<ClockAt> clocksAt(const FitProblem& problem, const FitExperiment& experiment,
                              const Eigen::VectorXd& values) {
    std::vector<ClockAt> clocks;
    for (const ChannelClock& clock : experiment.clocks) {
        const std::string name = clockOf(experiment.system->outputs()[static_cast<std::size_t>(clock.output)].name);
        ClockAt at{clock.output, clock.offset, -1};
        for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
            if (problem.parameters[i].name != name) continue;
            at.parameter = static_cast<int>(i);
            at.offset = values[static_cast<Eigen::Index>(i)];
        }
        clocks.push_back(at);
    }
    return clocks;
}

/// Residuals that are not known yet, and a Jacobian for them.
Linearisation roomFor(const FitProblem& problem, bool withJacobian) {
    Linearisation result;
    const Eigen::Index rows = problem.residualCount();
    resizeLarge(result.residuals, rows, 1);
    result.residuals.setConstant(std::numeric_limits<double>::quiet_NaN());
    if (!withJacobian) return result;
    const auto K = static_cast<Eigen::Index>(problem.parameters.size());
    resizeLarge(result.jacobian, rows, K);
    // What acts in every experiment fills its column; a parameter of one leaves gaps.
    for (Eigen::Index k = 0; k < K; ++k)
        if (problem.parameters[static_cast<std::size_t>(k)].experiment >= 0 || !actsEverywhere(problem, k))
            result.jacobian.col(k).setZero();
    return result;
}

/// The rows of one experiment from `firstRow` on, and its trajectory; `added`: its normal equations as well. Why it
/// failed, or nothing.
Text lineariseOne(const FitProblem& problem, std::size_t e, const Eigen::VectorXd& values, bool withJacobian,
                  const std::vector<GridPlan>& plans, const SimulationOptions& options, const Progress& progress,
                  Eigen::Index firstRow, std::unique_ptr<NormalEquations>* added, Linearisation& result) {
    const FitExperiment& experiment = problem.experiments[e];
    std::vector<Eigen::Index> columns;  // column of the Jacobian of each direction
    const SimulationTask task = taskFor(problem, static_cast<int>(e), values, withJacobian ? &columns : nullptr);
    const std::vector<ClockAt> clocks = clocksAt(problem, experiment, values);
    RowWriter writer(experiment, columns, firstRow, withJacobian, clocks, result);
    if (added) *added = std::make_unique<NormalEquations>(experiment, columns);
    std::optional<BothSinks> both;
    if (added) both.emplace(writer, **added);
    SampleSink& sink = both ? static_cast<SampleSink&>(*both) : writer;
    Trajectory& trajectory = result.trajectories[e];
    trajectory = simulated(problem, e, task, plans, options, progress, sink);
    if (options.engine == Engine::Adaptive) pour(trajectory, static_cast<int>(task.directions.cols()), sink);
    if (!trajectory.failure.failed) writer.applyClocks();
    trajectory.outputs = std::move(writer.outputs);  // also of what failed: NaN where it did not get to
    if (trajectory.failure.failed) return describe(trajectory.failure, experiment.name);
    if (!allFinite(trajectory.outputs.data(), trajectory.outputs.size()))
        return phrase("experiment '{}': an output is not finite", experiment.name);
    return {};
}

}  // namespace

Eigen::Index FitExperiment::measuredCount(Eigen::Index output) const {
    const Eigen::Index stride = measured.rows(), samples = measured.cols();
    const double* at = measured.data() + output;
    Eigen::Index count = 0;
    for (Eigen::Index k = 0; k < samples; ++k, at += stride) count += *at == *at;
    return count;
}

Eigen::Index FitExperiment::residualCount() const {
    Eigen::Index count = 0;
    for (Eigen::Index o = 0; o < measured.rows(); ++o)
        if (isFitted(o)) count += measuredCount(o);
    return count;
}

int FitProblem::residualCount() const {
    Eigen::Index count = 0;
    for (const FitExperiment& experiment : experiments) count += experiment.residualCount();
    return static_cast<int>(count);
}

Eigen::VectorXd FitProblem::startValues() const {
    Eigen::VectorXd values(static_cast<Eigen::Index>(parameters.size()));
    for (Eigen::Index k = 0; k < values.size(); ++k) values[k] = parameters[static_cast<std::size_t>(k)].start;
    return values;
}

bool FitProblem::hasPriors() const {
    return std::any_of(parameters.begin(), parameters.end(), [](const FitParameter& p) { return p.prior.has_value(); });
}

bool FitProblem::hasClocks() const {
    return std::any_of(experiments.begin(), experiments.end(),
                       [](const FitExperiment& e) { return !e.clocks.empty(); });
}

const GridPlan* FitProblem::knownPlan(int experiment) const {
    const auto e = static_cast<std::size_t>(experiment);
    return e < knownPlans.size() ? &knownPlans[e] : nullptr;
}

SimulationTask taskOf(const FitExperiment& experiment) {
    SimulationTask task;
    task.system = experiment.system.get();
    task.inputs = &experiment.inputs;
    task.parameters = experiment.parameters;
    if (experiment.isInterpreted) task.execution = Execution::Interpreted;
    return task;
}

GridPlan planFor(const FitProblem& problem, int experiment, const Eigen::VectorXd& values,
                 const SimulationOptions& options, const Progress& progress, const GridPlan* inForce) {
    return planGrid(taskFor(problem, experiment, values, nullptr), options, progress, inForce);
}

GridPlan singleStepsFor(const FitProblem& problem, int experiment, const Eigen::VectorXd& values, double errorEstimate,
                        const Progress& progress) {
    return singleSteps(taskFor(problem, experiment, values, nullptr), errorEstimate, progress);
}

Linearisation linearise(const FitProblem& problem, const Eigen::VectorXd& values, bool withJacobian,
                        const std::vector<GridPlan>& plans, const SimulationOptions& options, const Progress& progress,
                        MisfitSums* sums, int threads) {
    Linearisation result = roomFor(problem, withJacobian);
    const std::size_t count = problem.experiments.size();
    std::vector<Eigen::Index> firstRows(count, 0);
    for (std::size_t e = 1; e < count; ++e)
        firstRows[e] = firstRows[e - 1] + problem.experiments[e - 1].residualCount();
    std::vector<std::unique_ptr<NormalEquations>> added(sums ? count : 0);
    result.trajectories.resize(count);
    std::vector<Text> failures(count);
    std::atomic<std::size_t> firstFailed{count};
    // What is told of how far it is goes from the first to the last.
    parallelFor(static_cast<int>(count), options.reached ? 1 : threads, [&](int index) {
        const auto e = static_cast<std::size_t>(index);
        if (e > firstFailed) return;
        failures[e] = lineariseOne(problem, e, values, withJacobian, plans, options, progress, firstRows[e],
                                   sums ? &added[e] : nullptr, result);
        if (options.reached) options.reached(static_cast<double>(e + 1) / static_cast<double>(count));
        std::size_t failed = firstFailed;
        while (!failures[e].empty() && e < failed && !firstFailed.compare_exchange_weak(failed, e)) {
        }
    });
    const auto K = withJacobian ? static_cast<Eigen::Index>(problem.parameters.size()) : 0;
    if (sums) *sums = {false, Eigen::MatrixXd::Zero(K, K), Eigen::VectorXd::Zero(K), 0.0, {}};
    // In the order of the experiments, whatever thread was first; it ends with the first that failed.
    for (std::size_t e = 0; sums && e < std::min<std::size_t>(firstFailed, count); ++e) {
        sums->squares += added[e]->squares();
        added[e]->addTo(sums->hessian, sums->gradient);
    }
    if (firstFailed < count) {
        result.trajectories.resize(firstFailed + 1);
        result.failure = failures[firstFailed];
        return result;
    }
    // so large that their squares are not: the steps were stable for the states and not for what moves them
    if (withJacobian && !std::isfinite(result.jacobian.squaredNorm())) {
        result.failure = phrase("the sensitivities are not finite");
        return result;
    }
    result.ok = true;
    if (sums) sums->ok = true;
    return result;
}

Text causeOf(const FitProblem& problem, int experiment, const Eigen::VectorXd& values, const SimulationFailure& failure,
             const SimulationOptions& options, const Progress& progress) {
    return causeOf(taskFor(problem, experiment, values, nullptr), failure, options, progress);
}

Text failureAt(const FitProblem& problem, const Eigen::VectorXd& values, const SimulationOptions& options,
               const Progress& progress) {
    const Linearisation line = linearise(problem, values, false, {}, options, progress);
    if (line.ok || line.trajectories.empty()) return {};
    const int experiment = static_cast<int>(line.trajectories.size()) - 1;  // it ends with the first that fails
    const SimulationFailure& failure = line.trajectories.back().failure;
    if (!failure.cause.empty()) return line.failure;  // it is told there
    const Text cause = causeOf(problem, experiment, values, failure, options, progress);
    return cause.empty() ? line.failure : phrase("{}: {}", line.failure, cause);
}

MisfitSums sumUp(const FitProblem& problem, const Eigen::VectorXd& values, bool withJacobian,
                 const std::vector<GridPlan>& plans, const SimulationOptions& options, const Progress& progress,
                 int threads) {
    const auto K = withJacobian ? static_cast<Eigen::Index>(problem.parameters.size()) : 0;
    MisfitSums sums;
    sums.hessian = Eigen::MatrixXd::Zero(K, K);
    sums.gradient = Eigen::VectorXd::Zero(K);
    const std::size_t count = problem.experiments.size();
    std::vector<std::unique_ptr<NormalEquations>> parts(count);
    std::vector<Text> failures(count);
    parallelFor(static_cast<int>(count), threads, [&](int index) {
        const auto e = static_cast<std::size_t>(index);
        std::vector<Eigen::Index> columns;
        const SimulationTask task = taskFor(problem, index, values, withJacobian ? &columns : nullptr);
        parts[e] = std::make_unique<NormalEquations>(problem.experiments[e], std::move(columns));
        const Trajectory trajectory = simulated(problem, e, task, plans, options, progress, *parts[e]);
        if (trajectory.failure.failed) {
            failures[e] = describe(trajectory.failure, problem.experiments[e].name);
        } else if (!parts[e]->isFinite()) {
            failures[e] = phrase("experiment '{}': the sensitivities are not finite", problem.experiments[e].name);
        }
    });
    // In the order of the experiments, whatever thread was first.
    for (std::size_t e = 0; e < count; ++e) {
        if (!failures[e].empty()) {
            sums.failure = failures[e];
            return sums;
        }
        sums.squares += parts[e]->squares();
        parts[e]->addTo(sums.hessian, sums.gradient);
    }
    sums.ok = true;
    return sums;
}

}  // namespace analogon
