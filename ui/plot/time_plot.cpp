#include "ui/plot/time_plot.hpp"

#include <QPaintEngine>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/plot/time_keys.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

constexpr double leftMargin = 64, rightMargin = 26, topMargin = 6;  // [px] equal, so that stacked plots line up
constexpr double labelGap = 6;                                      // [px] between a label and the axis

/// As many digits as tell the grid lines apart.
QString tickText(double value, double step) {
    if (std::abs(value) < step * 1e-6) value = 0;
    const double magnitude = std::max(std::abs(value), step);
    const int digits = static_cast<int>(std::floor(std::log10(magnitude)) - std::floor(std::log10(step))) + 1;
    return style::numberText(value, std::clamp(digits, 6, 12));
}

double middle(const ValueRange& range) { return (range.low + range.high) / 2; }

}  // namespace

QColor traceColour(TraceRole role, const QPalette& palette) {
    switch (role) {
        case TraceRole::Measured:
            return style::measuredTrace(palette);
        case TraceRole::Before:
            return style::beforeTrace(palette);
        case TraceRole::After:
            break;
    }
    return style::afterTrace(palette);
}

TimePlot::TimePlot(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
}

void TimePlot::setTraces(std::shared_ptr<const std::vector<double>> time, std::vector<Trace> traces) {
    time_ = std::move(time);
    traces_ = std::move(traces);
    extents_.clear();
    for (const Trace& trace : traces_) extents_.emplace_back(trace.values);
    fitValues();
}

void TimePlot::setTrace(Trace trace) {
    const auto found =
        std::find_if(traces_.begin(), traces_.end(), [&](const Trace& t) { return t.role == trace.role; });
    ValueExtent extent(trace.values);
    if (found == traces_.end()) {
        traces_.push_back(std::move(trace));
        extents_.push_back(std::move(extent));
    } else {
        *found = std::move(trace);
        extents_[static_cast<std::size_t>(found - traces_.begin())] = std::move(extent);
    }
    fitValues();
}

void TimePlot::setVisible(TraceRole role, bool isVisible) {
    std::erase(hidden_, role);
    if (!isVisible) hidden_.push_back(role);
    fitValues();
}

void TimePlot::setTimeRange(double from, double to) {
    if ((from == from_ && to == to_) || !(to > from)) return;
    from_ = from;
    to_ = to;
    redraw();
}

void TimePlot::setTimeLabels(bool isShown) {
    if (isShown == hasTimeLabels_) return;
    hasTimeLabels_ = isShown;
    redraw();
}

void TimePlot::setTrimming(bool isTrimming) {
    isTrimming_ = isTrimming;
    setCursor(isTrimming ? Qt::SplitHCursor : Qt::ArrowCursor);
}

void TimePlot::setSymmetric(bool isSymmetric) {
    isSymmetric_ = isSymmetric;
    fitValues();
}

void TimePlot::setCaption(const QString& caption) {
    caption_ = caption;
    redraw();
}

void TimePlot::setNote(const QString& note) {
    if (note == note_) return;
    note_ = note;
    redraw();
}

void TimePlot::setCursorTime(std::optional<double> time) {
    if (time == cursor_) return;
    cursor_ = time;
    update();
}

void TimePlot::setMarks(const std::vector<double>& times) {
    marks_ = times;
    update();
}

bool TimePlot::isHidden(TraceRole role) const {
    return std::find(hidden_.begin(), hidden_.end(), role) != hidden_.end();
}

void TimePlot::showAllValues() {
    isCloseUp_ = false;
    fitValues();
}

void TimePlot::setValueRange(double low, double high) {
    if (!(high - low > 1e-12 * std::max(std::abs(low), std::abs(high)))) return;
    low_ = low;
    high_ = high;
    isCloseUp_ = true;
    redraw();
}

void TimePlot::fitValues() {
    if (isCloseUp_) return redraw();
    const auto hasAfter = [&](const Trace& trace) { return trace.role == TraceRole::After && !isHidden(trace.role); };
    const bool isOfAfter = isSymmetric_ && std::any_of(traces_.begin(), traces_.end(), hasAfter);
    ValueRange range;  // a residual as what is left after needs it, however large it was before
    for (std::size_t i = 0; i < traces_.size(); ++i)
        if (!isHidden(traces_[i].role) && (!isOfAfter || hasAfter(traces_[i]))) range.add(extents_[i].whole());
    if (range.isEmpty()) range = {0, 1};
    constexpr double farthest = 1e150;  // beyond, a range has no width that is a number
    double low = std::clamp(range.low, -farthest, farthest), high = std::clamp(range.high, -farthest, farthest);
    if (isSymmetric_) {
        high = std::max(std::abs(low), std::abs(high));
        low = -high;
    }
    if (high == low) {
        const double around = low == 0 ? 1 : std::abs(low) * 0.1;
        low -= around;
        high += around;
    }
    const double pad = (high - low) * 0.06;
    low_ = low - pad;
    high_ = high + pad;
    redraw();
}

