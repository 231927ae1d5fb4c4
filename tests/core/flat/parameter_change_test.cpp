#include "core/flat/parameter_change.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "flat_support.hpp"

namespace analogon::test {
namespace {

/// Value of the right side of the model's first equation at a time, with parameters at their values.
double rightSide(const FlatModel& model, double time, double step, double moment) {
    return model.pool->evaluate(model.equations.front().right, [&](const ExpressionNode& node) {
        if (node.operation == Operation::Time) return time;
        const std::string& name = model[node.variable].name;
        if (name == "p.step") return step;
        if (name == "p.moment") return moment;
        return model.parameterValue(node.variable).value_or(std::nan(""));
    });
}

TEST(ParameterChange, GivesTheParameterAnotherValueFromItsMomentOn) {
    const FlatModel flat = flatOf("model M parameter Real p = 2; Real x; equation x = 10*p; end M;");
    const Outcome<FlatModel> changed = withChange(flat, "p", 0.1);
    ASSERT_TRUE(changed) << format(changed.diagnostics());
    EXPECT_NEAR(rightSide(*changed, 1.0, 0.5, 3.0), 20, 1e-9);
    EXPECT_NEAR(rightSide(*changed, 3.0, 0.5, 3.0), 22.5, 1e-9);
    EXPECT_NEAR(rightSide(*changed, 5.0, 0.5, 3.0), 25, 1e-9);
    EXPECT_NEAR(rightSide(*changed, 5.0, 0.0, 0.0), 20, 1e-9);
}

TEST(ParameterChange, IsFollowedByParametersBoundToIt) {
    const FlatModel flat = flatOf(
        "model M parameter Real p = 2; parameter Real q = 3*p; parameter Real r = 1; Real x; equation x = q + r; end "
        "M;");
    const Outcome<FlatModel> changed = withChange(flat, "p", 0.1);
    ASSERT_TRUE(changed) << format(changed.diagnostics());
    EXPECT_NEAR(rightSide(*changed, 0.0, 1.0, 3.0), 7, 1e-9);
    EXPECT_NEAR(rightSide(*changed, 9.0, 1.0, 3.0), 10, 1e-9);
}

TEST(ParameterChange, LetsAParameterMoveWithASignal) {
    const FlatModel flat = flatOf("model M parameter Real p = 2; Real x; equation x = 10*p; end M;");
    const Outcome<FlatModel> moving = withDependence(flat, "p", "flow");
    ASSERT_TRUE(moving) << format(moving.diagnostics());
    const double value = moving->pool->evaluate(moving->equations.front().right, [&](const ExpressionNode& node) {
        const std::string& name = (*moving)[node.variable].name;
        if (name == "p.slope") return 0.5;
        if (name == "flow") return 3.0;
        return moving->parameterValue(node.variable).value_or(std::nan(""));
    });
    EXPECT_NEAR(value, 10 * (2 + 0.5 * 3.0), 1e-9);
    EXPECT_EQ((*moving)[moving->find("flow")].causality, FlatCausality::Input);
}

TEST(ParameterChange, LetsASignalSetAVariableInsteadOfItsEquation) {
    const FlatModel flat = flatOf("model M Real x; Real y; equation y = 2*x; x = sin(time); end M;");
    const Outcome<FlatModel> imposed = withImposed(flat, "x", "recorded");
    ASSERT_TRUE(imposed) << format(imposed.diagnostics());
    EXPECT_EQ((*imposed)[imposed->find("recorded")].causality, FlatCausality::Input);
    const ExpressionNode& right = (*imposed->pool)[imposed->equations.back().right];
    ASSERT_EQ(right.operation, Operation::Variable);
    EXPECT_EQ(right.variable, imposed->find("recorded"));
    EXPECT_FALSE(withImposed(flat, "z", "recorded")) << "no such variable";
    EXPECT_FALSE(withImposed(flat, "x", "y")) << "a variable of the input's name";
}

TEST(ParameterChange, LetsAVariableBeginWhereAParameterSays) {
    const FlatModel flat = flatOf(
        "model M parameter Real p = 2; input Real u; Real x(start=3, unit=\"V\"); Real y; equation der(x) = u; "
        "der(y) = x; end M;");
    const Outcome<FlatModel> started = withStarts(flat, {"p", "x.start", "y.start"});
    ASSERT_TRUE(started) << format(started.diagnostics());
    const auto valueOf = [&](const char* name) { return started->parameterValue(started->find(name)).value_or(-1); };
    EXPECT_EQ(valueOf("x.start"), 3);
    EXPECT_EQ(valueOf("y.start"), 0);
    EXPECT_EQ((*started)[started->find("x.start")].unit, "V");
    const FlatVariable& x = (*started)[started->find("x")];
    EXPECT_TRUE(x.isFixed);
    EXPECT_EQ(x.start, started->pool->variable(started->find("x.start")));
    for (const char* name : {"u.start", "p.start", "z.start", "x"}) EXPECT_FALSE(withStart(flat, name)) << name;
}

TEST(ParameterChange, RefusesWhatIsNoParameter) {
    const FlatModel flat = flatOf("model M Real x; equation x = time; end M;");
    EXPECT_FALSE(withDependence(flat, "x", "flow"));
    EXPECT_FALSE(withChange(flat, "x", 0.1));
    EXPECT_FALSE(withChange(flat, "y", 0.1));
}

}  // namespace
}  // namespace analogon::test
