#include "core/effect/search/laws.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/search/warm_nodes.hpp"

namespace analogon {
namespace {

TEST(Laws, CountAsTheirTerms) {
    WarmSearch of(laggingBody(3));
    Node node = lagFound(of);
    EXPECT_EQ(termsIn(of.search, node.null), 1u);
    PlacedEffect& placed = node.null.variant.effects.front();
    placed.freed.push_back(placed.freed.front());
    of.search.laws[placed.effect.className] = "a law of two terms";
    EXPECT_EQ(termsIn(of.search, node.null), 2u);
}

TEST(Laws, AreSoughtOnceWhereNonePasses) {
    WarmSearch of(laggingBody(0));
    Node node{of.base, {}};
    EXPECT_FALSE(addLaw(of.search, node));
    EXPECT_TRUE(node.steps.empty());
    EXPECT_EQ(of.search.frontier.stays.lawless.size(), 1u);
    EXPECT_FALSE(addLaw(of.search, node));
    EXPECT_EQ(of.search.frontier.stays.lawless.size(), 1u) << "the same effects at the same optimum";
}

}  // namespace
}  // namespace analogon
