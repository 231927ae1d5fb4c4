#pragma once

#include <QGraphicsItem>

namespace analogon::ui {

/// What a small mark at a corner of a block says: parameters of it are fitted, one ended at a bound, or an effect
/// brought or changed it.
enum class MarkKind { Fitted, AtBound, Effect };

/// The mark itself, around the corner of a block it is placed at; its parent. It grows with the diagram, between sizes
/// that are seen from afar and hide nothing close by, and tells what it stands for where one points at it.
class MarkItem : public QGraphicsItem {
public:
    enum { Type = UserType + 3 };
    MarkItem(MarkKind kind, const QString& tip, QGraphicsItem* block);

    MarkKind kind() const { return kind_; }
    /// What it covers at a zoom [px per diagram unit], in diagram units around its place.
    static QRectF rectAt(double zoom);

    int type() const override { return Type; }
    QRectF boundingRect() const override;
    QPainterPath shape() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    MarkKind kind_;
};

}  // namespace analogon::ui
