#include "ui/plot/time_keys.hpp"

#include <gtest/gtest.h>

#include <QKeyEvent>

namespace analogon::ui {
namespace {

TimeKey pressed(int key, const TimeView& view, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    return timeKeyOf(QKeyEvent(QEvent::KeyPress, key, modifiers), view);
}

TEST(TimeKeys, MoveThePointerWithinWhatIsSeen) {
    EXPECT_EQ(pressed(Qt::Key_Right, {10, 20, 15}).wish, TimeKey::Wish::Point);
    EXPECT_DOUBLE_EQ(pressed(Qt::Key_Right, {10, 20, 15}).time, 15.1);
    EXPECT_DOUBLE_EQ(pressed(Qt::Key_Left, {10, 20, 10.05}).time, 10);
    EXPECT_DOUBLE_EQ(pressed(Qt::Key_Left, {10, 20, 3}).time, 14.9) << "from the middle where it is not seen";
}

TEST(TimeKeys, MoveAndZoomTheRange) {
    const TimeKey moved = pressed(Qt::Key_Left, {10, 20, {}}, Qt::ControlModifier);
    EXPECT_EQ(moved.wish, TimeKey::Wish::Range);
    EXPECT_DOUBLE_EQ(moved.range.from, 9);
    EXPECT_DOUBLE_EQ(moved.range.to, 19);
    const TimeKey closer = pressed(Qt::Key_Plus, {10, 20, 10});
    EXPECT_DOUBLE_EQ(closer.range.from, 10);
    EXPECT_DOUBLE_EQ(closer.range.to, 18);
}

TEST(TimeKeys, MarkThePointerShowAllAndLeaveOthersAlone) {
    EXPECT_EQ(pressed(Qt::Key_Return, {10, 20, 12}).wish, TimeKey::Wish::Mark);
    EXPECT_DOUBLE_EQ(pressed(Qt::Key_Return, {10, 20, 12}).time, 12);
    EXPECT_EQ(pressed(Qt::Key_Home, {10, 20, {}}).wish, TimeKey::Wish::All);
    EXPECT_EQ(pressed(Qt::Key_A, {10, 20, {}}).wish, TimeKey::Wish::None);
}

}  // namespace
}  // namespace analogon::ui
