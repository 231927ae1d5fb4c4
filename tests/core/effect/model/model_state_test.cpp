#include "core/effect/model/model_state.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/effect/lagging_body.hpp"

namespace analogon {
namespace {

OutputState output(const std::string& name, double errorPercent, double range) {
    OutputState o;
    o.name = name;
    o.measured = Eigen::Vector2d(0, range);
    o.simulated = Eigen::Vector2d(0, range * (1 + errorPercent / 100 * std::sqrt(2.0)));
    o.figures = errorFigures(o.simulated.transpose(), o.measured.transpose());
    return o;
}

ExperimentState experiment(Role role, double errorPercent, double range = 1) {
    ExperimentState e;
    e.role = role;
    e.outputs = {output("y", errorPercent, range)};
    e.errorPercent = errorPercentOf(e.outputs);
    return e;
}

TEST(ErrorPercent, IsTheRootMeanSquareOfTheOutputsButForThoseThatAreZeroThroughout) {
    EXPECT_NEAR(errorPercentOf({output("a", 3, 1), output("b", 4, 20)}), std::sqrt(12.5), 1e-9);
    EXPECT_NEAR(errorPercentOf({output("a", 3, 1), output("b", 4, 0)}), 3, 1e-9);
}

TEST(IsColoured, IsWhatChanceBringsLessThanOnceInAThousandTimes) {
    ResidualSummary residual;
    residual.whiteProbability = 5e-4;
    EXPECT_TRUE(isColoured(residual));
    residual.whiteProbability = 2e-3;
    EXPECT_FALSE(isColoured(residual));
}

TEST(ErrorPercent, OfARoleIsThatOfItsExperimentsAlone) {
    ModelState state;
    EXPECT_EQ(errorPercentOf(state, Role::Fit), 0);
    EXPECT_EQ(validationErrorOf(state), -1) << "there is none";
    state.experiments = {experiment(Role::Fit, 3), experiment(Role::Fit, 4), experiment(Role::Validate, 10)};
    EXPECT_NEAR(errorPercentOf(state, Role::Fit), std::sqrt(12.5), 1e-9);
    EXPECT_NEAR(validationErrorOf(state), 10, 1e-9);
}

/// A model that is not fitted: no parameter.
Variant asItStands(EstimationTask task) {
    task.parameters.clear();
    return {std::move(task), {}, {}};
}

TEST(StateOf, SimulatesWhatOnlyValidatesBesideWhatIsFitted) {
    EstimationTask task = laggingBody(0);
    Recording check = task.recordings.front();
    check.name = "check";
    check.role = Role::Validate;
    check.outputs.array() += 1;
    task.recordings.push_back(check);
    const Outcome<ModelState> state = stateOf(asItStands(task), {}, {}, {});
    ASSERT_TRUE(state) << format(state.diagnostics());
    ASSERT_EQ(state->experiments.size(), 2u);
    EXPECT_EQ(state->experiments[1].name, "check");
    EXPECT_EQ(state->experiments[1].role, Role::Validate);
    EXPECT_NEAR((state->experiments[1].outputs[0].simulated - state->experiments[0].outputs[0].simulated).norm(), 0,
                1e-9);
    EXPECT_GT(validationErrorOf(*state), 2 * errorPercentOf(*state, Role::Fit));
    ASSERT_EQ(state->residual.size(), 1u) << "of the fitted recording alone";
    EXPECT_GT(state->residual.at("T").whiteProbability, 1e-3) << "the noise of the sensor";
}

TEST(StateOf, TellsHowFarTheParametersLeaveTheOutputsUncertainInAReportAlone) {
    const Variant variant{laggingBody(0), {}, {{"joint.G", -1, 0.2}}};
    FitResult fit;
    fit.simulations = 1;
    FitEstimate G;
    G.name = "joint.G";
    G.value = 0.2;
    G.standardError = 0.01;
    fit.estimates = {G};
    fit.values = Eigen::VectorXd::Constant(1, 0.2);
    fit.covariance = Eigen::MatrixXd::Constant(1, 1, 1e-4);
    const Outcome<ModelState> told = stateOf(variant, fit, {}, {}, Detail::Report),
                              errors = stateOf(variant, fit, {}, {}, Detail::Errors);
    ASSERT_TRUE(told && errors);
    EXPECT_EQ(errors->experiments[0].outputs[0].deviation.size(), 0);
    const Eigen::VectorXd& deviation = told->experiments[0].outputs[0].deviation;
    ASSERT_EQ(deviation.size(), 400);
    EXPECT_NEAR(deviation[0], 0, 1e-9) << "the start does not depend on it";
    // before the power falls: T = 300 + P/G (1 - exp(-G t / C)), by hand
    const double t = 49.75, T = 300 + 8 / 0.2 * (1 - std::exp(-0.2 * t / 4));
    const double slope = -(T - 300) / 0.2 + 8 / 0.2 * t / 4 * std::exp(-0.2 * t / 4);
    EXPECT_NEAR(deviation[199], 0.01 * std::abs(slope), 0.01);
}

TEST(StateOf, IsTheSameWhateverTheThreads) {
    Variant variant{laggingBody(0), {}, {{"joint.G", -1, 0.2}}};
    for (const double offset : {0.5, 1.0, 2.0}) {
        Recording another = variant.task.recordings.front();
        another.name = "recording " + std::to_string(variant.task.recordings.size() + 1);
        another.outputs.array() += offset;
        variant.task.recordings.push_back(another);
    }
    FitResult fit;
    fit.simulations = 1;
    fit.estimates.emplace_back();
    fit.estimates.back().name = "joint.G";
    fit.estimates.back().value = 0.2;
    fit.values = Eigen::VectorXd::Constant(1, 0.2);
    fit.covariance = Eigen::MatrixXd::Constant(1, 1, 1e-4);
    const Outcome<ModelState> one = stateOf(variant, fit, {}, {}),
                              several = stateOf(variant, fit, {}, {}, Detail::Report, 3);
    ASSERT_TRUE(one && several);
    ASSERT_EQ(one->experiments.size(), 4u);
    ASSERT_EQ(several->experiments.size(), 4u);
    for (std::size_t e = 0; e < 4; ++e) {
        EXPECT_EQ(several->experiments[e].name, one->experiments[e].name);
        EXPECT_EQ(several->experiments[e].errorPercent, one->experiments[e].errorPercent);
        EXPECT_EQ(several->experiments[e].outputs[0].simulated, one->experiments[e].outputs[0].simulated);
        EXPECT_EQ(several->experiments[e].outputs[0].deviation, one->experiments[e].outputs[0].deviation);
    }
}

TEST(ValuesAlone, AreWrittenIntoTheModelWithoutASimulation) {
    const Variant variant{laggingBody(0), {}, {{"joint.G", -1, 0.25}}};
    FitResult fit;
    fit.status = FitStatus::Converged;
    fit.simulations = 7;
    const Outcome<ModelState> state = valuesAlone(variant, fit);
    ASSERT_TRUE(state);
    EXPECT_NE(state->modelText.find("joint(G=0.25)"), std::string::npos) << state->modelText;
    EXPECT_EQ(state->simulations, 7);
    EXPECT_TRUE(state->experiments.empty());
    const Outcome<FlatModel> flat = flattened(variant.task, state->modelText);
    ASSERT_TRUE(flat);
    EXPECT_EQ(flat->parameterValue(flat->find("joint.G")), 0.25);
}

TEST(OtherParameters, AreThoseThatAnEffectHoldsBesideWhatIsKnown) {
    const EstimationTask task = taskOf(R"(model M
  Analogon.Effects.Sensor.Lag lag(T=3);
  Analogon.Sources.Constant one(k=1);
equation
  connect(one.y, lag.u);
end M;
)",
                                       "M");
    const Outcome<FlatModel> flat = flatten(task.library, "M");
    ASSERT_TRUE(flat) << format(flat.diagnostics());
    PlacedEffect placed;
    placed.instance = "lag";
    placed.effect.parameters.units["T"] = "s";
    std::vector<EffectValue> values;
    addOtherParameters(*flat, placed, values);
    ASSERT_EQ(values.size(), 1u) << "of no other component";
    EXPECT_EQ(values[0].name, "T");
    EXPECT_EQ(values[0].value, 3);
    EXPECT_EQ(values[0].unit, "s");
    EXPECT_TRUE(std::isnan(values[0].standardError));
    addOtherParameters(*flat, placed, values);
    EXPECT_EQ(values.size(), 1u) << "it is known already";
}

TEST(OtherParameters, AreNoneThatAreOff) {
    const EstimationTask task = taskOf(R"(model M
  Analogon.Effects.Thermal.SourceMass element(tau_s=12);
  Analogon.Thermal.HeatCapacitor body(C=20, T_start=300);
  Analogon.Sources.Constant power(k=5);
  Analogon.Sources.PrescribedHeatFlow heater;
equation
  connect(power.y, heater.Q_flow);
  connect(heater.port, element.port_a);
  connect(element.port_b, body.port);
end M;
)",
                                       "M");
    const Outcome<FlatModel> flat = flatten(task.library, "M");
    ASSERT_TRUE(flat) << format(flat.diagnostics());
    PlacedEffect placed;
    placed.instance = "element";
    for (const char* name : {"tau_s", "C_s", "G_s", "R_s"}) placed.effect.parameters.units[name] = "1";
    std::vector<EffectValue> values;
    addOtherParameters(*flat, placed, values);
    ASSERT_EQ(values.size(), 1u) << "a heat capacity of 0 says that it is small";
    EXPECT_EQ(values[0].name, "tau_s");
}

}  // namespace
}  // namespace analogon
