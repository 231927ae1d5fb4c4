#include "core/fit/fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <random>

#include "tests/core/fit/motor_problem.hpp"
#include "tests/core/fit/slopes.hpp"

namespace analogon {
namespace {

using test::compileText;
using test::expectSlopesOf;
using test::motorProblem;
using test::ownParameters;
using test::parameter;
using test::simulated;
using test::steps;
using ::testing::HasSubstr;

const char* const capacitorText = R"(
model Charging "voltage of a capacitor behind a resistor, with leak"
  input Real u;
  output Real y;
  parameter Real R = 2;
  parameter Real C = 0.5;
  parameter Real G = 0;
  parameter Real y_start = 0;
  Real v(start = y_start, fixed = true);
equation
  C*der(v) = (u - v)/R - G*v;
  y = v;
end Charging;
)";

FitProblem charging(double sigma = 0.01) {
    const SystemPtr system = compileText(capacitorText, "Charging", {"R", "C"});
    FitProblem problem;
    problem.experiments.push_back(simulated("steps", system, steps(2000, 0.01, 5.0, 8.0), {3.0, 0.8}, sigma, 1));
    problem.parameters = {parameter("R", 1.0, 0.1, 100.0)};
    return problem;
}

TEST(Linearise, YieldsTheJacobianOfTheResiduals) {
    const SystemPtr system = compileText(test::motorText, "Motor", {"R", "k", "J2", "b"});
    FitProblem problem;
    problem.experiments.push_back(
        simulated("steps", system, steps(400, 1e-3, 6.0, 0.2), ownParameters(*system), 0.01, 3));
    problem.experiments[0].measured(0, 17) = std::nan("");
    problem.parameters = {parameter("k", 0.06), parameter("J2", 4e-4)};
    const Eigen::VectorXd at = (Eigen::VectorXd(2) << 0.06, 4e-4).finished();
    const std::vector<GridPlan> plans{planFor(problem, 0, at)};
    const Linearisation line = linearise(problem, at, true, plans);
    ASSERT_TRUE(line.ok) << line.failure;
    EXPECT_EQ(line.residuals.size(), 799);
    EXPECT_EQ(line.residuals.size(), problem.residualCount());
    expectSlopesOf(problem, at, plans, line, 1e-6);
}

TEST(Fit, RecoversAKnownTimeConstantWithinItsStandardError) {
    const FitProblem problem = charging();
    FitProblem both = problem;
    both.parameters.push_back(parameter("C", 2.0, 0.01, 10.0));
    // Only the product R C shows without a leak; fix C at its true value for the first.
    both.experiments[0].parameters[1] = 0.8;
    FitProblem one = problem;
    one.experiments[0].parameters[1] = 0.8;
    const FitResult result = fit(one);
    ASSERT_EQ(result.status, FitStatus::Converged) << result.message;
    EXPECT_NEAR(result.values[0], 3.0, 4.0 * result.estimates[0].standardError);
    EXPECT_LT(result.estimates[0].standardError, 0.01);
    EXPECT_NEAR(2.0 * result.cost / one.residualCount(), 1.0, 0.1);
    EXPECT_LT(result.simulations, 20);
    EXPECT_FALSE(result.estimates[0].atBound);
    EXPECT_TRUE(result.remarks.empty()) << result.remarks.front();

    const FitResult undetermined = fit(both);
    ASSERT_EQ(undetermined.status, FitStatus::Converged) << undetermined.message;
    EXPECT_NEAR(undetermined.values[0] * undetermined.values[1], 2.4, 0.02);
    EXPECT_TRUE(std::isnan(undetermined.estimates[0].standardError));
    EXPECT_TRUE(std::isnan(undetermined.estimates[1].standardError));
    ASSERT_FALSE(undetermined.remarks.empty());
    EXPECT_EQ(undetermined.remarks[0], "R and C cannot be told apart from these data: fix one");
}

TEST(Fit, RecoversEightMotorParametersFromFarStarts) {
    const FitProblem problem = motorProblem(4000, 0.005);
    const FitResult result = fit(problem);
    ASSERT_EQ(result.status, FitStatus::Converged) << result.message;
    const std::vector<double> truth = ownParameters(*problem.experiments[0].system);
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const FitEstimate& estimate = result.estimates[i];
        EXPECT_NEAR(estimate.value, truth[i], 4.5 * estimate.standardError) << estimate.name;
        EXPECT_LT(estimate.standardError, 0.2 * truth[i]) << estimate.name;
    }
    EXPECT_NEAR(2.0 * result.cost / problem.residualCount(), 1.0, 0.05);
    EXPECT_NEAR(result.correlation(0, 0), 1.0, 1e-12);
}

