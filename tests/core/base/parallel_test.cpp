#include "core/base/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace analogon {
namespace {

TEST(Parallel, RunsEveryTaskOnceOnAnyNumberOfThreads) {
    for (const int threads : {0, 1, 3, 50}) {
        std::vector<std::atomic<int>> runs(20);
        parallelFor(20, threads, [&](int i) { ++runs[static_cast<std::size_t>(i)]; });
        for (const std::atomic<int>& each : runs) EXPECT_EQ(each, 1) << threads << " threads";
    }
    parallelFor(0, 4, [](int) { FAIL(); });
}

TEST(Parallel, RethrowsWhatATaskThrew) {
    EXPECT_THROW(parallelFor(8, 2,
                             [](int i) {
                                 if (i == 3) throw std::runtime_error("3");
                             }),
                 std::runtime_error);
}

TEST(Parallel, TakesNoneForAsManyThreadsAsTheMachineHas) {
    EXPECT_EQ(threadCount(3), 3);
    EXPECT_GE(threadCount(0), 1);
    EXPECT_EQ(threadCount(-1), threadCount(0));
}

}  // namespace
}  // namespace analogon
