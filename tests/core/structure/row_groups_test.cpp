#include "core/structure/row_groups.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace analogon {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

using Row = std::vector<int>;  // its unknowns

std::vector<std::vector<Row>> groupsOf(const std::vector<Row>& rows) {
    return groupsThatShare(rows, [](const Row& row) { return row; });
}

TEST(RowGroups, ShareUnknownsDirectlyOrThroughOthers) {
    EXPECT_THAT(groupsOf({{1, 2}, {3}, {4, 5}, {2, 4}}),
                UnorderedElementsAre(UnorderedElementsAre(Row{1, 2}, Row{4, 5}, Row{2, 4}), ElementsAre(Row{3})));
}

TEST(RowGroups, OfRowsWithoutUnknownsAreTheRows) {
    EXPECT_THAT(groupsOf({{}, {}}), ElementsAre(ElementsAre(IsEmpty()), ElementsAre(IsEmpty())));
    EXPECT_THAT(groupsOf({}), IsEmpty());
}

}  // namespace
}  // namespace analogon
