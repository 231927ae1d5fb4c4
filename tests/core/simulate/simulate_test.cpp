#include "core/simulate/simulate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <random>
#include <thread>

#include "core/base/stop.hpp"
#include "tests/core/simulate/text_models.hpp"

namespace analogon {
namespace {

using test::compileText;
using test::ownParameters;

SampledInputs oneInput(int count, double step, const std::function<double(double)>& u) {
    SampledInputs inputs;
    inputs.values.resize(1, count);
    for (int k = 0; k < count; ++k) {
        inputs.time.push_back(k * step);
        inputs.values(0, k) = u(k * step);
    }
    return inputs;
}

SimulationTask taskOf(const SystemPtr& system, const SampledInputs& inputs, bool withTangents = false) {
    SimulationTask task;
    task.system = system.get();
    task.inputs = &inputs;
    task.parameters = ownParameters(*system);
    if (withTangents) task.directions = Eigen::MatrixXd::Identity(system->parameterCount(), system->parameterCount());
    return task;
}

SampledInputs noisyVoltage(int count) {
    std::mt19937 random(4);
    std::normal_distribution<double> normal;
    return oneInput(count, 1e-3,
                    [&](double t) { return 6.0 * (std::sin(9.0 * t) > 0 ? 1.0 : -0.5) + 0.2 * normal(random); });
}

TEST(Simulate, GridAndAdaptiveEnginesAgreeOnAMotorWithNoisyVoltage) {
    const SystemPtr system = compileText(test::motorText, "Motor", {"R", "k", "J2"});
    ASSERT_TRUE(system);
    const SampledInputs inputs = noisyVoltage(1500);
    const SimulationTask task = taskOf(system, inputs, true);
    const Trajectory grid = simulate(task);
    ASSERT_FALSE(grid.failure.failed) << grid.failure.reason;
    EXPECT_EQ(grid.engine, Engine::Grid);
    EXPECT_LT(grid.plan.errorEstimate, 2e-5);
    SimulationOptions tight;
    tight.relativeTolerance = 1e-8;
    tight.absoluteTolerance = 1e-11;
    const Trajectory reference = simulateAdaptive(task, tight);
    ASSERT_FALSE(reference.failure.failed) << reference.failure.reason;
    for (Eigen::Index o = 0; o < 2; ++o) {
        const double range = reference.outputs.row(o).maxCoeff() - reference.outputs.row(o).minCoeff();
        EXPECT_LT((grid.outputs - reference.outputs).row(o).cwiseAbs().maxCoeff(), 5e-5 * range);
        const Eigen::MatrixXd& expected = reference.tangents[static_cast<std::size_t>(o)];
        const Eigen::MatrixXd gap = grid.tangents[static_cast<std::size_t>(o)] - expected;
        for (Eigen::Index k = 0; k < 3; ++k) {
            EXPECT_LT(gap.col(k).cwiseAbs().maxCoeff(), 1e-3 * expected.col(k).cwiseAbs().maxCoeff());
        }
    }
}

TEST(Simulate, StopsWithinASingleInterval) {
    const SystemPtr system = compileText(test::motorText, "Motor", {"R"});
    ASSERT_TRUE(system);
    const SampledInputs inputs = oneInput(2, 1.0, [](double t) { return 6.0 * t; });
    for (const GridMethod method : {GridMethod::Esdirk, GridMethod::RungeKutta4}) {
        const GridPlan plan{method, 1'000'000'000, 0.0};  // minutes
        std::stop_source source;
        const std::jthread other([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(30));
            source.request_stop();
        });
        const std::clock_t begin = std::clock();
        const Trajectory y = simulateGrid(taskOf(system, inputs, true), plan, {}, Progress(source.get_token(), {}));
        EXPECT_TRUE(y.failure.failed);
        EXPECT_EQ(y.failure.reason, "cancelled");
        EXPECT_TRUE(y.failure.variable.empty()) << y.failure.variable;
        EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 0.3);
    }
}

TEST(Simulate, IsStoppedByWhatIsInForceForTheThread) {
    const SystemPtr system = compileText(test::motorText, "Motor", {"R"});
    ASSERT_TRUE(system);
    const SampledInputs inputs = noisyVoltage(1500);
    std::stop_source source;
    source.request_stop();
    const StopScope scope(source.get_token());
    EXPECT_EQ(simulate(taskOf(system, inputs)).failure.reason, "cancelled");
    const std::stop_source nobody;
    EXPECT_FALSE(simulate(taskOf(system, inputs), {}, Progress(nobody.get_token(), {})).failure.failed)
        << "asked by somebody else";
}

TEST(Simulate, TakesTheImplicitMethodForAStiffMotor) {
    const SystemPtr system = compileText(test::motorText, "Motor", {"L"});
    ASSERT_TRUE(system);
    SampledInputs inputs = noisyVoltage(4000);
    inputs.time.back() += 1e-4 * (inputs.time[1] - inputs.time[0]);  // not equidistant: no exact steps
    SimulationTask task = taskOf(system, inputs, true);
    task.parameters = {1e-7};
    const Trajectory y = simulate(task);
    ASSERT_FALSE(y.failure.failed) << y.failure.reason;
    EXPECT_EQ(y.plan.method, GridMethod::Esdirk);
    EXPECT_TRUE(y.tangents[1].allFinite());
}

TEST(Simulate, TellsALoopWithoutASolutionFromANumberThatIsNotFinite) {
    const SystemPtr system = compileText(R"(
model Throttle
  input Real drop;
  output Real level;
  Real inflow(start = 1);
  Real x(start = 0, fixed = true);
equation
  inflow^2 + inflow^4 = drop;
  der(x) = inflow - x;
  level = x;
end Throttle;
)",
                                         "Throttle");
    ASSERT_TRUE(system);
    SampledInputs inputs;
    inputs.values.resize(1, 50);
    for (int k = 0; k < 50; ++k) {
        inputs.time.push_back(0.1 * k);
        inputs.values(0, k) = 2.0 - 0.1 * k;  // none from 2 s on
    }
    const Trajectory y = simulateGrid(taskOf(system, inputs, false), {GridMethod::RungeKutta4, 1, 0.0});
    EXPECT_TRUE(y.failure.failed);
    EXPECT_EQ(y.failure.reason, "no convergence of an algebraic loop");
    EXPECT_EQ(y.failure.variable, "inflow");
    EXPECT_NEAR(y.failure.time, 2.0, 0.11);
}

