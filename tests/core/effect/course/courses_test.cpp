#include "core/effect/course/courses.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

TEST(Courses, AreEmptyAsLongAsNeitherAChangeNorADependenceIsClaimed) {
    Courses courses;
    courses.isSought = true;
    EXPECT_TRUE(courses.areEmpty()) << "looked for, and not found";
    courses.change.emplace();
    EXPECT_FALSE(courses.areEmpty());
    courses.change.reset();
    courses.dependence.emplace();
    EXPECT_FALSE(courses.areEmpty());
}

}  // namespace
}  // namespace analogon
