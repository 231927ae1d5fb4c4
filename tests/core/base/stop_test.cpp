#include "core/base/stop.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "core/base/parallel.hpp"

namespace analogon {
namespace {

TEST(Stop, IsAskedForByTheInnermostScope) {
    std::stop_source outer, inner;
    EXPECT_NO_THROW(stopPoint()) << "there is no scope";
    outer.request_stop();
    const StopScope scope(outer.get_token());
    EXPECT_THROW(stopPoint(), Stopped);
    {
        const StopScope within(inner.get_token());
        EXPECT_NO_THROW(stopPoint());
        inner.request_stop();
        EXPECT_THROW(stopPoint(), Stopped);
    }
    {
        const StopScope nothing{std::stop_token()};
        EXPECT_TRUE(isStopped()) << "a token that never asks leaves the one in force";
    }
    EXPECT_TRUE(isStopped());
}

TEST(Stop, EndsParallelWorkOnEveryThread) {
    std::stop_source source;
    const StopScope scope(source.get_token());
    std::atomic<int> ended{};
    const auto body = [&](int) {
        source.request_stop();
        try {
            for (;;) stopPoint();
        } catch (const Stopped&) {
            ++ended;
            throw;
        }
    };
    EXPECT_THROW(parallelFor(4, 2, body), Stopped);
    EXPECT_GE(ended, 1);
    EXPECT_LE(ended, 2) << "what has not begun does not begin";
}

TEST(Stop, ComesAfterSoMuchWork) {
    const StopAfter soon(std::chrono::milliseconds(20));
    const StopScope scope(soon.token());
    EXPECT_FALSE(isStopped());
    EXPECT_THROW(
        {
            for (;;) stopPoint();
        },
        Stopped);
}

}  // namespace
}  // namespace analogon
