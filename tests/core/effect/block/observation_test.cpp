#include "core/effect/block/observation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/effect/block/candidates_of.hpp"
#include "tests/core/effect/hand_made.hpp"
#include "tests/core/effect/lagging_body.hpp"

namespace analogon {
namespace {

using Shapes = std::vector<std::map<std::string, double>>;

Observations observed() {
    Observations o;
    o.setTimes({{0, 1, 2}, {0, 0.5}});
    o.add("w", {{3, -5, 1}, {2, 4}});
    o.add("through port", {{3, 4}});
    return o;
}

TEST(Observations, HaveTheStatisticsOfAllExperimentsTogether) {
    const Observations o = observed();
    EXPECT_EQ(o.statistic("range", "w"), 9);
    EXPECT_EQ(o.statistic("maxabs", "w"), 5);
    EXPECT_EQ(o.statistic("minimum", "w"), -5);
    EXPECT_EQ(o.statistic("maximum", "w"), 4);
    EXPECT_EQ(o.statistic("mean", "w"), 1);
    EXPECT_NEAR(o.statistic("rms", "w"), std::sqrt(11.0), 1e-12);
    EXPECT_EQ(o.statistic("start", "w"), 3);
    EXPECT_EQ(o.statistic("rate", "w"), 8) << "per second, and none from one experiment to the next";
    EXPECT_NEAR(o.statistic("through", "port"), std::sqrt(12.5), 1e-12);
    EXPECT_TRUE(std::isnan(o.statistic("range", "phi"))) << "not observed";
    EXPECT_TRUE(std::isnan(o.statistic("median", "w"))) << "no such function";
}

TEST(Observations, AreOfTheRecordingWhereItTellsMore) {
    Observations o = observed();
    EXPECT_TRUE(o.lead().empty());
    o.setLead("w", {Eigen::Vector3d(0, 0, 10), Eigen::Vector2d(0, 0)});
    EXPECT_EQ(o.statistic("maximum", "w"), 11);
    EXPECT_EQ(o.series("w")[0][2], 1) << "the simulation is as it was";
    EXPECT_TRUE(o.series("phi").empty());
}

TEST(ContextOf, KnowsTheFirstFittedRecording) {
    NullModel null = modelThatLeaves(whiteNoise(101), Eigen::MatrixXd(101, 0));
    const Observations none;
    EXPECT_EQ(contextOf(null, none).quantity("duration"), 100);
    EXPECT_EQ(contextOf(null, none).quantity("sample"), 1);
    EXPECT_TRUE(std::isnan(contextOf(null, none).quantity("period"))) << "nothing repeats";
    null.period = 7;
    EXPECT_EQ(contextOf(null, none).quantity("period"), 7);
    EXPECT_TRUE(std::isnan(contextOf(null, none).quantity("speed")));
}

TEST(ShapesOf, AreAllCombinationsThatAreValid) {
    const NullModel null = modelThatLeaves(whiteNoise(101), Eigen::MatrixXd(101, 0));
    const Observations none;
    const ShapeContext context = contextOf(null, none);
    EffectClass effect;
    effect.parameters.strength = "k";
    EXPECT_EQ(*shapesOf(effect, context, 0), Shapes{{}}) << "of no shape there is one";
    effect.parameters.shape = {{"a", {"1*sample", "k"}}, {"b", {"10", "20"}}};
    EXPECT_EQ(*shapesOf(effect, context, 3),
              (Shapes{{{"a", 1}, {"b", 10}}, {{"a", 3}, {"b", 10}}, {{"a", 1}, {"b", 20}}, {{"a", 3}, {"b", 20}}}));
    effect.trial.valid = "a*b - 25";
    EXPECT_EQ(*shapesOf(effect, context, 3), (Shapes{{{"a", 3}, {"b", 10}}, {{"a", 3}, {"b", 20}}}));
    effect.trial.valid = "a - 100";
    const Outcome<Shapes> refused = shapesOf(effect, context, 3);
    ASSERT_FALSE(refused);
    EXPECT_THAT(format(refused.diagnostics()),
                testing::HasSubstr("does not show what tells this effect apart: a - 100"));
}

/// The temperature of the body that an added loss would see, simulated with the loss off.
TEST(ObserveFor, TakesWhatTheShapesOfTheNewestEffectName) {
    const NullModel null = fittedModel(laggingBody(0));
    Candidate loss = firstCandidate(null.variant, "thermal.loss");
    loss.effect.parameters.shape["T_amb"] = {"start(T)", "maximum(T)", "through(port)"};
    const Outcome<Variant> off = withEffect(null.variant, loss.effect, loss.place, {});
    ASSERT_TRUE(off) << format(off.diagnostics());
    const Outcome<Observations> seen = observeFor(null, *off, {});
    ASSERT_TRUE(seen) << format(seen.diagnostics());
    EXPECT_NEAR(seen->statistic("start", "T"), 300, 1e-6);
    EXPECT_NEAR(seen->statistic("maximum", "T"), 336.7, 1.5);
    EXPECT_GT(seen->statistic("through", "port"), 1);
    EXPECT_LT(seen->statistic("through", "port"), 8.1) << "no more than the heater gives";
}

}  // namespace
}  // namespace analogon
