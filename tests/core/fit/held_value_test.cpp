#include "core/fit/held_value.hpp"

#include <gtest/gtest.h>

#include "core/fit/clock.hpp"
#include "tests/core/fit/motor_problem.hpp"

namespace analogon {
namespace {

FitProblem twoLines() {
    const SystemPtr system = test::compileText(
        "model Line\n  input Real x;\n  output Real y;\n  parameter Real a = 1;\n"
        "  parameter Real b = 1;\nequation\n  y = a + b*x;\nend Line;\n",
        "Line", {"a", "b"});
    FitProblem problem;
    for (const char* const name : {"one", "two"})
        problem.experiments.push_back(test::simulated(name, system, test::steps(10, 0.1, 2.0, 3.0), {5, 3}, 0, 1));
    return problem;
}

double valueOf(const FitExperiment& experiment, const std::string& name) {
    return experiment.parameters[static_cast<std::size_t>(experiment.system->parameterIndex(name))];
}

TEST(SetParameter, WritesIntoOneExperimentOrIntoAll) {
    FitProblem problem = twoLines();
    setParameter(problem.experiments[0], "a", 7);
    EXPECT_EQ(valueOf(problem.experiments[0], "a"), 7);
    EXPECT_NE(valueOf(problem.experiments[1], "a"), 7);
    setParameter(problem, "b", 2);
    for (const FitExperiment& e : problem.experiments) EXPECT_EQ(valueOf(e, "b"), 2);
}

TEST(SetParameter, LeavesAsItIsWhatHasNoSuchParameter) {
    FitProblem problem = twoLines();
    const std::vector<double> before = problem.experiments[0].parameters;
    setParameter(problem, "c", 4);
    EXPECT_EQ(problem.experiments[0].parameters, before);
}

TEST(Hold, SetsTheClockOfAnOutputAsWell) {
    FitProblem problem = twoLines();
    FitExperiment& one = problem.experiments.front();
    one.clocks.emplace_back();
    hold(one, clockOf("y"), 0.25);
    EXPECT_EQ(one.clocks.front().offset, 0.25);
    hold(one, "a", 9);
    EXPECT_EQ(valueOf(one, "a"), 9);
    EXPECT_EQ(one.clocks.front().offset, 0.25) << "of another name";
}

}  // namespace
}  // namespace analogon
