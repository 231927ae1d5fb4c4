#include "ui/signals/signal_chart.hpp"

#include <QGraphicsLayout>
#include <QLineSeries>
#include <QMouseEvent>
#include <QPainter>
#include <QValueAxis>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/plot/time_keys.hpp"
#include "ui/signals/chart_axis.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

constexpr double sideMargin = 64, topMargin = 20, bottomMargin = 26;  // [px] equal, so that stacked axes line up

bool isDrawn(const ChartLine& line) { return line.data && line.data->time && !line.data->time->empty(); }

/// That of the first trace with numbers is on the left.
QString leftUnit(const std::vector<ChartLine>& lines) {
    const auto first = std::find_if(lines.begin(), lines.end(), isDrawn);
    return first == lines.end() ? QString() : first->data->unit;
}

bool isRight(const std::vector<ChartLine>& lines, std::size_t line) {
    return isDrawn(lines[line]) && lines[line].data->unit != leftUnit(lines);
}

/// Each change of an axis lays its labels out anew: as few as there can be. A step too small for a range, even for a
/// moment, would make ticks without number.
void setAxis(QValueAxis& axis, double low, double high, int ticks) {
    const double step = niceStep(high - low, ticks);
    if (step > axis.tickInterval()) axis.setTickInterval(step);
    axis.setRange(low, high);
    if (step < axis.tickInterval()) axis.setTickInterval(step);
}

}  // namespace

QString axisUnits(const std::vector<ChartLine>& lines, bool isOfRight) {
    QStringList units;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (isDrawn(lines[i]) && isRight(lines, i) == isOfRight && !units.contains(lines[i].data->unit))
            units << lines[i].data->unit;
    units.removeAll(QString());
    return units.join(", ");
}

SignalChart::SignalChart(QWidget* parent) : QChartView(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setMinimumHeight(110);
    setAcceptDrops(false);  // its strip takes what is dropped
    viewport()->setAcceptDrops(false);
    chart()->legend()->hide();
    chart()->setMargins({});
    chart()->setBackgroundRoundness(0);
    chart()->setLocalizeNumbers(true);
    QLocale locale = style::windowLocale();
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    chart()->setLocale(locale);
    time_ = new QValueAxis;
    left_ = new QValueAxis;
    right_ = new QValueAxis;
    chart()->addAxis(time_, Qt::AlignBottom);
    chart()->addAxis(left_, Qt::AlignLeft);
    chart()->addAxis(right_, Qt::AlignRight);
    for (QValueAxis* axis : {time_, left_, right_}) {
        axis->setTickType(QValueAxis::TicksDynamic);
        axis->setTickAnchor(0);
        axis->setLabelFormat("%.6g");  // without the digits nothing is written where numbers are localised
    }
    right_->setGridLineVisible(false);
    right_->setVisible(false);
    style();
}

void SignalChart::style() {
    const QColor base = palette().color(QPalette::Base);
    chart()->setBackgroundBrush(base);
    setBackgroundBrush(base);
    for (QValueAxis* axis : {time_, left_, right_}) styleAxis(*axis, font(), palette());
}

void SignalChart::setLines(std::vector<ChartLine> lines) {
    if (lines == lines_) return;
    std::vector<ValueExtent> extents;
    for (const ChartLine& line : lines) {
        const auto same =
            std::find_if(lines_.begin(), lines_.end(), [&](const ChartLine& l) { return l.data == line.data; });
        if (same != lines_.end())
            extents.push_back(extents_[static_cast<std::size_t>(same - lines_.begin())]);
        else
            extents.push_back(line.data ? ValueExtent(line.data->values) : ValueExtent());
    }
    lines_ = std::move(lines);
    extents_ = std::move(extents);
    while (series_.size() > lines_.size()) {
        chart()->removeSeries(series_.back());
        delete series_.back();
        series_.pop_back();
    }
    while (series_.size() < lines_.size()) {
        series_.push_back(new QLineSeries);
        chart()->addSeries(series_.back());
        series_.back()->attachAxis(time_);
    }
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        QLineSeries& series = *series_[i];
        QValueAxis* axis = isRight(lines_, i) ? right_ : left_;
        if (!series.attachedAxes().contains(axis)) {
            QValueAxis* other = axis == left_ ? right_ : left_;
            if (series.attachedAxes().contains(other)) series.detachAxis(other);
            series.attachAxis(axis);
        }
        series.setPen(QPen(lines_[i].colour, 1));
    }
    right_->setVisible(hasRightAxis());
    feed();
}

