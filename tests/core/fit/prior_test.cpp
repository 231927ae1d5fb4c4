#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "core/fit/fit.hpp"
#include "core/fit/profile.hpp"
#include "tests/core/fit/motor_problem.hpp"

// Priors, against the posterior of a straight line in closed form.
namespace analogon {
namespace {

using test::compileText;
using test::parameter;
using ::testing::Contains;
using ::testing::HasSubstr;

constexpr double sigma = 0.1;

/// y = 2 + 3 x with white noise of known standard deviation.
FitProblem line(int count) {
    FitExperiment experiment;
    experiment.name = "line";
    experiment.system = compileText(
        "model Line\n input Real x;\n output Real y;\n parameter Real a = 1;\n parameter Real b = 1;\n"
        "equation\n y = a + b*x;\nend Line;\n",
        "Line", {"a", "b"});
    experiment.parameters = test::ownParameters(*experiment.system);
    experiment.inputs.values.resize(1, count);
    experiment.measured.resize(1, count);
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0.0, sigma);
    for (int k = 0; k < count; ++k) {
        const double x = static_cast<double>(k) / count - 0.3;
        experiment.inputs.time.push_back(k);
        experiment.inputs.values(0, k) = x;
        experiment.measured(0, k) = 2.0 + 3.0 * x + normal(random);
    }
    experiment.weights = Eigen::VectorXd::Constant(1, 1.0 / sigma);
    FitProblem problem;
    problem.experiments.push_back(std::move(experiment));
    problem.parameters = {parameter("a", 0.0, -10.0, 10.0), parameter("b", 1.0, 0.01, 100.0)};
    return problem;
}

struct Posterior {
    Eigen::Vector2d mean;
    Eigen::Matrix2d covariance;
};

/// Of the line with noise of this variance, by normal equations.
Posterior posteriorOf(const FitProblem& problem, double variance) {
    const FitExperiment& experiment = problem.experiments[0];
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (Eigen::Index k = 0; k < experiment.measured.cols(); ++k) {
        const Eigen::Vector2d row(1.0, experiment.inputs.values(0, k));
        information += row * row.transpose() / variance;
        right += row * experiment.measured(0, k) / variance;
    }
    for (Eigen::Index i = 0; i < 2; ++i)
        if (const auto& prior = problem.parameters[static_cast<std::size_t>(i)].prior) {
            information(i, i) += 1.0 / (prior->deviation * prior->deviation);
            right[i] += prior->mean / (prior->deviation * prior->deviation);
        }
    return {information.inverse() * right, information.inverse()};
}

void expectPosterior(const FitResult& result, const Posterior& expected, double part) {
    ASSERT_EQ(result.status, FitStatus::Converged) << result.message;
    for (int i = 0; i < 2; ++i) {
        const double error = std::sqrt(expected.covariance(i, i));
        EXPECT_NEAR(result.values[i], expected.mean[i], part * error) << i;
        EXPECT_NEAR(result.estimates[static_cast<std::size_t>(i)].standardError, error, part * error) << i;
    }
}

/// Whatever looks for the optimum, and whether residuals are kept (few) or summed up (many).
class Prior : public ::testing::TestWithParam<std::pair<FitMethod, int>> {};

TEST_P(Prior, GivesThePosteriorOfALine) {
    FitProblem problem = line(GetParam().second);
    problem.parameters[1].prior = NormalPrior{2.8, 0.05};
    FitOptions options;
    options.method = GetParam().first;
    const FitResult result = fit(problem, options);
    const double variance = sigma * sigma * std::max(1.0, result.variance);
    expectPosterior(result, posteriorOf(problem, variance), 0.02);
    // Between what the data say alone and what was known.
    problem.parameters[1].prior.reset();
    const FitResult alone = fit(problem, options);
    EXPECT_LT(result.values[1], alone.values[1]);
    EXPECT_GT(result.values[1], 2.8);
    EXPECT_LT(result.estimates[1].standardError, alone.estimates[1].standardError);
}

INSTANTIATE_TEST_SUITE_P(Methods, Prior,
                         ::testing::Values(std::pair{FitMethod::LeastSquares, 200},
                                           std::pair{FitMethod::LeastSquares, 3000},
                                           std::pair{FitMethod::LeastSquaresByCeres, 200},
                                           std::pair{FitMethod::LeastSquaresByCeres, 3000},
                                           std::pair{FitMethod::NelderMead, 200},
                                           std::pair{FitMethod::NelderMead, 3000}, std::pair{FitMethod::Bobyqa, 200}));

TEST(PriorFit, FindsTheScatterItWeighsAgainstWhereTheNoiseIsNotKnown) {
    FitProblem problem = line(400);
    problem.parameters[0].prior = NormalPrior{1.98, 0.01};
    problem.parameters[1].prior = NormalPrior{2.9, 0.05};
    problem.weightsAreNoise = false;
    problem.experiments[0].weights[0] = 1.0 / 3.0;  // 1 / range
    for (const int starts : {1, 4}) {
        FitOptions options;
        options.starts = starts;
        const FitResult result = fit(problem, options);
        expectPosterior(result, posteriorOf(problem, 9.0 * result.variance), 0.03);
        EXPECT_NEAR(3.0 * std::sqrt(result.variance), sigma, 0.1 * sigma);
    }
}

TEST(PriorFit, TellsApartWhatTheDataCannot) {
    FitProblem problem = line(100);
    problem.experiments[0].inputs.values.setOnes();  // a + b is all that shows
    problem.experiments[0].measured.array() = 5.0;
    problem.parameters[0].prior = NormalPrior{2.2, 0.3};
    const FitResult result = fit(problem);
    ASSERT_EQ(result.status, FitStatus::Converged) << result.message;
    EXPECT_NEAR(result.values[0], 2.2, 1e-6);
    EXPECT_NEAR(result.values[1], 2.8, 1e-6);
    EXPECT_NEAR(result.estimates[0].standardError, 0.3, 1e-6);
    EXPECT_NEAR(result.estimates[1].standardError, std::hypot(0.3, 0.01), 1e-6);
    EXPECT_THAT(result.remarks, Contains(HasSubstr("a is known from its prior alone: the data add nothing")));
}

TEST(PriorFit, SaysWhenTheDataContradictIt) {
    FitProblem problem = line(400);
    problem.parameters[1].prior = NormalPrior{2.0, 0.02};
    const FitResult result = fit(problem);
    ASSERT_TRUE(result.estimates[1].prior);
    EXPECT_GT(result.estimates[1].prior->distance(result.values[1]), 3.0);
    EXPECT_THAT(result.remarks, Contains(HasSubstr("from its prior 2 ± 0.02: the data contradict what was known")));
    problem.parameters[1].prior = NormalPrior{2.95, 0.05};
    EXPECT_TRUE(fit(problem).remarks.empty());
}

TEST(PriorFit, LimitsTheProfile) {
    FitProblem problem = line(400);
    problem.parameters[0].prior = NormalPrior{2.01, 0.004};
    problem.parameters[1].prior = NormalPrior{2.9, 0.02};
    problem.parameters[1].scale = ParameterScale::Linear;
    const FitResult best = fit(problem);
    const Posterior posterior = posteriorOf(problem, sigma * sigma * best.variance);
    for (int i = 0; i < 2; ++i) {
        const double error = std::sqrt(posterior.covariance(i, i));
        const ConfidenceInterval interval = profile(problem, best, i);
        EXPECT_NEAR(interval.lower, best.values[i] - 1.959964 * error, 0.03 * error);
        EXPECT_NEAR(interval.upper, best.values[i] + 1.959964 * error, 0.03 * error);
    }
}

TEST(PriorFit, HasErrorsThatHoldInCorrelatedNoiseToo) {
    FitProblem problem = line(2000);
    problem.parameters[0].prior = NormalPrior{2.0, 1e-4};
    FitOptions options;
    options.findsRobustErrors = true;
    const FitResult result = fit(problem, options);
    EXPECT_NEAR(result.estimates[0].robustError, 1e-4, 5e-6);
    EXPECT_NEAR(result.estimates[1].robustError, result.estimates[1].standardError,
                0.15 * result.estimates[1].standardError);
}

TEST(PriorFit, LeavesTheResidualsToTheData) {
    FitProblem problem = line(300);
    problem.parameters[1].prior = NormalPrior{2.9, 0.05};
    const FitResult result = fit(problem);
    EXPECT_EQ(result.optimum.residuals.size(), 300);
    const double known = result.scatter * problem.parameters[1].prior->distance(result.values[1]);
    EXPECT_NEAR(2.0 * result.cost, result.optimum.residuals.squaredNorm() + known * known, 1e-6 * result.cost);
}

TEST(PriorFit, RefusesADeviationThatIsNone) {
    FitProblem problem = line(10);
    problem.parameters[0].prior = NormalPrior{1.0, 0.0};
    EXPECT_THAT(fit(problem).message, HasSubstr("a: the prior 1 ± 0 is none"));
}

}  // namespace
}  // namespace analogon
