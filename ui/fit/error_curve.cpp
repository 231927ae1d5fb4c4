#include "ui/fit/error_curve.hpp"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

ErrorCurve::ErrorCurve(QWidget* parent) : QWidget(parent) {
    setMinimumHeight(90);
    setBackgroundRole(QPalette::Base);
    setAutoFillBackground(true);
    setAccessibleName(tr("Error during the run"));
}

void ErrorCurve::clear() {
    points_.clear();
    update();
}

void ErrorCurve::add(double seconds, double errorPercent) {
    if (!std::isfinite(errorPercent) || errorPercent <= 0) return;
    const double best = points_.empty() ? errorPercent : std::min(errorPercent, points_.back().y());
    points_.emplace_back(seconds, best);
    update();
}

void ErrorCurve::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetricsF metrics(font());
    const QRectF area = QRectF(rect()).adjusted(style::margin, metrics.height() + style::unit, -style::margin,
                                                -style::unit - metrics.height());
    painter.setPen(style::mutedText(palette()));
    if (points_.empty()) {
        painter.drawText(rect().adjusted(style::margin, 0, -style::margin, 0), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("The error is drawn here while a run goes on."));
        return;
    }
    const double last = std::max(points_.back().x(), 1e-3);
    double low = std::log10(points_.back().y()), high = std::log10(points_.front().y());
    const double air = std::max(0.15 - (high - low) / 2, (high - low) / 10);  // from the text above, the axis below
    low -= air;
    high += air;
    const auto at = [&](QPointF p) {
        return QPointF(area.left() + p.x() / last * area.width(),
                       area.bottom() - (std::log10(p.y()) - low) / (high - low) * area.height());
    };
    painter.drawText(QRectF(rect()).adjusted(style::margin, style::unit / 2.0, -style::margin, 0),
                     Qt::AlignTop | Qt::AlignLeft, tr("error %1 %").arg(style::numberText(points_.back().y(), 3)));
    painter.drawText(QRectF(rect()).adjusted(style::margin, 0, -style::margin, -style::unit / 2.0),
                     Qt::AlignBottom | Qt::AlignRight, tr("%1 s").arg(style::fixedText(last, 1)));
    painter.setPen(style::hairline(palette()));
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    QPolygonF line;
    for (const QPointF& p : points_) {
        if (!line.isEmpty()) line << QPointF(at(p).x(), line.back().y());
        line << at(p);
    }
    painter.setPen(QPen(style::accent(palette()), 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    painter.setBrush(style::accent(palette()));
    painter.drawEllipse(line.back(), 2.5, 2.5);
}

}  // namespace analogon::ui
