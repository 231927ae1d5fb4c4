#include "core/simulate/simulate.hpp"

#include <algorithm>
#include <limits>

#include "core/base/stop.hpp"
#include "core/base/work.hpp"
#include "core/simulate/all_finite.hpp"
#include "core/simulate/grid.hpp"
#include "core/simulate/input_slots.hpp"
#include "core/simulate/recorded_events.hpp"

namespace analogon {

namespace {

/// A trajectory that failed before it began.
Trajectory refused(const SimulationTask& task, Engine engine, std::string variable, std::string reason) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto samples = static_cast<Eigen::Index>(task.inputs->time.size());
    Trajectory result;
    result.engine = engine;
    result.outputs = Eigen::MatrixXd::Constant(task.system->outputCount(), samples, nan);
    if (task.directions.cols() > 0) {
        result.tangents.assign(static_cast<std::size_t>(task.system->outputCount()),
                               Eigen::MatrixXd::Constant(samples, task.directions.cols(), nan));
    }
    if (task.keepStates) result.states = Eigen::MatrixXd::Constant(task.system->stateCount(), samples, nan);
    result.observed = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(task.observe.size()), samples, nan);
    result.failure = {true, task.inputs->time.empty() ? 0.0 : task.inputs->time.front(), std::move(variable),
                      std::move(reason)};
    return result;
}

/// What does not fit together would read outside of arrays.
const char* misfit(const SimulationTask& task) {
    const System& system = *task.system;
    if (task.inputs->time.empty()) return "no samples";
    if (task.inputs->values.rows() != system.inputCount() ||
        (system.inputCount() > 0 &&
         task.inputs->values.cols() != static_cast<Eigen::Index>(task.inputs->time.size()))) {
        return "inputs do not have the shape the system asks for";
    }
    if (static_cast<int>(task.parameters.size()) != system.parameterCount()) return "wrong number of parameters";
    if (task.directions.cols() > 0 && task.directions.rows() != system.parameterCount()) {
        return "directions do not have the shape the system asks for";
    }
    for (const int i : task.inputs->heldInputs())
        if (system.isDifferentiated(i)) return "the model needs the slope of an input that is held";
    if (!allFinite(task.inputs->values.data(), task.inputs->values.size())) return "an input is not finite";
    return nullptr;
}

/// Why an evaluation failed, where the integrators only know that it did.
const char* reasonOf(const Dynamics& dynamics) {
    return dynamics.failedToSolve() ? "no convergence of an algebraic loop" : "not finite";
}

/// What was asked to stop fails wherever it was evaluated: that says nothing of the model.
Trajectory explained(Trajectory trajectory, const Dynamics& dynamics) {
    SimulationFailure& failure = trajectory.failure;
    if (failure.failed && isStopped()) {
        failure.reason = "cancelled";
        failure.variable.clear();
    } else if (failure.failed && failure.reason == "not finite") {
        failure.reason = reasonOf(dynamics);
    }
    return trajectory;
}

/// A run of a model with events of its own; what it has not reached is open.
Trajectory withEvents(const SimulationTask& task, const SimulationOptions& options, const Progress& progress) {
    // the integrator begins anew about once a sample: some 12 µs a column, in steps of 0.03 to 0.1 µs (measured)
    constexpr double eventCost = 100.0;
    countWork(eventCost * static_cast<double>(task.inputs->time.size() * (1 + task.directions.cols())));
    Trajectory run = refused(task, Engine::Adaptive, {}, {});
    runWithEvents(task, options, progress, run);
    return run;
}

/// A model that could not be evaluated at the start.
Trajectory unready(const SimulationTask& task, Engine engine, const Dynamics& dynamics) {
    return isStopped() ? refused(task, engine, {}, "cancelled")
                       : refused(task, engine, dynamics.failure(), reasonOf(dynamics));
}

}  // namespace

void SampleSink::takeRows(int first, int count, const double* rows, const RowLayout& layout, int directions) {
    const auto outputs = static_cast<std::size_t>(layout.outputs), K = static_cast<std::size_t>(directions);
    std::vector<double> dy(outputs * K);
    for (int j = 0; j < count; ++j, rows += layout.resultSize()) {
        for (int o = 0; o < layout.outputs; ++o)
            std::copy_n(rows + layout.tangent(o), K, dy.data() + static_cast<std::size_t>(o) * K);
        take(first + j, rows + layout.value(0), K > 0 ? dy.data() : nullptr);
    }
}

