#include "core/effect/search/held_values.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/held_body.hpp"
#include "tests/core/effect/search/warm_nodes.hpp"

namespace analogon {
namespace {

TEST(HeldValues, AreNoneWhereNothingIsHeldThatCouldBeWrong) {
    EstimationTask task = laggingBody(3);
    task.parameters.push_back({"body.C", "J/K", 4, 1, 10});
    WarmSearch of(task);
    Node node = lagFound(of);
    for (const auto& [order, values] : heldValues(of.search, node)) EXPECT_TRUE(values.empty()) << order;
    EXPECT_TRUE(takeOutForHeld(of.search, node, {}).empty());
    EXPECT_TRUE(takeOutAllForHeld(of.search, node, of.base).empty());
    EXPECT_EQ(node.steps.size(), 1u);
}

const FitParameter joint{"joint.G", "W/K", 0.3, 0.01, 10};

TEST(HeldValues, AreTheBetterAccountWhereNothingElseIsFound) {
    WarmSearch of(bodyHeldAt(6, {joint}));
    Node node{of.base, {}};
    ASSERT_FALSE(isNoise(of.base));
    const std::vector<HeldInstead> values = takeOutForHeld(of.search, node, {});
    ASSERT_EQ(values.size(), 1u);
    EXPECT_EQ(values[0].parameter, "body.C");
    WarmSearch right(bodyHeldAt(4, {joint}));
    Node noise{right.base, {}};
    EXPECT_TRUE(takeOutForHeld(right.search, noise, {}).empty());
}

TEST(HeldValues, AreNotAskedForBesideAParameterThatChanges) {
    WarmSearch of(bodyHeldAt(6, {joint}));
    Node node{of.base, {}};
    of.search.courses.change.emplace();
    EXPECT_TRUE(takeOutForHeld(of.search, node, {}).empty());
}

}  // namespace
}  // namespace analogon
