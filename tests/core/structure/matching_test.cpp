#include "core/structure/matching.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace analogon {
namespace {

using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

TEST(Matching, FindsAPerfectMatchingAlongAugmentingPaths) {
    const Adjacency rows{{0, 1}, {0}, {1, 2}};
    Matching matching(rows, 3);
    ASSERT_TRUE(matching.augment(0));  // takes column 0
    ASSERT_TRUE(matching.augment(1));  // pushes row 0 to column 1
    ASSERT_TRUE(matching.augment(2));
    EXPECT_EQ(matching.columnOf(0), 1);
    EXPECT_EQ(matching.columnOf(1), 0);
    EXPECT_EQ(matching.columnOf(2), 2);
}

TEST(Matching, TellsTheRowsThatCompete) {
    const Adjacency rows{{0}, {0, 1}, {1}, {2}};
    Matching matching(rows, 3);
    EXPECT_FALSE(matching.augmentAll());
    int unmatched = 0;
    for (int row = 0; row < 4; ++row)
        if (matching.columnOf(row) < 0 && !matching.augment(row)) ++unmatched;
    EXPECT_EQ(unmatched, 1);
    EXPECT_THAT(matching.visitedRows(), UnorderedElementsAre(0, 1, 2));
}

TEST(Matching, HiddenColumnsBecomeUsableLater) {
    const Adjacency rows{{0, 1}, {0}};
    Matching matching(rows, 2);
    EXPECT_FALSE(matching.augment(1, {0, 1}));
    EXPECT_TRUE(matching.augment(0, {0, 1}));
    EXPECT_TRUE(matching.augment(1));
    EXPECT_EQ(matching.columnOf(1), 0);
}

TEST(StrongComponents, ComeAfterWhatTheyDependOn) {
    // 0 -> 1 <-> 2, 2 -> 3, 4 alone
    const auto components = strongComponents({{1}, {2}, {1, 3}, {}, {}});
    EXPECT_THAT(components, ElementsAre(ElementsAre(3), ElementsAre(1, 2), ElementsAre(0), ElementsAre(4)));
}

}  // namespace
}  // namespace analogon
