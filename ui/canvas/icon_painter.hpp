#pragma once

#include <QPainterPath>
#include <QPalette>
#include <QRectF>
#include <QString>
#include <QTransform>
#include <functional>

#include "core/diagram/diagram.hpp"

class QPainter;

namespace analogon::ui {

/// Scene coordinates have y downward; the diagram's have it upward.
inline QPointF toScene(Point p) { return {p.x, -p.y}; }
QTransform toScene(const Placement& placement, const Extent& coordinates);
QColor toColour(const Colour& colour);

/// Expands the macros of a Text primitive: "name", "class" or a parameter's name to its text.
using TextMacros = std::function<QString(const QString&)>;

/// Draws an icon. `transform` maps icon coordinates to those of the painter. Texts stay upright and are set in
/// device pixels, so that they are sharp at every zoom.
void paintPrimitives(QPainter& painter, const std::vector<Primitive>& primitives, const QTransform& transform,
                     const TextMacros& macros, const QPalette& palette);

/// What the primitives cover, texts included, in the painter's coordinates.
QRectF boundsOf(const std::vector<Primitive>& primitives, const QTransform& transform);

}  // namespace analogon::ui