TEST(Simulate, TakesExactStepsWhereTheModelIsLinear) {
    const SystemPtr system = compileText(test::motorText, "Motor", {"R", "J2", "c"});
    ASSERT_TRUE(system);
    const SampledInputs inputs = noisyVoltage(600);
    const SimulationTask task = taskOf(system, inputs, true);
    const Trajectory exact = simulate(task);
    ASSERT_EQ(exact.plan.method, GridMethod::Exact);
    const Trajectory fine = simulateGrid(task, {GridMethod::RungeKutta4, 64, 0.0});
    ASSERT_FALSE(exact.failure.failed);
    EXPECT_LT((exact.outputs - fine.outputs).cwiseAbs().maxCoeff(), 1e-8 * fine.outputs.cwiseAbs().maxCoeff());
    for (std::size_t o = 0; o < 2; ++o) {
        const Eigen::MatrixXd gap = exact.tangents[o] - fine.tangents[o];
        for (Eigen::Index k = 0; k < 3; ++k)
            EXPECT_LT(gap.col(k).cwiseAbs().maxCoeff(), 1e-7 * fine.tangents[o].col(k).cwiseAbs().maxCoeff());
    }
}

void expectSame(const Trajectory& a, const Trajectory& b) {
    EXPECT_LT((a.outputs - b.outputs).cwiseAbs().maxCoeff(), 1e-12 * b.outputs.cwiseAbs().maxCoeff());
    for (std::size_t o = 0; o < b.tangents.size(); ++o)
        EXPECT_LT((a.tangents[o] - b.tangents[o]).cwiseAbs().maxCoeff(), 1e-11 * b.tangents[o].cwiseAbs().maxCoeff());
}

TEST(Simulate, GivesTheSameWhateverRunsIt) {
    const SystemPtr system = compileText(test::motorText, "Motor", {"R", "J2", "c"});
    ASSERT_TRUE(system);
    const SampledInputs inputs = noisyVoltage(600);
    SimulationTask task = taskOf(system, inputs, true);
    // What is observed keeps the interpreter from whole stretches: it evaluates the programs one by one.
    SimulationTask single = task;
    single.observe = {"tau"};
    single.execution = Execution::Interpreted;
    const GridPlan plan{GridMethod::RungeKutta4, 2, 0.0};
    const Trajectory reference = simulateGrid(single, plan), byCode = simulateGrid(task, plan);
    expectSame(byCode, reference);
    const Trajectory exact = simulateGrid(task, {GridMethod::Exact, 1, 0.0});
    for (const Execution execution : {Execution::Avx2, Execution::Interpreted}) {
        SCOPED_TRACE(static_cast<int>(execution));
        task.execution = execution;
        expectSame(simulateGrid(task, plan), reference);
        expectSame(simulateGrid(task, {GridMethod::Exact, 1, 0.0}), exact);
    }
    // Exact steps that are looked at one by one.
    expectSame(simulateGrid(single, {GridMethod::Exact, 1, 0.0}), exact);
}

