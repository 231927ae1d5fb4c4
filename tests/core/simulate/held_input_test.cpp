#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/simulate/simulate.hpp"
#include "tests/core/simulate/text_models.hpp"

namespace analogon {
namespace {

using test::compileText;
using test::ownParameters;

/// A command of random levels, one a sample; the first `held` of the inputs are held.
SampledInputs commands(int count, int inputs, int held, double step, double jitter) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> level(-1.0, 2.0), late(0.0, jitter);
    SampledInputs sampled;
    sampled.values.resize(inputs, count);
    for (int k = 0; k < count; ++k) {
        sampled.time.push_back(k * step + late(random));
        for (int i = 0; i < inputs; ++i)
            sampled.values(i, k) = i < held ? level(random) : std::sin(0.3 * sampled.time.back() + i);
    }
    for (int i = 0; i < inputs; ++i) sampled.held.push_back(i < held ? 1 : 0);
    return sampled;
}

SimulationTask taskOf(const SystemPtr& system, const SampledInputs& inputs, bool withTangents = false) {
    SimulationTask task;
    task.system = system.get();
    task.inputs = &inputs;
    task.parameters = ownParameters(*system);
    if (withTangents) task.directions = Eigen::MatrixXd::Identity(system->parameterCount(), system->parameterCount());
    return task;
}

SimulationOptions by(Engine engine, GridMethod method = GridMethod::Auto, double tolerance = 1e-10) {
    SimulationOptions options;
    options.engine = engine;
    options.method = method;
    options.relativeTolerance = tolerance;
    options.absoluteTolerance = 0.01 * tolerance;
    return options;
}

const char* const lagText = R"(
model Lag
  input Real u;
  output Real y;
  output Real seen;
  parameter Real T = 0.3;
  parameter Real K = 2;
  Real x(start = 0.5, fixed = true);
equation
  T*der(x) = K*u - x;
  y = x;
  seen = x + 3*u;
end Lag;
)";

/// Its states by the exponential of each interval (zero-order hold).
Eigen::VectorXd lagAt(const SampledInputs& inputs, double T, double K) {
    Eigen::VectorXd x(inputs.values.cols());
    x[0] = 0.5;
    for (Eigen::Index k = 0; k + 1 < x.size(); ++k) {
        const auto i = static_cast<std::size_t>(k);
        const double decay = std::exp(-(inputs.time[i + 1] - inputs.time[i]) / T);
        x[k + 1] = decay * x[k] + (1 - decay) * K * inputs.values(0, k);
    }
    return x;
}

void expectLag(const Trajectory& run, const SampledInputs& inputs, double tolerance) {
    ASSERT_FALSE(run.failure.failed) << run.failure.reason;
    const Eigen::VectorXd x = lagAt(inputs, 0.3, 2);
    EXPECT_LT((run.outputs.row(0).transpose() - x).cwiseAbs().maxCoeff(), tolerance);
    // at the sample the output sees the value after the jump, at the last one too
    const Eigen::VectorXd seen = x + 3 * inputs.values.row(0).transpose();
    EXPECT_LT((run.outputs.row(1).transpose() - seen).cwiseAbs().maxCoeff(), 4 * tolerance);
}

TEST(HeldInput, AFirstOrderLagIsExactUnderTheRecurrence) {
    const SystemPtr system = compileText(lagText, "Lag", {"T", "K"});
    for (const int count : {20, 500}) {  // short records are interpreted
        const SampledInputs inputs = commands(count, 1, 1, 0.1, 0);
        const Trajectory run = simulate(taskOf(system, inputs), by(Engine::Grid, GridMethod::Exact));
        EXPECT_EQ(run.plan.method, GridMethod::Exact);
        expectLag(run, inputs, 1e-12);
    }
}

TEST(HeldInput, AFirstOrderLagIsExactOnAnIrregularRasterByEveryMethod) {
    const SystemPtr system = compileText(lagText, "Lag", {"T", "K"});
    for (const int count : {60, 400}) {
        const SampledInputs inputs = commands(count, 1, 1, 0.1, 0.05);
        expectLag(simulate(taskOf(system, inputs), by(Engine::Grid, GridMethod::RungeKutta4, 1e-12)), inputs, 1e-9);
        expectLag(simulate(taskOf(system, inputs), by(Engine::Grid, GridMethod::Auto, 1e-12)), inputs, 1e-9);
        expectLag(simulate(taskOf(system, inputs), by(Engine::Grid, GridMethod::Esdirk, 1e-9)), inputs, 1e-6);
        expectLag(simulate(taskOf(system, inputs), by(Engine::Adaptive, GridMethod::Auto, 1e-11)), inputs, 1e-9);
    }
}

const char* const mixedText = R"(
model Mixed
  input Real u;
  input Real v;
  input Real s;
  output Real y;
  output Real z;
  parameter Real a = 1.3;
  parameter Real b = 0.4;
  Real x1(start = 0.1, fixed = true);
  Real x2(start = 0, fixed = true);
