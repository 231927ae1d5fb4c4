#include "core/effect/search/beside_flow.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/effect/judge/judgement.hpp"
#include "core/effect/search/best_path.hpp"
#include "core/effect/search/contenders.hpp"
#include "core/effect/search/indicate.hpp"
#include "core/effect/search/path.hpp"
#include "tests/core/effect/search/flow_search.hpp"

namespace analogon {
namespace {

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
    indicate(of.search, of.base, node, {});
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
    indicate(of.search, of.base, node, {});
    ASSERT_EQ(kindsOf(node), "sensor.lag");
    ASSERT_TRUE(node.steps.front().prediction);
}

/// An effect that least squares may have begun with beside a flow.
class LikelierThan : public testing::Test {
protected:
    LikelierThan() : of(laggingBodyBesideAFlow(0.6, 1, 3)) {
        seekLikeliest(of.search, of.base, tryAll(of.search, of.base));
    }
    WarmSearch of;
};

TEST_F(LikelierThan, TheEffectsOfANodeIsWhatIsClearlyLikelierAlone) {
    const std::optional<Node> likelier = likelierThan(of.search, of.base, nodeWith(of, "sensor.offset"));
    ASSERT_TRUE(likelier);
    EXPECT_EQ(kindsOf(*likelier), "sensor.lag");
    EXPECT_FALSE(likelierThan(of.search, of.base, nodeWith(of, "sensor.lag"))) << "the node has it";
    EXPECT_FALSE(likelierThan(of.search, of.base, Node{of.base, {}})) << "there is nothing to take the place of";
    of.search.frontier.best.first.residuals *= -1;
    EXPECT_FALSE(likelierThan(of.search, of.base, nodeWith(of, "sensor.offset"))) << "sought beside another model";
}

TEST_F(LikelierThan, TheEffectsOfANodeIsIndicatedInTheirPlace) {
    Node node = nodeWith(of, "sensor.offset");
    indicate(of.search, of.base, node, {});
    EXPECT_EQ(kindsOf(node), "sensor.lag");
    ASSERT_EQ(node.steps.size(), 1u);
    ASSERT_TRUE(node.steps.front().prediction);
    EXPECT_TRUE(node.steps.front().prediction->besideFlow);
}

}  // namespace
}  // namespace analogon
