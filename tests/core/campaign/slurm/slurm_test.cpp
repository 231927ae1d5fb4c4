#include "core/campaign/slurm/slurm.hpp"

#include <gmock/gmock.h>

namespace analogon {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(TasksNamed, AreThoseOfTheJobInEveryWayThatSlurmWritesThem) {
    EXPECT_THAT(tasksNamed("12_7", "12"), ElementsAre(7));
    EXPECT_THAT(tasksNamed("12_[3-5,9%2]", "12"), ElementsAre(3, 4, 5, 9));
    EXPECT_THAT(tasksNamed("12_[1-9:4]", "12"), ElementsAre(1, 5, 9));
    EXPECT_THAT(tasksNamed("12_[8]", "12"), ElementsAre(8));
}

TEST(TasksNamed, AreNoneOfAnotherJobAndNoneOfAnotherText) {
    EXPECT_THAT(tasksNamed("123_7", "12"), IsEmpty());
    EXPECT_THAT(tasksNamed("12", "12"), IsEmpty());
    EXPECT_THAT(tasksNamed("12_batch", "12"), IsEmpty());
    EXPECT_THAT(tasksNamed("", "12"), IsEmpty());
}

}  // namespace
}  // namespace analogon
