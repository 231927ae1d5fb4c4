#include "core/effect/tell/proposed_value.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

TEST(ProposedValue, OfAChangeSaysWhenAndFromWhatToWhat) {
    Change change;
    change.parameter = "winding.R";
    change.time = 12.5;
    change.before = 1.2;
    change.after = 1.5;
    change.explained = 300;
    const Remainder r = remainderOf(change, 40);
    EXPECT_EQ(r.node, "winding");
    EXPECT_EQ(r.proposal.equation.english(), "winding.R = if time < 12.5 then 1.2 else 1.5");
    EXPECT_EQ(r.from, 12.5);
    EXPECT_EQ(r.to, 40);
}

TEST(ProposedValue, OfADependenceSaysOnWhichChannel) {
    ChannelDependence d;
    d.parameter = "winding.R";
    d.channel = "T_case";
    d.value = 1.2;
    d.slope = -0.4;
    d.range = 20;
    d.middle = 300;
    EXPECT_EQ(remainderOf(d).proposal.equation.english(), "winding.R = 1.2 - 0.02*(T_case - 300)");
}

TEST(ProposedValue, OfChecksIsTheConditionThatSuitsEachBest) {
    EXPECT_EQ(leastOf({}), -1);
    EXPECT_DOUBLE_EQ(leastOf({{"a", 2, 1, 3}, {"b", 1, 4, 5}}), 1);
}

TEST(ProposedValue, BeyondABoundSaysToWidenIt) {
    HeldInstead held;
    held.parameter = "body.C";
    held.unit = "J/K";
    held.held = 5;
    held.value = 6.2;
    held.standardError = 0.1;
    EXPECT_NE(remarkOf(held).english().find("let it be fitted"), std::string::npos);
    held.byBound = true;
    EXPECT_NE(remarkOf(held).english().find("widen the bound"), std::string::npos);
    EXPECT_NE(remarkOfEqual(held).english().find("explains as much"), std::string::npos);
}

}  // namespace
}  // namespace analogon
