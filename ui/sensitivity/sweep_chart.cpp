#include "ui/sensitivity/sweep_chart.hpp"

#include <QHelpEvent>
#include <QLineSeries>
#include <QLogValueAxis>
#include <QScatterSeries>
#include <QToolTip>
#include <QValueAxis>
#include <algorithm>
#include <cmath>

#include "ui/signals/chart_axis.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

bool growsByFactors(const std::vector<double>& values) {
    if (values.size() < 3 || !(values[0] > 0)) return false;
    const double middle = values[1] * values[1], product = values[0] * values[2];
    return std::abs(middle - product) < 1e-6 * middle;
}

/// From half a cell before the first value to half a cell behind the last.
std::pair<double, double> rangeAround(const std::vector<double>& values) {
    const double first = values.front(), last = values.back();
    if (values.size() < 2 || first == last)
        return {first - 0.5 * std::abs(first) - 1e-12, first + 0.5 * std::abs(first) + 1e-12};
    const double gaps = static_cast<double>(values.size() - 1);
    if (growsByFactors(values)) {
        const double half = std::pow(last / first, 0.5 / gaps);
        return {first / half, last * half};
    }
    const double half = 0.5 * (last - first) / gaps;
    return {first - half, last + half};
}

/// Ticks at round values, whatever the ends of the axis.
void setRoundTicks(QAbstractAxis& axis, double from, double to) {
    auto* linear = qobject_cast<QValueAxis*>(&axis);
    if (!linear || !(to > from)) return;
    constexpr double wanted = 5;
    const double raw = (to - from) / wanted, decade = std::pow(10.0, std::floor(std::log10(raw)));
    double interval = 10 * decade;
    for (const double step : {5.0, 2.0, 1.0})
        if (step * decade >= raw) interval = step * decade;
    linear->setTickType(QValueAxis::TicksDynamic);
    linear->setTickAnchor(0);
    linear->setTickInterval(interval);
}

std::pair<double, double> errorsOf(const ParameterSweep& sweep) {
    double low = INFINITY, high = -INFINITY;
    for (const double e : sweep.errorPercent.reshaped())
        if (std::isfinite(e)) low = std::min(low, e), high = std::max(high, e);
    return {low, high};
}

}  // namespace

SweepChart::SweepChart(QWidget* parent) : QChartView(parent) {
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing);
    chart()->legend()->hide();
    chart()->setMargins({0, 0, style::margin, 0});
    chart()->setBackgroundRoundness(0);
    chart()->setLocalizeNumbers(true);
    QLocale locale = style::windowLocale();
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    chart()->setLocale(locale);
    setAccessibleName(tr("Error over the parameters"));
    draw();
}

void SweepChart::setSweep(std::optional<ParameterSweep> sweep) {
    sweep_ = std::move(sweep);
    draw();
}

/// Logarithmic: errors range over decades, and what is looked for is where they are small.
QColor SweepChart::colourOf(double errorPercent) const {
    const QColor base = palette().color(QPalette::Base);
    if (!sweep_ || !std::isfinite(errorPercent)) return base;
    const auto [low, high] = errorsOf(*sweep_);
    constexpr double leastError = 1e-9;  // [%]
    const double from = std::log(std::max(low, leastError)), to = std::log(std::max(high, leastError));
    const double part = to > from ? (std::log(std::max(errorPercent, leastError)) - from) / (to - from) : 0.0;
    return style::mix(style::accent(palette()), style::mix(base, style::accent(palette()), 0.06), part);
}

QAbstractAxis* SweepChart::axisOf(const std::string& title, const std::string& unit, bool isLogarithmic) const {
    const bool hasUnit = !unit.empty() && unit != "1";
    const QString whole =
        QString::fromStdString(title) + (hasUnit ? " [" + QString::fromStdString(unit) + "]" : QString());
    QAbstractAxis* const axis = makeAxis(whole, isLogarithmic, "%.4g", font(), palette());
    if (auto* log = qobject_cast<QLogValueAxis*>(axis)) log->setMinorTickCount(8);
    return axis;
}

void SweepChart::draw() {
    const QColor base = palette().color(QPalette::Base);
    chart()->setBackgroundBrush(base);
    setBackgroundBrush(base);
    chart()->removeAllSeries();
    for (QAbstractAxis* axis : chart()->axes()) {
        chart()->removeAxis(axis);
        delete axis;
    }
    if (!sweep_) return;
    if (isMap())
        drawMap();
    else
        drawCurve();
}

