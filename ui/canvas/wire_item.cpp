#include "ui/canvas/wire_item.hpp"

#include <QPainter>
#include <QPainterPathStroker>
#include <QStyleOptionGraphicsItem>
#include <QWidget>
#include <cmath>

#include "ui/canvas/icon_painter.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

WireItem::WireItem(const Wire& wire) : wire_(wire) {
    setPath(wire_.points);
    setFlag(ItemIsSelectable);
    setAcceptHoverEvents(true);
    const auto text = [](const std::string& s) { return QString::fromStdString(s).toHtmlEscaped(); };
    setToolTip(QStringLiteral("%1 – %2").arg(text(wire_.from), text(wire_.to)));
}

void WireItem::setPath(const std::vector<Point>& points) {
    path_ = {};
    lines_.clear();
    isOrthogonal_ = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i == 0) {
            path_.moveTo(toScene(points[i]));
            continue;
        }
        path_.lineTo(toScene(points[i]));
        lines_ << QLineF(toScene(points[i - 1]), toScene(points[i]));
        isOrthogonal_ = isOrthogonal_ && (points[i].x == points[i - 1].x || points[i].y == points[i - 1].y);
    }
}

void WireItem::showPoints(const std::vector<Point>& points) {
    prepareGeometryChange();
    junctions_.clear();
    setPath(points);
}

void WireItem::setMarked(bool marked) {
    isMarked_ = marked;
    setZValue(marked ? 0.5 : 0);
    update();
}

void WireItem::setJunctions(std::vector<QPointF> junctions) {
    junctions_ = std::move(junctions);
    update();
}

QRectF WireItem::boundingRect() const { return path_.boundingRect().adjusted(-3, -3, 3, 3); }

QPainterPath WireItem::shape() const {
    QPainterPathStroker stroker;
    stroker.setWidth(4);
    return stroker.createStroke(path_);
}

void WireItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) {
    const QPalette palette = widget ? widget->palette() : QPalette();
    painter->setRenderHint(QPainter::Antialiasing);
    const double pixel = 1.0 / std::max(0.01, std::sqrt(std::abs(painter->worldTransform().determinant())));
    const bool isStrong = isMarked_ || isHovered_ || (option->state & QStyle::State_Selected);
    const QColor colour = isStrong ? style::accent(palette) : style::onCanvas(toColour(wire_.colour), palette);
    const double width = std::max(wire_.thickness * 1.6, (isStrong ? 2.2 : 1.3) * pixel);
    painter->setBrush(Qt::NoBrush);
    if (isOrthogonal_) {  // lines with square ends are drawn many times faster than a path, and meet in a corner
        painter->setPen(QPen(colour, width, Qt::SolidLine, Qt::SquareCap));
        painter->drawLines(lines_);
    } else {
        painter->setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->drawPath(path_);
    }
    painter->setPen(Qt::NoPen);
    painter->setBrush(colour);
    for (const QPointF& p : junctions_) painter->drawEllipse(p, 1.1 + width / 4, 1.1 + width / 4);
}

void WireItem::hoverEnterEvent(QGraphicsSceneHoverEvent*) {
    isHovered_ = true;
    update();
}

void WireItem::hoverLeaveEvent(QGraphicsSceneHoverEvent*) {
    isHovered_ = false;
    update();
}

}  // namespace analogon::ui
