#include "core/effect/search/beside_flow.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/effect/judge/judgement.hpp"
#include "core/effect/search/best_path.hpp"
#include "core/effect/search/contenders.hpp"
#include "core/effect/search/indicate.hpp"
#include "core/effect/search/path.hpp"
#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

/// A body behind a sensor that lags, into which a heat flow goes that nobody recorded and that changes within 2 s.
/// `size`: root mean square [W].
EstimationTask laggingBodyBesideAFlow(double lag, double size, unsigned seed) {
    EstimationTask task = laggingBody(lag);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Recording& r = task.recordings.edit().front();
    const double step = r.time[1] - r.time[0], keeps = std::exp(-step / 2);
    double flow = 0, body = 0, sensor = 0;
    for (Eigen::Index k = 0; k < r.outputs.cols(); ++k) {
        r.outputs(0, k) += lag > 0 ? sensor : body;
        flow = keeps * flow + std::sqrt(1 - keeps * keeps) * size * normal(random);
        for (int i = 0; i < 100; ++i) {
            if (lag > 0) sensor += step / 100 * (body - sensor) / lag;
            body += step / 100 * (flow - 0.2 * body) / 4;
        }
    }
    return task;
}

std::string kindsOf(const Node& node) {
    std::string kinds;
    for (const PlacedEffect& e : node.null.variant.effects) kinds += e.effect.kind;
    return kinds;
}

TEST(LikeliestBesideFlow, IsTheEffectThatPredictionAloneDoesNotTell) {
    for (const unsigned seed : {3, 4}) {
        WarmSearch of(laggingBodyBesideAFlow(0.6, 1, seed));
        ASSERT_FALSE(isNoise(of.base));
        Round round = tryAll(of.search, of.base);
        EXPECT_TRUE(contendersOf(of.search, of.base, round.trials).empty());
        const LikeliestBesideFlow found = withLikeliestBesideFlow(of.search, Node{of.base, {}}, round);
        EXPECT_TRUE(found.isAnyClear);
        const std::optional<Node>& node = found.node;
        ASSERT_TRUE(node) << seed;
        EXPECT_EQ(kindsOf(*node), "sensor.lag");
        ASSERT_TRUE(node->steps.front().prediction && node->steps.front().prediction->besideFlow);
        EXPECT_GT(*node->steps.front().prediction->besideFlow, 30);
        EXPECT_GT(node->steps.front().prediction->removed(), 0);
        ASSERT_TRUE(round.chosen);
        EXPECT_EQ(round.candidate(*round.chosen).effect.kind, "sensor.lag");
    }
}

TEST(LikeliestBesideFlow, IsNothingBesideAFlowAlone) {
    for (const unsigned seed : {11, 12, 13, 14, 15, 16}) {
        WarmSearch of(laggingBodyBesideAFlow(0, 1, seed));
        Round round = tryAll(of.search, of.base);
        const LikeliestBesideFlow found = withLikeliestBesideFlow(of.search, Node{of.base, {}}, round);
        EXPECT_FALSE(found.node) << kindsOf(*found.node) << ", seed " << seed;
        EXPECT_FALSE(found.isAnyClear);
        seekLikeliest(of.search, of.base, round);
        EXPECT_TRUE(of.search.frontier.best.first.isFlowAlone);
    }
}

TEST(LikeliestBesideFlow, EndsTheSearchForOtherPathsWhereItIsTheFlowAlone) {
    for (const bool isFlowAlone : {true, false}) {
        DiscoverOptions options;
        options.trace = std::make_shared<DecisionTrace>();
        WarmSearch of(isFlowAlone ? laggingBodyBesideAFlow(0, 1, 12) : laggingBodyBesideAFlow(0.6, 1, 3), options);
        ASSERT_TRUE(bestPathFrom(of.search, of.base));
        EXPECT_EQ(of.search.frontier.best.first.isFlowAlone, isFlowAlone);
        const std::vector<Decision> decisions = options.trace->decisions();
        const bool isLawSought =
            std::any_of(decisions.begin(), decisions.end(), [](const Decision& d) { return d.step == "law"; });
        EXPECT_EQ(isLawSought, !isFlowAlone);
    }
}

TEST(LikeliestBesideFlow, IsSoughtOnceAndToldByASearchThatIsInterrupted) {
    WarmSearch of(laggingBodyBesideAFlow(0.6, 1, 3));
    Frontier& frontier = of.search.frontier;
    seekLikeliest(of.search, of.base, tryAll(of.search, of.base));
    EXPECT_TRUE(frontier.best.first.isBeside(of.base));
    EXPECT_FALSE(frontier.best.first.isFlowAlone);
    ASSERT_TRUE(frontier.best.first.node);
    ASSERT_NE(frontier.toTell(), nullptr);
    EXPECT_EQ(kindsOf(frontier.toTell()->node), "sensor.lag");

    const double tried = of.search.work.done;
    Node node{of.base, {}};
    indicate(of.search, node, {});
    EXPECT_EQ(kindsOf(node), "sensor.lag");
    EXPECT_EQ(of.search.work.done, tried) << "no trial is made again";

    frontier.best.clear = Whole{Node{of.base, {}}, of.search.readings};  // what is clear goes before it
    EXPECT_EQ(frontier.toTell(), &*frontier.best.clear);
}

TEST(SoughtFirst, IsBesideAModelThatLeavesTheSameAtAnyLevelOfNoise) {
    NullModel model;
    SoughtFirst known;
    EXPECT_FALSE(known.isBeside(model)) << "nothing was sought";
    known.residuals = Eigen::Vector3d(1, 2, 3);
    model.fit.optimum.residuals = 2 * known.residuals;
    EXPECT_TRUE(known.isBeside(model));
    model.fit.optimum.residuals = -known.residuals;
    EXPECT_FALSE(known.isBeside(model));
    model.fit.optimum.residuals = Eigen::Vector3d(3, 2, 1);
    EXPECT_FALSE(known.isBeside(model));
    model.fit.optimum.residuals = Eigen::Vector4d(1, 2, 3, 4);
    EXPECT_FALSE(known.isBeside(model)) << "of other recordings";
}

TEST(LikeliestBesideFlow, IsIndicatedWhereNothingPredictsClearlyBetter) {
    WarmSearch of(laggingBodyBesideAFlow(0.6, 1, 3));
    Node node{of.base, {}};
    indicate(of.search, node, {});
    ASSERT_EQ(kindsOf(node), "sensor.lag");
    ASSERT_TRUE(node.steps.front().prediction);
}

}  // namespace
}  // namespace analogon
