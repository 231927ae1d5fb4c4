#include "ui/style/tinted_icon.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QPicture>

#include "tests/working_time.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui::style {
namespace {

QImage drawn(const QIcon& icon, double scale, QIcon::Mode mode = QIcon::Normal) {
    QImage picture(QSize(40, 40) * scale, QImage::Format_ARGB32_Premultiplied);
    picture.setDevicePixelRatio(scale);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    icon.paint(&painter, QRect(12, 12, 16, 16), Qt::AlignCenter, mode);
    return picture;
}

int inkIn(const QImage& picture) {
    int pixels = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) pixels += picture.pixelColor(x, y).alpha() > 0;
    return pixels;
}

/// Each place makes an icon of its own; a list repaints a hundred of them with every change.
TEST(TintedIcon, IsDrawnFromItsTextOnceForAllItsPlaces) {
    constexpr int places = 500;
    drawn(icon("recording"), 1);
    QImage list(40, 40, QImage::Format_ARGB32_Premultiplied);
    QPainter painter(&list);
    const double taken = test::leastMilliseconds(5, [&] {
        for (int i = 0; i < places; ++i) icon("recording").paint(&painter, QRect(0, 0, 16, 16));
    });
#ifdef __SANITIZE_ADDRESS__
    constexpr double most = 0.1;  // [ms]
#else
    constexpr double most = 0.02;
#endif
    EXPECT_LT(taken / places, most);
}

TEST(TintedIcon, HasThePixelsOfTheScreenAtEveryScale) {
    for (const double scale : {1.5, 2.0}) {
        const QImage picture = drawn(icon("output"), scale);
        bool hasHalfPixels = false;  // each pixel of 100 % would be a square of 2 × 2
        for (int y = 0; y + 1 < picture.height(); y += 2)
            for (int x = 0; x + 1 < picture.width(); x += 2)
                hasHalfPixels = hasHalfPixels || picture.pixel(x, y) != picture.pixel(x + 1, y) ||
                                picture.pixel(x, y) != picture.pixel(x, y + 1);
        EXPECT_TRUE(hasHalfPixels) << scale;
        EXPECT_GT(inkIn(picture), scale * scale * inkIn(drawn(icon("output"), 1)) * 0.6) << scale;
    }
}

TEST(TintedIcon, FollowsTheThemeAndWhetherItsButtonIsEnabled) {
    apply(*qApp, Theme::Light);
    const QImage light = drawn(icon("output"), 1), disabled = drawn(icon("output"), 1, QIcon::Disabled);
    apply(*qApp, Theme::Dark);
    const QImage dark = drawn(icon("output"), 1);
    apply(*qApp, Theme::Light);
    EXPECT_NE(light, dark);
    EXPECT_NE(light, disabled);
    EXPECT_EQ(light, drawn(icon("output"), 1));
}

/// A page of a printer is not made of pixels of the screen, and what is turned is not upright.
TEST(TintedIcon, IsMadeOfLinesWhereItsPixelsWouldNotDo) {
    QPicture page;
    QPainter writer(&page);
    icon("output").paint(&writer, QRect(0, 0, 16, 16));
    writer.end();
    QImage picture(QSize(64, 64), QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.scale(4, 4);
    painter.drawPicture(0, 0, page);
    painter.end();
    EXPECT_GT(inkIn(picture), 0);
    QImage mirrored(QSize(40, 40), QImage::Format_ARGB32_Premultiplied);
    mirrored.fill(Qt::transparent);
    QPainter turned(&mirrored);
    turned.translate(30, 0);
    turned.scale(-1, 1);
    icon("output").paint(&turned, QRect(0, 0, 16, 16));
    turned.end();
    EXPECT_GT(inkIn(mirrored), 0);
}

}  // namespace
}  // namespace analogon::ui::style