void TimePlot::redraw() {
    ground_ = {};
    update();
}

QFont TimePlot::labelFont() const {
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.85);
    return small;
}

QRectF TimePlot::area() const {
    const double bottom = hasTimeLabels_ ? fontMetrics().height() + 8 : 8;
    const double top = caption_.isEmpty() ? topMargin : QFontMetricsF(labelFont()).height() + 4;
    return {leftMargin, top, std::max(10.0, width() - leftMargin - rightMargin),
            std::max(10.0, height() - top - bottom)};
}

double TimePlot::timeAt(double x) const {
    const QRectF area = this->area();
    return from_ + (x - area.left()) / area.width() * (to_ - from_);
}

double TimePlot::xAt(double time) const {
    const QRectF area = this->area();
    return area.left() + (time - from_) / (to_ - from_) * area.width();
}

double TimePlot::yAt(double value) const {
    const QRectF area = this->area();
    return area.bottom() - (value - low_) / (high_ - low_) * area.height();
}

double TimePlot::valueAt(double y) const {
    const QRectF area = this->area();
    return low_ + (area.bottom() - y) / area.height() * (high_ - low_);
}

/// Else only times are chosen.
bool TimePlot::isBox() const {
    constexpr double flat = 12;  // [px]
    return bandFrom_ && !isTrimming_ && std::abs(bandBottom_ - bandTop_) > flat;
}

void TimePlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (painter.paintEngine()->type() != QPaintEngine::Raster) {
        paintGround(painter);  // a drawing of lines, not of a picture of them
    } else {
        const double ratio = devicePixelRatioF();
        if (ground_.isNull() || ground_.size() != (QSizeF(size()) * ratio).toSize()) {
            ground_ = QPixmap((QSizeF(size()) * ratio).toSize());
            ground_.setDevicePixelRatio(ratio);
            QPainter fresh(&ground_);
            fresh.setFont(font());
            paintGround(fresh);
        }
        painter.drawPixmap(0, 0, ground_);
    }
    const QRectF area = this->area();
    if (hasFocus()) {
        painter.setPen(QPen(style::accent(palette()), 2));
        painter.drawLine(area.topLeft(), area.bottomLeft());
    }
    const auto drawTime = [&](double time, const QPen& pen) {
        if (time < from_ || time > to_) return;
        painter.setPen(pen);
        painter.drawLine(QPointF(xAt(time), area.top()), QPointF(xAt(time), area.bottom()));
    };
    if (cursor_)
        drawTime(*cursor_, QPen(style::mix(palette().color(QPalette::Text), palette().color(QPalette::Base), 0.35), 1));
    for (const double mark : marks_) drawTime(mark, QPen(style::accent(palette()), 1.2));
    if (bandFrom_ && bandTo_ != *bandFrom_) {
        QColor tint = style::accent(palette());
        painter.setPen(QPen(tint, 1));
        tint.setAlphaF(0.12f);
        painter.setBrush(tint);
        painter.drawRect(QRectF(QPointF(*bandFrom_, isBox() ? bandTop_ : area.top()),
                                QPointF(bandTo_, isBox() ? bandBottom_ : area.bottom()))
                             .normalized());
    }
}

void TimePlot::paintGround(QPainter& painter) const {
    painter.fillRect(rect(), palette().color(QPalette::Base));
    painter.setFont(labelFont());
    paintGrid(painter);
    painter.save();
    painter.setClipRect(area());
    for (std::size_t i = 0; i < traces_.size(); ++i)
        if (!isHidden(traces_[i].role)) paintTrace(painter, i);
    painter.restore();
    paintNote(painter);
}

/// Beside the caption, where no trace is and nothing moves while one looks from effect to effect.
void TimePlot::paintNote(QPainter& painter) const {
    if (note_.isEmpty()) return;
    const QFontMetricsF metrics(painter.font());
    const double from = leftMargin + metrics.horizontalAdvance(caption_) + 4 * labelGap;
    const QRectF room(from, 1, width() - rightMargin - from, metrics.height());
    painter.setPen(traceColour(TraceRole::After, palette()));
    painter.drawText(room, Qt::AlignRight | Qt::AlignTop, metrics.elidedText(note_, Qt::ElideRight, room.width()));
}

