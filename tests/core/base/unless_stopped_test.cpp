#include "core/base/unless_stopped.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

TEST(UnlessStopped, GivesWhatTheWorkGives) {
    const Outcome<int> done = unlessStopped({}, [] { return Outcome<int>(7); });
    ASSERT_TRUE(done);
    EXPECT_EQ(*done, 7);
}

TEST(UnlessStopped, SaysThatItWasCancelled) {
    std::stop_source source;
    source.request_stop();
    const Outcome<int> stopped = unlessStopped(Progress(source.get_token(), {}), [] {
        stopPoint();
        return Outcome<int>(7);
    });
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.diagnostics().front().message.english(), "cancelled");
}

}  // namespace
}  // namespace analogon
