#include "core/effect/search/first_fit.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace analogon
