#include "core/fit/own_parameters.hpp"

#include <gtest/gtest.h>

#include "tests/core/fit/motor_problem.hpp"

namespace analogon {
namespace {

const char* const lineText = R"(
model Line
  input Real x;
  output Real y;
  parameter Real a = 1;
  parameter Real b = 1;
equation
  y = a + b*x;
end Line;
)";

FitExperiment line(const std::string& name, double a, double b) {
    const SystemPtr system = test::compileText(lineText, "Line", {"a", "b"});
    return test::simulated(name, system, test::steps(100, 0.1, 2.0, 3.0), {a, b}, 0.01, 3);
}

TEST(OwnParameters, AreEstimatedFromTheirExperimentAloneWithTheOthersHeld) {
    FitProblem problem;
    problem.experiments = {line("one", 5, 3), line("two", 7, 3)};
    problem.parameters = {test::parameter("b", 1), test::parameter("a", 0), test::parameter("a", 0)};
    problem.parameters[1].experiment = 0;
    problem.parameters[2].experiment = 1;
    EXPECT_TRUE(hasOwnParameters(problem, 1));

    const FitResult own = fitOwnParameters(problem, 1, Eigen::Vector3d(3, 0, 0));
    ASSERT_EQ(own.estimates.size(), 1u);
    EXPECT_EQ(own.estimates[0].name, "a");
    EXPECT_EQ(own.estimates[0].experiment, 1);
    EXPECT_NEAR(own.estimates[0].value, 7, 0.005);
    EXPECT_NEAR(own.estimates[0].standardError, 0.001, 1e-4);
    // what is held is held, even where it is wrong: what is missing of b*x lands in a
    const double mean = problem.experiments[1].inputs.values.mean();
    EXPECT_NEAR(fitOwnParameters(problem, 1, Eigen::Vector3d(2, 0, 0)).estimates[0].value, 7 + mean, 0.005);
}

TEST(OwnParameters, AreNoneWhereAllBelongToEveryExperiment) {
    FitProblem problem;
    problem.experiments = {line("one", 5, 3)};
    problem.parameters = {test::parameter("a", 0), test::parameter("b", 1)};
    EXPECT_FALSE(hasOwnParameters(problem, 0));
}

}  // namespace
}  // namespace analogon
