#include "ui/measurement/course_frame.hpp"

#include <QPainter>
#include <QWidget>

#include "ui/style/style.hpp"

namespace analogon::ui {

QRectF paintCourseFrame(QPainter& painter, const QWidget& on) {
    const int line = on.fontMetrics().height();
    const QRectF frame = QRectF(on.rect()).adjusted(style::unit, line + style::unit, -style::unit, -line - style::unit);
    painter.fillRect(frame, style::canvas(on.palette()));
    painter.setPen(style::hairline(on.palette()));
    painter.drawRect(frame);
    return frame;
}

void paintCourseLabels(QPainter& painter, const QRectF& frame, const QWidget& on, const QString& high,
                       const QString& low, const QString& along) {
    painter.setPen(style::mutedText(on.palette()));
    const QRectF labels(frame.left(), 0, frame.width(), on.height());
    painter.drawText(labels, Qt::AlignLeft | Qt::AlignTop, high);
    painter.drawText(labels, Qt::AlignLeft | Qt::AlignBottom, low);
    painter.drawText(labels, Qt::AlignRight | Qt::AlignBottom, along);
}

}  // namespace analogon::ui
