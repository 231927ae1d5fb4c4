#include "ui/measurement/course_plot.hpp"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/measurement/course_frame.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

CoursePlot::CoursePlot(QWidget* parent) : QWidget(parent) { setMinimumSize(320, 160); }

void CoursePlot::show(std::vector<Line> lines, const QString& unit) {
    lines_ = std::move(lines);
    unit_ = unit;
    from_ = low_ = INFINITY;
    to_ = high_ = -INFINITY;
    for (const Line& line : lines_) {
        if (line.time.empty()) continue;
        from_ = std::min(from_, line.time.front() - line.shift);
        to_ = std::max(to_, line.time.back() - line.shift);
        for (const double value : line.values) {
            if (!std::isfinite(value)) continue;
            low_ = std::min(low_, value);
            high_ = std::max(high_, value);
        }
    }
    if (!(from_ < to_)) from_ = 0, to_ = 1;
    if (!(low_ <= high_)) low_ = 0, high_ = 1;
    if (low_ == high_) low_ -= 0.5, high_ += 0.5;
    update();
}

void CoursePlot::setShift(std::size_t line, double shift) {
    lines_.at(line).shift = shift;
    update();
}

void CoursePlot::setMarked(std::size_t line) {
    marked_ = line;
    update();
}

/// Not those of what was measured and what the model says of it: here every line was measured.
QColor CoursePlot::colourOf(std::size_t line) const { return style::signalTrace(static_cast<int>(line), palette()); }

/// The range of each column of pixels, joined: a line that leaves out no peak.
void CoursePlot::paintLine(QPainter& painter, const Line& line, const QRectF& frame) const {
    const auto x = [&](double t) { return frame.left() + (t - from_) / (to_ - from_) * frame.width(); };
    const auto y = [&](double v) { return frame.bottom() - (v - low_) / (high_ - low_) * frame.height(); };
    QPolygonF points;
    const auto draw = [&] {
        painter.drawPolyline(points);
        points.clear();
    };
    int column = -1;
    double low = 0, high = 0, last = 0;
    const auto close = [&] {
        if (column < 0) return;
        const double at = frame.left() + column + 0.5;
        points << QPointF(at, y(low)) << QPointF(at, y(high)) << QPointF(at, y(last));
        column = -1;
    };
    for (std::size_t i = 0; i < line.time.size(); ++i) {
        if (!std::isfinite(line.values[i])) {
            close();
            draw();
            continue;
        }
        const int at = static_cast<int>(x(line.time[i] - line.shift) - frame.left());
        if (at != column) {
            close();
            column = at;
            low = high = line.values[i];
        }
        low = std::min(low, line.values[i]);
        high = std::max(high, line.values[i]);
        last = line.values[i];
    }
    close();
    draw();
}

void CoursePlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = paintCourseFrame(painter, *this);
    paintCourseLabels(painter, frame, *this, style::numberText(high_, 5) + ' ' + unit_,
                      style::numberText(low_, 5) + ' ' + unit_,
                      QStringLiteral("%1 … %2 s").arg(style::numberText(from_, 5), style::numberText(to_, 5)));
    painter.setClipRect(frame);
    const QRectF inner = frame.adjusted(0, style::unit, 0, -style::unit);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        painter.setPen(QPen(colourOf(i), i == marked_ ? 2.0 : 1.2));
        paintLine(painter, lines_[i], inner);
    }
}

}  // namespace analogon::ui
