#include "core/simulate/step_schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "tests/core/simulate/pulses.hpp"
#include "tests/core/simulate/text_models.hpp"

namespace analogon {
namespace {

using test::differenceInRanges;
using test::pulses;

/// A driven rotor on a spring with sharp dry friction: it sticks, breaks loose and slips.
const char* const rotorText = R"(
model Rotor
  input Real drive;
  output Real angle;
  parameter Real J = 1.7e-4;
  parameter Real c = 0.4;
  parameter Real d = 2e-3;
  parameter Real tau_c = 0.02;
  parameter Real w_eps = 0.005;
  Real phi(start = 0, fixed = true);
  Real w(start = 0, fixed = true);
equation
  der(phi) = w;
  J*der(w) = drive - c*phi - d*w - tau_c*tanh(w/w_eps);
  angle = phi;
end Rotor;
)";

struct Rotor {
    SystemPtr system = test::compileText(rotorText, "Rotor", {"J", "c", "tau_c"});
    SampledInputs inputs = pulses(2000, 0.002);

    SimulationTask task(bool hasTangents, Execution execution = Execution::Fastest) const {
        SimulationTask task;
        task.system = system.get();
        task.inputs = &inputs;
        task.parameters = test::ownParameters(*system);
        if (hasTangents) task.directions = Eigen::MatrixXd::Identity(3, 3);
        task.execution = execution;
        return task;
    }
};

TEST(StepSchedule, PutsItsStepsWhereTheModelNeedsThem) {
    const Rotor rotor;
    for (const Execution execution : {Execution::Fastest, Execution::Interpreted}) {
        const SimulationTask task = rotor.task(false, execution);
        const GridPlan plan = planGrid(task);
        ASSERT_TRUE(plan.steps);
        EXPECT_LE(plan.errorEstimate, 1e-5);
        const Trajectory fine = simulateGrid(task, {GridMethod::Esdirk, 64, 0.0});
        EXPECT_LT(differenceInRanges(simulateGrid(task, plan).outputs, fine.outputs), 2e-5);
        // All intervals alike at the same error: several times the work.
        int substeps = 1;
        while (differenceInRanges(simulateGrid(task, {GridMethod::Esdirk, substeps, 0.0}).outputs, fine.outputs) > 2e-5)
            substeps *= 2;
        int explicitly = 1;
        while (!(differenceInRanges(simulateGrid(task, {GridMethod::RungeKutta4, explicitly, 0.0}).outputs,
                                    fine.outputs) < 2e-5))
            explicitly *= 2;
        EXPECT_LT(2.0 * plan.work(), std::min(12.0 * substeps, 1.0 * explicitly));
    }
}

TEST(StepSchedule, CarriesTheTangentsOfTheDiscreteSolution) {
    const Rotor rotor;
    for (const Execution execution : {Execution::Fastest, Execution::Interpreted}) {
        SimulationTask task = rotor.task(true, execution);
        const GridPlan plan = planGrid(task);
        ASSERT_TRUE(plan.steps);
        const Trajectory with = simulateGrid(task, plan);
        task.directions.resize(0, 0);
        const std::vector<double> p = task.parameters;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double shift = 1e-6 * p[i];
            task.parameters[i] = p[i] + shift;
            const Eigen::MatrixXd above = simulateGrid(task, plan).outputs;
            task.parameters[i] = p[i] - shift;
            const Eigen::MatrixXd below = simulateGrid(task, plan).outputs;
            task.parameters = p;
            const Eigen::VectorXd slope = (above - below).row(0).transpose() / (2.0 * shift);
            const Eigen::VectorXd tangent = with.tangents[0].col(static_cast<Eigen::Index>(i));
            EXPECT_LT((tangent - slope).cwiseAbs().maxCoeff(), 1e-4 * slope.cwiseAbs().maxCoeff()) << "parameter " << i;
        }
    }
}

