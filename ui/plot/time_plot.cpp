#include "ui/plot/time_plot.hpp"

#include <QChart>
#include <QChartView>
#include <QGraphicsLayout>
#include <QGraphicsLineItem>
#include <QGraphicsRectItem>
#include <QGraphicsSimpleTextItem>
#include <QLineSeries>
#include <QValueAxis>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/plot/decimate.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

constexpr double leftMargin = 64, rightMargin = 26, topMargin = 6;  // [px] equal, so that stacked plots line up

/// Range and ticks of an axis. Each change lays the axis out anew, with one label a tick: so none is made without
/// need, and never a wide range with the narrow step of the range before.
void setAxis(QValueAxis& axis, double low, double high, double step) {
    if (axis.min() == low && axis.max() == high && axis.tickInterval() == step) return;
    if (axis.tickInterval() < step) axis.setTickInterval(step);
    axis.setRange(low, high);
    if (axis.tickInterval() != step) axis.setTickInterval(step);
}

std::pair<double, double> rangeOf(const std::vector<double>& values) {
    double low = 1e300, high = -1e300;
    for (const double v : values) {
        if (!std::isfinite(v)) continue;
        low = std::min(low, v);
        high = std::max(high, v);
    }
    return {low, high};
}

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

struct TimePlot::Chart {
    QChart* chart{new QChart};
    QChartView* view{};  // owns the chart
    QValueAxis* time{new QValueAxis};
    QValueAxis* value{new QValueAxis};
    std::vector<QLineSeries*> series;
    QGraphicsLineItem* cursor{};
    QGraphicsLineItem* marks[2]{};
    QGraphicsRectItem* band{};  // while zooming into it
    QGraphicsSimpleTextItem* caption{};
    QGraphicsSimpleTextItem* unit{};  // of the time axis
    QRectF area;
};

TimePlot::TimePlot(QWidget* parent) : QWidget(parent), chart_(std::make_unique<Chart>()) {
    Chart& c = *chart_;
    c.view = new QChartView(c.chart, this);
    c.view->setRenderHint(QPainter::Antialiasing);
    c.view->setFrameShape(QFrame::NoFrame);
    c.view->setBackgroundRole(QPalette::Base);
    c.view->viewport()->setMouseTracking(true);
    c.view->viewport()->installEventFilter(this);
    c.chart->legend()->hide();
    c.chart->setBackgroundRoundness(0);
    c.chart->setMargins({0, 0, 0, 0});
    c.chart->layout()->setContentsMargins(0, 0, 0, 0);
    c.chart->addAxis(c.time, Qt::AlignBottom);
    c.chart->addAxis(c.value, Qt::AlignLeft);
    for (QValueAxis* axis : {c.time, c.value}) {
        axis->setTickType(QValueAxis::TicksDynamic);
        axis->setLabelFormat("%g");
        axis->setMinorTickCount(0);
        QFont font = axis->labelsFont();
        font.setPointSizeF(this->font().pointSizeF() * 0.85);
        axis->setLabelsFont(font);
    }
    c.cursor = new QGraphicsLineItem(c.chart);
    c.cursor->setZValue(20);
    c.cursor->hide();
    for (QGraphicsLineItem*& mark : c.marks) {
        mark = new QGraphicsLineItem(c.chart);
        mark->setZValue(19);
        mark->hide();
    }
    c.band = new QGraphicsRectItem(c.chart);
    c.band->setZValue(18);
    c.band->hide();
    c.caption = new QGraphicsSimpleTextItem(c.chart);
    c.caption->setZValue(20);
    QFont font = this->font();
    font.setPointSizeF(font.pointSizeF() * 0.85);
    c.caption->setFont(font);
    c.unit = new QGraphicsSimpleTextItem(QStringLiteral("s"), c.chart);
    c.unit->setFont(font);
    recolour();
}

TimePlot::~TimePlot() = default;

void TimePlot::setTraces(std::shared_ptr<const std::vector<double>> time, std::vector<Trace> traces) {
    time_ = std::move(time);
    traces_ = std::move(traces);
    Chart& c = *chart_;
    while (c.series.size() > traces_.size()) {
        c.chart->removeSeries(c.series.back());
        delete c.series.back();
        c.series.pop_back();
    }
    while (c.series.size() < traces_.size()) addSeries();
    ranges_.clear();
    for (const Trace& trace : traces_) ranges_.push_back(rangeOf(trace.values));
    colourTraces();
    fitValues();
    refresh();
}

void TimePlot::setTrace(Trace trace) {
    const auto found =
        std::find_if(traces_.begin(), traces_.end(), [&](const Trace& t) { return t.role == trace.role; });
    const auto index = static_cast<std::size_t>(found - traces_.begin());
    const auto range = rangeOf(trace.values);
    if (found == traces_.end()) {
        traces_.push_back(std::move(trace));
        ranges_.push_back(range);
        addSeries();
        colourTraces();
    } else {
        *found = std::move(trace);
        ranges_[index] = range;
    }
    fitValues();
    draw(index);
}