equation
  der(x1) = -a*x1 + exp(0.5*u) - 1 + b*sin(s)*x2 + exp(0.2*v*s);
  der(x2) = x1*cos(u) - x2*(1 + x2^2) + 0.3*sqrt(2 + s)*x1 + v;
  y = x1 + 0.1*exp(u)*x2;
  z = x2;
end Mixed;
)";

TEST(HeldInput, HeldInputsAndLinearOnesRunBesideEachOther) {
    const SystemPtr system = compileText(mixedText, "Mixed", {"a", "b"});
    const SampledInputs inputs = commands(600, 3, 2, 0.05, 0.01);
    SimulationTask task = taskOf(system, inputs, true);
    const Trajectory reference = simulate(task, by(Engine::Adaptive, GridMethod::Auto, 1e-10));
    ASSERT_FALSE(reference.failure.failed) << reference.failure.reason;
    const auto expectAlike = [&](const Trajectory& run, double tolerance) {
        ASSERT_FALSE(run.failure.failed) << run.failure.reason;
        EXPECT_LT((run.outputs - reference.outputs).cwiseAbs().maxCoeff(), tolerance);
        for (std::size_t o = 0; o < 2; ++o)
            EXPECT_LT((run.tangents[o] - reference.tangents[o]).cwiseAbs().maxCoeff(), 20 * tolerance);
    };
    expectAlike(simulate(task, by(Engine::Grid, GridMethod::RungeKutta4)), 1e-7);
    expectAlike(simulate(task, by(Engine::Grid, GridMethod::Auto)), 1e-7);
    expectAlike(simulate(task, by(Engine::Grid, GridMethod::Esdirk, 1e-8)), 1e-5);
    task.execution = Execution::Interpreted;
    expectAlike(simulate(task, by(Engine::Grid, GridMethod::RungeKutta4)), 1e-7);
}

