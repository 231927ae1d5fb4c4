#include "core/fit/optimum_uncertainty.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/fit/reduced_misfit.hpp"
#include "tests/core/fit/motor_problem.hpp"

namespace analogon {
namespace {

using test::compileText;
using test::parameter;

constexpr double sigma = 0.1;
constexpr int samples = 200;

/// y = 2 + 3 x with white noise, and z, which no parameter moves and which is off by this much.
FitProblem lineBeside(double off) {
    FitExperiment experiment;
    experiment.name = "line";
    experiment.system = compileText(
        "model Line\n input Real x;\n output Real y;\n output Real z;\n parameter Real a = 2;\n"
        " parameter Real b = 3;\nequation\n y = a + b*x;\n z = x;\nend Line;\n",
        "Line", {"a", "b"});
    experiment.parameters = test::ownParameters(*experiment.system);
    experiment.inputs.values.resize(1, samples);
    experiment.measured.resize(2, samples);
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0.0, sigma);
    for (int k = 0; k < samples; ++k) {
        const double x = static_cast<double>(k) / samples - 0.3;
        experiment.inputs.time.push_back(k);
        experiment.inputs.values(0, k) = x;
        experiment.measured.col(k) << 2.0 + 3.0 * x + normal(random), x + off;
    }
    experiment.weights = Eigen::VectorXd::Ones(2);
    FitProblem problem;
    problem.experiments.push_back(std::move(experiment));
    problem.weightsAreNoise = false;
    problem.parameters = {parameter("a", 2.0, -10.0, 10.0), parameter("b", 3.0, 0.01, 100.0)};
    return problem;
}

OptimumUncertainty found(const FitProblem& problem, bool hasSlopes = true) {
    Linearisation line = linearise(problem, problem.startValues(), true, {}, {}, {});
    EXPECT_TRUE(line.ok);
    const ReducedMisfit reduced = reduce(line.jacobian, line.residuals);
    const double squares = line.residuals.squaredNorm();
    if (!hasSlopes) line.jacobian.resize(0, 0);
    return uncertaintyAt(problem, {"a", "b"}, problem.startValues(), line, reduced.jacobian, squares);
}

TEST(OptimumUncertainty, IsNotOfAChannelThatNoParameterMoves) {
    const OptimumUncertainty at = found(lineBeside(7)), alone = found(lineBeside(0));
    EXPECT_NEAR(at.variance, sigma * sigma, 0.3 * sigma * sigma);
    EXPECT_NEAR(at.variance, alone.variance, 1e-9);
    for (int i = 0; i < 2; ++i)
        EXPECT_NEAR(at.uncertainty.standardErrors[i], alone.uncertainty.standardErrors[i], 1e-9);
}

TEST(OptimumUncertainty, CountsAllChannelsWhereNoSlopesAreKnown) {
    EXPECT_NEAR(found(lineBeside(7), false).variance, 49 * samples / (2.0 * samples - 2), 0.1);
}

TEST(OptimumUncertainty, IsNoLessThanTheNoiseThatIsKnown) {
    FitProblem problem = lineBeside(0);
    problem.weightsAreNoise = true;
    EXPECT_EQ(found(problem).variance, 1);
}

}  // namespace
}  // namespace analogon