void pour(Trajectory& trajectory, int directions, SampleSink& sink) {
    std::vector<double> dy(static_cast<std::size_t>(trajectory.outputs.rows() * directions));
    sink.restart();
    for (Eigen::Index k = 0; k < trajectory.outputs.cols(); ++k) {
        double* to = dy.data();
        for (const Eigen::MatrixXd& tangents : trajectory.tangents)
            for (Eigen::Index i = 0; i < directions; ++i) *to++ = tangents(k, i);
        sink.take(static_cast<int>(k), trajectory.outputs.col(k).data(), directions > 0 ? dy.data() : nullptr);
    }
    trajectory.outputs.resize(0, 0);
    trajectory.tangents.clear();
}

void Trajectory::leaveOpen(Eigen::Index samples) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (Eigen::MatrixXd* values : {&outputs, &states, &observed})
        if (values->size() > 0) values->rightCols(samples).setConstant(nan);
    for (Eigen::MatrixXd& each : tangents) each.bottomRows(samples).setConstant(nan);
}

double GridPlan::work() const {
    constexpr double implicitCost = 12.0;
    if (!steps) return (method == GridMethod::Esdirk ? implicitCost : 1.0) * substeps;
    double sum = 0.0;
    for (const int each : *steps) sum += each < 0 ? -implicitCost * each : each;
    return sum / static_cast<double>(std::max<std::size_t>(1, steps->size()));
}

GridPlan planOf(std::vector<std::int16_t> steps) {
    GridPlan plan{GridMethod::RungeKutta4, 1, 0.0};
    const bool isImplicit = std::any_of(steps.begin(), steps.end(), [](int each) { return each < 0; });
    if (isImplicit) plan.method = GridMethod::Esdirk;
    for (const int each : steps)
        if ((each < 0) == isImplicit) plan.substeps = std::max(plan.substeps, std::abs(each));
    const bool isUniform = std::all_of(steps.begin(), steps.end(), [&](int each) { return each == steps.front(); });
    if (!isUniform) plan.steps = std::make_shared<const std::vector<std::int16_t>>(std::move(steps));
    return plan;
}

GridPlan refined(const GridPlan& plan, const std::vector<int>& needed) {
    if (plan.steps && plan.steps->size() != needed.size()) return plan;
    std::vector<std::int16_t> steps;
    bool isFiner = false;
    for (std::size_t k = 0; k < needed.size(); ++k) {
        const int interval = static_cast<int>(k), own = plan.substepsIn(interval);
        isFiner = isFiner || needed[k] > own;
        const int most = std::max(own, needed[k]);
        steps.push_back(static_cast<std::int16_t>(plan.methodIn(interval) == GridMethod::Esdirk ? -most : most));
    }
    return isFiner ? planOf(std::move(steps)) : plan;
}

bool operator==(const GridPlan& a, const GridPlan& b) {
    const bool sameSteps = a.steps == b.steps || (a.steps && b.steps && *a.steps == *b.steps);
    return a.method == b.method && a.substeps == b.substeps && sameSteps;
}

GridPlan planGrid(const SimulationTask& task, const SimulationOptions& options, const Progress& progress,
                  const GridPlan* inForce, std::optional<Trajectory>* taken) {
    if (misfit(task) || task.system->events()) return {};
    const StopScope scope(progress.stopToken());
    SimulationTask values = task;
    values.directions.resize(0, 0);
    values.observe.clear();
    SystemDynamics dynamics(values, false);
    if (!dynamics.isReady()) return {};
    const bool isAll = task.directions.cols() == 0 && task.observe.empty();
    if (!isAll) taken = nullptr;
    GridPlan plan = choosePlan(dynamics, *task.inputs, options, progress, inForce, taken);
    if (plan.terms || (taken && *taken)) return plan;
    if (inForce && plan == *inForce && inForce->terms && inForce->terms->owner == task.system->identity() &&
        inForce->terms->held == task.inputs->held) {
        plan.terms = inForce->terms;
    } else {
        plan.terms = tabulateTerms(dynamics, *task.inputs, plan, progress);
    }
    return plan;
}

GridPlan singleSteps(const SimulationTask& task, double errorEstimate, const Progress& progress) {
    GridPlan plan{GridMethod::RungeKutta4, 1, errorEstimate};
    if (misfit(task) || task.system->events()) return plan;
    const StopScope scope(progress.stopToken());
    SimulationTask values = task;
    values.directions.resize(0, 0);
    values.observe.clear();
    SystemDynamics dynamics(values, false);
    if (dynamics.isReady()) plan.terms = tabulateTerms(dynamics, *task.inputs, plan, progress);
    return plan;
}

