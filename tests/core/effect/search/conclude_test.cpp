#include "core/effect/search/conclude.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/search/warm_nodes.hpp"

namespace analogon {
namespace {

TEST(Conclude, KeepsAnEffectThatLeavesNoise) {
    WarmSearch of(laggingBody(3));
    Node node = lagFound(of);
    const Conclusion end = conclude(of.search, node, of.base, true);
    EXPECT_EQ(node.steps.size(), 1u);
    EXPECT_TRUE(end.proposed.empty());
    EXPECT_FALSE(end.leavesMuch);
    EXPECT_LT(end.misfit, misfitIn(of.base, of.base));
}

TEST(Conclude, TakesAllOutWhereAnotherAccountIsBetter) {
    WarmSearch of(laggingBody(3));
    Node node = lagFound(of);
    takeOutAll(of.search, node, of.base, Text("another account is better"));
    EXPECT_TRUE(node.steps.empty());
    EXPECT_TRUE(node.null.variant.effects.empty());
    for (const CandidateResult& c : node.candidates) EXPECT_NE(c.verdict, Verdict::Chosen);
}

TEST(Misfit, CountsWhatAParameterCosts) {
    WarmSearch of(laggingBody(3));
    const Node node = lagFound(of);
    const double rows = static_cast<double>(of.base.fit.optimum.residuals.size());
    EXPECT_NEAR(misfitIn(of.base, of.base), of.base.sumOfSquares() + std::log(rows), 1e-6 * of.base.sumOfSquares());
    EXPECT_EQ(node.null.parameterCount(), of.base.parameterCount() + 1);
}

}  // namespace
}  // namespace analogon
