#include "ui/signals/log_axis.hpp"

#include <QChart>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/signals/log_ticks.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

/// With as many digits as tell them apart.
QStringList labelsOf(const std::vector<double>& values) {
    constexpr int mostDigits = 12;
    QStringList labels;
    for (int digits = 3; digits <= mostDigits; ++digits) {
        labels.clear();
        for (const double value : values) labels << style::numberText(value, digits);
        if (QStringList once = labels; once.removeDuplicates() == 0) break;
    }
    labels.removeDuplicates();
    return labels;
}

}  // namespace

double LogAxis::at(double value) { return std::log10(value); }

void LogAxis::setValues(double low, double high) {
    low_ = low;
    high_ = high;
    setLabelsPosition(AxisLabelsPositionOnValue);
    setRange(at(low), at(high));
}

void LogAxis::fit(double length) {
    const QFontMetricsF metrics(labelsFont());
    const bool isAcross = orientation() == Qt::Horizontal;
    double gap = 1.6 * metrics.height();
    if (isAcross)
        for (const double end : {low_, high_}) {
            const double digits = 1.2 * std::pow(10.0, std::floor(std::log10(end)));
            gap = std::max(gap, metrics.horizontalAdvance(style::numberText(digits, 3)) + metrics.height());
        }
    LogTicks ticks = logTicks(low_, high_, length, gap);
    const QStringList labels = labelsOf(ticks.labelled);
    minor_ = std::move(ticks.minor);
    if (labels == categoriesLabels()) return;
    for (const QString& label : categoriesLabels()) remove(label);
    setStartValue(at(low_) - 1e-6 * (max() - min()));  // a label at the very start of it is not drawn
    for (qsizetype i = 0; i < labels.size(); ++i) append(labels[i], at(ticks.labelled[static_cast<std::size_t>(i)]));
}

void fitLogAxes(const QChart& chart, const QSizeF& size) {
    constexpr double beside = 70;  // [px] labels and titles of the other axis
    for (QAbstractAxis* axis : chart.axes())
        if (auto* log = qobject_cast<LogAxis*>(axis))
            log->fit(std::max(1.0, (axis->orientation() == Qt::Horizontal ? size.width() : size.height()) - beside));
}

void paintMinorTicks(QPainter& painter, const QChart& chart) {
    constexpr double tick = 4;  // [px]
    const QRectF area = chart.mapRectToScene(chart.plotArea());
    for (const QAbstractAxis* axis : chart.axes()) {
        const auto* log = qobject_cast<const LogAxis*>(axis);
        if (!log || !(log->max() > log->min())) continue;
        painter.setPen(log->linePen());
        for (const double value : log->minorTicks()) {
            const double part = (LogAxis::at(value) - log->min()) / (log->max() - log->min());
            if (part < 0 || part > 1) continue;
            const double x = area.left() + part * area.width(), y = area.bottom() - part * area.height();
            if (log->orientation() == Qt::Horizontal)
                painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() - tick));
            else
                painter.drawLine(QPointF(area.left(), y), QPointF(area.left() + tick, y));
        }
    }
}

}  // namespace analogon::ui
