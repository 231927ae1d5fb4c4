#include "core/effect/search/best_path.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace analogon
