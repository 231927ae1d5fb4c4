#pragma once

#include <QGraphicsItem>

#include "core/diagram/graphics_edit.hpp"

namespace analogon::ui {

/// A text or a picture that the model itself has in its diagram, behind blocks and wires.
class NoteItem : public QGraphicsItem {
public:
    enum { Type = UserType + 4 };
    explicit NoteItem(const OwnGraphic& graphic);

    static bool isNote(const Primitive& primitive);
    const Primitive& primitive() const { return graphic_.primitive; }
    const OwnGraphic& graphic() const { return graphic_; }

    int type() const override { return Type; }
    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    OwnGraphic graphic_;
    QRectF bounds_;
};

}  // namespace analogon::ui
