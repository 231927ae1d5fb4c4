#include "core/effect/judge/node.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/hand_made.hpp"

namespace analogon {
namespace {

/// To go back is to go on from another node: what is done to a copy is not done to the node.
TEST(Node, IsAValueOfWhichACopyGoesItsOwnWay) {
    Node node{modelThatLeaves(whiteNoise(50), Eigen::MatrixXd::Ones(50, 1)), {}};
    const ScoresBeside& scores = node.null.scores();
    const double left = node.null.sumOfSquares();
    Node further = node;
    further.steps.emplace_back();
    further.candidates.emplace_back();
    further.null = further.null.with(further.null.variant, FitResult());
    further.null.variant.task.recordings.edit().front().name = "redrawn";
    EXPECT_TRUE(node.steps.empty());
    EXPECT_TRUE(node.candidates.empty());
    EXPECT_EQ(node.null.sumOfSquares(), left);
    EXPECT_EQ(&node.null.scores(), &scores) << "what was found of it is known still";
    EXPECT_EQ(node.null.variant.task.recordings.front().name, "run");
}

TEST(Node, BeginsWithoutAChoiceAndWithNothingKnownOfIt) {
    const Node node{modelThatLeaves(whiteNoise(50), Eigen::MatrixXd(50, 0)), {}};
    EXPECT_FALSE(node.state);
    EXPECT_FALSE(node.meetsAnother);
    const Step step;
    EXPECT_EQ(step.errorWithout, -1) << "not known";
    EXPECT_FALSE(step.prediction) << "established as long as nothing else is said";
    EXPECT_EQ(step.tried, 1u);
    EXPECT_FALSE(step.acceptance.accepted());
}

}  // namespace
}  // namespace analogon