TEST(StepSchedule, KeepsAPlanThatStillHolds) {
    const Rotor rotor;
    SimulationTask task = rotor.task(false);
    const GridPlan plan = planGrid(task);
    EXPECT_TRUE(planGrid(task, {}, {}, &plan) == plan);
    GridPlan coarse = plan;
    coarse.steps = std::make_shared<const std::vector<std::int16_t>>(rotor.inputs.time.size() - 1, -1);
    EXPECT_FALSE(planGrid(task, {}, {}, &coarse) == coarse);
}

TEST(StepSchedule, GivesTheRunByWhichAPlanWasJudged) {
    const Rotor rotor;
    const SimulationTask task = rotor.task(false);
    std::optional<Trajectory> taken;
    const GridPlan plan = planGrid(task, {}, {}, nullptr, &taken);
    ASSERT_TRUE(plan.steps && taken) << "put together of many runs, the steps were judged by one of all of them";
    EXPECT_EQ(taken->outputs, simulateGrid(task, plan).outputs);
    for (const bool isGlance : {false, true}) {
        SimulationOptions options;
        options.isGlance = isGlance;
        ASSERT_TRUE(planGrid(task, options, {}, &plan, &taken) == plan);
        ASSERT_TRUE(taken);
        EXPECT_EQ(taken->outputs, simulateGrid(task, plan).outputs);
    }
}

TEST(StepSchedule, JudgesAPlanOnPartsOfTheRecordWhereItIsOnlyCompared) {
    const Rotor rotor;
    const SimulationTask task = rotor.task(false);
    const GridPlan plan = planGrid(task);
    ASSERT_TRUE(plan.steps);
    SimulationOptions glance;
    glance.isGlance = true;
    const auto coarseIn = [&](int first, int last) {
        std::vector<std::int16_t> steps = *plan.steps;
        std::fill(steps.begin() + first, steps.begin() + last, std::int16_t{-1});
        return planOf(std::move(steps));
    };
    const GridPlan here = coarseIn(0, 60), between = coarseIn(560, 620);
    EXPECT_FALSE(planGrid(task, glance, {}, &here) == here);
    EXPECT_FALSE(planGrid(task, {}, {}, &between) == between);
    EXPECT_TRUE(planGrid(task, glance, {}, &between) == between) << "what is not looked at";
}

TEST(StepSchedule, TakesNoRecurrenceWhereItIsToldNotTo) {
    const Rotor rotor;
    SimulationTask task = rotor.task(false);
    const SystemPtr linear =
        test::compileText("model M input Real u; output Real y; equation der(y) = u - y; end M;", "M");
    task.system = linear.get();
    task.parameters = test::ownParameters(*linear);
    SimulationOptions options;
    EXPECT_EQ(planGrid(task, options).method, GridMethod::Exact);
    options.byRecurrence = false;
    EXPECT_EQ(planGrid(task, options).method, GridMethod::RungeKutta4);
}

TEST(StepSchedule, KeepsStepsThatAreAllAlikeWhereTheyStillHold) {
    const Rotor rotor;
    SimulationTask task = rotor.task(false);
    const GridPlan single{GridMethod::RungeKutta4, 1, 0.0};
    EXPECT_FALSE(planGrid(task, {}, {}, &single) == single) << "not beside sharp friction";
    task.parameters[static_cast<std::size_t>(rotor.system->parameterIndex("tau_c"))] = 0;
    const GridPlan many{GridMethod::RungeKutta4, 64, 0.0}, half{GridMethod::RungeKutta4, 32, 0.0};
    const GridPlan kept = planGrid(task, {}, {}, &many);
    EXPECT_TRUE(kept == half) << "they were judged, and half of them are still far more than is asked for";
    EXPECT_LE(kept.errorEstimate, 10 * SimulationOptions().relativeTolerance);
}

TEST(StepSchedule, TakesFewerStepsWhereMuchLessIsAskedFor) {
    const Rotor rotor;
    const SimulationTask task = rotor.task(false);
    const GridPlan plan = planGrid(task);
    SimulationOptions loose;
    loose.relativeTolerance *= 300;
    const GridPlan fewer = planGrid(task, loose, {}, &plan);
    EXPECT_LT(fewer.work(), plan.work());
    EXPECT_LE(fewer.errorEstimate, 10 * loose.relativeTolerance);
}