bool SignalChart::hasRightAxis() const {
    for (std::size_t i = 0; i < lines_.size(); ++i)
        if (isRight(lines_, i)) return true;
    return false;
}

std::pair<double, double> SignalChart::valueRange(bool isRight) const {
    const QValueAxis* axis = isRight ? right_ : left_;
    return {axis->min(), axis->max()};
}

int SignalChart::pointsDrawn() const {
    int sum = 0;
    for (const QLineSeries* series : series_) sum += static_cast<int>(series->count());
    return sum;
}

void SignalChart::setTimeRange(double from, double to) {
    if (!(to > from) || (from == from_ && to == to_)) return;
    from_ = from;
    to_ = to;
    feed();
}

void SignalChart::setCursorTime(std::optional<double> time) {
    if (time == cursor_) return;
    cursor_ = time;
    viewport()->update();
}

void SignalChart::setMarks(const std::vector<double>& times) {
    marks_ = times;
    viewport()->update();
}

QRectF SignalChart::area() const {
    return {sideMargin, topMargin, std::max(10.0, width() - 2 * sideMargin),
            std::max(10.0, height() - topMargin - bottomMargin)};
}

double SignalChart::timeAt(double x) const { return from_ + (x - area().left()) / area().width() * (to_ - from_); }

double SignalChart::xAt(double time) const { return area().left() + (time - from_) / (to_ - from_) * area().width(); }

/// The points of one trace; adds the values that it takes in what is visible.
QList<QPointF> SignalChart::pointsOf(std::size_t line, ValueRange& range) const {
    QList<QPointF> points;
    if (const ChartLine& shown = lines_[line]; isDrawn(shown)) {
        const std::vector<double>& time = *shown.data->time;
        const std::span<const double> values = shown.data->values;
        const int columns = std::max(1, static_cast<int>(area().width()));
        const auto [begin, end] = samplesWithin(time, from_, to_);
        if (end - begin <= static_cast<std::size_t>(2 * columns)) {
            for (std::size_t i = begin; i < std::min(end, values.size()); ++i)
                if (std::isfinite(values[i])) {
                    points << QPointF(time[i], values[i]);
                    if (time[i] >= from_ && time[i] <= to_) range.add(values[i]);
                }
        } else {
            const double width = (to_ - from_) / columns;
            double t = from_ + width / 2;
            // A column is entered near where the one before was left: a slope is one line, and noise a row of bars.
            double last = std::numeric_limits<double>::quiet_NaN();
            for (const ValueRange& column : columnRanges(time, values, extents_[line], from_, to_, columns)) {
                if (!column.isEmpty()) {
                    range.add(column);
                    const bool isDown = std::abs(column.high - last) < std::abs(column.low - last);
                    points << QPointF(t, isDown ? column.high : column.low);
                    last = isDown ? column.low : column.high;
                    if (column.high > column.low) points << QPointF(t, last);
                }
                t += width;
            }
        }
    }
    return points;
}

void SignalChart::scale(QValueAxis& axis, const ValueRange& range) {
    const QFontMetricsF metrics(axis.labelsFont());
    double low = range.isEmpty() ? 0 : range.low, high = range.isEmpty() ? 1 : range.high;
    if (!(high - low > 1e-12 * std::max(std::abs(low), std::abs(high)))) {
        const double around = low == 0 ? 1 : std::abs(low) * 0.1;
        low -= around;
        high += around;
    }
    const double pad = (high - low) * 0.06;
    setAxis(axis, low - pad, high + pad, std::max(2, static_cast<int>(area().height() / (1.8 * metrics.height()))));
}

void SignalChart::feed() {
    ValueRange ofLeft, ofRight;
    std::vector<QList<QPointF>> points;
    for (std::size_t i = 0; i < lines_.size(); ++i)
        points.push_back(pointsOf(i, isRight(lines_, i) ? ofRight : ofLeft));
    // A series works its line out anew with each change of an axis: meanwhile there is nothing in it.
    for (QLineSeries* series : series_) series->clear();
    setAxis(*time_, from_, to_, std::max(2, width() / 110));
    scale(*left_, ofLeft);
    if (right_->isVisible()) scale(*right_, ofRight);
    for (std::size_t i = 0; i < lines_.size(); ++i) series_[i]->replace(points[i]);
}

void SignalChart::resizeEvent(QResizeEvent* event) {
    QChartView::resizeEvent(event);
    chart()->setPlotArea(area());
    // else the axes stay as high as they were where this is not the only size of one pass of the window's layout
    chart()->layout()->invalidate();
    chart()->layout()->activate();
    feed();
}

