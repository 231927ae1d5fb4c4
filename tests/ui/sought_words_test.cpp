#include "ui/style/sought_words.hpp"

#include <gtest/gtest.h>

namespace analogon::ui {
namespace {

TEST(SoughtWords, AreFoundWhereEachOfThemIsInWhateverOrderAndCase) {
    const style::SoughtWords sought("  Motor  TORQUE ");
    EXPECT_TRUE(sought.areIn("torque of the motor"));
    EXPECT_FALSE(sought.areIn("speed of the motor"));
    EXPECT_EQ(sought.first(), "motor");
}

TEST(SoughtWords, AreInEveryTextWhereNothingIsAskedFor) {
    const style::SoughtWords none("   ");
    EXPECT_TRUE(none.isEmpty());
    EXPECT_TRUE(none.areIn("anything"));
}

}  // namespace
}  // namespace analogon::ui
