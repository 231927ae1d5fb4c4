#include "ui/canvas/note_item.hpp"

#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <QWidget>
#include <cmath>

#include "ui/canvas/icon_painter.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

NoteItem::NoteItem(const OwnGraphic& graphic) : graphic_(graphic) {
    QTransform flip;
    flip.scale(1, -1);
    bounds_ = boundsOf({graphic.primitive}, flip);
    setFlag(ItemIsSelectable);
    setZValue(-0.5);  // between what is only drawn and the wires
}

bool NoteItem::isNote(const Primitive& primitive) {
    return primitive.kind == Primitive::Kind::Text || primitive.kind == Primitive::Kind::Bitmap;
}

QRectF NoteItem::boundingRect() const { return bounds_.adjusted(-2, -2, 2, 2); }

void NoteItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) {
    const QPalette palette = widget ? widget->palette() : QPalette();
    painter->setRenderHint(QPainter::Antialiasing);
    QTransform flip;
    flip.scale(1, -1);
    paintPrimitives(
        *painter, {graphic_.primitive}, flip, [](const QString& name) { return name; }, palette);
    if (!(option->state & QStyle::State_Selected)) return;
    const double pixel = 1.0 / std::max(0.01, std::sqrt(std::abs(painter->worldTransform().determinant())));
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(style::accent(palette), 1.3 * pixel, Qt::DashLine));
    painter->drawRect(bounds_.adjusted(-1, -1, 1, 1));
}

}  // namespace analogon::ui
