#include "ui/sensitivity/sweep_chart.hpp"

#include <QHelpEvent>
#include <QLineSeries>
#include <QMouseEvent>
#include <QScatterSeries>
#include <QToolTip>
#include <QValueAxis>
#include <algorithm>
#include <cmath>

#include "ui/signals/chart_axis.hpp"
#include "ui/signals/log_axis.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

bool growsByFactors(const std::vector<double>& values) {
    if (values.size() < 3 || !(values[0] > 0)) return false;
    const double middle = values[1] * values[1], product = values[0] * values[2];
    return std::abs(middle - product) < 1e-6 * middle;
}

/// Between two of the values, as the axis has them; half a step before the first and behind the last.
double edgeBefore(const std::vector<double>& values, std::size_t i, bool isLogarithmic) {
    const std::size_t count = values.size();
    if (count < 2 || values.front() == values.back()) {
        const double half = 0.5 * std::abs(values.front()) + 1e-12;
        return values.front() + (i == 0 ? -half : half);
    }
    const double one = i == 0 ? values[0] : values[i - 1];
    const double other = i == 0 ? values[1] : i == count ? values[count - 2] : values[i];
    const double half = isLogarithmic ? std::sqrt(other / one) : 0.5 * (other - one);
    const bool isOuter = i == 0 || i == count;
    if (isLogarithmic) return isOuter ? one / half : one * half;
    return isOuter ? one - half : one + half;
}

double placeOn(const QAbstractAxis& axis, double value) {
    return qobject_cast<const LogAxis*>(&axis) ? LogAxis::at(value) : value;
}

/// Ticks at round values, whatever the ends of the axis.
void setRoundTicks(QValueAxis& axis, double from, double to) {
    constexpr double wanted = 5;
    const double raw = (to - from) / wanted, decade = std::pow(10.0, std::floor(std::log10(raw)));
    double interval = 10 * decade;
    for (const double step : {5.0, 2.0, 1.0})
        if (step * decade >= raw) interval = step * decade;
    axis.setTickType(QValueAxis::TicksDynamic);
    axis.setTickAnchor(0);
    axis.setTickInterval(interval);
}

void setEnds(QAbstractAxis& axis, double from, double to) {
    if (!(to > from)) return;
    if (auto* log = qobject_cast<LogAxis*>(&axis)) return log->setValues(from, to);
    axis.setRange(from, to);
    if (auto* linear = qobject_cast<QValueAxis*>(&axis)) setRoundTicks(*linear, from, to);
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
    setFocusPolicy(Qt::StrongFocus);
    draw();
}

void SweepChart::setSweep(std::optional<ParameterSweep> sweep) {
    sweep_ = std::move(sweep);
    errors_ = sweep_ ? errorsOf(*sweep_) : std::pair(0.0, 0.0);
    cursor_.reset();
    draw();
}

/// Logarithmic: errors range over decades, and what is looked for is where they are small.
QColor SweepChart::colourOf(double errorPercent) const {
    const QColor base = palette().color(QPalette::Base);
    if (!sweep_ || !std::isfinite(errorPercent)) return base;
    const auto [low, high] = errors_;
    constexpr double leastError = 1e-9;  // [%]
    const double from = std::log(std::max(low, leastError)), to = std::log(std::max(high, leastError));
    const double part = to > from ? (std::log(std::max(errorPercent, leastError)) - from) / (to - from) : 0.0;
    return style::mix(style::accent(palette()), style::mix(base, style::accent(palette()), 0.06), part);
}

QAbstractAxis* SweepChart::axisOf(const std::string& title, const std::string& unit, bool isLogarithmic) const {
    const bool hasUnit = !unit.empty() && unit != "1";
    const QString whole =
        QString::fromStdString(title) + (hasUnit ? " [" + QString::fromStdString(unit) + "]" : QString());
    return makeAxis(whole, isLogarithmic, "%.4g", font(), palette());
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
    fitLogAxes(*chart(), size());
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
            curve->append(placeOn(*x, along.values[i]), e);
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
        mark->append(placeOn(*x, along.values[static_cast<std::size_t>(column)]), sweep_->errorPercent(row, column));
        add(mark);
        const auto [low, high] = errors_;
        const double room = std::max(0.05 * (high - low), 1e-3 * high + 1e-12);
        y->setRange(std::max(0.0, low - room), high + room);
        y->applyNiceNumbers();
    }
    const auto [from, to] = std::minmax(along.values.front(), along.values.back());
    setEnds(*x, from, to);
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
        const std::vector<double>& values = sweep_->axes[i].values;
        const bool isLogarithmic = growsByFactors(values);
        const double from = edgeBefore(values, 0, isLogarithmic), to = edgeBefore(values, values.size(), isLogarithmic);
        setEnds(*axes[i], std::min(from, to), std::max(from, to));
    }
}

