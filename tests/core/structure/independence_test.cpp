#include "core/structure/independence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace analogon {
namespace {

using ::testing::ElementsAre;

TEST(IndependentColumns, AreTheFirstThatCombineFromNoneBeforeThem) {
    const std::vector<SparseColumn> columns{{{0, 1}, {1, 2}}, {{0, 2}, {1, 4}}, {{2, 1}}, {{0, 1}, {2, 3}}, {{1, 1}}};
    const auto chosen = independentColumns(columns, 3);
    ASSERT_TRUE(chosen);
    EXPECT_THAT(*chosen, ElementsAre(0, 2, 3));
}

TEST(IndependentColumns, WhatRoundingLeavesIsZero) {
    const double third = 2 * M_PI / 3;
    const std::vector<SparseColumn> columns{{{0, std::cos(0)}, {1, 1}},
                                            {{0, std::cos(third)}, {1, 1}},
                                            {{0, std::cos(0) + std::cos(third) + std::cos(2 * third)}, {1, 3}},
                                            {{1, 1}}};
    EXPECT_THAT(independentColumns({columns[2], columns[3], columns[0]}, 2).value(), ElementsAre(0, 2));
    EXPECT_FALSE(independentColumns({columns[2], columns[3]}, 2));
}

TEST(IndependentColumns, OfALongChainAreFound) {
    std::vector<SparseColumn> columns;
    for (int k = 0; k < 400; ++k) columns.push_back({{k, 1}, {k + 1, -1}});
    columns.push_back({{0, 1}, {400, -1}});  // closes the circle
    columns.push_back({{7, 1}});
    const auto chosen = independentColumns(columns, 401);
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->back(), 401u);
    EXPECT_FALSE(independentColumns(columns, 402));
}

}  // namespace
}  // namespace analogon
