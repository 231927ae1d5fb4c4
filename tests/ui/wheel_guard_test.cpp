#include "ui/style/wheel_guard.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

namespace analogon::ui {
namespace {

void turnWheel(QWidget* over) {
    const QPointF at = over->rect().center();
    QWheelEvent event(at, over->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(over, &event);
}

TEST(WheelGuard, AWheelChangesNothingThatHasNoFocus) {
    QWidget window;
    auto* const layout = new QVBoxLayout(&window);
    auto* const other = new QSpinBox;
    auto* const box = new QComboBox;
    box->addItems({"a", "b", "c"});
    auto* const number = new QSpinBox;
    number->setValue(5);
    auto* const slider = new QSlider;
    slider->setValue(5);
    for (QWidget* widget : {static_cast<QWidget*>(other), static_cast<QWidget*>(box), static_cast<QWidget*>(number),
                            static_cast<QWidget*>(slider)})
        layout->addWidget(widget);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    other->setFocus();
    for (QWidget* widget : {static_cast<QWidget*>(box), static_cast<QWidget*>(number), static_cast<QWidget*>(slider)}) {
        turnWheel(widget);
        EXPECT_NE(widget->focusPolicy(), Qt::WheelFocus) << widget->metaObject()->className();
    }
    EXPECT_EQ(box->currentIndex(), 0);
    EXPECT_EQ(number->value(), 5);
    EXPECT_EQ(slider->value(), 5);
    box->setFocus();
    turnWheel(box);
    EXPECT_EQ(box->currentIndex(), 1);
    number->setFocus();
    turnWheel(number);
    EXPECT_EQ(number->value(), 4);
}

}  // namespace
}  // namespace analogon::ui
