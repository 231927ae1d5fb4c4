#include "core/fit/uncertainty.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "core/fit/profile.hpp"
#include "tests/core/fit/motor_problem.hpp"

// What a fit is worth, against closed forms of a straight line.
namespace analogon {
namespace {

using test::compileText;
using test::parameter;
using ::testing::HasSubstr;

const char* const lineText = R"(
model Line
  input Real x;
  output Real y;
  output Real twice;
  parameter Real a = 1;
  parameter Real b = 1;
equation
  y = a + b*x;
  twice = 2*y;
end Line;
)";

/// y = 2 + 3 x with given noise; `twice` is not measured.
FitProblem line(const std::vector<double>& noise, double sigma) {
    FitExperiment experiment;
    experiment.name = "line";
    experiment.system = compileText(lineText, "Line", {"a", "b"});
    experiment.parameters = test::ownParameters(*experiment.system);
    const auto count = static_cast<Eigen::Index>(noise.size());
    experiment.inputs.values.resize(1, count);
    experiment.measured.setConstant(2, count, std::nan(""));
    for (Eigen::Index k = 0; k < count; ++k) {
        const double x = static_cast<double>(k) / static_cast<double>(count) - 0.3;
        experiment.inputs.time.push_back(static_cast<double>(k));
        experiment.inputs.values(0, k) = x;
        experiment.measured(0, k) = 2.0 + 3.0 * x + noise[static_cast<std::size_t>(k)];
    }
    experiment.weights = Eigen::Vector2d(1.0 / sigma, 0.0);
    FitProblem problem;
    problem.experiments.push_back(std::move(experiment));
    problem.parameters = {parameter("a", 0.0), parameter("b", 1.0)};
    return problem;
}

/// A first-order autoregression; rho = 0: white noise.
std::vector<double> noise(int count, double rho, double sigma, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0.0, sigma);
    std::vector<double> e;
    double last = normal(random) / std::sqrt(1.0 - rho * rho);
    for (int k = 0; k < count; ++k) e.push_back(last = k == 0 ? last : rho * last + normal(random));
    return e;
}

/// (XᵀX)^-1 of the line.
Eigen::Matrix2d inverseOf(const FitProblem& problem) {
    const Eigen::MatrixXd& x = problem.experiments[0].inputs.values;
    const double weight = problem.experiments[0].weights[0];
    Eigen::Matrix2d sum;
    sum << static_cast<double>(x.cols()), x.sum(), x.sum(), x.squaredNorm();
    return (weight * weight * sum).inverse();
}

TEST(Profile, OfALineIsAParabola) {
    const FitProblem problem = line(noise(400, 0.0, 0.1, 3), 0.1);
    const FitResult best = fit(problem);
    ASSERT_EQ(best.status, FitStatus::Converged) << best.message;
    const Eigen::Matrix2d covariance = best.variance * inverseOf(problem);
    for (int i = 0; i < 2; ++i) {
        const double error = std::sqrt(covariance(i, i));
        EXPECT_NEAR(best.estimates[static_cast<std::size_t>(i)].standardError, error, 1e-9 * error);
        const ConfidenceInterval interval = profile(problem, best, i);
        EXPECT_NEAR(interval.lower, best.values[i] - 1.959964 * error, 1e-4 * error);
        EXPECT_NEAR(interval.upper, best.values[i] + 1.959964 * error, 1e-4 * error);
        EXPECT_FALSE(interval.isOpenBelow);
        EXPECT_FALSE(interval.isOpenAbove);
        EXPECT_TRUE(interval.remark.empty()) << interval.remark;
        ASSERT_EQ(interval.values.size(), interval.rises.size());
        EXPECT_GE(interval.values.size(), 7u);
        for (std::size_t k = 0; k < interval.values.size(); ++k) {
            const double away = (interval.values[k] - best.values[i]) / error;
            EXPECT_NEAR(interval.rises[k], away * away, 1e-4 * (1.0 + away * away));
        }
    }
}

TEST(Profile, DoesNotDependOnTheThreads) {
    const FitProblem problem = test::motorProblem(600, 0.005);
    const FitResult best = fit(problem);
    FitOptions options;
    const ConfidenceInterval one = profile(problem, best, 3, options);
    options.threads = 2;
    const ConfidenceInterval two = profile(problem, best, 3, options);
    EXPECT_EQ(one.values, two.values);
    EXPECT_EQ(one.rises, two.rises);
    // In the logarithm, and close to the standard error where the data say much.
    const double error = best.estimates[3].standardError;
    EXPECT_NEAR(one.upper - one.lower, 2.0 * 1.96 * error, 0.1 * error);
}

