#include "core/fit/clock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/fit/profile.hpp"
#include "tests/core/fit/motor_problem.hpp"
#include "tests/core/fit/slopes.hpp"

namespace analogon {
namespace {

using test::compileText;
using test::expectSlopesOf;
using test::ownParameters;
using test::parameter;
using test::steps;

TEST(TimeStencil, IsExactForAParabolaBetweenUnequalSamples) {
    const std::vector<double> time{0.0, 0.1, 0.25, 0.3, 0.5, 0.9};
    const auto parabola = [](double t) { return 2.0 - 3.0 * t + 4.0 * t * t; };
    const auto at = [&](int k) { return parabola(time[static_cast<std::size_t>(k)]); };
    for (const double t : {0.13, 0.25, 0.29, 0.41}) {
        const TimeStencil stencil = stencilAt(time, t);
        EXPECT_NEAR(stencil.value(at), parabola(t), 1e-14) << t;
        EXPECT_NEAR(stencil.slope(at), -3.0 + 8.0 * t, 1e-13) << t;
    }
    EXPECT_EQ(stencilAt(time, -1.0).value(at), parabola(0.0));
    EXPECT_EQ(stencilAt(time, 2.0).value(at), parabola(0.9));
    EXPECT_EQ(stencilAt(time, 2.0).slope(at), 0.0);
}

TEST(OnLinesAt, DrawsALateColumnEarlierOnItsLines) {
    const std::vector<double> time{0.0, 1.0, 2.0, 4.0};
    Eigen::RowVectorXd column(4);
    column << 0.0, 0.0, 6.0, 2.0;
    Eigen::RowVectorXd expected(4);
    expected << 0.0, 3.0, 5.0, 2.0;
    EXPECT_TRUE(onLinesAt(time, column, 0.5).isApprox(expected));
    expected << 0.0, 0.0, 3.0, 3.0;
    EXPECT_TRUE(onLinesAt(time, column, -0.5).isApprox(expected));
    EXPECT_TRUE(onLinesAt(time, column, 0.0).isApprox(column));
}

TEST(TimeStencil, MovesSmoothlyPastASample) {
    const std::vector<double> time{0.0, 1.0, 2.0, 3.0, 4.0};
    const auto at = [](int k) { return k == 2 ? 1.0 : 0.0; };
    const double step = 1e-9;
    const TimeStencil before = stencilAt(time, 2.0 - step), after = stencilAt(time, 2.0 + step);
    EXPECT_NEAR(before.value(at), after.value(at), 1e-8);
    EXPECT_NEAR(before.slope(at), after.slope(at), 1e-7);
}

constexpr double late = 0.037;  // [s]

/// A motor whose speed was recorded by a logger with a clock of its own, 37 ms ahead: every 4 ms, and noise.
FitProblem lateSpeed(double sigma, unsigned seed = 9) {
    constexpr int count = 2500, fine = 4;  // samples of the recording, and of the truth in each of their intervals
    const SystemPtr system = compileText(test::motorText, "Motor", {"R", "k", "J2"});
    FitExperiment experiment;
    experiment.name = "steps";
    experiment.system = system;
    experiment.inputs = steps(count, 4e-3, 6.0, 1.7);
    experiment.parameters = ownParameters(*system);
    SampledInputs inputs;  // the same, on the lines between its samples
    inputs.values.resize(1, fine * (count - 1) + 1);
    for (Eigen::Index j = 0; j < inputs.values.cols(); ++j) {
        const Eigen::Index k = std::min<Eigen::Index>(j / fine, count - 2);
        const double part = static_cast<double>(j - fine * k) / fine;
        inputs.time.push_back(1e-3 * static_cast<double>(j));
        inputs.values(0, j) = (1.0 - part) * experiment.inputs.values(0, k) + part * experiment.inputs.values(0, k + 1);
    }
    SimulationTask task;
    task.system = system.get();
    task.inputs = &inputs;
    task.parameters = experiment.parameters;
    const Eigen::MatrixXd exact = simulate(task).outputs;
    experiment.measured.setConstant(2, count, std::nan(""));
    experiment.weights.resize(2);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (Eigen::Index o = 0; o < 2; ++o) {
        const double level = sigma * (exact.row(o).maxCoeff() - exact.row(o).minCoeff());
        experiment.weights[o] = 1.0 / level;
        // 25 samples at either end may lie outside what was recorded.
        for (Eigen::Index k = o == 0 ? 0 : 25; k < (o == 0 ? count : count - 25); ++k)
            experiment.measured(o, k) = exact(o, fine * k - (o == 0 ? 0 : 37)) + level * normal(random);
    }
    experiment.clocks = {{1, 0.0}};
    FitProblem problem;
    problem.experiments.push_back(std::move(experiment));
    for (const char* const name : {"R", "k", "J2"}) {
        const double value = system->parameters()[static_cast<std::size_t>(system->parameterIndex(name))].value;
        problem.parameters.push_back(parameter(name, 1.2 * value, 0.01 * value, 100.0 * value));
    }
    problem.parameters.push_back(parameter("clock w_meas", 0.0, -0.1, 0.1));
    return problem;
}

void expectTruth(const FitProblem& problem, const FitResult& result, double errors) {
    ASSERT_EQ(result.status, FitStatus::Converged) << result.message;
    for (const FitEstimate& estimate : result.estimates) {
        const int index = problem.experiments[0].system->parameterIndex(estimate.name);
        const double truth =
            index < 0 ? late : problem.experiments[0].system->parameters()[static_cast<std::size_t>(index)].value;
        EXPECT_NEAR(estimate.value, truth, errors * estimate.standardError) << estimate.name;
    }
}

TEST(Clock, OfALateChannelIsFoundWithTheOtherParameters) {
    const FitProblem problem = lateSpeed(0.02);
    const FitResult result = fit(problem);
    expectTruth(problem, result, 3.0);
    EXPECT_LT(result.estimates[3].standardError, 1e-3);
    EXPECT_NEAR(2.0 * result.cost / problem.residualCount(), 1.0, 0.05);
    // Without it the others are far off.
    FitProblem blind = problem;
    blind.parameters.pop_back();
    const FitResult biased = fit(blind);
    EXPECT_GT(std::abs(biased.values[2] - result.values[2]), 20.0 * result.estimates[2].standardError);
}

TEST(Clock, IsFoundBySearchesWithoutSlopesToo) {
    const FitProblem problem = lateSpeed(0.02);
    FitOptions options;
    options.method = FitMethod::NelderMead;
    expectTruth(problem, fit(problem, options), 3.0);
}

TEST(Clock, IsKnownAsWellAsItsStandardErrorSays) {
    double squares = 0.0;
    constexpr int draws = 12;
    for (unsigned seed = 1; seed <= draws; ++seed) {
        const FitResult result = fit(lateSpeed(0.02, seed));
        const double z = (result.values[3] - late) / result.estimates[3].standardError;
        squares += z * z;
    }
    EXPECT_GT(squares / draws, 0.2);
    EXPECT_LT(squares / draws, 2.5);
}

TEST(Clock, MovesTheResidualsAsItsSlopesSay) {
    const FitProblem problem = lateSpeed(0.02);
    Eigen::VectorXd at = problem.startValues();
    at[3] = 0.0213;
    const std::vector<GridPlan> plans{planFor(problem, 0, at)};
    const Linearisation line = linearise(problem, at, true, plans);
    ASSERT_TRUE(line.ok) << line.failure;
    expectSlopesOf(problem, at, plans, line, 5e-5);
}

TEST(Clock, MayBeKnownInsteadOfFitted) {
    FitProblem problem = lateSpeed(0.02);
    problem.parameters.pop_back();
    problem.experiments[0].clocks[0].offset = late;
    expectTruth(problem, fit(problem), 3.0);
}

TEST(Clock, HasAProfile) {
    const FitProblem problem = lateSpeed(0.02);
    const FitResult best = fit(problem);
    const ConfidenceInterval interval = profile(problem, best, 3);
    const double error = best.estimates[3].standardError;
    EXPECT_NEAR(interval.lower, best.values[3] - 1.96 * error, 0.2 * error);
    EXPECT_NEAR(interval.upper, best.values[3] + 1.96 * error, 0.2 * error);
}

TEST(Clock, IsUnknownWhereNoOutputHasOne) {
    FitProblem problem = lateSpeed(0.02);
    problem.experiments[0].clocks.clear();
    EXPECT_THAT(fit(problem).message, ::testing::HasSubstr("clock w_meas is no free parameter of the model"));
}

}  // namespace
}  // namespace analogon
