#include "core/fit/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>

#include "core/base/memory.hpp"
#include "core/base/parallel.hpp"
#include "core/fit/clock.hpp"
#include "core/fit/normal_equations.hpp"
#include "core/simulate/all_finite.hpp"

namespace analogon {

namespace {

Eigen::Index measuredCount(const FitExperiment& experiment, Eigen::Index output) {
    const Eigen::Index stride = experiment.measured.rows(), samples = experiment.measured.cols();
    const double* at = experiment.measured.data() + output;
    Eigen::Index count = 0;
    for (Eigen::Index k = 0; k < samples; ++k, at += stride) count += *at == *at;
    return count;
}

bool hasGaps(const FitExperiment& experiment, Eigen::Index output) {
    return measuredCount(experiment, output) != experiment.measured.cols();
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

/// What the clock of an output is ahead by at these values, and which fit parameter it is (-1: none).
struct ClockAt {
    int output{};
    double offset{};
    int parameter{-1};
};

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

/// Writes the rows of one experiment while its samples pass by, and keeps the outputs.
class RowWriter final : public SampleSink {
public:
    RowWriter(const FitExperiment& experiment, const std::vector<Eigen::Index>& columns, Eigen::Index firstRow,
              bool withJacobian, const std::vector<ClockAt>& clocks, Linearisation& result)
        : experiment_(experiment),
          columns_(columns),
          withJacobian_(withJacobian),
          clocks_(clocks),
          result_(result),
          slopes_(experiment.measured.rows()) {
        for (const ClockAt& clock : clocks_)
            slopes_[static_cast<std::size_t>(clock.output)].resize(withJacobian ? columns.size() : 0,
                                                                   experiment.measured.cols());
        resizeLarge(outputs, experiment.measured.rows(), experiment.measured.cols());
        outputs.setConstant(std::numeric_limits<double>::quiet_NaN());
        for (Eigen::Index o = 0; o < experiment.measured.rows(); ++o) {
            if (!experiment.isFitted(o)) continue;
            Output output;
            output.index = o;
            output.firstRow = firstRow;
            output.isComplete = !hasGaps(experiment, o);
            output.hasClock =
                std::any_of(clocks.begin(), clocks.end(), [&](const ClockAt& c) { return c.output == o; });
            for (Eigen::Index k = 0; k < experiment.measured.cols() && !output.isComplete; ++k)
                output.rows.push_back(std::isnan(experiment.measured(o, k)) ? -1 : firstRow++);
            if (output.isComplete) firstRow += experiment.measured.cols();
            fitted_.push_back(std::move(output));
        }
    }

    void take(int sample, const double* y, const double* dy) override {
        outputs.col(sample) = Eigen::Map<const Eigen::VectorXd>(y, outputs.rows());
        for (const Output& output : fitted_)
            pass(output, sample, 1, y + output.index,
                 dy ? dy + output.index * static_cast<Eigen::Index>(columns_.size()) : nullptr, 0);
    }

    void takeRows(int first, int count, const double* rows, const RowLayout& layout, int) override {
        for (int j = 0; j < count; ++j)
            outputs.col(first + j) =
                Eigen::Map<const Eigen::VectorXd>(rows + j * layout.resultSize() + layout.value(0), outputs.rows());
        for (const Output& output : fitted_) {
            const int o = static_cast<int>(output.index);
            pass(output, first, count, rows + layout.value(o), rows + layout.tangent(o), layout.resultSize());
        }
    }
    void restart() override {}

    /// When all samples are there: what has a clock of its own is taken where that clock stamps it.
    void applyClocks() {
        const std::vector<double>& time = experiment_.inputs.time;
        for (const ClockAt& clock : clocks_) {
            const Eigen::MatrixXd& slopes = slopes_[static_cast<std::size_t>(clock.output)];
            Eigen::RowVectorXd shifted(outputs.cols()), rates(outputs.cols());
            Eigen::MatrixXd shiftedSlopes = Eigen::MatrixXd::Zero(slopes.rows(), slopes.cols());
            for (Eigen::Index k = 0; k < outputs.cols(); ++k) {
                const TimeStencil stencil = stencilAt(time, time[static_cast<std::size_t>(k)] - clock.offset);
                const auto value = [&](int sample) { return outputs(clock.output, sample); };
                shifted[k] = stencil.value(value);
                rates[k] = stencil.slope(value);
                for (int j = 0; j < stencil.count && slopes.cols() > 0; ++j)
                    shiftedSlopes.col(k) +=
                        stencil.weights[static_cast<std::size_t>(j)] * slopes.col(stencil.first + j);
            }
            outputs.row(clock.output) = shifted;
            for (const Output& output : fitted_) {
                if (output.index != clock.output) continue;
                write(output, 0, static_cast<int>(shifted.size()), shifted.data(), 1, shiftedSlopes.data(),
                      shiftedSlopes.rows());
                if (withJacobian_ && clock.parameter >= 0) writeClock(output, rates, clock.parameter);
            }
        }
    }

    Eigen::MatrixXd outputs;  // rows: outputs, columns: samples; NaN where it did not get to

private:
    struct Output {
        Eigen::Index index{}, firstRow{};
        bool isComplete{}, hasClock{};
        std::vector<Eigen::Index> rows;  // of each sample, unless complete; -1: not measured
    };

    static Eigen::Index rowOf(const Output& output, Eigen::Index sample) {
        return output.isComplete ? output.firstRow + sample : output.rows[static_cast<std::size_t>(sample)];
    }

    /// Written at once, or kept until the clock can be applied.
    void pass(const Output& output, int first, int count, const double* y, const double* dy, Eigen::Index stride) {
        if (!output.hasClock) return write(output, first, count, y, stride, dy, stride);
        Eigen::MatrixXd& kept = slopes_[static_cast<std::size_t>(output.index)];
        for (int j = 0; j < count && kept.rows() > 0; ++j)
            kept.col(first + j) = Eigen::Map<const Eigen::VectorXd>(dy + j * stride, kept.rows());
    }

    void write(const Output& output, int first, int count, const double* y, Eigen::Index yStride, const double* dy,
               Eigen::Index stride) {
        const double weight = experiment_.weights[output.index];
        for (int j = 0; j < count; ++j) {
            const Eigen::Index row = rowOf(output, first + j);
            if (row >= 0)
                result_.residuals[row] = weight * (y[j * yStride] - experiment_.measured(output.index, first + j));
        }
        for (std::size_t k = 0; withJacobian_ && k < columns_.size(); ++k) {
            double* const column = result_.jacobian.data() + columns_[k] * result_.jacobian.rows();
            const double* slope = dy + k;
            for (int j = 0; j < count; ++j, slope += stride) {
                const Eigen::Index row = rowOf(output, first + j);
                if (row >= 0) column[row] = weight * *slope;
            }
        }
    }

    void writeClock(const Output& output, const Eigen::RowVectorXd& rates, int parameter) {
        for (Eigen::Index k = 0; k < rates.size(); ++k) {
            const Eigen::Index row = rowOf(output, k);
            if (row >= 0) result_.jacobian(row, parameter) = -experiment_.weights[output.index] * rates[k];
        }
    }

    const FitExperiment& experiment_;
    const std::vector<Eigen::Index>& columns_;
    bool withJacobian_{};
    const std::vector<ClockAt>& clocks_;
    Linearisation& result_;
    std::vector<Eigen::MatrixXd> slopes_;  // of outputs with a clock: rows: directions, columns: samples
    std::vector<Output> fitted_;
};

/// Shows the samples to two.
class BothSinks final : public SampleSink {
public:
    BothSinks(SampleSink& first, SampleSink& second) : sinks_{&first, &second} {}
    void take(int sample, const double* y, const double* dy) override {
        for (SampleSink* sink : sinks_) sink->take(sample, y, dy);
    }
    void takeRows(int first, int count, const double* rows, const RowLayout& layout, int directions) override {
        for (SampleSink* sink : sinks_) sink->takeRows(first, count, rows, layout, directions);
    }
    void restart() override {
        for (SampleSink* sink : sinks_) sink->restart();
    }

private:
    std::array<SampleSink*, 2> sinks_;
};

}  // namespace

int FitProblem::residualCount() const {
    Eigen::Index count = 0;
    for (const FitExperiment& experiment : experiments) {
        for (Eigen::Index o = 0; o < experiment.measured.rows(); ++o) {
            if (experiment.isFitted(o)) {
                count += measuredCount(experiment, o);
            }
        }
    }
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
                        MisfitSums* sums) {
    Linearisation result;
    if (sums) {
        const auto K = withJacobian ? static_cast<Eigen::Index>(problem.parameters.size()) : 0;
        *sums = {false, Eigen::MatrixXd::Zero(K, K), Eigen::VectorXd::Zero(K), 0.0, {}};
    }
    const Eigen::Index rows = problem.residualCount();
    resizeLarge(result.residuals, rows, 1);
    result.residuals.setConstant(std::numeric_limits<double>::quiet_NaN());
    if (withJacobian) {
        const auto K = static_cast<Eigen::Index>(problem.parameters.size());
        resizeLarge(result.jacobian, rows, K);
        // What acts in every experiment fills its column; a parameter of one leaves gaps.
        for (Eigen::Index k = 0; k < K; ++k)
            if (problem.parameters[static_cast<std::size_t>(k)].experiment >= 0 || !actsEverywhere(problem, k))
                result.jacobian.col(k).setZero();
    }
    Eigen::Index row = 0;
    for (std::size_t e = 0; e < problem.experiments.size(); ++e) {
        const FitExperiment& experiment = problem.experiments[e];
        std::vector<Eigen::Index> columns;  // column of the Jacobian of each direction
        const SimulationTask task = taskFor(problem, static_cast<int>(e), values, withJacobian ? &columns : nullptr);
        const std::vector<ClockAt> clocks = clocksAt(problem, experiment, values);
        RowWriter writer(experiment, columns, row, withJacobian, clocks, result);
        NormalEquations added(experiment, sums ? columns : std::vector<Eigen::Index>{});
        BothSinks both(writer, added);
        SampleSink& sink = sums ? static_cast<SampleSink&>(both) : writer;
        result.trajectories.push_back(simulated(problem, e, task, plans, options, progress, sink));
        if (options.reached)
            options.reached(static_cast<double>(e + 1) / static_cast<double>(problem.experiments.size()));
        Trajectory& trajectory = result.trajectories.back();
        if (options.engine == Engine::Adaptive) pour(trajectory, static_cast<int>(task.directions.cols()), sink);
        if (!trajectory.failure.failed) writer.applyClocks();
        trajectory.outputs = std::move(writer.outputs);  // also of what failed: NaN where it did not get to
        if (trajectory.failure.failed) {
            result.failure = describe(trajectory.failure, experiment.name);
            return result;
        }
        for (Eigen::Index o = 0; o < experiment.measured.rows(); ++o)
            if (experiment.isFitted(o)) row += measuredCount(experiment, o);
        if (!allFinite(trajectory.outputs.data(), trajectory.outputs.size())) {
            result.failure = phrase("experiment '{}': an output is not finite", experiment.name);
            return result;
        }
        if (sums) {
            sums->squares += added.squares();
            added.addTo(sums->hessian, sums->gradient);
        }
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
