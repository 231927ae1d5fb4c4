#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/simulate/simulate.hpp"
#include "tests/core/simulate/text_models.hpp"

// Which operation of which equation a simulation fails at.
namespace analogon {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string causeIn(const std::string& declarations, const std::string& equations) {
    const SystemPtr system = test::compileText(
        "model M\n  input Real u;\n  output Real y;\n  " + declarations + "\nequation\n  " + equations + "\nend M;\n",
        "M");
    if (!system) return {};
    SampledInputs inputs;
    inputs.values.resize(1, 101);
    for (int k = 0; k <= 100; ++k) {
        inputs.time.push_back(0.1 * k);
        inputs.values(0, k) = 1 - 0.02 * k;  // 0 at 5 s, -1 at 10 s
    }
    SimulationTask task;
    task.system = system.get();
    task.inputs = &inputs;
    task.parameters = test::ownParameters(*system);
    const Trajectory t = simulateGrid(task, planGrid(task));
    EXPECT_TRUE(t.failure.failed);
    return causeOf(task, t.failure);
}

TEST(CauseOfAFailure, NamesTheOperationTheEquationAndTheValues) {
    EXPECT_THAT(causeIn("Real x(start=1, fixed=true);", "der(x) = -x + sqrt(u);\n  y = x;"),
                AllOf(HasSubstr("sqrt(u) is the root of -0.0"), HasSubstr("(u = -0.0"),
                      HasSubstr("in the equation der(x) = "), HasSubstr("(model.mo, line 6)")));
    EXPECT_THAT(causeIn("", "y = 3 + log(u);"), HasSubstr("log(u) is the logarithm of 0"));
    EXPECT_THAT(causeIn("Real x(start=1, fixed=true);", "der(x) = -1;\n  y = asin(2 - x);"),
                AllOf(HasSubstr("is the arcsine of 1.1"), HasSubstr("(x = 0.9)")));
    EXPECT_THAT(causeIn("Real x(start=1, fixed=true);", "der(x) = -1;\n  y = acos(2 - x);"),
                HasSubstr("is the arccosine of 1.1"));
    EXPECT_THAT(causeIn("", "y = 2/noEvent(max(u, 0));"), HasSubstr("divides 2 by 0"));
    EXPECT_THAT(causeIn("", "y = u^1.5;"), HasSubstr("is the power of -0.02 to 1.5"));
}

TEST(CauseOfAFailure, IsTheInnermostOperationAndNothingAConditionDecidedAgainst) {
    const std::string cause = causeIn("Real x(start=1, fixed=true);",
                                      "der(x) = (if noEvent(u > -10) then 0 else log(u)) + exp(1/(2 + sqrt(u)));\n"
                                      "  y = x;");
    EXPECT_THAT(cause, HasSubstr("sqrt(u) is the root of"));
}

TEST(CauseOfAFailure, AtTheStartIsFound) {
    const std::string cause =
        causeIn("Real x(start=0.6, fixed=true);\n  Real z;", "z = sqrt(x - 0.7);\n  der(x) = u - z;\n  y = x;");
    EXPECT_THAT(cause, AllOf(HasSubstr("is the root of -0.1 (x = 0.6)"), HasSubstr("z = sqrt(x - 0.7)")));
}

TEST(CauseOfAFailure, InsideABlockThatCannotBeSolvedIsFound) {
    const std::string cause =
        causeIn("Real a(start=1);\n  Real b(start=1);", "a + 0.1*a^3 = sqrt(u) + b;\n  b + 0.1*b^5 = 0.3*a;\n  y = a;");
    EXPECT_THAT(cause, HasSubstr("sqrt(u) is the root of"));
}

TEST(CauseOfAFailure, OfNoneIsNotTold) {
    SimulationFailure cancelled{true, 1, "", "cancelled"};
    const SystemPtr system = test::compileText("model M\n  input Real u;\n  output Real y = u;\nend M;\n", "M");
    SampledInputs inputs{{0, 1}, Eigen::MatrixXd::Ones(1, 2)};
    SimulationTask task;
    task.system = system.get();
    task.inputs = &inputs;
    EXPECT_TRUE(causeOf(task, cancelled).empty());
    EXPECT_TRUE(causeOf(task, {}).empty());
    EXPECT_TRUE(causeOf(task, {true, 0, "y", "not finite"}).empty()) << "every operation has a value";
}

}  // namespace
}  // namespace analogon
