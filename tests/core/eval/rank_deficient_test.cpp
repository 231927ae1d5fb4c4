#include "core/eval/rank_deficient.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace analogon {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

TEST(RankDeficient, TakesTheSmallestOfAllSolutionsAndSaysWhatIsOpen) {
    // x + y + z = 3 three times over, and w = 5 in rows of different size.
    const std::vector<double> matrix{1, 1, 1, 0, 0, 0, 0, 1e6, 1e-6, 1e-6, 1e-6, 0, 2, 2, 2, 0};
    const std::vector<double> right{3, 5e6, 3e-6, 6};
    const auto solution = solveRankDeficient(matrix, right);
    ASSERT_TRUE(solution);
    EXPECT_THAT(solution->values, ElementsAre(DoubleNear(1, 1e-12), DoubleNear(1, 1e-12), DoubleNear(1, 1e-12), 5));
    EXPECT_THAT(solution->isUndecided, ElementsAre(1, 1, 1, 0));
    const auto other = solveRankDeficient(matrix, right, 1);
    ASSERT_TRUE(other);
    EXPECT_NEAR(other->values[0] + other->values[1] + other->values[2], 3, 1e-12);
    EXPECT_EQ(other->values[3], 5);
    EXPECT_GT(std::fabs(other->values[0] - 1) + std::fabs(other->values[1] - 1), 0.5);
}

TEST(RankDeficient, GivesNothingWhereRowsContradictEachOtherOrAllIsDecided) {
    EXPECT_FALSE(solveRankDeficient(std::vector<double>{1, 1, 2, 2}, std::vector<double>{1, 3}));
    EXPECT_FALSE(solveRankDeficient(std::vector<double>{1, 1, 1, -1}, std::vector<double>{1, 3}));
    EXPECT_FALSE(solveRankDeficient(std::vector<double>{1, NAN, 2, 2}, std::vector<double>{1, 2}));
    EXPECT_FALSE(solveRankDeficient(std::vector<double>{0, 0, 0, 0}, std::vector<double>{0, 1}));
    const auto nothing = solveRankDeficient(std::vector<double>{0, 0, 0, 0}, std::vector<double>{0, 0});
    ASSERT_TRUE(nothing);
    EXPECT_THAT(nothing->values, ElementsAre(0, 0));
}

TEST(RankDeficient, OnlyAScopeOfThisThreadAcceptsIt) {
    EXPECT_EQ(UndecidedScope::inForce(), nullptr);
    {
        UndecidedScope outer;
        {
            const UndecidedScope inner;
            EXPECT_EQ(UndecidedScope::inForce(), &inner);
        }
        EXPECT_EQ(UndecidedScope::inForce(), &outer);
    }
    EXPECT_EQ(UndecidedScope::inForce(), nullptr);
}

}  // namespace
}  // namespace analogon