void SignalChart::changeEvent(QEvent* event) {
    QChartView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) style();
}

void SignalChart::drawForeground(QPainter* painter, const QRectF&) {
    const QRectF area = this->area();
    const QColor base = palette().color(QPalette::Base), text = palette().color(QPalette::Text);
    const auto drawTime = [&](double time, const QPen& pen) {
        if (time < from_ || time > to_) return;
        painter->setPen(pen);
        painter->drawLine(QPointF(xAt(time), area.top()), QPointF(xAt(time), area.bottom()));
    };
    if (cursor_) drawTime(*cursor_, QPen(style::mix(text, base, 0.35), 1));
    for (const double mark : marks_) drawTime(mark, QPen(style::accent(palette()), 1.2));
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.85);
    painter->setFont(small);
    painter->setPen(style::mix(text, base, 0.35));
    const QFontMetricsF metrics(small);
    painter->drawText(QRectF(area.right() + 4, area.bottom() + 4, sideMargin - 8, metrics.height()),
                      Qt::AlignRight | Qt::AlignTop, QStringLiteral("s"));
    painter->drawText(QRectF(0, 1, sideMargin, metrics.height()), Qt::AlignRight, axisUnits(lines_, false));
    painter->drawText(QRectF(area.right(), 1, sideMargin, metrics.height()), Qt::AlignLeft, axisUnits(lines_, true));
    if (hasFocus()) {
        painter->setPen(QPen(style::accent(palette()), 2));
        painter->drawLine(area.topLeft(), area.bottomLeft());
    }
    if (bandFrom_ && bandTo_ != *bandFrom_) {
        QColor tint = style::accent(palette());
        painter->setPen(QPen(tint, 1));
        tint.setAlphaF(0.12f);
        painter->setBrush(tint);
        painter->drawRect(QRectF(QPointF(*bandFrom_, area.top()), QPointF(bandTo_, area.bottom())).normalized());
    }
}

void SignalChart::zoom(double about, double factor) {
    const TimeView range = TimeView{from_, to_}.zoomed(about, factor);
    Q_EMIT timeRangeWanted(range.from, range.to);
}

void SignalChart::wheelEvent(QWheelEvent* event) {
    if (event->modifiers() & Qt::ShiftModifier) return event->ignore();  // scrolls the list of axes
    zoom(timeAt(event->position().x()), std::pow(0.9985, event->angleDelta().y()));
    event->accept();
}

void SignalChart::keyPressEvent(QKeyEvent* event) {
    if (!answerTimeKey(*this, *event, {from_, to_, cursor_})) event->ignore();
}

void SignalChart::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    const double x = std::clamp(event->position().x(), area().left(), area().right());
    if (event->modifiers() & Qt::ShiftModifier)
        bandFrom_ = bandTo_ = x;
    else if (event->modifiers() & Qt::ControlModifier)
        Q_EMIT markWanted(timeAt(x));
    else
        dragFrom_ = x;
}

void SignalChart::mouseMoveEvent(QMouseEvent* event) {
    const double x = std::clamp(event->position().x(), area().left(), area().right());
    if (bandFrom_) {
        bandTo_ = x;
        viewport()->update();
    }
    if (dragFrom_) {
        const double shift = timeAt(*dragFrom_) - timeAt(x);
        dragFrom_ = x;
        Q_EMIT timeRangeWanted(from_ + shift, to_ + shift);
    }
    Q_EMIT pointedAt(timeAt(x));
}

void SignalChart::mouseReleaseEvent(QMouseEvent*) {
    constexpr double worthIt = 3;  // [px]
    dragFrom_.reset();
    if (!bandFrom_) return;
    const double from = std::min(*bandFrom_, bandTo_), to = std::max(*bandFrom_, bandTo_);
    bandFrom_.reset();
    viewport()->update();
    if (to - from > worthIt) Q_EMIT timeRangeWanted(timeAt(from), timeAt(to));
}

void SignalChart::mouseDoubleClickEvent(QMouseEvent*) { Q_EMIT allWanted(); }

void SignalChart::leaveEvent(QEvent* event) {
    QChartView::leaveEvent(event);
    Q_EMIT pointerLeft();
}

void SignalChart::focusInEvent(QFocusEvent* event) {
    QChartView::focusInEvent(event);
    viewport()->update();
}

void SignalChart::focusOutEvent(QFocusEvent* event) {
    QChartView::focusOutEvent(event);
    viewport()->update();
}

}  // namespace analogon::ui
