#include "ui/plot/residual_plot.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/residual/noise.hpp"
#include "core/study/recorded.hpp"
#include "ui/plot/decimate.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

constexpr int largestLag = 60, bins = 41;
constexpr std::size_t mostPoints = 4000;  // of the scatter: more cannot be told apart

ValueRange finiteRangeOf(const std::vector<double>& values) {
    ValueRange range;
    for (const double v : values)
        if (std::isfinite(v)) range.add(v);
    return range;
}

/// An axis has a width.
std::pair<double, double> axisOf(const ValueRange& range) {
    if (range.isEmpty()) return {0, 1};
    if (range.low == range.high) return {range.low - 0.5, range.high + 0.5};
    return {range.low, range.high};
}

std::vector<double> everyNth(const std::vector<double>& values, std::size_t stride) {
    std::vector<double> result;
    for (std::size_t i = 0; i < values.size(); i += stride) result.push_back(values[i]);
    return result;
}

}  // namespace

QString withUnit(const QString& name, const QString& unit) {
    return unit.isEmpty() ? name : QStringLiteral("%1 [%2]").arg(name, unit);
}

ResidualFacts residualFacts(const std::vector<double>& residual, const std::vector<NamedSeries>& against) {
    ResidualFacts facts;
    std::vector<double> finite;
    finite.reserve(residual.size());
    for (const double v : residual)
        if (std::isfinite(v)) finite.push_back(v);
    facts.count = static_cast<int>(finite.size());
    facts.range = finiteRangeOf(finite);
    const std::size_t stride = std::max<std::size_t>(1, residual.size() / mostPoints);
    facts.sampled = everyNth(residual, stride);
    for (const NamedSeries& s : against)
        facts.against.push_back({s.name, finiteRangeOf(s.values), everyNth(s.values, stride)});
    if (finite.empty()) return facts;

    const Eigen::Map<const Eigen::VectorXd> r(finite.data(), static_cast<Eigen::Index>(finite.size()));
    facts.mean = r.mean();
    facts.deviation = std::sqrt((r.array() - facts.mean).square().mean());
    facts.histogram.assign(bins, 0);
    const double reach = facts.reach();
    for (const double v : finite)
        ++facts.histogram[static_cast<std::size_t>(std::clamp((v + reach) / (2 * reach) * bins, 0.0, bins - 1.0))];
    if (const int lags = std::min(largestLag, facts.count / 4); lags > 1) {
        const Eigen::VectorXd c = analogon::autocorrelation(r, lags);
        facts.correlation.assign(c.data(), c.data() + c.size());
    }
    return facts;
}

std::vector<NamedSeries> variablesOf(const Study& study, const std::string& experiment,
                                     const std::vector<double>& time) {
    std::vector<NamedSeries> result;
    for (const StudyExperiment& e : study.experiments) {
        const std::shared_ptr<const Table> table = e.name == experiment ? shownTable(study.tables, e) : nullptr;
        if (!table) continue;
        const Outcome<std::vector<double>> stamps = readTime(*table, e.timeColumn);
        if (!stamps || stamps->size() < 2) return result;
        for (const Column& column : table->columns) {
            NamedSeries series{QString::fromStdString(column.header.empty() ? column.name : column.header), {}};
            if (column.name == e.timeColumn || column.values.size() != stamps->size()) {
                if (column.name == e.timeColumn)
                    result.insert(result.begin(), {withUnit(QObject::tr("time"), QStringLiteral("s")), time});
                continue;
            }
            series.values.reserve(time.size());
            std::size_t k = 0;
            for (const double t : time) {
                while (k + 2 < stamps->size() && (*stamps)[k + 1] < t) ++k;
                const double width = (*stamps)[k + 1] - (*stamps)[k];
                const double part = width > 0 ? std::clamp((t - (*stamps)[k]) / width, 0.0, 1.0) : 0;
                series.values.push_back(column.values[k] + part * (column.values[k + 1] - column.values[k]));
            }
            result.push_back(std::move(series));
        }
    }
    return result;
}

double ResidualFacts::correlationReach() const {
    constexpr double boundsSeen = 3, room = 1.1;
    double most = boundsSeen * correlationBound();
    for (std::size_t k = 1; k < correlation.size(); ++k) most = std::max(most, room * std::abs(correlation[k]));
    return std::min(1.0, most);
}

