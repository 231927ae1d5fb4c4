#include "core/effect/block/flow_domain.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

TEST(FlowDomain, KnowsWhatFlowsWithItsUnits) {
    EXPECT_EQ(flowDomain("tau").flowUnit, "N.m");
    EXPECT_EQ(flowDomain("f").flowUnit, "N");
    EXPECT_EQ(flowDomain("i").flowUnit, "A");
    EXPECT_EQ(flowDomain("Q_flow").flowUnit, "W");
    EXPECT_EQ(flowDomain("Q_flow").potentialUnit, "K");
}

TEST(FlowDomain, HasARateOnlyWhereAFlowMayDependOnOne) {
    EXPECT_EQ(flowDomain("tau").rate, "w");
    EXPECT_EQ(flowDomain("f").rateUnit, "m/s");
    EXPECT_TRUE(flowDomain("i").rate.empty());
    EXPECT_TRUE(flowDomain("Q_flow").rate.empty());
}

TEST(FlowDomain, OfAnUnknownNameHasNoUnits) {
    const FlowDomain domain = flowDomain("m_flow");
    EXPECT_EQ(domain.flow, "m_flow");
    EXPECT_EQ(domain.lawName, "MissingFlow");
    EXPECT_TRUE(domain.flowUnit.empty() && domain.potentialUnit.empty());
}

}  // namespace
}  // namespace analogon