/// ANALOGON_REPEATS asks for more than a test of every day runs.
int repeats() {
    const char* const asked = std::getenv("ANALOGON_REPEATS");
    return asked ? std::max(1, std::atoi(asked)) : 5;
}

TEST(Fit, IsReproducibleWhateverTheThreads) {
    FitProblem several = motorProblem(300, 0.005);
    several.experiments.push_back(motorProblem(1200, 0.01).experiments.front());
    FitOptions options;
    for (const int starts : {6, 1}) {  // threads for the starts, and for the experiments
        options.starts = starts;
        options.seed = 7;
        options.threads = 1;
        const FitResult reference = fit(several, options);
        EXPECT_EQ(reference.status, FitStatus::Converged) << reference.message;
        for (const int threads : {1, 2, 4})
            for (int repeat = 0; repeat < repeats(); ++repeat) {
                options.threads = threads;
                const FitResult result = fit(several, options);
                // To the last bit: 1e-10 is what is promised.
                EXPECT_EQ(result.values, reference.values) << threads;
                EXPECT_EQ(result.cost, reference.cost) << threads;
                EXPECT_EQ(result.covariance, reference.covariance) << threads;
                EXPECT_EQ(result.simulations, reference.simulations) << threads;
            }
    }
}

TEST(Fit, ReachesABoundAndSaysSo) {
    FitProblem problem = charging();
    problem.experiments[0].parameters[1] = 0.8;
    problem.parameters = {parameter("R", 1.0, 0.1, 2.5)};
    const FitResult result = fit(problem);
    ASSERT_EQ(result.status, FitStatus::Converged) << result.message;
    EXPECT_EQ(result.values[0], 2.5);
    EXPECT_TRUE(result.estimates[0].atBound);
    ASSERT_FALSE(result.remarks.empty());
    EXPECT_EQ(result.remarks[0], "R rests at its upper bound 2.5");
}

TEST(Fit, FindsTheOptimumOfTheOthersWhenOneParameterIsHeldByItsBound) {
    const SystemPtr system = compileText(capacitorText, "Charging", {"R", "G", "y_start"});
    FitProblem problem;
    // The measurement has a negative leak, which the bound forbids.
    problem.experiments.push_back(simulated("leak", system, steps(2000, 0.01, 5.0, 8.0), {3.0, -0.02, 1.0}, 0.01, 2));
    problem.parameters = {parameter("R", 1.0, 0.1, 100.0), parameter("G", 0.05, 0.0, 1.0),
                          parameter("y_start", 0.0, -10.0, 10.0)};
    const FitResult bounded = fit(problem);
    ASSERT_EQ(bounded.status, FitStatus::Converged) << bounded.message;
    EXPECT_EQ(bounded.values[1], 0.0);
    EXPECT_TRUE(bounded.estimates[1].atBound);
    FitProblem held = problem;
    held.parameters.erase(held.parameters.begin() + 1);
    held.experiments[0].parameters[1] = 0.0;
    const FitResult reference = fit(held);
    EXPECT_NEAR(bounded.values[0], reference.values[0], 1e-5 * reference.values[0]);
    EXPECT_NEAR(bounded.values[2], reference.values[1], 1e-5);
    EXPECT_NEAR(bounded.cost, reference.cost, 1e-6 * reference.cost);
}

class WithoutSlopes : public ::testing::TestWithParam<FitMethod> {};

TEST_P(WithoutSlopes, FindsTheSameOptimumAsLeastSquares) {
    FitProblem problem = charging();
    const SystemPtr system = compileText(capacitorText, "Charging", {"R", "G"});
    problem.experiments = {simulated("leak", system, steps(1000, 0.02, 5.0, 8.0), {3.0, 0.05}, 0.01, 2)};
    problem.parameters = {parameter("R", 1.0, 0.1, 100.0), parameter("G", 0.0, -1.0, 1.0)};
    const FitResult squares = fit(problem);
    FitOptions options;
    options.method = GetParam();
    const FitResult direct = fit(problem, options);
    ASSERT_EQ(squares.status, FitStatus::Converged) << squares.message;
    ASSERT_EQ(direct.status, FitStatus::Converged) << direct.message;
    EXPECT_NEAR(direct.values[0], squares.values[0], 0.02 * squares.estimates[0].standardError);
    EXPECT_NEAR(direct.values[1], squares.values[1], 0.02 * squares.estimates[1].standardError);
    EXPECT_NEAR(direct.cost, squares.cost, 1e-6 * squares.cost);
    EXPECT_EQ(fit(problem, options).values, direct.values) << "a search at random must be the same each time";
}