void TimePlot::paintGrid(QPainter& painter) const {
    const QRectF area = this->area();
    const QFontMetricsF metrics(painter.font());
    const QColor base = palette().color(QPalette::Base), text = palette().color(QPalette::Text);
    const QColor grid = style::mix(base, text, 0.10), label = style::mix(text, base, 0.35);
    const auto ticks = [](double low, double high, double step, const auto& draw) {
        for (double k = std::ceil(low / step); k * step <= high; ++k) draw(k * step);
    };
    const double valueStep =
        labelStep(low_, high_, std::max(2, static_cast<int>(area.height() / (1.4 * metrics.height()))));
    // In a low plot the ends say the scale; what stands between them only where there is room.
    const double lowest = yAt(std::ceil(low_ / valueStep) * valueStep),
                 highest = yAt(std::floor(high_ / valueStep) * valueStep), room = 0.9 * metrics.height();
    const bool isCrowded = valueStep / (high_ - low_) * area.height() < room;
    ticks(low_, high_, valueStep, [&](double value) {
        const double y = yAt(value);
        painter.setPen(grid);
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.setPen(label);
        const bool isEnd = std::abs(y - lowest) < 0.5 || (std::abs(y - highest) < 0.5 && lowest - highest >= room);
        const bool isZero = std::abs(value) < valueStep * 1e-6;
        if (isCrowded && !isEnd && !(isZero && lowest - y >= room && y - highest >= room)) return;
        painter.drawText(QRectF(0, y - metrics.height() / 2, leftMargin - labelGap, metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, tickText(value, valueStep));
    });
    const double timeStep = niceStep(to_ - from_, std::max(2, width() / 110));
    ticks(from_, to_, timeStep, [&](double time) {
        const double x = xAt(time);
        painter.setPen(grid);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        if (!hasTimeLabels_) return;
        painter.setPen(label);
        const QString number = tickText(time, timeStep);
        const double half = metrics.horizontalAdvance(number) / 2;
        if (x + half < width() - rightMargin + labelGap)  // else it would run into the unit
            painter.drawText(QPointF(x - half, area.bottom() + labelGap + metrics.ascent()), number);
    });
    painter.setPen(style::mix(base, text, 0.25));
    painter.drawLine(area.topLeft(), area.bottomLeft());
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    painter.setPen(label);
    painter.drawText(QPointF(leftMargin, 1 + metrics.ascent()), caption_);
    if (hasTimeLabels_)
        painter.drawText(QRectF(0, area.bottom() + labelGap, width() - 4, metrics.height()), Qt::AlignRight,
                         QStringLiteral("s"));
}

void TimePlot::paintTrace(QPainter& painter, std::size_t trace) const {
    if (!time_) return;
    const Trace& shown = traces_[trace];
    QPen pen(traceColour(shown.role, palette()), shown.role == TraceRole::Measured ? 1.0 : 1.6);
    const double ratio = painter.device()->devicePixelRatioF();
    const QRectF area = this->area();
    const int count = std::max(1, static_cast<int>(area.width() * ratio));
    const auto [begin, end] = samplesWithin(*time_, from_, to_);
    // Where corners lie a few pixels apart nobody sees a round one, and rounding them is most of the work of a line.
    const bool isDense = 4 * (end - begin) > static_cast<std::size_t>(count);
    pen.setJoinStyle(isDense ? Qt::BevelJoin : Qt::RoundJoin);
    if (end - begin <= static_cast<std::size_t>(count)) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(pen);
        painter.drawPolyline(lineThroughSamples(shown.values));
        return;
    }
    paintColumns(painter, columnRanges(*time_, shown.values, extents_[trace], from_, to_, count), area.width() / count,
                 pen);
}

QPolygonF TimePlot::lineThroughSamples(std::span<const double> values) const {
    QPolygonF line;
    const auto [begin, end] = samplesWithin(*time_, from_, to_);
    for (std::size_t i = begin; i < std::min(end, values.size()); ++i)
        if (std::isfinite(values[i])) line << QPointF(xAt((*time_)[i]), yAt(values[i]));
    return line;
}

