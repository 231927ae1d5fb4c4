#include "core/report/icon_svg.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace analogon {
namespace {

using ::testing::HasSubstr;

Primitive shape(Primitive::Kind kind) {
    Primitive p;
    p.kind = kind;
    p.extent = {{10, 20}, {-10, -20}};
    p.points = {{0, 0}, {10, 0}, {10, 10}};
    p.fill = {255, 0, 16};
    return p;
}

TEST(IconShapes, AreDrawnFilledOrNotOutlinedOrNot) {
    Icon icon;
    icon.primitives = {shape(Primitive::Kind::Rectangle)};
    EXPECT_EQ(iconShapes(icon), "<rect x=\"-10\" y=\"-20\" width=\"20\" height=\"40\" stroke=\"#000000\"/>");
    icon.primitives[0].filled = true;
    icon.primitives[0].outlined = false;
    EXPECT_EQ(iconShapes(icon), "<rect x=\"-10\" y=\"-20\" width=\"20\" height=\"40\" fill=\"#ff0010\"/>");
    icon.primitives = {shape(Primitive::Kind::Ellipse), shape(Primitive::Kind::Line), shape(Primitive::Kind::Polygon)};
    EXPECT_EQ(iconShapes(icon),
              "<ellipse cx=\"0\" cy=\"0\" rx=\"10\" ry=\"20\" stroke=\"#000000\"/>"
              "<path d=\"M0 0L10 0L10 10\" stroke=\"#000000\"/><path d=\"M0 0L10 0L10 10L0 0Z\" stroke=\"#000000\"/>");
}

TEST(IconShapes, AreBentTurnedAndMoved) {
    Icon icon;
    icon.primitives = {shape(Primitive::Kind::Line)};
    icon.primitives[0].smooth = true;
    icon.primitives[0].origin = {3, 4};
    icon.primitives[0].rotation = 90;
    EXPECT_EQ(iconShapes(icon),
              "<g transform=\"translate(3 4) rotate(90)\">"
              "<path d=\"M0 0L5 0Q10 0 10 5L10 10\" stroke=\"#000000\"/></g>");
    icon.primitives = {shape(Primitive::Kind::Ellipse)};
    icon.primitives[0].endAngle = 90;
    EXPECT_THAT(iconShapes(icon), HasSubstr("M10 0A10 20 0 0 1 0 20"));
}

TEST(IconShapes, LeaveTextsAndFilesOut) {
    Icon icon;
    icon.primitives = {shape(Primitive::Kind::Text), shape(Primitive::Kind::Bitmap)};
    EXPECT_EQ(iconShapes(icon), "");
}

TEST(SvgNumber, IsShortAndAlwaysANumber) {
    EXPECT_EQ(svgNumber(3.14159), "3.14");
    EXPECT_EQ(svgNumber(-0.001), "0");
    EXPECT_EQ(svgNumber(-12), "-12");
    EXPECT_EQ(svgNumber(std::numeric_limits<double>::quiet_NaN()), "0");
}

}  // namespace
}  // namespace analogon