void TimePlot::addSeries() {
    Chart& c = *chart_;
    auto* series = new QLineSeries;
    c.chart->addSeries(series);
    series->attachAxis(c.time);
    series->attachAxis(c.value);
    c.series.push_back(series);
}

void TimePlot::setVisible(TraceRole role, bool isVisible) {
    std::erase(hidden_, role);
    if (!isVisible) hidden_.push_back(role);
    fitValues();
    refresh();
}

void TimePlot::setTimeRange(double from, double to) {
    if (from == from_ && to == to_) return;
    from_ = from;
    to_ = to;
    refresh();
}

void TimePlot::setTimeLabels(bool isShown) {
    hasTimeLabels_ = isShown;
    chart_->time->setLabelsVisible(isShown);
    layOut();
}

void TimePlot::setTrimming(bool isTrimming) {
    isTrimming_ = isTrimming;
    chart_->view->viewport()->setCursor(isTrimming ? Qt::SplitHCursor : Qt::ArrowCursor);
}

void TimePlot::setSymmetric(bool isSymmetric) {
    isSymmetric_ = isSymmetric;
    fitValues();
}

void TimePlot::setCaption(const QString& caption) {
    chart_->caption->setText(caption);
    layOut();
}

void TimePlot::setCursorTime(std::optional<double> time) {
    const QRectF area = chart_->chart->plotArea();
    const bool isShown = time && *time >= from_ && *time <= to_;
    chart_->cursor->setVisible(isShown);
    if (!isShown) return;
    const double x = area.left() + (*time - from_) / (to_ - from_) * area.width();
    chart_->cursor->setLine(x, area.top(), x, area.bottom());
}

double TimePlot::xAt(double time) const {
    const QRectF area = chart_->chart->plotArea();
    return area.left() + (time - from_) / (to_ - from_) * area.width();
}

void TimePlot::setMarks(const std::vector<double>& times) {
    marks_ = times;
    showMarks();
}

void TimePlot::showMarks() {
    const QRectF area = chart_->chart->plotArea();
    for (std::size_t i = 0; i < 2; ++i) {
        const bool isShown = i < marks_.size() && marks_[i] >= from_ && marks_[i] <= to_;
        chart_->marks[i]->setVisible(isShown);
        if (isShown) chart_->marks[i]->setLine(xAt(marks_[i]), area.top(), xAt(marks_[i]), area.bottom());
    }
}

int TimePlot::paintedPoints() const {
    qsizetype points = 0;
    for (const QLineSeries* series : chart_->series)
        if (series->isVisible()) points += series->count();
    return static_cast<int>(points);
}

std::pair<double, double> TimePlot::valueRange() const { return {low_, high_}; }

void TimePlot::fitValues() {
    double low = 1e300, high = -1e300;
    for (std::size_t i = 0; i < traces_.size(); ++i) {
        if (isHidden(traces_[i].role)) continue;
        low = std::min(low, ranges_[i].first);
        high = std::max(high, ranges_[i].second);
    }
    if (low > high) low = 0, high = 1;
    constexpr double farthest = 1e150;  // beyond, a range has no width that is a number
    low = std::clamp(low, -farthest, farthest);
    high = std::clamp(high, -farthest, farthest);
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
    layOut();
}

void TimePlot::refresh() {
    Chart& c = *chart_;
    if (!time_ || !(to_ > from_)) return;
    showMarks();
    setAxis(*c.time, from_, to_, niceStep(to_ - from_, std::max(2, width() / 110)));
    for (std::size_t i = 0; i < traces_.size(); ++i) draw(i);
}

void TimePlot::draw(std::size_t trace) {
    Chart& c = *chart_;
    c.series[trace]->setVisible(!isHidden(traces_[trace].role));
    if (!c.series[trace]->isVisible() || !time_ || !(to_ > from_)) return;
    const int pixels = std::max(1, static_cast<int>(c.chart->plotArea().width()));
    c.series[trace]->replace(decimate(*time_, traces_[trace].values, from_, to_, pixels));
}

bool TimePlot::isHidden(TraceRole role) const {
    return std::find(hidden_.begin(), hidden_.end(), role) != hidden_.end();
}

void TimePlot::recolour() {
    Chart& c = *chart_;
    const QPalette p = palette();
    c.chart->setBackgroundBrush(p.color(QPalette::Base));
    c.chart->setBackgroundPen(Qt::NoPen);
    c.chart->setPlotAreaBackgroundVisible(false);
    const QColor grid = style::mix(p.color(QPalette::Base), p.color(QPalette::Text), 0.10);
    const QColor label = style::mix(p.color(QPalette::Text), p.color(QPalette::Base), 0.35);
    for (QValueAxis* axis : {c.time, c.value}) {
        axis->setGridLineColor(grid);
        axis->setLinePen(QPen(style::mix(p.color(QPalette::Base), p.color(QPalette::Text), 0.25), 1));
        axis->setLabelsColor(label);
    }
    c.cursor->setPen(QPen(label, 1));
    for (QGraphicsLineItem* mark : c.marks) mark->setPen(QPen(style::accent(p), 1.2));
    QColor tint = style::accent(p);
    c.band->setPen(QPen(tint, 1));
    tint.setAlphaF(0.12f);
    c.band->setBrush(tint);
    c.caption->setBrush(label);
    c.unit->setBrush(label);
    colourTraces();
}

