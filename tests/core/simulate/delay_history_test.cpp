#include "core/simulate/delay_history.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace analogon {
namespace {

TEST(DelayHistory, IsWhatTheSignalWasAndItsStartBefore) {
    DelayHistory history(0.5);
    history.addBehindEvent(0, 1);
    for (int k = 1; k <= 10; ++k) history.add(0.1 * k, 1 + 2 * 0.1 * k);
    EXPECT_EQ(history.at(0.2), 1);
    EXPECT_EQ(history.slopeAt(0.2), 0);
    EXPECT_NEAR(history.at(0.75), 1.5, 1e-12);
    EXPECT_NEAR(history.slopeAt(0.75), 2, 1e-12);
    EXPECT_TRUE(std::isinf(history.nextArrival()));
}

TEST(DelayHistory, AJumpArrivesWhenItIsSaidToHaveArrived) {
    DelayHistory history(0.5);
    history.addBehindEvent(0, 0);
    history.add(1, 0);
    history.addBehindEvent(1, 0);  // an event without a jump
    EXPECT_TRUE(std::isinf(history.nextArrival()));
    history.addBehindEvent(1, 3);
    history.add(2, 3);
    EXPECT_EQ(history.nextArrival(), 1.5);
    EXPECT_EQ(history.at(1.5), 0) << "right before";
    history.arriveUpTo(1.4);
    EXPECT_EQ(history.at(1.5), 0);
    history.arriveUpTo(1.5);
    EXPECT_EQ(history.at(1.5), 3);
    EXPECT_TRUE(std::isinf(history.nextArrival()));
}

}  // namespace
}  // namespace analogon