INSTANTIATE_TEST_SUITE_P(Fit, WithoutSlopes,
                         ::testing::Values(FitMethod::NelderMead, FitMethod::Sbplx, FitMethod::Bobyqa, FitMethod::Crs2,
                                           FitMethod::Isres, FitMethod::Esch));

TEST(Fit, FitsALinearParameterOfTinySizeFromZeroWithoutBounds) {
    const SystemPtr system = compileText(R"(
model Radiator
  input Real q;
  output Real y;
  parameter Real C = 5;
  parameter Real k_r = 0;
  Real T(start = 300, fixed = true);
equation
  C*der(T) = q - k_r*(T^4 - 300.0^4);
  y = T;
end Radiator;
)",
                                         "Radiator", {"C", "k_r"});
    FitProblem problem;
    problem.experiments.push_back(simulated("heating", system, steps(1000, 0.5, 20.0, 200.0), {8.0, 3e-10}, 0.2, 4));
    problem.parameters = {parameter("C", 5.0, 0.1, 100.0), parameter("k_r", 0.0)};
    const FitResult result = fit(problem);
    ASSERT_EQ(result.status, FitStatus::Converged) << result.message;
    EXPECT_NEAR(result.values[1], 3e-10, 5.0 * result.estimates[1].standardError);
    EXPECT_LT(result.estimates[1].standardError, 3e-12);
}

TEST(Fit, SurvivesSimulationsThatFail) {
    // The root of a negative number for k above 0.4: most of the range fails.
    const SystemPtr system = compileText(R"(
model Draining
  input Real u;
  output Real y;
  parameter Real k = 1;
  Real h(start = 4, fixed = true);
equation
  der(h) = u - k;
  y = sqrt(h);
end Draining;
)",
                                         "Draining", {"k"});
    FitProblem problem;
    problem.experiments.push_back(simulated("tank", system, steps(200, 0.05, 0.0, 4.0), {0.38}, 0.002, 6));
    problem.parameters = {parameter("k", 0.01, 0.0, 2.0)};
    FitOptions options;
    options.starts = 4;
    const FitResult result = fit(problem, options);
    ASSERT_EQ(result.status, FitStatus::Converged) << result.message;
    EXPECT_NEAR(result.values[0], 0.38, 4.0 * result.estimates[0].standardError);
    EXPECT_GT(result.failedSimulations, 0);
    EXPECT_THAT(result.remarks, ::testing::Contains(HasSubstr("simulations failed")));
    options.method = FitMethod::NelderMead;
    const FitResult simplex = fit(problem, options);
    ASSERT_EQ(simplex.status, FitStatus::Converged) << simplex.message;
    EXPECT_NEAR(simplex.values[0], result.values[0], 1e-4);
}

TEST(Fit, LooksForABetterOptimumAboutTheStart) {
    // a wave of which another period fits best from a frequency that is told wrongly
    const SystemPtr system = compileText(R"(
model Wave
  input Real u;
  output Real y;
  parameter Real f = 1;
equation
  y = sin(f*u);
end Wave;
)",
                                         "Wave", {"f"});
    FitProblem problem;
    SampledInputs ramp = steps(400, 0.05, 0.0, 1.0);
    for (Eigen::Index k = 0; k < ramp.values.cols(); ++k) ramp.values(0, k) = 0.05 * static_cast<double>(k);
    problem.experiments.push_back(simulated("ramp", system, ramp, {2.0}, 0.01, 3));
    problem.parameters = {parameter("f", 3.1, 1e-3, 1e3)};
    EXPECT_GT(std::abs(fit(problem).values[0] - 2.0), 0.1);
    FitOptions options;
    options.starts = 16;
    options.startsWithin = 2;
    EXPECT_NEAR(fit(problem, options).values[0], 2.0, 0.01);
    // within a factor of 1.05 there is nothing better
    options.startsWithin = 1.05;
    EXPECT_GT(std::abs(fit(problem, options).values[0] - 2.0), 0.1);
}