void TimePlot::colourTraces() {
    Chart& c = *chart_;
    const QPalette p = palette();
    for (std::size_t i = 0; i < c.series.size(); ++i) {
        QPen pen(traceColour(traces_[i].role, p), traces_[i].role == TraceRole::Measured ? 1.0 : 1.6);
        pen.setJoinStyle(Qt::RoundJoin);
        if (c.series[i]->pen() != pen) c.series[i]->setPen(pen);
    }
}

void TimePlot::layOut() {
    Chart& c = *chart_;
    c.view->setGeometry(rect());
    c.chart->resize(size());
    const double bottom = hasTimeLabels_ ? fontMetrics().height() + 8 : 8;
    const double top = c.caption->text().isEmpty() ? topMargin : c.caption->boundingRect().height() + 4;
    const QRectF area(leftMargin, top, std::max(10.0, width() - leftMargin - rightMargin),
                      std::max(10.0, height() - top - bottom));
    if (area != c.area) {
        c.chart->setPlotArea(area);
        c.chart->layout()->invalidate();
        c.chart->layout()->activate();  // axes and grid at once, not when the next event comes by
    }
    c.area = area;
    setAxis(*c.value, low_, high_, niceStep(high_ - low_, std::max(2, static_cast<int>(area.height() / 18))));
    c.caption->setPos(leftMargin, 1);
    c.unit->setVisible(hasTimeLabels_);
    c.unit->setPos(width() - c.unit->boundingRect().width() - 3, area.bottom() + 6);
}

void TimePlot::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    layOut();
    refresh();
}

void TimePlot::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) recolour();
}

double TimePlot::timeAt(double x) const {
    const QRectF area = chart_->chart->plotArea();
    return from_ + (x - area.left()) / area.width() * (to_ - from_);
}

bool TimePlot::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::Wheel: {
            auto* wheel = static_cast<QWheelEvent*>(event);
            if (wheel->modifiers() & Qt::ShiftModifier) break;  // scrolls the list of plots
            const double about = timeAt(wheel->position().x());
            const double factor = std::pow(0.9985, wheel->angleDelta().y());
            Q_EMIT timeRangeWanted(about - (about - from_) * factor, about + (to_ - about) * factor);
            return true;
        }
        case QEvent::MouseButtonPress: {
            auto* mouse = static_cast<QMouseEvent*>(event);
            if (mouse->button() != Qt::LeftButton) return true;
            if (isTrimming_)
                zoomFrom_ = mouse->position().x();
            else if (mouse->modifiers() & Qt::ControlModifier)
                Q_EMIT markWanted(timeAt(mouse->position().x()));
            else if (mouse->modifiers() & Qt::ShiftModifier)
                zoomFrom_ = mouse->position().x();
            else
                dragFrom_ = mouse->position().x();
            return true;
        }
        case QEvent::MouseMove: {
            auto* mouse = static_cast<QMouseEvent*>(event);
            if (zoomFrom_) {
                const QRectF area = chart_->chart->plotArea();
                const double a = std::clamp(*zoomFrom_, area.left(), area.right());
                const double b = std::clamp(mouse->position().x(), area.left(), area.right());
                chart_->band->setRect(QRectF(QPointF(a, area.top()), QPointF(b, area.bottom())).normalized());
                chart_->band->show();
            }
            if (dragFrom_) {
                const double shift = timeAt(*dragFrom_) - timeAt(mouse->position().x());
                dragFrom_ = mouse->position().x();
                Q_EMIT timeRangeWanted(from_ + shift, to_ + shift);
            }
            Q_EMIT pointedAt(timeAt(mouse->position().x()));
            return true;
        }
        case QEvent::MouseButtonRelease: {
            const bool isChosen = zoomFrom_ && chart_->band->isVisible() && chart_->band->rect().width() > 3;
            const double from = timeAt(chart_->band->rect().left()), to = timeAt(chart_->band->rect().right());
            chart_->band->hide();
            dragFrom_.reset();
            zoomFrom_.reset();
            // Last: who is asked may give this plot other traces.
            if (isChosen && isTrimming_)
                Q_EMIT trimWanted(from, to);
            else if (isChosen)
                Q_EMIT timeRangeWanted(from, to);
            return true;
        }
        case QEvent::MouseButtonDblClick:
            Q_EMIT allWanted();
            return true;
        case QEvent::Leave:
            Q_EMIT pointerLeft();
            break;
        default:
            break;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace analogon::ui
