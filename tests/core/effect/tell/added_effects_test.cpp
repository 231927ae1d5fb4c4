#include "core/effect/tell/added_effects.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/effect/judge/judgement.hpp"
#include "tests/core/effect/hand_made.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;

PlacedEffect lagOf(const std::string& output) {
    PlacedEffect placed;
    placed.effect.kind = "sensor.lag";
    placed.effect.className = "Analogon.Effects.Sensor.Lag";
    placed.effect.description = "Lag of a measured channel";
    placed.effect.placement.way = Way::Insert;
    placed.effect.placement.signalSide = "output";
    placed.effect.parameters.units = {{"T", "s"}, {"w", "K"}};
    placed.place.at = "output " + output;
    placed.instance = "lag";
    placed.freed.resize(1);
    placed.freed.front().name = "lag.T";
    placed.values["w"] = 2;
    return placed;
}

FitEstimate estimate(const std::string& name, double value, double error) {
    FitEstimate e;
    e.name = name;
    e.value = value;
    e.standardError = error;
    e.unit = "s";
    return e;
}

/// A node with a lag of 3 s, in what a fit found, and 3.1 s in the state that is told.
Node lagged() {
    Node node{modelThatLeaves(whiteNoise(50), Eigen::MatrixXd(50, 0)), {}};
    node.null.variant.effects = {lagOf("T")};
    node.null.fit.estimates = {estimate("lag.T", 3, 0.2)};
    Step step;
    step.order = 4;
    step.tried = 10;
    step.acceptance.explained = 30;
    step.acceptance.evidence = 25;
    step.acceptance.heldOut = 0.9;
    step.alternatives = {{"sensor.delay", "output T", 7, true},
                         {"sensor.lag", "output T", 1, true},
                         {"sensor.delay", "output T", 8, false}};
    node.steps = {step};
    return node;
}

Finding told(const Node& node, const HeldValues& held = {}, double errorAfter = -1) {
    Finding finding;
    finding.final.parameters = {estimate("lag.T", 3.1, 0.1)};
    addEffects(finding, node, held, nullptr, errorAfter);
    return finding;
}

TEST(AddEffects, TellsWhereAndWhatWithTheValuesThatAreReported) {
    const Finding finding = told(lagged());
    ASSERT_EQ(finding.effects.size(), 1u);
    const AddedEffect& lag = finding.effects.front();
    EXPECT_EQ(lag.kind, "sensor.lag");
    EXPECT_EQ(lag.at, "output T");
    EXPECT_EQ(lag.wired.way, Way::Insert);
    EXPECT_EQ(lag.wired.instance, "lag");
    ASSERT_EQ(lag.parameters.size(), 2u);
    EXPECT_EQ(lag.parameters[0].name, "T");
    EXPECT_EQ(lag.parameters[0].value, 3.1);
    EXPECT_EQ(lag.parameters[0].standardError, 0.1);
    EXPECT_EQ(lag.parameters[1].name, "w");
    EXPECT_EQ(lag.parameters[1].value, 2);
    EXPECT_EQ(lag.parameters[1].unit, "K");
    EXPECT_TRUE(std::isnan(lag.parameters[1].standardError)) << "it was not fitted";
    Finding before;  // an interrupted search may have a state of before the last refit
    addEffects(before, lagged(), {}, nullptr, -1);
    EXPECT_EQ(before.effects.front().parameters[0].value, 3);
}

TEST(AddEffects, TellsTheEvidenceByTheTestsThatItPassed) {
    const Evidence evidence = told(lagged()).effects.front().evidence;
    EXPECT_EQ(evidence.score, 30);
    EXPECT_EQ(evidence.deltaBic, -25) << "negative is better";
    EXPECT_EQ(evidence.heldOut, 0.9);
    EXPECT_EQ(evidence.pValue, pValue(30, 1, 10));
}

TEST(AddEffects, TellsEachAlternativeOnceAndNoneThatStandsInTheModel) {
    const AddedEffect lag = told(lagged()).effects.front();
    ASSERT_EQ(lag.instead.effects.size(), 1u);
    EXPECT_EQ(lag.instead.effects[0].kind, "sensor.delay");
    EXPECT_EQ(lag.instead.effects[0].deltaBic, -18) << "on the scale of the chosen one";
    EXPECT_TRUE(lag.instead.effects[0].equivalent);
}

TEST(AddEffects, TellsWhatTheModelIsWithoutIt) {
    Node node = lagged();
    node.steps.front().errorWithout = 6;
    EXPECT_EQ(told(node, {}, 1.5).effects.front().evidence.errorPercentBefore, 6);
    EXPECT_EQ(told(node, {}, 1.5).effects.front().evidence.errorPercentAfter, 1.5);
}

TEST(AddEffects, IsIndicatedWhereAPredictionIsAllThatSpeaksForIt) {
    EXPECT_EQ(told(lagged()).effects.front().confidence, Confidence::Established);
    Node node = lagged();
    node.steps.front().prediction = Prediction();
    EXPECT_EQ(told(node).effects.front().confidence, Confidence::Indicated);
    EXPECT_TRUE(told(node).effects.front().prediction);
}

TEST(AddEffects, TellsATwinAsAnEffectOfItsOwnAndSaysSo) {
    Node node = lagged();
    PlacedEffect& lag = node.null.variant.effects.front();
    lag.twins = {{"output T2", "T2", "", ""}};
    lag.twinInstances = {"lag2"};
    const Finding finding = told(node);
    ASSERT_EQ(finding.effects.size(), 2u);
    EXPECT_EQ(finding.effects[1].at, "output T2");
    EXPECT_EQ(finding.effects[1].wired.instance, "lag2");
    EXPECT_EQ(finding.effects[1].parameters[0].value, 3.1);
    EXPECT_TRUE(finding.effects[1].instead.effects.empty());
    ASSERT_EQ(finding.warnings.size(), 1u);
    EXPECT_THAT(finding.warnings[0].english(), HasSubstr("sensor.lag stands at output T and output T2"));
}

TEST(AddEffects, NamesTheValuesThatWouldExplainAsMuchByTheChoice) {
    HeldInstead held;
    held.parameter = "core.C";
    held.value = 302;
    held.unit = "J/K";
    EXPECT_EQ(told(lagged(), {{4, {held}}}).effects.front().instead.values, std::vector<Text>{"core.C = 302 J/K"});
    EXPECT_TRUE(told(lagged(), {{3, {held}}}).effects.front().instead.values.empty()) << "of another choice";
    Finding finding;
    EXPECT_EQ(addEffects(finding, lagged(), {{4, {held}}}, nullptr, -1).size(), 1u);
}

}  // namespace
}  // namespace analogon