TEST(Fit, SaysWhyItCannotStart) {
    FitProblem problem = charging();
    problem.parameters[0].name = "Rr";
    problem.parameters.push_back(parameter("C", 5.0, 0.0, 1.0));
    const FitResult result = fit(problem);
    EXPECT_EQ(result.status, FitStatus::Failed);
    EXPECT_THAT(result.message, HasSubstr("Rr is no free parameter of the model"));
    EXPECT_THAT(result.message, HasSubstr("C: the start value 5 is outside its bounds 0 to 1"));
}

TEST(Fit, ThatBeganAtTheOptimumSaysSoAndCountsNoIterations) {
    FitProblem problem = charging();
    problem.experiments[0].parameters[1] = 0.8;
    FitResult result = fit(problem);
    for (int again = 0; again < 3; ++again) {
        problem.parameters[0].start = result.values[0];
        result = fit(problem);
        ASSERT_EQ(result.status, FitStatus::Converged) << result.message;
    }
    EXPECT_EQ(result.iterations, 0);
    EXPECT_EQ(result.message.english(), "it began at the optimum");
}

TEST(Fit, ThatFailsOnItsWayKeepsTheBestAndSaysWhichParameterWentWhere) {
    FitProblem problem = charging();
    problem.experiments[0].parameters[1] = 0.8;
    std::atomic<int> simulations{0};
    problem.beforeSimulation = [&](SimulationTask&, SimulationOptions&) {
        if (++simulations > 3) throw std::runtime_error("there is no root");
    };
    const FitResult result = fit(problem);
    EXPECT_EQ(result.status, FitStatus::Failed);
    EXPECT_TRUE(std::isfinite(result.cost));
    EXPECT_LT(result.cost, result.startCost);
    EXPECT_THAT(result.message.english(), HasSubstr("there is no root"));
    EXPECT_THAT(result.message.english(), HasSubstr("the best until then is kept: R went from 1 to "));
}

TEST(Fit, SaysWhereTheSimulationAtTheStartFails) {
    const SystemPtr system = compileText(R"(
model Falling
  input Real u;
  output Real y;
  parameter Real k = 1;
  Real h(start = 1, fixed = true);
equation
  der(h) = -k + u;
  y = sqrt(h);
end Falling;
)",
                                         "Falling", {"k"});
    FitProblem problem;
    problem.experiments.push_back(simulated("fall", system, steps(21, 0.05, 0.0, 4.0), {0.5}, 0.01, 6));
    problem.parameters = {parameter("k", 5.0)};
    const FitResult result = fit(problem);
    EXPECT_EQ(result.status, FitStatus::Failed);
    EXPECT_THAT(result.message, HasSubstr("experiment 'fall' failed at t = 0.2"));
}

TEST(Fit, KeepsTheBestWhenCancelled) {
    const FitProblem problem = motorProblem(2000, 0.005);
    std::stop_source source;
    int reports = 0;
    const Progress progress(source.get_token(), [&](const Progress::Report&) {
        if (++reports == 3) source.request_stop();
    });
    const FitResult result = fit(problem, {}, progress);
    EXPECT_EQ(result.status, FitStatus::Cancelled);
    ASSERT_EQ(result.values.size(), 8);
    EXPECT_LT(result.cost, result.startCost);
    EXPECT_TRUE(std::isfinite(result.estimates.front().standardError)) << "from the slopes where it was";
    EXPECT_EQ(result.optimum.trajectories.size(), 0u) << "nobody waits for a simulation more";
}

TEST(Fit, TheIterationLimitIsNotConvergence) {
    const FitProblem problem = motorProblem(600, 0.005);
    FitOptions options;
    options.maxIterations = 2;
    const FitResult result = fit(problem, options);
    EXPECT_EQ(result.status, FitStatus::IterationLimit);
    EXPECT_THAT(result.message, HasSubstr("limit of 2 iterations"));
    EXPECT_LT(result.cost, result.startCost);
}

TEST(Fit, LeavesUnmeasuredSamplesOut) {
    FitProblem problem = charging();
    problem.experiments[0].parameters[1] = 0.8;
    for (Eigen::Index k = 100; k < 900; ++k) problem.experiments[0].measured(0, k) = std::nan("");
    const FitResult result = fit(problem);
    ASSERT_EQ(result.status, FitStatus::Converged) << result.message;
    EXPECT_EQ(problem.residualCount(), 1200);
    EXPECT_NEAR(result.values[0], 3.0, 4.0 * result.estimates[0].standardError);
}

