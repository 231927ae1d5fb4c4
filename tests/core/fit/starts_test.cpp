#include "core/fit/starts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/fit/motor_problem.hpp"

namespace analogon {
namespace {

using test::compileText;
using test::parameter;
using ::testing::HasSubstr;
using ::testing::Not;

/// A tank that empties through an outlet of area a at the height h0.
const char* const outletText = R"(
model Outlet
  input Real q;
  output Real level;
  parameter Real a = 0.005;
  parameter Real h0 = 0.7;
  Real h(start = 0.6, fixed = true);
equation
  0.2*der(h) = q - a*sqrt(2*9.81*(h - h0));
  level = h;
end Outlet;
)";

/// Recorded with the outlet at the bottom, so that at its start values the model cannot be simulated.
FitProblem emptying() {
    FitProblem problem;
    FitExperiment e;
    e.name = "emptying";
    e.system = compileText(outletText, "Outlet", {"a", "h0"});
    for (int k = 0; k < 200; ++k) e.inputs.time.push_back(0.2 * k);
    e.inputs.values = Eigen::MatrixXd::Constant(1, 200, 0.02);
    e.measured.resize(1, 200);
    double h = 0.6;
    for (int k = 0; k < 200; ++k) {
        e.measured(0, k) = h + 1e-4 * std::sin(37.0 * k);
        for (int s = 0; s < 200; ++s) h += 1e-3 * (0.02 - 0.0113 * std::sqrt(2 * 9.81 * h)) / 0.2;
    }
    e.weights = Eigen::VectorXd::Constant(1, 1 / 1e-4);
    e.parameters = {0.005, 0.7};
    problem.experiments.push_back(std::move(e));
    problem.parameters = {parameter("a", 0.005, 0.0005, 0.2), parameter("h0", 0.7, -0.5, 0.9)};
    return problem;
}

TEST(Fit, ThatCannotBeginAtItsStartValuesTriesOthersWithinTheBounds) {
    const FitProblem problem = emptying();
    for (const FitMethod method : {FitMethod::LeastSquares, FitMethod::NelderMead}) {
        FitOptions options;
        options.method = method;
        options.otherStarts = 128;
        const FitResult result = fit(problem, options);
        ASSERT_EQ(result.status, FitStatus::Converged) << result.message;
        EXPECT_TRUE(result.beganElsewhere);
        EXPECT_NEAR(result.values[0], 0.0113, 1e-4);
        EXPECT_NEAR(result.values[1], 0.0, 5e-3);
        ASSERT_FALSE(result.remarks.empty());
        const std::string& remark = result.remarks.front();
        EXPECT_THAT(remark, HasSubstr("cannot be simulated at its start values"));
        EXPECT_THAT(remark, HasSubstr("experiment 'emptying' failed at t = "));
        EXPECT_THAT(remark, HasSubstr("is the root of -1.962 (h = 0.6, h0 = 0.7), in the equation"));
    }
}

TEST(Fit, ThatCannotBeSimulatedAnywhereNamesTheOperation) {
    FitProblem problem = emptying();
    problem.parameters[1] = parameter("h0", 0.7, 0.65, 0.9);
    FitOptions options;
    options.otherStarts = 32;
    const FitResult result = fit(problem, options);
    EXPECT_EQ(result.status, FitStatus::Failed);
    EXPECT_THAT(result.message.english(), HasSubstr("is the root of -1.962 (h = 0.6, h0 = 0.7)"));
    EXPECT_THAT(result.message.english(), HasSubstr("nor can it be simulated at any of 32 other starts"));
}

TEST(Fit, TakesNoOtherStartUnlessItIsAskedTo) {
    const FitResult result = fit(emptying());
    EXPECT_EQ(result.status, FitStatus::Failed);
    EXPECT_FALSE(result.beganElsewhere);
    EXPECT_THAT(result.message.english(), Not(HasSubstr("other starts")));
}

TEST(StartsElsewhere, DoNotDependOnTheNumberOfThreads) {
    FitOptions options;
    options.otherStarts = 64;
    const StartsElsewhere one = startsElsewhere(emptying(), options, {});
    options.threads = 3;
    const StartsElsewhere three = startsElsewhere(emptying(), options, {});
    ASSERT_FALSE(one.starts.empty());
    ASSERT_EQ(one.starts.size(), three.starts.size());
    for (std::size_t s = 0; s < one.starts.size(); ++s) EXPECT_EQ(one.starts[s], three.starts[s]);
    for (const Eigen::VectorXd& start : one.starts) EXPECT_LT(start[1], 0.6) << "the outlet lies below the level";
}

}  // namespace
}  // namespace analogon
