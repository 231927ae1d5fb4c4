#include "core/effect/search/first_fit.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

TEST(FirstFit, IsIntegratedNoMoreExactlyThanTheNoiseAsksFor) {
    WarmSearch of(laggingBody(0));
    const double asked = 1e-9, found = toleranceBeside(of.base, asked);
    EXPECT_GT(found, asked);
    EXPECT_LE(found, 3e-5);
    EXPECT_DOUBLE_EQ(found, 2e-3 * quietest(of.base));
    EXPECT_EQ(beginningAnywhere({}).otherStarts, 128);
}

TEST(FirstFit, IsHeldAgainstSevenOthersWithinAFactorOfFour) {
    EXPECT_EQ(beginningNear({}).starts, 8);
    EXPECT_EQ(beginningNear({}).startsWithin, 4);
}

TEST(FirstFit, BeginsNowhereElseWhereNoiseIsLeft) {
    WarmSearch of(laggingBody(0));
    const double before = of.base.sumOfSquares();
    EXPECT_FALSE(beginElsewhere(of.search, of.base));
    EXPECT_EQ(of.base.sumOfSquares(), before);
}

TEST(FirstFit, IsAsExactAsWasAskedForWhereTheNoiseAsksForMore) {
    WarmSearch of(laggingBody(0));
    const double found = toleranceBeside(of.base, 1e-9), between = (found + 3e-5) / 2;
    ASSERT_LT(found, between);
    EXPECT_DOUBLE_EQ(toleranceBeside(of.base, between), between);
}

TEST(LastFit, IsAstrayWhereItLeavesAFifthMoreThanTheSearchDidOnTheSameSamples) {
    WarmSearch of(laggingBody(0));
    NullModel last = of.base;
    EXPECT_FALSE(isAstray(last, of.base));
    last.fit.optimum.residuals *= 1.15;
    EXPECT_FALSE(isAstray(last, of.base));
    last.fit.optimum.residuals *= 1.1;
    EXPECT_TRUE(isAstray(last, of.base));
    last.fit.optimum.residuals.fill(std::numeric_limits<double>::quiet_NaN());
    EXPECT_TRUE(isAstray(last, of.base));
    last.fit.optimum.residuals.conservativeResize(last.fit.optimum.residuals.size() / 2);
    EXPECT_FALSE(isAstray(last, of.base)) << "of other samples";
}

}  // namespace
}  // namespace analogon
