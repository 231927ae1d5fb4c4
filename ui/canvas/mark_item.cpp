#include "ui/canvas/mark_item.hpp"

#include <QPainter>
#include <QWidget>
#include <algorithm>
#include <cmath>

#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

constexpr double size = 5;              // [diagram units] across
constexpr double least = 4, most = 15;  // [px] the same on the screen
constexpr double farthestZoom = 0.25;   // [px per diagram unit] from where on a mark need not be seen

double zoomOf(const QTransform& toView) { return std::sqrt(std::abs(toView.determinant())); }

}  // namespace

MarkItem::MarkItem(MarkKind kind, const QString& tip, QGraphicsItem* block) : QGraphicsItem(block), kind_(kind) {
    setToolTip(tip);
    setZValue(5);
    setAcceptedMouseButtons(Qt::NoButton);
}

QRectF MarkItem::rectAt(double zoom) {
    const double across = std::clamp(size * zoom, least, most) / zoom;
    return {-across / 2, -across / 2, across, across};
}

QRectF MarkItem::boundingRect() const { return rectAt(farthestZoom); }

QPainterPath MarkItem::shape() const {
    QPainterPath path;
    path.addEllipse(QRectF(-size / 2, -size / 2, size, size));
    return path;
}

/// A ring with a dot, as one aims at, for what is fitted; a dot that leans on a stop for a bound; a plus for an effect.
void MarkItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget* widget) {
    const QPalette palette = widget ? widget->palette() : QPalette();
    const double zoom = zoomOf(painter->worldTransform());
    if (zoom < farthestZoom) return;
    const QRectF rect = rectAt(zoom);
    const double pixel = 1 / zoom, r = rect.width() / 2;
    const QColor ground = style::canvas(palette);
    const QColor ink = kind_ == MarkKind::AtBound ? style::caution(palette) : style::accent(palette);
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(ground, pixel));  // tells it from an icon that it touches
    painter->setBrush(kind_ == MarkKind::Fitted ? ground : ink);
    painter->drawEllipse(rect);
    if (kind_ == MarkKind::Fitted) {
        painter->setPen(QPen(ink, 0.32 * r));
        painter->drawEllipse(QPointF(), 0.8 * r, 0.8 * r);
        painter->setPen(Qt::NoPen);
        painter->setBrush(ink);
        painter->drawEllipse(QPointF(), 0.36 * r, 0.36 * r);
        return;
    }
    painter->setPen(QPen(ground, 0.34 * r, Qt::SolidLine, Qt::FlatCap));
    if (kind_ == MarkKind::Effect) {
        painter->drawLine(QPointF(-0.55 * r, 0), QPointF(0.55 * r, 0));
        painter->drawLine(QPointF(0, -0.55 * r), QPointF(0, 0.55 * r));
        return;
    }
    painter->drawLine(QPointF(0.4 * r, -0.6 * r), QPointF(0.4 * r, 0.6 * r));
    painter->setPen(Qt::NoPen);
    painter->setBrush(ground);
    painter->drawEllipse(QPointF(-0.16 * r, 0), 0.32 * r, 0.32 * r);
}

}  // namespace analogon::ui
