#include "core/effect/search/best_path.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/hand_made.hpp"
#include "tests/core/effect/search/warm_nodes.hpp"

namespace analogon {
namespace {

TEST(BestPath, OfNoiseIsTheModelAsGiven) {
    WarmSearch of(laggingBody(0));
    const Outcome<Node> best = bestPathFrom(of.search, of.base);
    ASSERT_TRUE(best);
    EXPECT_TRUE(best->steps.empty());
    EXPECT_FALSE(best->candidates.empty()) << "what was tried is told";
}

TEST(IsExplained, IsNoiseBehindFewNames) {
    WarmSearch of(laggingBody(3));
    const Node node = lagFound(of);
    EXPECT_TRUE(isExplained(node, 1));
    EXPECT_FALSE(isExplained(node, 0));
    EXPECT_FALSE(isExplained({of.base, {}}, 1));
}

TEST(IsEnoughTried, AreTwoOtherBeginningsOrMuchWorkBehindTheFirst) {
    EXPECT_FALSE(isEnoughTried(0, 1e9)) << "the first is always tried";
    EXPECT_FALSE(isEnoughTried(1, 2.9e7));
    EXPECT_TRUE(isEnoughTried(1, 3.1e7));
    EXPECT_TRUE(isEnoughTried(2, 0));
}

TEST(IsNearEnoughForPairs, ByTheNoiseOrByTheError) {
    EXPECT_TRUE(isNearEnoughForPairs(9.9, 50));
    EXPECT_TRUE(isNearEnoughForPairs(11, 9.9));
    EXPECT_FALSE(isNearEnoughForPairs(10.1, 10.1));
}

TEST(LeavesLittle, IsATenthAboveTheNoise) {
    const auto leaves = [](double chi) {
        return leavesLittle(modelThatLeaves(Eigen::VectorXd::Constant(1000, chi), Eigen::MatrixXd(1000, 0)));
    };
    EXPECT_TRUE(leaves(1.09));
    EXPECT_FALSE(leaves(1.11));
}

}  // namespace
}  // namespace analogon
