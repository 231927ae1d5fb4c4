#include "core/effect/judge/decision_trace.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace analogon {
namespace {

TEST(DecisionTrace, KeepsTheOrderInWhichItWasTold) {
    DecisionTrace trace;
    trace.add({"screen", "a", 1, 1, {{"score", 3.5}}, "visible", ""});
    trace.add({"choose", "b", 1, 2, {}, "chosen", "because"});
    const std::vector<Decision> decisions = trace.decisions();
    ASSERT_EQ(decisions.size(), 2u);
    EXPECT_EQ(decisions[0].key, "a");
    EXPECT_EQ(decisions[0].figures.at(0).second, 3.5);
    EXPECT_EQ(decisions[1].round, 2);
    EXPECT_EQ(decisions[1].reason, "because");
}

TEST(DecisionTrace, LosesNothingThatSeveralThreadsTell) {
    constexpr int threads = 4, each = 2000;
    DecisionTrace trace;
    {
        std::vector<std::jthread> all;
        for (int t = 0; t < threads; ++t)
            all.emplace_back([&trace, t] {
                for (int k = 0; k < each; ++k) trace.add({"trial", std::to_string(t), 0, k, {}, "", ""});
            });
    }
    const std::vector<Decision> decisions = trace.decisions();
    ASSERT_EQ(decisions.size(), static_cast<std::size_t>(threads * each));
    for (int t = 0; t < threads; ++t) {
        int next = 0;  // those of one thread stand in its order
        for (const Decision& d : decisions)
            if (d.key == std::to_string(t)) {
                EXPECT_EQ(d.round, next++);
            }
        EXPECT_EQ(next, each);
    }
}

}  // namespace
}  // namespace analogon
