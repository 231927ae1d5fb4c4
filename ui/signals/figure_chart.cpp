#include "ui/signals/figure_chart.hpp"

#include <QLineSeries>
#include <QValueAxis>
#include <algorithm>
#include <cmath>

#include "ui/signals/chart_axis.hpp"
#include "ui/signals/log_axis.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

/// As the axes have them.
QList<QPointF> placed(const QPolygonF& points, bool isLogarithmic) {
    QList<QPointF> places = points;
    if (isLogarithmic)
        for (QPointF& point : places) point = {LogAxis::at(point.x()), LogAxis::at(point.y())};
    return places;
}

/// So that all of the curves is within it.
void fit(QAbstractAxis& axis, const ValueRange& range) {
    if (range.isEmpty()) return;
    if (auto* log = qobject_cast<LogAxis*>(&axis)) return log->setValues(range.low / 1.2, range.high * 1.2);
    auto* linear = qobject_cast<QValueAxis*>(&axis);
    const double around = range.high > range.low ? 0 : std::max(1e-9, 0.1 * std::abs(range.low));
    linear->setRange(range.low - around, range.high + around);
    linear->applyNiceNumbers();
}

}  // namespace

FigureChart::FigureChart(QWidget* parent) : QChartView(parent) {
    setFrameShape(QFrame::NoFrame);
    setMinimumHeight(110);
    setAcceptDrops(false);  // its strip takes what is dropped
    viewport()->setAcceptDrops(false);
    setRenderHint(QPainter::Antialiasing);
    chart()->legend()->hide();
    chart()->setMargins({0, 0, style::margin, 0});
    chart()->setBackgroundRoundness(0);
    QLocale locale = style::windowLocale();
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    chart()->setLocalizeNumbers(true);
    chart()->setLocale(locale);
    constexpr int moment = 60;  // [ms] while the time is dragged
    pause_.setSingleShot(true);
    pause_.setInterval(moment);
    connect(&pause_, &QTimer::timeout, this, &FigureChart::workOut);
}

void FigureChart::want(PlotView view, std::vector<ChartLine> lines, double from, double to) {
    if (view == view_ && lines == lines_ && from == from_ && to == to_) return;
    view_ = view;
    lines_ = std::move(lines);
    from_ = from;
    to_ = to;
    pause_.start();
}

void FigureChart::show(Figure figure) {
    figure_ = std::move(figure);
    draw();
}

void FigureChart::workOut() {
    worker_.start<Figure>(
        QString(),
        [view = view_, lines = lines_, from = from_, to = to_](const Progress&) {
            return figureOf(view, lines, from, to);
        },
        [this](Figure figure) { show(std::move(figure)); });
}

void FigureChart::draw() {
    const QColor base = palette().color(QPalette::Base);
    chart()->setBackgroundBrush(base);
    setBackgroundBrush(base);
    chart()->removeAllSeries();
    for (QAbstractAxis* axis : chart()->axes()) {
        chart()->removeAxis(axis);
        delete axis;
    }
    chart()->setTitle(figure_.fault);
    chart()->setTitleBrush(style::mutedText(palette()));
    if (!figure_.fault.isEmpty() || figure_.curves.empty()) return;
    const auto make = [&](const QString& title) {
        return makeAxis(title, figure_.isLogarithmic, "%.5g", font(), palette());
    };
    QAbstractAxis *x = make(figure_.xLabel), *y = make(figure_.yLabel);
    chart()->addAxis(x, Qt::AlignBottom);
    chart()->addAxis(y, Qt::AlignLeft);
    for (const Figure::Curve& curve : figure_.curves) {
        auto* series = new QLineSeries;
        series->replace(placed(curve.points, figure_.isLogarithmic));
        series->setPen(QPen(curve.colour, 1.4));
        chart()->addSeries(series);
        series->attachAxis(x);
        series->attachAxis(y);
    }
    ValueRange across, along;  // an axis takes its range from the first series alone
    for (const Figure::Curve& curve : figure_.curves)
        for (const QPointF& point : curve.points) {
            across.add(point.x());
            along.add(point.y());
        }
    fit(*x, across);
    fit(*y, along);
    fitLogAxes(*chart(), size());
}

void FigureChart::resizeEvent(QResizeEvent* event) {
    QChartView::resizeEvent(event);
    fitLogAxes(*chart(), size());
}

void FigureChart::drawForeground(QPainter* painter, const QRectF&) { paintMinorTicks(*painter, *chart()); }

void FigureChart::changeEvent(QEvent* event) {
    QChartView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) draw();
}

}  // namespace analogon::ui
