#include "core/effect/block/law_probe.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/effect/block/candidates_of.hpp"
#include "tests/core/effect/lagging_body.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

ModelNodes::FlowNode bodyNode() {
    return {{"body.port", "body.port", "", ""}, "Analogon.Interfaces.HeatPort_a", "T", "Q_flow"};
}

/// What may flow at the body: in proportion to its own temperature over 300 K, and to the power.
LawProbe probeAtBody(const NullModel& null) {
    LawProbe probe(null, siteOf(bodyNode()));
    LawQuantity own;
    own.name = "p";
    own.shown = "(T - 300)";
    own.unit = UnitFactors::of("K");
    own.origin = 300;
    probe.addOwn(own, "port.T");
    LawQuantity power;
    power.name = "x1";
    power.variable = power.shown = "P";
    power.unit = UnitFactors::of("W");
    probe.addForeign(power);
    probe.terms() = {{"p", "(T - 300)", UnitFactors::of("K"), 1}, {"x1", "P", UnitFactors::of("W"), 2}};
    return probe;
}

TEST(LawSite, SaysWhatIsMissingThere) {
    const LawSite flow = siteOf(bodyNode()), reading = siteOf("T", "K");
    EXPECT_EQ(flow.baseName, "MissingHeatFlow");
    EXPECT_EQ(flow.shown, "body.port.Q_flow =");
    EXPECT_EQ(flow.unit->text(), UnitFactors::of("W")->text());
    EXPECT_EQ(flow.way, Way::Attach);
    EXPECT_EQ(reading.shown, "T = T_true +");
    EXPECT_EQ(reading.place.at, "output T");
    EXPECT_EQ(reading.way, Way::Insert);
    EXPECT_EQ(reading.signalSide, "output");
    EXPECT_EQ(trueReading("T"), "T_true");
}

TEST(LawProbe, WritesAClassOfTheChosenTermsAlone) {
    const NullModel null = fittedModel(laggingBody(0));
    const LawProbe probe = probeAtBody(null);
    const Law one = probe.law({0}, 3), both = probe.law({1, 0}, 4);
    EXPECT_EQ(one.candidate.effect.className, "MissingHeatFlow3");
    EXPECT_EQ(one.candidate.effect.proposal, "body.port.Q_flow = a1*(T - 300)");
    EXPECT_EQ(one.candidate.effect.parameters.units.at("a1"), UnitFactors::of("W/K")->text());
    EXPECT_TRUE(one.candidate.effect.bound.empty());
    EXPECT_THAT(one.text, HasSubstr("p = port.T - (300);"));
    EXPECT_THAT(one.text, Not(HasSubstr("x1")));
    EXPECT_EQ(both.candidate.effect.proposal, "body.port.Q_flow = a1*P + a2*(T - 300)");
    EXPECT_EQ(both.candidate.effect.parameters.linear, std::vector<std::string>{"a2"});
    EXPECT_EQ(both.candidate.effect.bound.at("x1"), "P");
    EXPECT_THAT(both.text, HasSubstr("port.Q_flow = a1*x1 + a2*p;"));
}

/// The written class stands in the model and, switched off, changes nothing.
TEST(LawProbe, WritesAClassThatCanBeWiredIn) {
    const NullModel null = fittedModel(laggingBody(0));
    const Law law = probeAtBody(null).law({1, 0}, 0);
    Variant variant = null.variant;
    Outcome<Library> library = variant.task.library.withSource(std::make_shared<Source>("law.mo", law.text));
    ASSERT_TRUE(library) << format(library.diagnostics());
    variant.task.library = std::move(*library);
    const Outcome<Variant> wired = withEffect(variant, law.candidate.effect, law.candidate.place, {});
    ASSERT_TRUE(wired) << format(wired.diagnostics());
    const Outcome<PreparedTask> held = prepareHeld(*wired, {}, null.noise);
    ASSERT_TRUE(held) << format(held.diagnostics());
    const Linearisation off = linearise(held->problem, {}, false, {}, {}, {});
    ASSERT_TRUE(off.ok) << off.failure;
    EXPECT_LT((off.residuals - null.fit.optimum.residuals).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(LawProbe, TakesTheTracesOfAllTermsAtCoefficientsOfZero) {
    const NullModel null = fittedModel(laggingBody(0));
    LawProbe probe = probeAtBody(null);
    const std::optional<Eigen::MatrixXd> traces = probe.traces({}, {});
    ASSERT_TRUE(traces);
    ASSERT_EQ(traces->cols(), 2);
    // a flow in proportion to the temperature over 300 K is that of the joint; its trace is the slope along joint.G
    const Eigen::VectorXd slope = null.fit.optimum.jacobian.col(0);
    EXPECT_NEAR(traces->col(0).normalized().dot(slope.normalized()), 1, 1e-4);
    EXPECT_NEAR(traces->col(0).norm(), slope.norm(), 1e-2 * slope.norm());
    probe.terms().clear();
    EXPECT_FALSE(probe.traces({}, {}));
}

}  // namespace
}  // namespace analogon
