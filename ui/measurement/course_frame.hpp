#pragma once

#include <QRectF>
#include <QString>

class QPainter;
class QWidget;

namespace analogon::ui {

/// The frame of a small plot over the whole of a widget, with room for a line of text above and below.
QRectF paintCourseFrame(QPainter& painter, const QWidget& on);

/// What the frame spans: the values at its top and bottom, and along it.
void paintCourseLabels(QPainter& painter, const QRectF& frame, const QWidget& on, const QString& high,
                       const QString& low, const QString& along);

}  // namespace analogon::ui