TEST(Fit, SharesParametersBetweenExperimentsAndFitsStartsForEach) {
    const SystemPtr system = compileText(capacitorText, "Charging", {"R", "y_start"});
    FitProblem problem;
    problem.experiments.push_back(simulated("a", system, steps(500, 0.02, 5.0, 8.0), {3.0, 1.0}, 0.01, 2));
    problem.experiments.push_back(simulated("b", system, steps(700, 0.02, 3.0, 5.0), {3.0, -2.0}, 0.01, 3));
    problem.parameters = {parameter("R", 1.0, 0.1, 100.0), parameter("y_start", 0.0), parameter("y_start", 0.0)};
    problem.parameters[1].experiment = 0;
    problem.parameters[2].experiment = 1;
    const FitResult result = fit(problem);
    ASSERT_EQ(result.status, FitStatus::Converged) << result.message;
    EXPECT_NEAR(result.values[0], 3.0, 0.02);
    EXPECT_NEAR(result.values[1], 1.0, 0.03);
    EXPECT_NEAR(result.values[2], -2.0, 0.03);
    EXPECT_EQ(result.estimates[2].experiment, 1);
}

TEST(Fit, ARobustLossShrugsOffOutliers) {
    FitProblem problem = charging();
    problem.experiments[0].parameters[1] = 0.8;
    for (Eigen::Index k = 0; k < 2000; k += 10) problem.experiments[0].measured(0, k) += 2.0;
    const FitResult plain = fit(problem);
    FitOptions options;
    options.loss = RobustLoss::Cauchy;
    const FitResult robust = fit(problem, options);
    ASSERT_EQ(robust.status, FitStatus::Converged) << robust.message;
    EXPECT_GT(std::abs(plain.values[0] - 3.0), 0.02);
    EXPECT_NEAR(robust.values[0], 3.0, 0.01);
}

TEST(Fit, RefinesTheStepsWhenTheOptimumNeedsIt) {
    // At the start slow (R C = 40 s), at the optimum fast against the sample.
    const SystemPtr system = compileText(capacitorText, "Charging", {"R"});
    FitProblem problem;
    problem.experiments.push_back(simulated("fast", system, steps(400, 0.5, 5.0, 20.0), {0.3}, 0.0, 2));
    problem.parameters = {parameter("R", 80.0, 0.001, 1000.0)};
    const FitResult result = fit(problem);
    ASSERT_EQ(result.status, FitStatus::Converged) << result.message;
    EXPECT_NEAR(result.values[0], 0.3, 1e-4);
    EXPECT_LT(result.plans[0].errorEstimate, 2e-5);
}

TEST(ErrorFigures, AreThoseComputedByHand) {
    const Eigen::RowVectorXd measured = (Eigen::RowVectorXd(5) << 1.0, 2.0, 4.0, 1.0, std::nan("")).finished();
    const Eigen::RowVectorXd simulated = (Eigen::RowVectorXd(5) << 1.5, 2.0, 3.0, 1.0, 77.0).finished();
    const ErrorFigures figures = errorFigures(simulated, measured);
    EXPECT_DOUBLE_EQ(figures.rmse, std::sqrt(1.25 / 4.0));
    EXPECT_DOUBLE_EQ(figures.errorPercent, 100.0 * std::sqrt(1.25 / 4.0) / 3.0);
    EXPECT_DOUBLE_EQ(figures.relativeRmsPercent, 100.0 * std::sqrt(1.25 / 22.0));
    EXPECT_DOUBLE_EQ(figures.fitPercent, 100.0 * (1.0 - std::sqrt(1.25 / 6.0)));
    EXPECT_DOUBLE_EQ(figures.maxAbs, 1.0);
}

TEST(Fit, AFiveStateMotorWithTwentyThousandSamplesIsAMatterOfASecond) {
    const FitProblem problem = motorProblem(20000, 0.005);
    const std::clock_t started = std::clock();
    const FitResult result = fit(problem);
    const double spent = static_cast<double>(std::clock() - started) / CLOCKS_PER_SEC;
    EXPECT_EQ(result.status, FitStatus::Converged) << result.message;
    RecordProperty("processor_seconds", std::to_string(spent));
    EXPECT_LT(spent, 20.0);  // many times what it takes, for a busy or an instrumented machine
}

/// A machine behind brushes under a noisy voltage: the current changes its sign at almost every sample, within zones
/// far narrower than any step. The tangents of the numerical solution grow at each of them.
const char* const brushText = R"(
model Brush
  input Real v;
  output Real i(start=0, fixed=true), w(start=0, fixed=true);
  parameter Real R = 0.5, L = 3e-4, k = 0.023, J = 3e-5, V_b = 0.25, i_eps = 1e-3;