class ResidualPlot::Canvas : public QWidget {
public:
    explicit Canvas(ResidualPlot& plot) : QWidget(&plot), plot_(plot) { setMinimumHeight(130); }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const double third = width() / 3.0;
        paintHistogram(painter, frame(0, third));
        paintCorrelation(painter, frame(third, third));
        paintScatter(painter, frame(2 * third, third));
    }

private:
    /// Above it a line for the title; below it one for the ends of the axis and one for what it is.
    QRectF frame(double left, double width) const {
        return QRectF(left + 58, fontMetrics().height() + 6, width - 58 - style::margin,
                      height() - 3.4 * fontMetrics().height() - 10);
    }
    void paintFrame(QPainter& painter, const QRectF& area, const QString& title, const QString& axis,
                    std::pair<double, double> x, std::pair<double, double> y, bool hasY) const {
        painter.setPen(style::mutedText(palette()));
        painter.drawText(QRectF(area.left(), 0, area.width(), area.top() - 2), Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(title, Qt::ElideRight, static_cast<int>(area.width())));
        const double line = fontMetrics().height() + 2;
        painter.drawText(QRectF(area.left(), area.bottom() + 3 + fontMetrics().height(), area.width(), line),
                         Qt::AlignHCenter,
                         fontMetrics().elidedText(axis, Qt::ElideMiddle, static_cast<int>(area.width())));
        painter.drawText(QRectF(area.left(), area.bottom() + 3, 100, line), Qt::AlignLeft, number(x.first));
        painter.drawText(QRectF(area.right() - 100, area.bottom() + 3, 100, line), Qt::AlignRight, number(x.second));
        if (hasY) {
            painter.drawText(QRectF(area.left() - 58, area.top() - 4, 54, fontMetrics().height()), Qt::AlignRight,
                             number(y.second));
            painter.drawText(
                QRectF(area.left() - 58, area.bottom() - fontMetrics().height() + 2, 54, fontMetrics().height()),
                Qt::AlignRight, number(y.first));
        }
        painter.setPen(style::hairline(palette()));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(area);
    }
    static QString number(double v) { return style::numberText(v, 3); }

    void paintHistogram(QPainter& painter, const QRectF& area) const {
        const ResidualFacts& f = plot_.facts_;
        const double reach = f.reach();
        paintFrame(painter, area, ResidualPlot::tr("Distribution"), plot_.axisLabels().distribution, {-reach, reach},
                   {}, false);
        if (f.count < 2) return;
        const auto& counts = f.histogram;
        const double mean = f.mean, deviation = std::max(1e-150, f.deviation);
        const double binWidth = 2 * reach / bins;
        const auto normal = [&](double v) {
            const double z = (v - mean) / deviation;
            return f.count * binWidth / (deviation * std::sqrt(2 * std::numbers::pi)) * std::exp(-z * z / 2);
        };
        const double top = std::max(*std::max_element(counts.begin(), counts.end()), normal(mean)) * 1.05;
        // What is half seen on white is next to nothing on a dark ground.
        QColor fill = style::afterTrace(palette());
        fill.setAlphaF(style::isDark(palette()) ? 0.75f : 0.45f);
        for (int i = 0; i < bins; ++i) {
            const double h = counts[static_cast<std::size_t>(i)] / top * area.height();
            painter.fillRect(
                QRectF(area.left() + i * area.width() / bins, area.bottom() - h, area.width() / bins - 0.7, h), fill);
        }
        QPolygonF curve;
        for (int i = 0; i <= 120; ++i) {
            const double v = -reach + 2 * reach * i / 120;
            curve << QPointF(area.left() + i / 120.0 * area.width(), area.bottom() - normal(v) / top * area.height());
        }
        painter.setPen(QPen(style::beforeTrace(palette()), 1.5));
        painter.drawPolyline(curve);
    }

    void paintCorrelation(QPainter& painter, const QRectF& area) const {
        const auto& c = plot_.facts_.correlation;
        const double reach = plot_.facts_.correlationReach(), bound = plot_.facts_.correlationBound();
        paintFrame(painter, area, ResidualPlot::tr("Autocorrelation"), plot_.axisLabels().correlation,
                   {1, std::max(1.0, static_cast<double>(c.size()) - 1)}, {-reach, reach}, true);
        if (c.size() < 2) return;
        const auto y = [&](double v) {
            return area.center().y() - std::clamp(v / reach, -1.0, 1.0) * area.height() / 2;
        };
        QColor band = style::good(palette());
        band.setAlphaF(style::isDark(palette()) ? 0.4f : 0.22f);
        painter.fillRect(QRectF(QPointF(area.left(), y(bound)), QPointF(area.right(), y(-bound))), band);
        painter.setPen(QPen(style::accent(palette()), 1.6));
        for (std::size_t k = 1; k < c.size(); ++k) {
            const double x =
                area.left() + (static_cast<double>(k) - 0.5) / static_cast<double>(c.size() - 1) * area.width();
            painter.drawLine(QPointF(x, y(0)), QPointF(x, y(c[k])));
        }
    }

    void paintScatter(QPainter& painter, const QRectF& area) const {
        const int chosen = plot_.variable_->currentIndex();
        const ResidualFacts& f = plot_.facts_;
        if (chosen < 0 || chosen >= static_cast<int>(f.against.size())) return;
        const ResidualFacts::Variable& variable = f.against[static_cast<std::size_t>(chosen)];
        const auto& x = variable.sampled;
        const auto& r = f.sampled;
        const auto xs = axisOf(variable.range), ys = axisOf(f.range);
        const ResidualPlot::AxisLabels labels = plot_.axisLabels();
        paintFrame(painter, area, labels.againstY, labels.againstX, xs, ys, true);
        const std::size_t n = std::min(x.size(), r.size());
        QPolygonF points;
        const QRectF inner =
            area.adjusted(style::unit, style::unit, -style::unit, -style::unit);  // no dot on the frame
        for (std::size_t i = 0; i < n; ++i)
            if (std::isfinite(x[i]) && std::isfinite(r[i]))
                points << QPointF(inner.left() + (x[i] - xs.first) / (xs.second - xs.first) * inner.width(),
                                  inner.bottom() - (r[i] - ys.first) / (ys.second - ys.first) * inner.height());
        QColor ink = style::afterTrace(palette());
        ink.setAlphaF(style::isDark(palette()) ? 0.7f : 0.5f);
        painter.setPen(QPen(ink, 2, Qt::SolidLine, Qt::RoundCap));
        painter.drawPoints(points);
    }

    ResidualPlot& plot_;
};