Trajectory simulateGrid(const SimulationTask& task, const GridPlan& plan, const SimulationOptions& options,
                        const Progress& progress, SampleSink* sink) {
    if (const char* reason = misfit(task)) return refused(task, Engine::Grid, {}, reason);
    const StopScope scope(progress.stopToken());
    if (task.system->events()) {
        Trajectory run = withEvents(task, options, progress);
        if (sink) pour(run, static_cast<int>(task.directions.cols()), *sink);
        return run;
    }
    SystemDynamics dynamics(task, true);
    if (!dynamics.isReady()) return unready(task, Engine::Grid, dynamics);
    GridRun run;
    run.plan = plan;
    run.plan.substeps = std::max(1, plan.substeps);
    // the plan of a model that was linear: what has joined it may need any steps, and they are chosen without tangents
    if (plan.method == GridMethod::Exact && dynamics.shape().states > 0 && !canBeExact(dynamics, *task.inputs))
        run.plan = planGrid(task, options, progress);
    // Made for another recording: the most demanding steps for all of this one.
    if (plan.steps && plan.steps->size() + 1 != task.inputs->time.size()) run.plan.steps = nullptr;
    run.keepStates = task.keepStates;
    run.sink = sink;
    // a row of the matrix exponential in place of four evaluations of the model: 6 ns in place of 30 (measured)
    constexpr double exactCost = 0.2;
    const double cost = run.plan.method == GridMethod::Exact ? exactCost : run.plan.work();
    countWork(cost * static_cast<double>(task.inputs->time.size() * (1 + task.directions.cols())));
    return explained(runGrid(dynamics, *task.inputs, run, options, progress), dynamics);
}

std::optional<Eigen::MatrixXd> observeAlong(const SimulationTask& task, const Eigen::MatrixXd& states) {
    const auto samples = static_cast<Eigen::Index>(task.inputs->time.size());
    if (misfit(task) || task.system->events() || states.rows() != task.system->stateCount() || states.cols() != samples)
        return std::nullopt;
    SystemDynamics dynamics(task, false);
    if (!dynamics.isReady() || !dynamics.shape().delays.empty()) return std::nullopt;
    InputSlots slots(dynamics, *task.inputs);
    std::vector<double> u(static_cast<std::size_t>(dynamics.shape().slots));
    Eigen::MatrixXd observed(dynamics.observedCount(), samples);
    for (int k = 0; k < samples; ++k) {
        const double t = task.inputs->time[static_cast<std::size_t>(k)];
        slots.atSample(k, u.data());
        if (!dynamics.observed(t, states.col(k).data(), u.data(), observed.col(k).data()))
            observed.col(k).setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    return observed;
}

Trajectory simulateAdaptive(const SimulationTask& task, const SimulationOptions& options, const Progress& progress) {
    if (const char* reason = misfit(task)) return refused(task, Engine::Adaptive, {}, reason);
    const StopScope scope(progress.stopToken());
    if (task.system->events()) return withEvents(task, options, progress);
    SystemDynamics dynamics(task, true);
    if (!dynamics.isReady()) return unready(task, Engine::Adaptive, dynamics);
    countWork(12.0 * static_cast<double>(task.inputs->time.size() * (1 + task.directions.cols())));
    return explained(runAdaptive(dynamics, *task.inputs, task.keepStates, options, progress), dynamics);
}

Trajectory simulate(const SimulationTask& task, const SimulationOptions& options, const Progress& progress) {
    if (options.engine == Engine::Adaptive || task.system->events()) return simulateAdaptive(task, options, progress);
    const GridPlan plan = planGrid(task, options, progress);
    Trajectory grid = simulateGrid(task, plan, options, progress);
    // Where fixed steps do not get through or stay rough, the adaptive engine may: at a kink in every sample it
    // takes its time, so only then.
    constexpr double rough = 1e-2;
    const bool isRough = grid.failure.failed ? grid.failure.reason != "cancelled" : plan.errorEstimate > rough;
    if (options.engine == Engine::Grid || !isRough) return grid;
    Trajectory adaptive = simulateAdaptive(task, options, progress);
    return adaptive.failure.failed ? grid : adaptive;
}

}  // namespace analogon