double SweepChart::coordinateOf(int axis, double value) const {
    const QRectF area = chart()->plotArea();
    const auto axes = chart()->axes(axis == 0 ? Qt::Horizontal : Qt::Vertical);
    const auto* scale = axes.isEmpty() ? nullptr : qobject_cast<const QValueAxis*>(axes.front());
    if (!scale || !(scale->max() > scale->min())) return 0;
    const double part = (placeOn(*scale, value) - scale->min()) / (scale->max() - scale->min());
    return axis == 0 ? area.left() + part * area.width() : area.bottom() - part * area.height();
}

std::vector<double> SweepChart::edgesOf(int axis) const {
    const std::vector<double>& values = sweep_->axes[static_cast<std::size_t>(axis)].values;
    const bool isLogarithmic = growsByFactors(values);
    std::vector<double> edges;
    for (std::size_t i = 0; i <= values.size(); ++i)
        edges.push_back(coordinateOf(axis, edgeBefore(values, i, isLogarithmic)));
    return edges;
}

QRectF SweepChart::cell(Eigen::Index row, Eigen::Index column) const {
    const auto edges = [this](int axis, Eigen::Index at) {
        const std::vector<double>& values = sweep_->axes[static_cast<std::size_t>(axis)].values;
        const bool isLogarithmic = growsByFactors(values);
        const auto i = static_cast<std::size_t>(at);
        return std::pair(coordinateOf(axis, edgeBefore(values, i, isLogarithmic)),
                         coordinateOf(axis, edgeBefore(values, i + 1, isLogarithmic)));
    };
    const auto [left, right] = edges(0, column);
    const auto [low, high] = edges(1, row);
    return QRectF(QPointF(left, low), QPointF(right, high)).normalized();
}

QPoint SweepChart::placeOf(Eigen::Index row, Eigen::Index column) const {
    const QPointF at = isMap() ? cell(row, column).center()
                               : QPointF(coordinateOf(0, sweep_->axes[0].values[static_cast<std::size_t>(column)]),
                                         coordinateOf(1, sweep_->errorPercent(row, column)));
    return mapFromScene(chart()->mapToScene(at));
}

std::optional<SweepPoint> SweepChart::pointAt(const QPoint& place) const {
    const QPointF at = chart()->mapFromScene(mapToScene(place));
    if (!sweep_ || !chart()->plotArea().contains(at)) return {};
    const auto within = [&](int axis, double coordinate) {
        const std::vector<double> edges = edgesOf(axis);
        std::size_t i = 0;
        while (i + 2 < edges.size() && (coordinate < edges[i + 1]) != (edges.front() < edges.back())) ++i;
        return static_cast<Eigen::Index>(i);
    };
    return SweepPoint{isMap() ? within(1, at.y()) : 0, within(0, at.x())};
}

QStringList SweepChart::wordsOf(const SweepPoint& point) const {
    QStringList values;
    for (std::size_t i = 0; i < sweep_->axes.size(); ++i)
        values << QString::fromStdString(sweep_->axes[i].parameter) + " = " +
                      style::numberWithUnit(style::numberText(valuesAt(point)[i], 4),
                                            QString::fromStdString(sweep_->units[i]));
    return values;
}

QString SweepChart::errorWordsOf(const SweepPoint& point) const {
    const double e = sweep_->errorPercent(point.row, point.column);
    return std::isfinite(e) ? tr("Error %1").arg(style::percentText(e)) : tr("Not simulated");
}

std::vector<double> SweepChart::valuesAt(const SweepPoint& point) const {
    std::vector<double> values{sweep_->axes[0].values[static_cast<std::size_t>(point.column)]};
    if (isMap()) values.push_back(sweep_->axes[1].values[static_cast<std::size_t>(point.row)]);
    return values;
}

void SweepChart::setPresent(std::vector<double> values) {
    present_ = std::move(values);
    viewport()->update();
}

void SweepChart::drawForeground(QPainter* painter, const QRectF&) {
    if (!sweep_) return;
    painter->save();
    if (isMap()) drawCells(*painter);
    paintMinorTicks(*painter, *chart());
    painter->setRenderHint(QPainter::Antialiasing);
    drawPresent(*painter);
    if (cursor_ && hasFocus()) {
        const QPointF at = mapToScene(placeOf(cursor_->row, cursor_->column));
        painter->setPen(QPen(style::accent(palette()), 2));
        painter->setBrush(Qt::NoBrush);
        if (isMap())
            painter->drawRect(chart()->mapRectToScene(cell(cursor_->row, cursor_->column)));
        else
            painter->drawLine(QPointF(at.x(), chart()->plotArea().top()),
                              QPointF(at.x(), chart()->plotArea().bottom()));
    }
    painter->restore();
}