TEST(Simulate, PlansAnewWhereAnExactPlanMeetsAModelThatIsNotLinear) {
    // the plan of a linear model, and a drag that has joined it: explicit steps of the samples would not be stable
    const SystemPtr system = compileText(R"(model Fast
  input Real u;
  output Real x(start = 0, fixed = true);
equation
  der(x) = 2000*(u - x) - 0.5*x*abs(x);
end Fast;
)",
                                         "Fast");
    ASSERT_TRUE(system);
    SampledInputs inputs;
    inputs.values.resize(1, 200);
    for (int k = 0; k < 200; ++k) {
        inputs.time.push_back(0.04 * k);
        inputs.values(0, k) = std::sin(0.3 * k);
    }
    const SimulationTask task = taskOf(system, inputs);
    const Trajectory y = simulateGrid(task, {GridMethod::Exact, 1, 0.0});
    ASSERT_FALSE(y.failure.failed) << y.failure.reason;
    EXPECT_NE(y.plan.method, GridMethod::Exact);
    const Trajectory reference = simulateAdaptive(task);
    EXPECT_LT((y.outputs - reference.outputs).cwiseAbs().maxCoeff(), 1e-4);
}

/// A run of a motor that keeps its states and is observed.
struct ObservedMotor {
    SystemPtr system = compileText(test::motorText, "Motor");
    SampledInputs inputs = noisyVoltage(300);
    SimulationTask task = taskOf(system, inputs);
    Trajectory y;

    ObservedMotor() {
        task.keepStates = true;
        task.observe = {"tau", "no.such.variable", "w2"};
        y = simulate(task);
    }
};

TEST(Simulate, KeepsStatesAndObservesVariables) {
    const ObservedMotor motor;
    const Trajectory& y = motor.y;
    ASSERT_FALSE(y.failure.failed);
    ASSERT_EQ(y.states.rows(), 5);
    ASSERT_EQ(y.observed.rows(), 3);
    EXPECT_TRUE(y.observed.row(0).allFinite());
    EXPECT_GT(y.observed.row(0).cwiseAbs().maxCoeff(), 0.0);
    EXPECT_TRUE(std::isnan(y.observed(1, 10)));
    EXPECT_LT((y.observed.row(2) - y.outputs.row(1)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Simulate, ObservesAlongKnownStates) {
    const ObservedMotor motor;
    const SimulationTask& task = motor.task;
    const Trajectory& y = motor.y;
    ASSERT_FALSE(y.failure.failed);
    const std::optional<Eigen::MatrixXd> seen = observeAlong(task, y.states);
    ASSERT_TRUE(seen);
    for (const Eigen::Index row : {0, 2})
        EXPECT_LT((seen->row(row) - y.observed.row(row)).cwiseAbs().maxCoeff(), 1e-12) << row;
    EXPECT_TRUE(std::isnan((*seen)(1, 10)));
    EXPECT_FALSE(observeAlong(task, y.states.topRows(4))) << "states of another model";
    EXPECT_FALSE(observeAlong(task, y.states.leftCols(299))) << "of another recording";
}

TEST(Simulate, LocatesTheEventWhereATankRunsEmpty) {
    const SystemPtr system = compileText(R"(
model Tank
  output Real y;
  parameter Real a = 0.1;
  Real h(start = 1, fixed = true);
equation
  der(h) = if h > 0 then -a*sqrt(max(h, 0)) else 0;
  y = h;
end Tank;
)",
                                         "Tank", {"a"});
    ASSERT_TRUE(system);
    const SampledInputs inputs = [] {
        SampledInputs empty;
        for (int k = 0; k < 61; ++k) empty.time.push_back(0.5 * k);
        empty.values.resize(0, 61);
        return empty;
    }();
    const Trajectory y = simulateAdaptive(taskOf(system, inputs));
    ASSERT_FALSE(y.failure.failed) << y.failure.reason << " at " << y.failure.time;
    for (int k = 0; k < 61; ++k) {
        const double root = std::max(0.0, 1.0 - 0.05 * 0.5 * k);  // sqrt(h) falls with a / 2, empty at 20 s
        EXPECT_NEAR(y.outputs(0, k), root * root, 1e-5) << k;
    }
}

TEST(Simulate, DelaysInputsAndOutputs) {
    const SystemPtr system = compileText(R"(
model Delays
  input Real u;
  output Real y;
  output Real z;
  parameter Real T = 0.35;
  parameter Real T2 = 0.2;
  Real x(start = 0, fixed = true);
  Real ud;
equation
  ud = delay(u, T2);
  der(x) = ud - x;
  y = x;
  z = delay(y, T);
end Delays;
)",
                                         "Delays", {"T", "T2"});
    ASSERT_TRUE(system);
    const SampledInputs inputs = oneInput(200, 0.05, [](double t) { return t; });
    const SimulationTask task = taskOf(system, inputs, true);
    for (const Trajectory& trajectory : {simulate(task), simulateAdaptive(task)}) {
        ASSERT_FALSE(trajectory.failure.failed) << trajectory.failure.reason;
        double worst[3]{};
        for (int k = 0; k < 200; ++k) {
            const double s = std::max(0.0, 0.05 * k - 0.55);
            const double x = s - 1.0 + std::exp(-s);
            const double slope = s > 0 ? std::exp(-s) - 1.0 : 0.0;  // of z in either delay
            worst[0] = std::max(worst[0], std::abs(trajectory.outputs(1, k) - x));
            worst[1] = std::max(worst[1], std::abs(trajectory.tangents[1](k, 0) - slope));
            worst[2] = std::max(worst[2], std::abs(trajectory.tangents[1](k, 1) - slope));
        }
        EXPECT_LT(worst[0], 1e-5);
        EXPECT_LT(worst[1], 1e-4);
        EXPECT_LT(worst[2], 1e-4);
    }
}

