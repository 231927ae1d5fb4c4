#include "core/base/median.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

TEST(Median, IsTheMiddleOfTheValues) {
    EXPECT_EQ(median({5, -1, 3}), 3);
    EXPECT_EQ(median({4, 1, 100, 2}), 3) << "the mean of the two middle ones";
    EXPECT_EQ(median({7}), 7);
    EXPECT_EQ(median({}), 0) << "of none";
}

}  // namespace
}  // namespace analogon