ResidualPlot::ResidualPlot(QWidget* parent)
    : QWidget(parent), name_(new QLabel(this)), variable_(new QComboBox(this)), canvas_(new Canvas(*this)) {
    style::makeHeading(name_, 1.0);
    variable_->setSizeAdjustPolicy(QComboBox::AdjustToContents);  // what there is comes later
    variable_->setAccessibleName(tr("Residual against"));
    canvas_->setToolTip(
        tr("Left: how the residual is distributed, with the normal distribution of the same spread.\n"
           "Middle: how much of it is left after so many samples; white noise stays within the band.\n"
           "Right: the residual against another variable; noise shows no shape."));
    auto* heading = new QHBoxLayout;
    heading->setContentsMargins(style::margin, style::unit, style::margin, 0);
    heading->addWidget(name_);
    heading->addStretch(1);
    auto* label = new QLabel(tr("against"), this);
    style::makeCaption(label);
    heading->addWidget(label);
    heading->addWidget(variable_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(style::unit);
    column->addLayout(heading);
    column->addWidget(canvas_, 1);
    connect(variable_, &QComboBox::currentIndexChanged, canvas_, qOverload<>(&QWidget::update));
}

ResidualPlot::AxisLabels ResidualPlot::axisLabels() const {
    return {withUnit(tr("residual"), unit_), tr("lag [samples]"), variable_->currentText(),
            withUnit(tr("Residual"), unit_)};
}

void ResidualPlot::show(const QString& output, const QString& unit, std::function<ResidualFacts()> facts) {
    unit_ = unit;
    name_->setText(output);
    wanted_ = std::move(facts);
    if (isVisible()) workOut();
}

void ResidualPlot::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (wanted_) workOut();
}

void ResidualPlot::workOut() {
    worker_.start<ResidualFacts>(
        QString(), [work = std::exchange(wanted_, nullptr)](const Progress&) { return work(); },
        [this](ResidualFacts facts) { take(std::move(facts)); });
}

void ResidualPlot::take(ResidualFacts facts) {
    facts_ = std::move(facts);
    const QString chosen = variable_->currentText();
    const QSignalBlocker blocker(variable_);
    variable_->clear();
    for (const ResidualFacts::Variable& v : facts_.against) variable_->addItem(v.name);
    variable_->setCurrentIndex(std::max(0, variable_->findText(chosen)));
    canvas_->update();
}

}  // namespace analogon::ui
