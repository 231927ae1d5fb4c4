#pragma once

#include <QGraphicsItem>
#include <QPainterPath>

#include "core/diagram/diagram.hpp"

namespace analogon::ui {

/// A connection of the diagram.
class WireItem : public QGraphicsItem {
public:
    enum { Type = UserType + 2 };
    explicit WireItem(const Wire& wire);

    const Wire& wire() const { return wire_; }
    void setMarked(bool marked);
    /// Another way while a gesture lasts; setPos moves it as it is.
    void showPoints(const std::vector<Point>& points);
    /// Points where this wire leaves another one: drawn as dots.
    void setJunctions(std::vector<QPointF> junctions);

    /// As it is shown.
    const QVector<QLineF>& lines() const { return lines_; }

    int type() const override { return Type; }
    QRectF boundingRect() const override;
    QPainterPath shape() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

protected:
    void hoverEnterEvent(QGraphicsSceneHoverEvent* event) override;
    void hoverLeaveEvent(QGraphicsSceneHoverEvent* event) override;

private:
    void setPath(const std::vector<Point>& points);

    Wire wire_;
    QPainterPath path_;
    QVector<QLineF> lines_;  // of the same way
    bool isOrthogonal_{true};
    std::vector<QPointF> junctions_;
    bool isMarked_{}, isHovered_{};
};

}  // namespace analogon::ui