/// More samples than columns: what is nearly flat within most of them is a line through the middles, with bars where a
/// column is not; what is not flat is a row of bars, which cost far less than the same strokes smoothed.
void TimePlot::paintColumns(QPainter& painter, const std::vector<ValueRange>& columns, double width,
                            const QPen& pen) const {
    const QRectF area = this->area();
    const double perPixel = (high_ - low_) / area.height();
    constexpr double flat = 3;  // [px]
    double height = 0;
    int filled = 0;
    QPolygonF line;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (columns[i].isEmpty()) continue;
        height += (columns[i].high - columns[i].low) / perPixel;
        ++filled;
        line << QPointF(area.left() + (static_cast<double>(i) + 0.5) * width, yAt(middle(columns[i])));
    }
    if (filled == 0) return;
    painter.setPen(pen);
    const double half = pen.widthF() / 2;
    std::size_t drawn = 0, before = 0;
    if (height / filled < flat) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.drawPolyline(line);
        for (const ValueRange& c : columns) {
            if (c.isEmpty()) continue;
            const double at = line[static_cast<qsizetype>(drawn++)].x(), top = yAt(c.high), bottom = yAt(c.low);
            if (bottom - top > pen.widthF())
                painter.fillRect(QRectF(at - half, top - half, pen.widthF(), bottom - top + 2 * half), pen.color());
        }
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (columns[i].isEmpty()) continue;
        const QPointF at = line[static_cast<qsizetype>(drawn)];
        if (drawn > 0 && i > before + 1) painter.drawLine(line[static_cast<qsizetype>(drawn) - 1], at);
        const double top = yAt(columns[i].high) - half, bottom = yAt(columns[i].low) + half;
        painter.fillRect(QRectF(at.x() - width / 2, top, width, bottom - top), pen.color());
        before = i;
        ++drawn;
    }
}

void TimePlot::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) redraw();
}

void TimePlot::wheelEvent(QWheelEvent* event) {
    if (event->modifiers() & Qt::ShiftModifier) return event->ignore();  // scrolls the list of plots
    const double factor = std::pow(0.9985, event->angleDelta().y());
    if (!(event->modifiers() & Qt::ControlModifier)) return zoom(timeAt(event->position().x()), factor);
    const double about = valueAt(event->position().y());
    setValueRange(about - (about - low_) * factor, about + (high_ - about) * factor);
}

void TimePlot::zoom(double about, double factor) {
    const TimeView range = TimeView{from_, to_}.zoomed(about, factor);
    Q_EMIT timeRangeWanted(range.from, range.to);
}

void TimePlot::keyPressEvent(QKeyEvent* event) {
    if (!answerTimeKey(*this, *event, {from_, to_, cursor_})) QWidget::keyPressEvent(event);
}

void TimePlot::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    update();
}

void TimePlot::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

void TimePlot::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    const double x = event->position().x();
    const QRectF area = this->area();
    if (isTrimming_ || event->modifiers() & Qt::ShiftModifier) {
        bandFrom_ = bandTo_ = std::clamp(x, area.left(), area.right());
        bandTop_ = bandBottom_ = std::clamp(event->position().y(), area.top(), area.bottom());
    } else if (event->modifiers() & Qt::ControlModifier) {
        Q_EMIT markWanted(timeAt(x));
    } else {
        dragFrom_ = x;
    }
}

void TimePlot::mouseMoveEvent(QMouseEvent* event) {
    const double x = event->position().x();
    const QRectF area = this->area();
    if (bandFrom_) {
        bandTo_ = std::clamp(x, area.left(), area.right());
        bandBottom_ = std::clamp(event->position().y(), area.top(), area.bottom());
        update();
    }
    if (dragFrom_) {
        const double shift = timeAt(*dragFrom_) - timeAt(x);
        dragFrom_ = x;
        Q_EMIT timeRangeWanted(from_ + shift, to_ + shift);
    }
    Q_EMIT pointedAt(timeAt(x));
}

void TimePlot::mouseReleaseEvent(QMouseEvent*) {
    constexpr double worthIt = 3;  // [px]
    const bool isChosen = bandFrom_ && std::abs(bandTo_ - *bandFrom_) > worthIt;
    const double from = isChosen ? timeAt(std::min(*bandFrom_, bandTo_)) : 0;
    const double to = isChosen ? timeAt(std::max(*bandFrom_, bandTo_)) : 0;
    if (isChosen && isBox())
        setValueRange(valueAt(std::max(bandTop_, bandBottom_)), valueAt(std::min(bandTop_, bandBottom_)));
    dragFrom_.reset();
    bandFrom_.reset();
    update();
    // Last: who is asked may give this plot other traces.
    if (isChosen && isTrimming_)
        Q_EMIT trimWanted(from, to);
    else if (isChosen)
        Q_EMIT timeRangeWanted(from, to);
}

void TimePlot::mouseDoubleClickEvent(QMouseEvent*) { Q_EMIT allWanted(); }

void TimePlot::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    Q_EMIT pointerLeft();
}

}  // namespace analogon::ui
