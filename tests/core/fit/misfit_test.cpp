#include "core/fit/misfit.hpp"

#include <gtest/gtest.h>

#include "tests/core/fit/motor_problem.hpp"

namespace analogon {
namespace {

/// A spring that stiffens, recorded with hardly any noise: far less than what the tolerances allow the integration.
FitProblem stiffeningSpring(double noise) {
    const SystemPtr system = test::compileText(R"(
model Spring
  input Real f;
  output Real y;
  parameter Real d = 0.8;
  parameter Real k = 900;
  parameter Real k3 = 4e5;
  Real x(start = 0, fixed = true);
  Real v(start = 0, fixed = true);
equation
  der(x) = v;
  der(v) = f - d*v - k*x - k3*x^3;
  y = x;
end Spring;
)",
                                               "Spring", {"d", "k", "k3"});
    FitProblem problem;
    problem.experiments.push_back(
        test::simulated("pushes", system, test::steps(2000, 0.02, 20.0, 3.0), {0.8, 900.0, 4e5}, noise, 4));
    problem.parameters = {test::parameter("d", 0.5, 0.01, 100.0), test::parameter("k", 850.0, 1.0, 1e5),
                          test::parameter("k3", 3e5, 1.0, 1e7)};
    return problem;
}

/// How far an estimate lies from that of an integration which is exact, in standard errors; the farthest of all.
double awayFromExact(const FitProblem& problem, const FitOptions& options) {
    FitOptions exact;
    exact.simulation.relativeTolerance = 1e-11;
    const FitResult best = fit(problem, exact), result = fit(problem, options);
    EXPECT_EQ(best.status, FitStatus::Converged) << best.message;
    EXPECT_EQ(result.status, FitStatus::Converged) << result.message;
    double farthest = 0;
    for (std::size_t i = 0; i < best.estimates.size(); ++i)
        farthest = std::max(
            farthest, std::abs(result.estimates[i].value - best.estimates[i].value) / best.estimates[i].standardError);
    return farthest;
}

TEST(PlanWithin, AQuietRecordingIsFittedWithinItsOwnScatter) {
    const FitProblem problem = stiffeningSpring(2e-6);  // of a range of about 0.1
    FitOptions options;
    EXPECT_GT(awayFromExact(problem, options), 0.1) << "the tolerances alone";
    options.integrationShare = 1e-3;
    EXPECT_LT(awayFromExact(problem, options), 0.02) << "an error that were the same in all 2 000 samples: 0.045";
}

TEST(PlanWithin, ALoudRecordingKeepsItsSteps) {
    const FitProblem problem = stiffeningSpring(3e-2);
    FitOptions options;
    const Progress progress;
    Misfit misfit(problem, options, progress);
    const Eigen::VectorXd values = (Eigen::VectorXd(3) << 0.8, 900.0, 4e5).finished();
    misfit.plan(values);
    const std::vector<GridPlan> before = misfit.plans();
    EXPECT_FALSE(misfit.planWithin(1e-3, values));
    EXPECT_EQ(misfit.plans(), before);
    EXPECT_TRUE(misfit.planWithin(1e-7, values));
    EXPECT_GT(misfit.plans().front().work(), before.front().work());
}

/// Two parameters of which a curve, b = a^2, is known far better than the place on it (Rosenbrock 1960), far from it.
FitProblem rosenbrock(double narrowness) {
    const SystemPtr system = test::compileText(R"(
model Valley
  input Real f;
  output Real y;
  output Real z;
  parameter Real a = 1;
  parameter Real b = 1;
  Real x(start = 0, fixed = true);
equation
  der(x) = f*a - x;
  y = x;
  z = b - a^2;
end Valley;
)",
                                               "Valley", {"a", "b"});
    FitProblem problem;
    problem.experiments.push_back(
        test::simulated("steps", system, test::steps(400, 0.02, 1.0, 3.0), {1.0, 1.0}, 0.0, 4));
    problem.experiments[0].weights[1] = narrowness;
    problem.parameters = {test::parameter("a", -3.0), test::parameter("b", 9.0)};
    return problem;
}

TEST(Fit, FollowsABentValleyInFewSteps) {
    const FitProblem problem = rosenbrock(300);
    FitOptions options;
    options.maxIterations = 400;
    const FitResult straight = fit(problem, options);
    options.goesOnInValleys = true;
    const FitResult bent = fit(problem, options);
    ASSERT_EQ(bent.status, FitStatus::Converged) << bent.message;
    EXPECT_NEAR(bent.values[0], 1, 1e-6);
    EXPECT_NEAR(bent.values[1], 1, 1e-6);
    EXPECT_LT(3 * bent.iterations, straight.iterations);
}

/// The same at its end, beside a spring that wants fine steps.
FitProblem bentValley() {
    const SystemPtr system = test::compileText(R"(
model Valley
  input Real f;
  output Real y;
  output Real z;
  parameter Real a = 1;
  parameter Real b = 1;
  Real x(start = 0, fixed = true);
  Real v(start = 0, fixed = true);
equation
  der(x) = v;
  der(v) = f - 0.8*v - 900*x - 4e5*x^3;
  y = x;
  z = if f > 10 then 0.07*a else 25*(b - a^2);
end Valley;
)",
                                               "Valley", {"a", "b"});
    FitProblem problem;
    problem.experiments.push_back(
        test::simulated("pushes", system, test::steps(2000, 0.02, 20.0, 3.0), {1.0, 1.0}, 1.0, 4));
    problem.experiments[0].weights[0] = 1e-3;  // the spring is only looked at
    problem.parameters = {test::parameter("a", 0.0), test::parameter("b", 0.0)};
    return problem;
}

TEST(Fit, FollowsABentValleyToItsEndWhereItIsAskedTo) {
    const FitProblem problem = bentValley();
    const FitExperiment& experiment = problem.experiments[0];
    double sum = 0, count = 0;  // a is the mean of what was measured of it: b takes up whatever the curve asks for
    for (Eigen::Index k = 0; k < experiment.measured.cols(); ++k)
        if (experiment.inputs.values(0, k) > 10) sum += experiment.measured(1, k) / 0.07, ++count;
    const double best = sum / count, deviation = 1 / (0.07 * std::sqrt(count));
    FitOptions options;
    const FitResult left = fit(problem, options);
    EXPECT_EQ(left.status, FitStatus::IterationLimit) << "in a flat valley";
    EXPECT_GT(std::abs(left.values[0] - best), 0.3 * deviation);
    options.goesOnInValleys = true;
    const FitResult followed = fit(problem, options);
    EXPECT_EQ(followed.status, FitStatus::Converged) << followed.message;
    EXPECT_NEAR(followed.values[0], best, 0.01 * deviation);
}

}  // namespace
}  // namespace analogon
