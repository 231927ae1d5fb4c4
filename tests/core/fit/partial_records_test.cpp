#include "core/fit/partial_records.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <stdexcept>

#include "tests/core/fit/motor_problem.hpp"

namespace analogon {
namespace {

using test::compileText;
using test::motorProblem;
using test::ownParameters;
using test::parameter;
using test::simulated;
using test::steps;

const char* const wireText = R"(
model Wire "current of a heated wire whose resistance grows with its temperature"
  input Real u(unit = "V");
  output Real i(unit = "A");
  parameter Real R = 3;
  parameter Real a = 2e-3;
  parameter Real C = 1.5;
  parameter Real G = 0.05;
  Real T(start = 300, fixed = true);
equation
  i = u/(R*(1 + a*(T - 300)));
  C*der(T) = u*i - G*(T - 300);
end Wire;
)";

/// A time constant of 30 s, sampled at 100 Hz.
FitProblem wireProblem(const SampledInputs& inputs) {
    const SystemPtr system = compileText(wireText, "Wire", {"R", "a", "C", "G"});
    FitProblem problem;
    problem.experiments.push_back(simulated("steps", system, inputs, ownParameters(*system), 0.02, 3));
    problem.parameters = {parameter("R", 5.0, 0.5, 50.0), parameter("C", 4.0, 0.1, 50.0),
                          parameter("G", 0.15, 1e-3, 1.0)};
    return problem;
}

FitProblem wireProblem() { return wireProblem(steps(15'000, 0.01, 12.0, 20.0)); }

FitResult fitAll(const FitProblem& problem, FitOptions options = {}) {
    options.beginsWithPart = false;
    return fit(problem, options);
}

/// The same optimum, far within what the data tell.
void expectSameOptimum(const FitResult& result, const FitResult& reference) {
    ASSERT_EQ(result.status, FitStatus::Converged) << result.message;
    EXPECT_LT(std::abs(result.cost / reference.cost - 1), 1e-8);
    for (Eigen::Index i = 0; i < reference.values.size(); ++i)
        EXPECT_NEAR(result.values[i], reference.values[i],
                    1e-2 * reference.estimates[static_cast<std::size_t>(i)].standardError)
            << reference.estimates[static_cast<std::size_t>(i)].name;
}

/// The part is looked at, and given up: all goes on as if it had not been.
void expectGivenUp(const FitProblem& problem) {
    const FitResult result = fit(problem), reference = fitAll(problem);
    EXPECT_GT(result.partSimulations, 0);
    EXPECT_EQ(result.values, reference.values);
    EXPECT_EQ(result.cost, reference.cost);
    EXPECT_EQ(result.startCost, reference.startCost);
    EXPECT_EQ(result.iterations, reference.iterations);
}

TEST(PartialRecords, TheHeadLeavesFewPassesOverAll) {
    const FitProblem problem = motorProblem(20'000, 0.005);
    const auto part = partOf(problem, problem.startValues(), {});
    ASSERT_TRUE(part);
    EXPECT_FALSE(part->isThinned);
    EXPECT_EQ(part->problem.experiments[0].inputs.time.size(), 2000u);
    const FitResult result = fit(problem), reference = fitAll(problem);
    expectSameOptimum(result, reference);
    EXPECT_LE(result.simulations, 4);
    EXPECT_GT(result.partSimulations, 3);
    EXPECT_GT(result.partIterations, 2);
    EXPECT_LT(result.iterations, reference.iterations);
    EXPECT_TRUE(std::isnan(result.startCost));
    EXPECT_EQ(reference.partSimulations, 0);
}

TEST(PartialRecords, ASlowModelNeedsEveryTenthSample) {
    const FitProblem problem = wireProblem();
    const auto part = partOf(problem, problem.startValues(), {});
    ASSERT_TRUE(part);
    EXPECT_TRUE(part->isThinned);
    EXPECT_EQ(part->problem.experiments[0].inputs.time.size(), 1500u);
    EXPECT_EQ(part->problem.experiments[0].inputs.time[7], problem.experiments[0].inputs.time[70]);
    const FitResult result = fit(problem);
    expectSameOptimum(result, fitAll(problem));
    EXPECT_LE(result.simulations, 2);
    // chosen from every tenth sample, the steps are no worse than those chosen from all
    EXPECT_EQ(result.plans[0], planFor(problem, 0, result.values));
}

TEST(PartialRecords, WhatIsKeptOfTheLastPassIsTheLinearisationThere) {
    // so long that the tenth tells where the optimum is: the pass there is known to be the last
    const FitProblem problem = wireProblem(steps(60'000, 0.01, 12.0, 20.0));
    const FitResult result = fit(problem);
    const Linearisation line = linearise(problem, result.values, true, result.plans);
    ASSERT_TRUE(result.optimum.ok);
    EXPECT_LT((result.optimum.residuals - line.residuals).norm(), 1e-7 * line.residuals.norm());
    EXPECT_LT((result.optimum.jacobian - line.jacobian).norm(), 1e-4 * line.jacobian.norm());
    EXPECT_NEAR(result.cost, 0.5 * line.residuals.squaredNorm(), 1e-9 * result.cost);
}

TEST(PartialRecords, TheLastStepNeedsNoPassOfItsOwn) {
    const FitProblem problem = wireProblem();
    const FitResult result = fit(problem);
    EXPECT_EQ(result.simulations, 2);
    // no step leads further down from there
    const Linearisation line = linearise(problem, result.values, true, result.plans);
    const ReducedMisfit there = reduce(line.jacobian, line.residuals);
    const Eigen::VectorXd step = -there.jacobian.householderQr().solve(there.residuals);
    EXPECT_LT((there.jacobian * step).squaredNorm(), 1e-12 * there.residuals.squaredNorm());
}

TEST(PartialRecords, SumsOnTheWayAreThoseOfAPassOfTheirOwn) {
    const FitProblem problem = motorProblem(1500, 0.005);
    const Eigen::VectorXd at = problem.startValues();
    const std::vector<GridPlan> plans{planFor(problem, 0, at)};
    MisfitSums sums;
    ASSERT_TRUE(linearise(problem, at, true, plans, {}, {}, &sums).ok);
    const MisfitSums alone = sumUp(problem, at, true, plans);
    ASSERT_TRUE(sums.ok);
    EXPECT_EQ(sums.squares, alone.squares);
    EXPECT_EQ(sums.gradient, alone.gradient);
    EXPECT_EQ(sums.hessian, alone.hessian);
}

TEST(PartialRecords, WhatFallsBetweenTheSamplesLeftIsNotThinned) {
    SampledInputs pulses = steps(15'000, 0.01, 12.0, 20.0);
    for (Eigen::Index k = 0; k < pulses.values.cols(); ++k)
        if (k % 3 == 0) pulses.values(0, k) = 0.0;
    const FitProblem problem = wireProblem(pulses);
    const auto part = partOf(problem, problem.startValues(), {});
    ASSERT_TRUE(part);
    EXPECT_FALSE(part->isThinned);
    expectSameOptimum(fit(problem), fitAll(problem));
}

TEST(PartialRecords, AHeadWithoutAnyMotionIsGivenUp) {
    FitProblem problem = motorProblem(12'000, 0.005);
    FitExperiment& experiment = problem.experiments[0];
    SampledInputs inputs = experiment.inputs;
    inputs.values.leftCols(3000).setZero();
    const Eigen::VectorXd weights = experiment.weights;
    experiment =
        simulated("late", experiment.system, inputs, ownParameters(*experiment.system), 1.0 / weights.maxCoeff(), 5);
    expectGivenUp(problem);
}

TEST(PartialRecords, AHeadThatSpeaksForItselfAloneIsGivenUp) {
    FitProblem problem = motorProblem(12'000, 0.005);
    FitExperiment& experiment = problem.experiments[0];
    std::vector<double> later = ownParameters(*experiment.system);
    later[0] *= 1.5;
    const FitExperiment other = simulated("", experiment.system, experiment.inputs, later, 0.0, 1);
    experiment.measured.rightCols(10'000) = other.measured.rightCols(10'000);
    expectGivenUp(problem);
}

TEST(PartialRecords, APartThatRestsAtABoundIsGivenUp) {
    FitProblem problem = wireProblem();
    problem.parameters[2].max = 0.03, problem.parameters[2].start = 0.02;
    expectGivenUp(problem);
}

TEST(PartialRecords, WhatCannotBeToldApartIsGivenUp) {
    FitProblem problem = wireProblem();  // of a, C and G only the ratios show
    problem.parameters.push_back(parameter("a", 4e-3, 1e-4, 1e-1));
    expectGivenUp(problem);
}

TEST(PartialRecords, APartThatFailsIsGivenUp) {
    FitProblem problem = motorProblem(12'000, 0.005);
    problem.beforeSimulation = [](SimulationTask& task, SimulationOptions&) {
        if (task.inputs->time.size() < 12'000) throw std::runtime_error("out of memory");
    };
    expectGivenUp(problem);
    EXPECT_EQ(fit(problem).failedSimulations, 0);
}

TEST(PartialRecords, NothingIsGainedWhereTheStartIsNear) {
    FitProblem problem = wireProblem();
    const FitResult found = fitAll(problem);
    for (std::size_t i = 0; i < problem.parameters.size(); ++i)
        problem.parameters[i].start = found.values[static_cast<Eigen::Index>(i)];
    expectGivenUp(problem);
}

TEST(PartialRecords, WhereAllIsAskedForThereIsNoPart) {
    const FitProblem problem = wireProblem();
    const auto isUsed = [](const FitProblem& p, const FitOptions& options) {
        return partOf(p, p.startValues(), options).has_value();
    };
    EXPECT_TRUE(isUsed(problem, {}));
    const FitProblem brief = motorProblem(9000, 0.005);
    EXPECT_FALSE(isUsed(brief, {}));
    FitOptions options;
    options.beginsWithPart = false;
    EXPECT_FALSE(isUsed(problem, options));
    options = {};
    options.loss = RobustLoss::Huber;
    EXPECT_FALSE(isUsed(problem, options));
    options = {};
    options.method = FitMethod::NelderMead;
    EXPECT_FALSE(isUsed(problem, options));
    options = {};
    options.simulation.engine = Engine::Adaptive;
    EXPECT_FALSE(isUsed(problem, options));
    options = {};
    options.simulation.evaluationLimit = 1'000'000;
    EXPECT_FALSE(isUsed(problem, options));
    FitProblem known = problem;
    known.parameters[0].prior = NormalPrior{3.0, 0.5};
    EXPECT_FALSE(isUsed(known, {}));
    FitProblem late = problem;
    late.experiments[0].clocks.push_back({0, 0.1});
    EXPECT_FALSE(isUsed(late, {}));
    // measured at the end alone, and between the samples that would be left
    FitProblem seldom = problem;
    for (Eigen::Index k = 0; k < 15'000; ++k)
        if (k < 7500 || k % 10 == 0) seldom.experiments[0].measured(0, k) = std::nan("");
    EXPECT_FALSE(isUsed(seldom, {}));
}

TEST(PartialRecords, ThreadsChangeNothing) {
    FitProblem several = motorProblem(15'000, 0.005);
    several.experiments.push_back(motorProblem(12'000, 0.01).experiments.front());
    several.experiments.back().name = "other";
    FitOptions options;
    for (const int starts : {3, 1}) {
        options.starts = starts;
        options.startsWithin = 1.5;
        options.threads = 1;
        const FitResult reference = fit(several, options);
        EXPECT_GT(reference.partSimulations, 0);
        for (const int threads : {2, 4}) {
            options.threads = threads;
            const FitResult result = fit(several, options);
            EXPECT_EQ(result.values, reference.values);
            EXPECT_EQ(result.cost, reference.cost);
            EXPECT_EQ(result.simulations, reference.simulations);
            EXPECT_EQ(result.partSimulations, reference.partSimulations);
        }
    }
}

}  // namespace
}  // namespace analogon