equation
  L*der(i) = v - R*i - V_b*tanh(i/i_eps) - k*w;
  J*der(w) = k*i - 1e-6*w*abs(w);
end Brush;
)";

constexpr int brushSamples = 500;

FitProblem brushProblem() {
    const SystemPtr system = test::compileText(brushText, "Brush", {"R", "k", "J", "V_b"});
    constexpr int count = brushSamples;
    SampledInputs inputs;
    inputs.values.resize(1, count);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 0.4);
    for (int n = 0; n < count; ++n) {
        inputs.time.push_back(0.005 * n);
        inputs.values(0, n) = (n / 125) % 2 == 0 ? 6 + noise(random) : noise(random);
    }
    FitProblem problem;
    problem.experiments.push_back(test::simulated("run", system, inputs, {0.45, 0.022, 2.8e-5, 0.3}, 0, 1));
    FitExperiment& run = problem.experiments.front();
    const double sigma[] = {0.2, 2};
    for (Eigen::Index o = 0; o < 2; ++o) {
        std::normal_distribution<double> scatter(0, sigma[o]);
        for (Eigen::Index n = 0; n < count; ++n) run.measured(o, n) += scatter(random);
        run.weights[o] = 1 / sigma[o];
    }
    problem.parameters = {test::parameter("R", 0.55, 0.01, 10), test::parameter("k", 0.025, 1e-3, 0.5),
                          test::parameter("J", 3.5e-5, 1e-6, 1e-3), test::parameter("V_b", 0.2, 0, 5)};
    return problem;
}

TEST(Fit, IsNotMisledByTheTangentsOfAModelThatSwitchesFasterThanItsSteps) {
    const FitResult result = fit(brushProblem());
    EXPECT_EQ(result.status, FitStatus::Converged);
    EXPECT_LT(result.cost, 0.5 * 1.15 * 2 * brushSamples) << "nothing but the noise is left";
    const double truth[] = {0.45, 0.022, 2.8e-5, 0.3};
    for (Eigen::Index p = 0; p < 4; ++p) {
        const FitEstimate& estimate = result.estimates[static_cast<std::size_t>(p)];
        EXPECT_NEAR(result.values[p], truth[p], 5 * estimate.standardError) << estimate.name;
        EXPECT_LT(estimate.standardError, 0.1 * truth[p]) << estimate.name;
    }
}

TEST(Fit, EndsWhereItOnlyCreepsAlongAKink) {
    const char* const text = R"(
model Kink "a valley with a sharp bottom: along it slopes hold for next to no step"
  input Real u;
  output Real high;
  output Real along;
  parameter Real a = 0;
  parameter Real b = 0;
equation
  high = u*(1 + sqrt((a - b)^2 + 1e-10));
  along = 0.1*u*(a + 2*b);
end Kink;
)";
    const SystemPtr system = compileText(text, "Kink", {"a", "b"});
    FitProblem problem;
    FitExperiment& run = problem.experiments.emplace_back();
    run.name = "run";
    run.system = system;
    run.inputs = steps(20, 0.1, 1.0, 1.0);
    run.parameters = ownParameters(*system);
    run.measured = Eigen::MatrixXd::Zero(2, 20);
    run.measured.row(1) = 0.002 * run.inputs.values.row(0);
    run.weights = Eigen::VectorXd::Constant(2, 1.0);
    problem.parameters = {parameter("a", 0.3, -10, 10), parameter("b", 0.1, -10, 10)};
    FitOptions options;
    options.maxIterations = 1000;
    const FitResult result = fit(problem, options);
    EXPECT_LT(result.iterations, 100);
    EXPECT_THAT(result.message, HasSubstr("flat valley"));
    EXPECT_NEAR(result.values[0], result.values[1], 1e-3);
}

TEST(Fit, TakesSlopesFromDifferencesOnlyWhereTheCostFalls) {
    FitProblem problem = brushProblem();
    problem.parameters[2].start = 9e-5;  // on the way from there the tangents mislead
    const FitResult result = fit(problem);
    EXPECT_TRUE(result.takesDifferences);
    EXPECT_LT(result.cost, 0.5 * 1.15 * 2 * brushSamples);
    EXPECT_LT(result.simulations, 150) << "twice as many, were slopes taken at every step that is tried";
}

}  // namespace
}  // namespace analogon