void SweepChart::drawCells(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing, false);
    const std::vector<double> across = edgesOf(0), up = edgesOf(1);
    const QBrush hatched(style::hairline(palette()), Qt::BDiagPattern);
    for (std::size_t row = 0; row + 1 < up.size(); ++row)
        for (std::size_t column = 0; column + 1 < across.size(); ++column) {
            const double e = sweep_->errorPercent(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
            const QRectF at = chart()->mapRectToScene(
                QRectF(QPointF(across[column], up[row]), QPointF(across[column + 1], up[row + 1])).normalized());
            if (std::isfinite(e))
                painter.fillRect(at.adjusted(0, 0, 0.5, 0.5), colourOf(e));
            else
                painter.fillRect(at, hatched);
        }
    if (const auto [row, column] = sweep_->least(); row >= 0) {
        painter.setPen(QPen(style::good(palette()), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(chart()->mapRectToScene(cell(row, column)).adjusted(1, 1, -1, -1));
    }
}

/// Where the study stands: a cross on the map, a line through the curve.
void SweepChart::drawPresent(QPainter& painter) const {
    if (present_.size() != sweep_->axes.size()) return;
    const QRectF area = chart()->plotArea();
    const double x = coordinateOf(0, present_[0]), y = isMap() ? coordinateOf(1, present_[1]) : area.center().y();
    if (!std::isfinite(x) || !std::isfinite(y) || !area.contains(QPointF(x, y))) return;
    const QColor ink = palette().color(QPalette::Text), base = palette().color(QPalette::Base);
    constexpr double arm = 6;  // [px]
    for (const QPen& pen : {QPen(base, 4), QPen(ink, 1.6)}) {
        painter.setPen(isMap() ? pen : QPen(style::mix(ink, base, 0.35), 1));
        if (isMap())
            painter.drawLine(chart()->mapToScene(QPointF(x - arm, y)), chart()->mapToScene(QPointF(x + arm, y)));
        painter.drawLine(chart()->mapToScene(QPointF(x, isMap() ? y - arm : area.top())),
                         chart()->mapToScene(QPointF(x, isMap() ? y + arm : area.bottom())));
    }
}

bool SweepChart::viewportEvent(QEvent* event) {
    if (event->type() != QEvent::ToolTip || !sweep_) return QChartView::viewportEvent(event);
    auto* help = static_cast<QHelpEvent*>(event);
    const std::optional<SweepPoint> point = pointAt(help->pos());
    const QStringList lines =
        point ? wordsOf(*point) + QStringList{errorWordsOf(*point), tr("Click to set this")} : QStringList();
    QToolTip::showText(help->globalPos(), lines.join('\n'), viewport());
    return true;
}

void SweepChart::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return QChartView::mousePressEvent(event);
    cursor_ = pointAt(event->pos());
    if (cursor_) Q_EMIT chosen(*cursor_);
    viewport()->update();
}

void SweepChart::keyPressEvent(QKeyEvent* event) {
    const bool isSet = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space;
    if (sweep_ && cursor_ && isSet) return Q_EMIT chosen(*cursor_);
    const auto step = [&](int key, int opposite) { return (event->key() == key) - (event->key() == opposite); };
    const int across = step(Qt::Key_Right, Qt::Key_Left), up = step(Qt::Key_Up, Qt::Key_Down);
    if (!sweep_ || (across == 0 && up == 0)) return QChartView::keyPressEvent(event);
    if (!cursor_) {
        const auto [row, column] = sweep_->least();
        cursor_ = SweepPoint{std::max<Eigen::Index>(0, row), std::max<Eigen::Index>(0, column)};
    } else {
        const auto moved = [](Eigen::Index at, int by, const std::vector<double>& values) {
            const int direction = values.back() < values.front() ? -by : by;
            return std::clamp<Eigen::Index>(at + direction, 0, static_cast<Eigen::Index>(values.size()) - 1);
        };
        cursor_->column = moved(cursor_->column, across, sweep_->axes[0].values);
        if (isMap()) cursor_->row = moved(cursor_->row, up, sweep_->axes[1].values);
    }
    Q_EMIT pointedAt(*cursor_);
    viewport()->update();
}

void SweepChart::resizeEvent(QResizeEvent* event) {
    QChartView::resizeEvent(event);
    fitLogAxes(*chart(), size());
}

void SweepChart::changeEvent(QEvent* event) {
    QChartView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) draw();
}

}  // namespace analogon::ui