TEST(StepSchedule, DoesNotTakeThePlanOfAnotherRecording) {
    const Rotor rotor;
    const SimulationTask task = rotor.task(false);
    const GridPlan plan = planGrid(task);
    for (const std::size_t intervals : {rotor.inputs.time.size() - 40, rotor.inputs.time.size() + 400}) {
        std::vector<std::int16_t> steps(intervals, 2);
        steps.front() = 4;
        const GridPlan other = planOf(steps);
        EXPECT_TRUE(planGrid(task, {}, {}, &other) == plan) << intervals;
    }
}

TEST(StepSchedule, IsMadeWhereThePlanOfALinearModelDoesNotServe) {
    const Rotor rotor;
    const GridPlan exact{GridMethod::Exact, 1, 0.0};
    for (const bool withTangents : {false, true}) {
        const Trajectory taken = simulateGrid(rotor.task(withTangents), exact);
        EXPECT_FALSE(taken.failure.failed);
        EXPECT_TRUE(taken.plan == planGrid(rotor.task(false))) << withTangents;
    }
}

TEST(StepSchedule, TakesAnyNumberOfStepsInAnInterval) {
    const Rotor rotor;
    const SimulationTask task = rotor.task(false);
    std::vector<std::int16_t> steps(rotor.inputs.time.size() - 1, 100);
    for (std::size_t k = 0; k < steps.size(); k += 7) steps[k] = 1000;  // more than a table of rows holds
    for (std::size_t k = 3; k < steps.size(); k += 7) steps[k] = -60;
    const Trajectory y = simulateGrid(task, planOf(steps));
    ASSERT_FALSE(y.failure.failed);
    const Trajectory fine = simulateGrid(task, {GridMethod::Esdirk, 64, 0.0});
    EXPECT_LT(differenceInRanges(y.outputs, fine.outputs), 2e-5);
}

TEST(StepSchedule, OfAnotherRecordingGivesItsMostDemandingSteps) {
    const Rotor rotor;
    SimulationTask task = rotor.task(false);
    const GridPlan plan = planGrid(task);
    const SampledInputs shorter = pulses(700, 0.002);
    task.inputs = &shorter;
    const Trajectory y = simulateGrid(task, plan);
    ASSERT_FALSE(y.failure.failed);
    EXPECT_EQ(y.outputs, simulateGrid(task, {plan.method, plan.substeps, 0.0}).outputs);
}

TEST(StepSchedule, BoundsTheSpectralRadiusFromAbove) {
    // Eigenvalues -1e4 and -3 of badly scaled, far from normal coordinates; a rotation by 7.
    double lag[] = {-1e4, 1e6, 0, -3}, turn[] = {0, 7e3, -7e-3, 0}, scratch[4];
    const double ofLag = spectralRadius(lag, scratch, 2), ofTurn = spectralRadius(turn, scratch, 2);
    EXPECT_GE(ofLag, 0.999e4);
    EXPECT_LE(ofLag, 1.25e4);
    EXPECT_GE(ofTurn, 6.99);
    EXPECT_LE(ofTurn, 8.75);
    double nothing[] = {0};
    EXPECT_EQ(spectralRadius(nothing, scratch, 1), 0.0);
}

TEST(StepSchedule, StopsAtABoundOfTheSpectralRadiusThatIsEnough) {
    // What is decided by an early bound is what the last one would have decided.
    for (int n = 1; n <= 10; ++n)
        for (unsigned seed = 0; seed < 50; ++seed) {
            std::srand(seed);
            const Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(n, n);
            Eigen::MatrixXd full = matrix, scratch(n, n);
            const double radius = spectralRadius(full.data(), scratch.data(), n);
            for (const double share : {0.5, 0.99, 1.01, 2.0, 10.0}) {
                Eigen::MatrixXd early = matrix;
                const double bound = spectralRadius(early.data(), scratch.data(), n, share * radius);
                EXPECT_GE(bound, radius * (1.0 - 1e-12));
                EXPECT_EQ(bound <= share * radius, share > 1.0) << n << ' ' << seed;
            }
        }
}

}  // namespace
}  // namespace analogon