TEST(Simulate, RefusesADelayOfADelayedSignal) {
    const SystemPtr system = compileText(R"(
model Chain
  input Real u;
  output Real y;
  Real x(start = 1, fixed = true);
  Real z;
equation
  der(x) = u - x;
  z = delay(x, 0.3) + x;
  y = delay(z, 0.2);
end Chain;
)",
                                         "Chain");
    ASSERT_TRUE(system);
    const SampledInputs inputs = oneInput(50, 0.05, [](double) { return 0.0; });
    const Trajectory y = simulateGrid(taskOf(system, inputs), {});
    EXPECT_TRUE(y.failure.failed);
    EXPECT_EQ(y.failure.reason, "a delay of a delayed signal cannot be simulated");
}

TEST(Simulate, RefusesInputsThatDoNotFit) {
    const SystemPtr system = compileText(test::motorText, "Motor");
    ASSERT_TRUE(system);
    SampledInputs inputs = noisyVoltage(10);
    inputs.values(0, 4) = std::nan("");
    EXPECT_EQ(simulate(taskOf(system, inputs)).failure.reason, "an input is not finite");
    inputs.values.resize(2, 10);
    EXPECT_TRUE(simulate(taskOf(system, inputs)).failure.failed);
}

TEST(Simulate, NamesTheVariableThatFails) {
    const SystemPtr system = compileText(R"(
model Root
  input Real u;
  output Real y;
  Real x(start = 1, fixed = true);
equation
  der(x) = -1;
  y = sqrt(x) + 0*u;
end Root;
)",
                                         "Root");
    ASSERT_TRUE(system);
    const SampledInputs inputs = oneInput(30, 0.1, [](double) { return 0.0; });
    const Trajectory y = simulate(taskOf(system, inputs));
    EXPECT_TRUE(y.failure.failed);
    EXPECT_NEAR(y.failure.time, 1.1, 0.11);
    EXPECT_EQ(y.failure.reason, "not finite");
    EXPECT_THAT(y.failure.variable, ::testing::HasSubstr("y"));
}

TEST(Simulate, AStateThatGrowsWithoutBoundInFiniteTimeIsFollowedNoFurtherThanRounding) {
    const SystemPtr system = compileText(
        "model M\n input Real u;\n output Real y;\n Real x(start=1, fixed=true);\n"
        "equation\n der(x) = 0.1*x^2;\n y = x + u;\nend M;\n",
        "M");
    ASSERT_TRUE(system);
    const SampledInputs inputs{{0, 5, 20}, Eigen::MatrixXd::Zero(1, 3)};
    const Trajectory y = simulateAdaptive(taskOf(system, inputs));
    EXPECT_TRUE(y.failure.failed);
    EXPECT_EQ(y.failure.reason, "the step became too small for the tolerance");
    EXPECT_EQ(y.failure.variable, "x");
    EXPECT_NEAR(y.failure.time, 10.0, 0.01);  // x = 1 / (1 - t/10)
}

}  // namespace
}  // namespace analogon