TEST(HeldInput, MachineCodeAndItsInterpreterTakeTheSameSteps) {
    const SystemPtr system = compileText(mixedText, "Mixed", {"a", "b"});
    const SampledInputs inputs = commands(300, 3, 2, 0.05, 0);
    SimulationTask task = taskOf(system, inputs, true);
    for (const int substeps : {1, 3}) {
        const GridPlan plan{GridMethod::RungeKutta4, substeps, 0.0};
        task.execution = Execution::Fastest;
        const Trajectory code = simulateGrid(task, plan);
        const GridPlan known = substeps == 1 ? singleSteps(task, 0.0) : plan;  // with what depends on inputs alone
        EXPECT_EQ(known.terms != nullptr, substeps == 1);
        const Trajectory looked = simulateGrid(task, known);
        task.execution = Execution::Interpreted;
        const Trajectory plain = simulateGrid(task, plan);
        ASSERT_FALSE(code.failure.failed || plain.failure.failed);
        EXPECT_LT((code.outputs - plain.outputs).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_LT((looked.outputs - plain.outputs).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_LT((code.tangents[0] - plain.tangents[0]).cwiseAbs().maxCoeff(), 1e-11);
    }
}

const char* const delayedText = R"(
model Delayed
  input Real u;
  input Real s;
  output Real y;
  parameter Real T = 0.13;
  parameter Real a = 1.5;
  Real x(start = 0, fixed = true);
equation
  der(x) = -a*x*(1 + 0.1*x) + (1 + 0.2*s)*delay(u, T, 2);
  y = x;
end Delayed;
)";

Eigen::MatrixXd differences(const SimulationTask& task, const SimulationOptions& options, double step) {
    Eigen::MatrixXd slopes(task.inputs->time.size(), static_cast<Eigen::Index>(task.parameters.size()));
    for (std::size_t i = 0; i < task.parameters.size(); ++i) {
        SimulationTask low = task, high = task;
        low.directions.resize(0, 0);
        high.directions.resize(0, 0);
        low.parameters[i] -= step;
        high.parameters[i] += step;
        slopes.col(static_cast<Eigen::Index>(i)) =
            (simulate(high, options).outputs.row(0) - simulate(low, options).outputs.row(0)).transpose() / (2 * step);
    }
    return slopes;
}

TEST(HeldInput, TangentsAreThoseOfDifferences) {
    struct Case {
        const char *text, *name;
        GridMethod method;
        double jitter;
    };
    const Case cases[] = {{lagText, "Lag", GridMethod::Exact, 0},
                          {lagText, "Lag", GridMethod::RungeKutta4, 0.03},
                          {lagText, "Lag", GridMethod::Esdirk, 0.03}};
    for (const Case& c : cases) {
        const SystemPtr system = compileText(c.text, c.name, {"T", "K"});
        const SampledInputs inputs = commands(150, 1, 1, 0.1, c.jitter);
        SimulationOptions options = by(Engine::Grid, c.method, 1e-8);
        if (c.method != GridMethod::Exact) options.substeps = 4;
        const SimulationTask task = taskOf(system, inputs, true);
        const Trajectory run = simulate(task, options);
        EXPECT_EQ(run.plan.method, c.method);
        EXPECT_LT((run.tangents[0] - differences(task, options, 1e-5)).cwiseAbs().maxCoeff(), 1e-6);
    }
}

TEST(HeldInput, ADelayOfAHeldInputMovesItsJumps) {
    const SystemPtr system = compileText(delayedText, "Delayed", {"T", "a"});
    const SampledInputs inputs = commands(120, 2, 1, 0.1, 0.02);
    const SimulationTask task = taskOf(system, inputs, true);
    const Trajectory grid = simulate(task, by(Engine::Grid, GridMethod::RungeKutta4, 1e-9));
    const Trajectory adaptive = simulate(task, by(Engine::Adaptive, GridMethod::Auto, 1e-10));
    ASSERT_FALSE(grid.failure.failed) << grid.failure.reason;
    ASSERT_FALSE(adaptive.failure.failed) << adaptive.failure.reason;
    EXPECT_LT((grid.outputs - adaptive.outputs).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LT((grid.tangents[0] - adaptive.tangents[0]).cwiseAbs().maxCoeff(), 1e-5);
    const Eigen::MatrixXd slopes = differences(task, by(Engine::Grid, GridMethod::RungeKutta4, 1e-11), 1e-5);
    EXPECT_GT(slopes.col(0).cwiseAbs().maxCoeff(), 0.1);
    EXPECT_LT((grid.tangents[0] - slopes).cwiseAbs().maxCoeff(), 1e-4);
    // delayed by whole samples, what was held there is held here: the same as a record that begins later
    const SampledInputs even = commands(80, 2, 1, 0.1, 0);
    SampledInputs shifted = even;
    for (int k = 0; k < 80; ++k) shifted.values(0, k) = even.values(0, std::max(0, k - 2));
    SimulationTask late = taskOf(system, even), plain = taskOf(system, shifted);
    late.parameters[static_cast<std::size_t>(system->parameterIndex("T"))] = 0.2;
    plain.parameters[static_cast<std::size_t>(system->parameterIndex("T"))] = 0;
    for (const Engine engine : {Engine::Grid, Engine::Adaptive}) {
        const SimulationOptions options = by(engine, GridMethod::Auto, 1e-10);
        EXPECT_LT((simulate(late, options).outputs - simulate(plain, options).outputs).cwiseAbs().maxCoeff(), 1e-7);
    }
}

TEST(HeldInput, AJumpEndsAndBeginsWhatFrictionHolds) {
    const SystemPtr system = compileText(R"(
model Brake
  input Real u;
  output Real w;
equation
  der(w) = u - (if w > 0 then 1 else -1);
initial equation
  w = 0;
end Brake;
)",
                                         "Brake");
    SampledInputs inputs;
    inputs.held = {1};
    inputs.values.resize(1, 51);
    for (int k = 0; k <= 50; ++k) {
        inputs.time.push_back(0.1 * k);
        inputs.values(0, k) = k < 10 ? 0.5 : k < 20 ? 2.0 : k < 40 ? 0.0 : -3.0;
    }
    const Trajectory run = simulate(taskOf(system, inputs), by(Engine::Adaptive, GridMethod::Auto, 1e-8));
    ASSERT_FALSE(run.failure.failed) << run.failure.reason;
    for (int k = 0; k <= 50; ++k) {
        const double t = 0.1 * k;
        const double w = t < 1 ? 0 : t < 2 ? t - 1 : t < 3 ? 3 - t : t < 4 ? 0 : -2 * (t - 4);
        EXPECT_NEAR(run.outputs(0, k), w, 1e-6) << "t = " << t;
    }
}

TEST(HeldInput, WhatJumpsHasNoSlope) {
    const SystemPtr system = compileText(R"(
model Slope
  input Real u;
  input Real v;
  output Real y;
  Real x(start = 0, fixed = true);
equation
  der(x) = der(v) - x + u;
  y = x;
end Slope;
)",
                                         "Slope");
    SampledInputs inputs = commands(30, 2, 0, 0.1, 0);
    inputs.held = {1, 0};
    EXPECT_FALSE(simulate(taskOf(system, inputs)).failure.failed);
    inputs.held = {0, 1};
    EXPECT_EQ(simulate(taskOf(system, inputs)).failure.reason, "the model needs the slope of an input that is held");
}

TEST(HeldInput, KinksAreWhereItJumps) {
    SampledInputs inputs;
    inputs.held = {1};
    inputs.time = {0, 1, 2, 3, 4, 5};
    inputs.values.resize(1, 6);
    inputs.values << 0, 1, 2, 2, 2, 3;
    EXPECT_EQ(jumpsOf(inputs), (std::vector<int>{1, 2, 5}));
    EXPECT_EQ(trueKinks(inputs), (std::vector<int>{0, 1, 2, 5}));
}

}  // namespace
}  // namespace analogon
