#include "core/fit/recordings.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

Recording named(const std::string& name) {
    Recording r;
    r.name = name;
    r.outputs = Eigen::MatrixXd::Ones(1, 1000);
    return r;
}

TEST(Recordings, AreSharedByCopiesUntilOneIsEdited) {
    Recordings all{named("a"), named("b")};
    Recordings copy = all;
    EXPECT_EQ(&copy[0], &all[0]) << "nothing is copied";
    copy.edit()[0].outputs(0, 3) = 7;
    EXPECT_EQ(all[0].outputs(0, 3), 1) << "the other keeps its own";
    EXPECT_EQ(copy[0].outputs(0, 3), 7);
    const Recording* own = &copy[1];
    copy.edit()[1].name = "c";
    EXPECT_EQ(&copy[1], own) << "those of one task alone are changed in place";
    EXPECT_EQ(all[1].name, "b");
}

TEST(Recordings, AreNoneToBeginWith) {
    Recordings none;
    EXPECT_TRUE(none.empty());
    EXPECT_EQ(none.begin(), none.end());
    const Recordings copy = none;
    none.push_back(named("a"));
    EXPECT_EQ(none.size(), 1u);
    EXPECT_TRUE(copy.empty());
    none.clear();
    EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace analogon
