#include "core/base/apart.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

namespace analogon {
namespace {

TEST(Apart, GivesTheBytesOfTheWork) {
    const std::string many(3'000'000, 'x');  // more than a pipe holds
    const Outcome<std::string> outcome = runApart([&] { return many; }, 10, fileError("ended", "a.mat"));
    ASSERT_TRUE(outcome);
    EXPECT_EQ(*outcome, many);
}

TEST(Apart, ChangesNothingHere) {
    int value = 1;
    ASSERT_TRUE(runApart([&] { return std::to_string(value = 2); }, 10, fileError("ended", "a.mat")));
    EXPECT_EQ(value, 1);
}

TEST(Apart, AnEndByASignalIsAFault) {
    for (const int number : {SIGKILL, SIGABRT, SIGSEGV}) {
        const Outcome<std::string> outcome = runApart(
            [&]() -> std::string {
                std::signal(number, SIG_DFL);
                kill(getpid(), number);
                return "went on";
            },
            10, fileError("the file is damaged", "a.mat"));
        ASSERT_FALSE(outcome) << number;
        EXPECT_EQ(outcome.diagnostics()[0].message, "the file is damaged");
        EXPECT_EQ(outcome.diagnostics()[0].place.file, "a.mat");
    }
}

TEST(Apart, AnExceptionIsAFault) {
    EXPECT_FALSE(runApart([]() -> std::string { throw std::bad_alloc(); }, 10, fileError("ended", "a.mat")));
}

TEST(Apart, MoreMemoryThanItMayTakeIsAFault) {
    const auto take = [](std::size_t bytes) {
        return [bytes]() -> std::string { return std::to_string(std::string(bytes, 'x').size()); };
    };
    constexpr double most = 256.0 * (1 << 20);
    EXPECT_TRUE(runApart(take(std::size_t{64} << 20), {10, most}, fileError("ended", "a.mat")));
    EXPECT_FALSE(runApart(take(std::size_t{512} << 20), {10, most}, fileError("ended", "a.mat")));
    EXPECT_TRUE(runApart(take(std::size_t{512} << 20), 10, fileError("ended", "a.mat")));
}

TEST(Apart, IsStoppedWhileItWorks) {
    std::stop_source stop;
    std::jthread later([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        stop.request_stop();
    });
    const auto begin = std::chrono::steady_clock::now();
    const Outcome<std::string> outcome = runApart(
        []() -> std::string {
            for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
        },
        10, fileError("ended", "a.mat"), Progress(stop.get_token(), {}));
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.diagnostics()[0].message, "reading was stopped");
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

TEST(Apart, WorkWithoutAnEndIsAFault) {
    const Outcome<std::string> outcome = runApart(
        []() -> std::string {
            volatile int i = 0;
            for (;;) {
                const int next = i + 1;
                i = next % 1000;
            }
        },
        1, fileError("the file is damaged", "a.mat"));
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.diagnostics()[0].message, "the file is damaged");
}

}  // namespace
}  // namespace analogon
