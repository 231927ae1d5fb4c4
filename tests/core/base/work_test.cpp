#include "core/base/work.hpp"

#include <gtest/gtest.h>

#include "core/base/parallel.hpp"

namespace analogon {
namespace {

TEST(Work, IsTheSameOnAnyNumberOfThreads) {
    for (const int threads : {1, 2, 5}) {
        const WorkCount count;
        parallelFor(100, threads, [](int i) { countWork(i); });
        EXPECT_EQ(count.done(), 4950) << threads;
    }
}

TEST(Work, OfAPartIsWorkOfTheWhole) {
    const WorkCount whole;
    countWork(1);
    {
        const WorkCount part;
        countWork(2);
        EXPECT_EQ(part.done(), 2);
    }
    countWork(4);
    EXPECT_EQ(whole.done(), 7);
}

TEST(Work, ThatNobodyCountsIsNotCounted) {
    countWork(1);
    EXPECT_EQ(workInForce(), nullptr);
    const WorkCount count;
    {
        const WorkScope nobody(nullptr);
        countWork(1);
    }
    EXPECT_EQ(count.done(), 0);
}

}  // namespace
}  // namespace analogon
