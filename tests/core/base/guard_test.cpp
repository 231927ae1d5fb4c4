#include "core/base/guard.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <thread>

#include "core/base/limits.hpp"
#include "core/base/parallel.hpp"

namespace analogon {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool isWatched = true;
#else
constexpr bool isWatched = false;
#endif

template <class Thrown>
Diagnostic told(Thrown thrown) {
    return guarded([&] { throw thrown; }).value();
}

TEST(Guard, SaysWhatWasThrown) {
    EXPECT_FALSE(guarded([] {}));
    EXPECT_EQ(told(std::bad_alloc()).message, "there is not enough memory for this");
    EXPECT_FALSE(told(std::bad_alloc()).isNumerical);
    EXPECT_EQ(told(std::length_error("vector")).message, "this is too large to be worked out");
    EXPECT_EQ(told(LimitReached(error("too many"))).message, "too many");
    EXPECT_TRUE(told(std::runtime_error("odd")).isNumerical);
    EXPECT_NE(format(told(std::runtime_error("odd"))).find("odd"), std::string::npos);
    EXPECT_TRUE(told(42).isNumerical);
    const auto fault = std::filesystem::filesystem_error("x", "a/b", std::make_error_code(std::errc::io_error));
    EXPECT_EQ(told(fault).place.file, "a/b");
}

TEST(Guard, MakesAFaultOfWhatWorkThrows) {
    const auto work = [](bool isTooLarge) -> Outcome<int> {
        if (isTooLarge) throw std::bad_alloc();
        return 5;
    };
    EXPECT_EQ(*guardedOutcome([&] { return work(false); }), 5);
    EXPECT_FALSE(guardedOutcome([&] { return work(true); }));
}

TEST(Guard, CatchesWhatThreadsThrow) {
    const auto fault = guarded([] {
        parallelFor(8, 4, [](int i) {
            if (i == 5) throw std::bad_alloc();
        });
    });
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->message, "there is not enough memory for this");
}

/// The room of each call is used by the next: no compiler makes a loop of them.
int deeper(volatile char* above) {
    volatile char room[4096]{};
    room[0] = above[0];
    return above[0] == 1 ? 0 : room[1] + deeper(room);
}

int deeper() {
    volatile char room[1]{};
    return deeper(room);
}

TEST(GuardDeathTest, EndsDeepRecursionWithASentence) {
    if (isWatched) GTEST_SKIP() << "sanitizers have their own";
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto recurse = [] {
        const StackGuard stack;
        std::exit(deeper() == 7);
    };
    EXPECT_EXIT(recurse(), testing::ExitedWithCode(2), "nests deeper than the program can follow");
    EXPECT_EXIT(std::thread(recurse).join(), testing::ExitedWithCode(2), "nests deeper than the program can follow");
    const auto together = [] {
        const StackGuard stack;
        parallelFor(2, 2, [](int) { std::exit(deeper() == 7); });
    };
    EXPECT_EXIT(together(), testing::ExitedWithCode(2), "nests deeper");
}

TEST(GuardDeathTest, LeavesOtherFaultsToTheSystem) {
    if (isWatched) GTEST_SKIP() << "sanitizers have their own";
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto stray = [] {
        const StackGuard stack;
        std::raise(SIGSEGV);
    };
    EXPECT_EXIT(stray(), testing::KilledBySignal(SIGSEGV), "");
}

TEST(GuardDeathTest, AsksForNoMoreMemoryThanThereIs) {
    if (isWatched) GTEST_SKIP() << "sanitizers reserve more";
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto fill = [] {
        setenv("ANALOGON_MEMORY", "64", 1);
        guardProgram();
        const auto fault = guarded([] {
            std::vector<std::vector<double>> all;
            for (int i = 0; i < 1000; ++i) all.emplace_back(1 << 17, 1.0);  // a gigabyte
        });
        if (fault) std::fputs(fault->message.english().c_str(), stderr);
        std::exit(fault ? 2 : 0);
    };
    EXPECT_EXIT(fill(), testing::ExitedWithCode(2), "not enough memory");
    const auto escape = [] {
        guardProgram();
        std::thread([] { throw std::runtime_error("out of a thread"); }).join();
    };
    EXPECT_EXIT(escape(), testing::ExitedWithCode(3), "error: an error that was not foreseen: out of a thread");
}

}  // namespace
}  // namespace analogon