void SweepChart::drawCurve() {
    const SweepAxis& along = sweep_->axes[0];
    QAbstractAxis* x = axisOf(along.parameter, sweep_->units[0], growsByFactors(along.values));
    auto* y = qobject_cast<QValueAxis*>(axisOf(tr("Error").toStdString(), "%", false));
    chart()->addAxis(x, Qt::AlignBottom);
    chart()->addAxis(y, Qt::AlignLeft);
    const auto add = [&](QXYSeries* series) {
        chart()->addSeries(series);
        series->attachAxis(x);
        series->attachAxis(y);
    };
    auto* curve = new QLineSeries;
    curve->setPen(QPen(style::accent(palette()), 1.6));
    const auto finish = [&] {
        if (curve->count() > 0)
            add(curve);
        else
            delete curve;
    };
    for (std::size_t i = 0; i < along.values.size(); ++i) {
        const double e = sweep_->errorPercent(0, static_cast<Eigen::Index>(i));
        if (std::isfinite(e)) {
            curve->append(along.values[i], e);
        } else if (curve->count() > 0) {  // the curve has a gap where the model cannot be simulated
            finish();
            curve = new QLineSeries;
            curve->setPen(QPen(style::accent(palette()), 1.6));
        }
    }
    finish();
    if (const auto [row, column] = sweep_->least(); row >= 0) {
        auto* mark = new QScatterSeries;
        mark->setMarkerSize(9);
        mark->setColor(style::good(palette()));
        mark->setBorderColor(palette().color(QPalette::Base));
        mark->append(along.values[static_cast<std::size_t>(column)], sweep_->errorPercent(row, column));
        add(mark);
        const auto [low, high] = errorsOf(*sweep_);
        const double room = std::max(0.05 * (high - low), 1e-3 * high + 1e-12);
        y->setRange(std::max(0.0, low - room), high + room);
        y->applyNiceNumbers();
    }
    const auto [from, to] = std::minmax(along.values.front(), along.values.back());
    if (to > from) x->setRange(from, to);
    setRoundTicks(*x, from, to);
}

/// The axes are those of the chart; the cells are drawn over its plot, as Qt Charts has no map.
void SweepChart::drawMap() {
    QAbstractAxis* axes[2]{};
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
        const SweepAxis& axis = sweep_->axes[i];
        axes[i] = axisOf(axis.parameter, sweep_->units[i], growsByFactors(axis.values));
        chart()->addAxis(axes[i], i == 0 ? Qt::AlignBottom : Qt::AlignLeft);
    }
    auto* none = new QLineSeries;  // an axis without a series has no labels
    chart()->addSeries(none);
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
        none->attachAxis(axes[i]);
        const auto [from, to] = rangeAround(sweep_->axes[i].values);
        axes[i]->setRange(std::min(from, to), std::max(from, to));
        setRoundTicks(*axes[i], std::min(from, to), std::max(from, to));
    }
}

QRectF SweepChart::cell(Eigen::Index row, Eigen::Index column) const {
    const QRectF area = chart()->plotArea();
    const auto& across = sweep_->axes[0].values;
    const auto& up = sweep_->axes[1].values;
    const double width = area.width() / static_cast<double>(across.size());
    const double height = area.height() / static_cast<double>(up.size());
    const auto last = [](const auto& values) { return static_cast<Eigen::Index>(values.size()) - 1; };
    const Eigen::Index i = across.back() < across.front() ? last(across) - column : column;
    const Eigen::Index j = up.back() < up.front() ? last(up) - row : row;
    return {area.left() + static_cast<double>(i) * width, area.bottom() - static_cast<double>(j + 1) * height, width,
            height};
}

QPoint SweepChart::placeOf(Eigen::Index row, Eigen::Index column) const {
    return mapFromScene(chart()->mapToScene(cell(row, column).center()));
}

void SweepChart::drawForeground(QPainter* painter, const QRectF&) {
    if (!isMap()) return;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing, false);
    for (Eigen::Index row = 0; row < sweep_->errorPercent.rows(); ++row)
        for (Eigen::Index column = 0; column < sweep_->errorPercent.cols(); ++column) {
            const double e = sweep_->errorPercent(row, column);
            const QRectF at = chart()->mapRectToScene(cell(row, column));
            if (std::isfinite(e))
                painter->fillRect(at.adjusted(0, 0, 0.5, 0.5), colourOf(e));
            else
                painter->fillRect(at, QBrush(style::hairline(palette()), Qt::BDiagPattern));
        }
    if (const auto [row, column] = sweep_->least(); row >= 0) {
        painter->setPen(QPen(style::good(palette()), 2));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(chart()->mapRectToScene(cell(row, column)).adjusted(1, 1, -1, -1));
    }
    painter->restore();
}

bool SweepChart::viewportEvent(QEvent* event) {
    if (event->type() != QEvent::ToolTip || !isMap()) return QChartView::viewportEvent(event);
    auto* help = static_cast<QHelpEvent*>(event);
    const QPointF at = chart()->mapFromScene(mapToScene(help->pos()));
    QString said;
    for (Eigen::Index row = 0; row < sweep_->errorPercent.rows(); ++row)
        for (Eigen::Index column = 0; column < sweep_->errorPercent.cols(); ++column) {
            if (!cell(row, column).contains(at)) continue;
            const double e = sweep_->errorPercent(row, column);
            const auto value = [&](std::size_t axis, Eigen::Index i) {
                return QString::fromStdString(sweep_->axes[axis].parameter) + " = " +
                       style::numberText(sweep_->axes[axis].values[static_cast<std::size_t>(i)], 4) + "\n";
            };
            said = value(0, column) + value(1, row) +
                   (std::isfinite(e) ? tr("Error %1").arg(style::percentText(e)) : tr("Not simulated"));
        }
    QToolTip::showText(help->globalPos(), said, viewport());
    return true;
}

void SweepChart::changeEvent(QEvent* event) {
    QChartView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) draw();
}

}  // namespace analogon::ui
