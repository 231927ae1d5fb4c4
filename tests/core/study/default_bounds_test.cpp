#include "core/study/default_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace analogon {
namespace {

TEST(DefaultBounds, AreThreeDecadesAboutAPositiveQuantityWithinItsDeclaration) {
    const auto open = defaultBounds(0, std::nullopt, 2);
    ASSERT_TRUE(open);
    EXPECT_DOUBLE_EQ(open->min, 0.002);
    EXPECT_DOUBLE_EQ(open->max, 2000);
    const auto within = defaultBounds(0.1, 5, 2);
    ASSERT_TRUE(within);
    EXPECT_DOUBLE_EQ(within->min, 0.1);
    EXPECT_DOUBLE_EQ(within->max, 5);
}

TEST(DefaultBounds, AreNoneOfWhatMayBeNegativeOrIsZero) {
    EXPECT_FALSE(defaultBounds(std::nullopt, std::nullopt, 2)) << "nobody says that it is positive";
    EXPECT_FALSE(defaultBounds(-1, 1, 0.5));
    EXPECT_FALSE(defaultBounds(0, 1, 0)) << "a factor of nothing";
    EXPECT_FALSE(defaultBounds(0, std::nullopt, std::nan("")));
    EXPECT_FALSE(defaultBounds(0, std::nullopt, INFINITY));
}

}  // namespace
}  // namespace analogon