TEST(Profile, OfWhatTheDataDoNotTellIsAFlatValley) {
    // Only a + b is seen: x is 1 throughout.
    FitProblem problem = line(noise(100, 0.0, 0.1, 3), 0.1);
    problem.experiments[0].inputs.values.setOnes();
    problem.parameters = {parameter("a", 1.0, -5.0, 5.0), parameter("b", 1.0, -50.0, 50.0)};
    const FitResult best = fit(problem);
    const ConfidenceInterval interval = profile(problem, best, 0);
    EXPECT_TRUE(interval.isOpenBelow);
    EXPECT_TRUE(interval.isOpenAbove);
    EXPECT_EQ(interval.lower, -5.0);
    EXPECT_EQ(interval.upper, 5.0);
    EXPECT_THAT(interval.remark, HasSubstr("these data set no lower limit to a: down to -5 the misfit hardly rises (a "
                                           "flat valley)"));
}

TEST(Profile, EndsAtABound) {
    FitProblem problem = line(noise(400, 0.0, 0.1, 3), 0.1);
    problem.parameters[1].max = 2.5;
    problem.parameters[1].min = -1e3;
    const FitResult best = fit(problem);
    ASSERT_TRUE(best.estimates[1].atBound);
    const ConfidenceInterval interval = profile(problem, best, 1);
    EXPECT_TRUE(interval.isOpenAbove);
    EXPECT_EQ(interval.upper, 2.5);
    EXPECT_THAT(interval.remark, HasSubstr("b rests at its upper bound 2.5"));
    EXPECT_FALSE(interval.isOpenBelow);
}

TEST(PredictionBand, OfALineFollowsFromTheCovariance) {
    const FitProblem problem = line(noise(200, 0.0, 0.1, 5), 0.1);
    const FitResult best = fit(problem);
    FitProblem all = problem;
    all.experiments[0].weights.setOnes();
    const Eigen::MatrixXd band = predictionBand(all, 0, best.values, best.covariance, nullptr);
    const Eigen::Matrix2d covariance = best.variance * inverseOf(problem);
    for (Eigen::Index k = 0; k < 200; k += 20) {
        const Eigen::Vector2d x(1.0, problem.experiments[0].inputs.values(0, k));
        const double expected = std::sqrt(x.dot(covariance * x));
        EXPECT_NEAR(band(0, k), expected, 1e-9 * expected);
        EXPECT_NEAR(band(1, k), 2.0 * expected, 1e-9 * expected);  // not measured, still predicted
    }
}

TEST(LongRunCovariance, IsTheWeightedSumOfAutocovariances) {
    std::mt19937 random(2);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd rows(50, 2);
    for (Eigen::Index i = 0; i < rows.size(); ++i) rows.data()[i] = normal(random);
    constexpr int window = 7;
    Eigen::Matrix2d expected = rows.transpose() * rows;
    for (int lag = 1; lag < window; ++lag) {
        const Eigen::Matrix2d product = rows.bottomRows(50 - lag).transpose() * rows.topRows(50 - lag);
        expected += (1.0 - static_cast<double>(lag) / window) * (product + product.transpose());
    }
    EXPECT_LT((longRunCovariance(rows, window) - expected).norm(), 1e-12 * expected.norm());
    EXPECT_LT((longRunCovariance(rows, 1) - rows.transpose() * rows).norm(), 1e-12);
}

TEST(RobustError, IsTheOrdinaryOneInWhiteNoise) {
    const FitProblem problem = line(noise(4000, 0.0, 0.1, 7), 0.1);
    FitOptions options;
    options.findsRobustErrors = true;
    const FitResult result = fit(problem, options);
    for (const FitEstimate& estimate : result.estimates)
        EXPECT_NEAR(estimate.robustError, estimate.standardError, 0.1 * estimate.standardError) << estimate.name;
    EXPECT_TRUE(std::isnan(fit(problem).estimates[0].robustError));
}

TEST(RobustError, GrowsWithTheMemoryOfTheNoise) {
    // The variance of a slowly varying sum of such noise is (1 + rho) / (1 - rho) times that of white noise.
    constexpr double rho = 0.8;
    const FitProblem problem = line(noise(20000, rho, 0.06, 11), 0.1);
    FitOptions options;
    options.findsRobustErrors = true;
    const FitResult result = fit(problem, options);
    const double ratio = std::sqrt((1.0 + rho) / (1.0 - rho));
    for (const FitEstimate& estimate : result.estimates)
        EXPECT_NEAR(estimate.robustError / estimate.standardError, ratio, 0.15 * ratio) << estimate.name;
}

TEST(RobustError, IsNotKnownWhereNothingIs) {
    FitProblem problem = line(noise(100, 0.0, 0.1, 3), 0.1);
    problem.experiments[0].inputs.values.setOnes();
    FitOptions options;
    options.findsRobustErrors = true;
    const FitResult result = fit(problem, options);
    EXPECT_TRUE(std::isnan(result.estimates[0].robustError));
    EXPECT_THAT(result.remarks, ::testing::Contains("a and b cannot be told apart from these data: fix one"));
}

}  // namespace
}  // namespace analogon
