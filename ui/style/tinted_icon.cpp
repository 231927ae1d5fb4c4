#include "ui/style/tinted_icon.hpp"

#include <QFile>
#include <QGuiApplication>
#include <QPaintEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

#include "ui/style/style.hpp"

namespace analogon::ui::style {

namespace {

struct Inks {
    QString stroke, accent;
};

Inks inksOf(const QString& icon, QIcon::Mode mode) {
    const QPalette palette = QGuiApplication::palette();
    const QColor colour = mode == QIcon::Disabled          ? palette.color(QPalette::Disabled, QPalette::ButtonText)
                          : mode == QIcon::Selected        ? palette.color(QPalette::Active, QPalette::HighlightedText)
                          : icon == QLatin1String("error") ? fault(palette)
                          : icon == QLatin1String("warning")
                              ? caution(palette)
                              : mix(palette.color(QPalette::ButtonText), palette.color(QPalette::Window), 0.15);
    const bool isOneColoured = mode == QIcon::Disabled || mode == QIcon::Selected;
    return {colour.name(), (isOneColoured ? colour : accent(palette)).name()};
}

}  // namespace

void TintedIcon::draw(QPainter& painter, const QRectF& rect, QIcon::Mode mode) const {
    QFile file(":/icons/" + name_ + ".svg");
    if (!file.open(QIODevice::ReadOnly)) return;
    const Inks inks = inksOf(name_, mode);
    QByteArray svg = file.readAll();
    svg.replace("currentColor", inks.stroke.toLatin1());
    svg.replace("accentColor", inks.accent.toLatin1());
    QSvgRenderer(svg).render(&painter, rect);
}

/// As many pixels as the place has on the screen: at 150 % they are as sharp as the lines beside them. What is written
/// as lines, a page of a printer, gets them as lines, and so does what is turned.
void TintedIcon::paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) {
    const QTransform onDevice = painter->deviceTransform();
    const bool isPixels = painter->paintEngine() && painter->paintEngine()->type() == QPaintEngine::Raster;
    const bool isUpright = onDevice.type() <= QTransform::TxScale && onDevice.m11() > 0 && onDevice.m22() > 0;
    if (!isPixels || !isUpright) return draw(*painter, rect, mode);
    const QSizeF pixels(rect.width() * onDevice.m11(), rect.height() * onDevice.m22());
    if (pixels.toSize().isEmpty()) return;
    const QPixmap picture = pixmap(pixels.toSize(), mode, state);
    painter->drawPixmap(
        QRectF(rect.topLeft(), QSizeF(picture.width() / onDevice.m11(), picture.height() / onDevice.m22())), picture,
        picture.rect());
}

QPixmap TintedIcon::pixmap(const QSize& size, QIcon::Mode mode, QIcon::State) {
    const Inks inks = inksOf(name_, mode);
    const QString key =
        QStringLiteral("analogon %1 %2x%3 %4 %5")
            .arg(name_, QString::number(size.width()), QString::number(size.height()), inks.stroke, inks.accent);
    QPixmap picture;
    if (QPixmapCache::find(key, &picture)) return picture;
    picture = QPixmap(size);
    picture.fill(Qt::transparent);
    {
        QPainter painter(&picture);
        draw(painter, picture.rect(), mode);
    }
    QPixmapCache::insert(key, picture);
    return picture;
}

}  // namespace analogon::ui::style
