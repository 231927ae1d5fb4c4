#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/plot/plot_panel.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

/// A trace's colour and name; a click hides and shows it.
class OutputPlot::LegendEntry : public QAbstractButton {
public:
    LegendEntry(TraceRole role, QWidget* parent) : QAbstractButton(parent), role_(role) {
        setCheckable(true);
        setChecked(true);
        setFocusPolicy(Qt::TabFocus);
        setCursor(Qt::PointingHandCursor);
        setToolTip(tr("Click to hide or show this trace"));
        // the last one may have a long name: it takes what is left, and the plot keeps its place
        setSizePolicy(role == TraceRole::After ? QSizePolicy::Preferred : QSizePolicy::Maximum, QSizePolicy::Fixed);
    }
    TraceRole role() const { return role_; }
    QSize minimumSizeHint() const override { return wholeSize().boundedTo({least, wholeSize().height()}); }
    QSize sizeHint() const override { return role_ == TraceRole::After ? minimumSizeHint() : wholeSize(); }
    QSize wholeSize() const {
        const QFontMetrics metrics(font());
        return {metrics.horizontalAdvance(text()) + swatch + 3 * style::unit, metrics.height() + style::unit};
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        QColor colour = traceColour(role_, palette());
        QColor ink = palette().color(QPalette::WindowText);
        if (!isChecked()) colour = ink = style::mix(ink, palette().color(QPalette::Window), 0.65);
        painter.setPen(QPen(colour, 2.4, Qt::SolidLine, Qt::RoundCap));
        const double middle = height() / 2.0;
        painter.drawLine(QPointF(2, middle), QPointF(swatch - 2, middle));
        painter.setPen(ink);
        const QRect room = rect().adjusted(swatch + style::unit, 0, 0, 0);
        painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft,
                         fontMetrics().elidedText(text(), Qt::ElideMiddle, room.width()));  // the figure stands last
        if (hasFocus()) {
            painter.setPen(style::accent(palette()));
            painter.drawLine(swatch + style::unit, height() - 1, width() - 2 * style::unit, height() - 1);
        }
    }

private:
    static constexpr int swatch = 18, least = 56;
    TraceRole role_;
};

OutputPlot::OutputPlot(QWidget* parent)
    : QWidget(parent),
      name_(new QLabel(this)),
      readout_(new QLabel(this)),
      values_(new TimePlot(this)),
      residual_(new TimePlot(this)) {
    auto* heading = new QHBoxLayout;
    heading->setContentsMargins(style::margin, style::unit, style::margin, 0);
    heading->setSpacing(3 * style::unit);
    style::makeHeading(name_, 1.0);
    heading->addWidget(name_);
    for (const TraceRole role : {TraceRole::Measured, TraceRole::Before, TraceRole::After}) {
        auto* entry = new LegendEntry(role, this);
        legend_.push_back(entry);
        heading->addWidget(entry, role == TraceRole::After ? 1000 : 0);
        connect(entry, &QAbstractButton::toggled, this, [this, role](bool isShown) {
            values_->setVisible(role, isShown);
            residual_->setVisible(role, isShown);
        });
    }
    heading->addStretch(1);
    style::makeCaption(readout_);
    heading->addWidget(readout_);

    values_->setTimeLabels(false);
    values_->setMinimumHeight(74);  // two outputs have room one below the other
    residual_->setSymmetric(true);
    residual_->setCaption(tr("measured − simulated"));
    residual_->setMinimumHeight(60);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(heading);
    column->addWidget(values_, 5);
    column->addWidget(residual_, 3);
    for (TimePlot* plot : {values_, residual_}) {
        connect(plot, &TimePlot::timeRangeWanted, this, &OutputPlot::timeRangeWanted);
        connect(plot, &TimePlot::allWanted, this, &OutputPlot::allWanted);
        connect(plot, &TimePlot::markWanted, this, &OutputPlot::markWanted);
        connect(plot, &TimePlot::trimWanted, this, &OutputPlot::trimWanted);
        connect(plot, &TimePlot::pointedAt, this, &OutputPlot::pointedAt);
        connect(plot, &TimePlot::pointerLeft, this, &OutputPlot::pointerLeft);
    }
}

void OutputPlot::fitInto(int height) {
    const int whole =
        layout()->itemAt(0)->minimumSize().height() + values_->minimumHeight() + residual_->minimumHeight();
    const bool isWhole = height >= whole && hasValues(content_.measured);
    if (isWhole != residual_->QWidget::isHidden()) return;
    residual_->setHidden(!isWhole);
    values_->setTimeLabels(!isWhole);
}

void OutputPlot::setLegend(TraceRole role, const QString& text) {
    for (LegendEntry* entry : legend_) {
        if (entry->role() != role) continue;
        entry->setText(text);
        entry->setVisible(!text.isEmpty());
        entry->setMaximumWidth(entry->wholeSize().width());
        entry->updateGeometry();
    }
}

QString OutputPlot::legendText(TraceRole role) const {
    for (const LegendEntry* entry : legend_)
        if (entry->role() == role) return entry->text();
    return {};
}

void OutputPlot::show(Content content) {
    content_ = std::move(content);
    name_->setText(content_.unit.isEmpty() ? content_.name : content_.name + "  [" + content_.unit + "]");
    const bool isMeasured = hasValues(content_.measured);
    setLegend(TraceRole::Measured, isMeasured ? tr("measured") : QString());
    setLegend(TraceRole::Before, content_.before.empty() ? QString() : content_.beforeLabel);
    setLegend(TraceRole::After, content_.after.empty() ? QString() : content_.afterLabel);

    std::vector<Trace> values{{TraceRole::Measured, content_.measured}};
    std::vector<Trace> residuals;
    const auto add = [&](TraceRole role, const Series& simulated, const Series& measured) {
        if (simulated.empty() || simulated.size() != measured.size()) return;
        values.push_back({role, simulated});
        residuals.push_back({role, residualOf(measured, simulated)});
    };
    add(TraceRole::Before, content_.before,
        content_.measuredBefore.empty() ? content_.measured : content_.measuredBefore);
    add(TraceRole::After, content_.after, content_.measured);
    residual_->setNote(content_.note);
    values_->setTraces(content_.time, std::move(values));
    residual_->setTraces(content_.time, std::move(residuals));
}

void OutputPlot::showAfter(const Series& values, const QString& label, const QString& note) {
    if (values.size() != content_.measured.size()) return;
    content_.after = values;
    content_.afterLabel = label;
    setLegend(TraceRole::After, label);
    residual_->setNote(note);
    values_->setTrace({TraceRole::After, values});
    residual_->setTrace({TraceRole::After, residualOf(content_.measured, values)});
}

void OutputPlot::setTimeRange(double from, double to) {
    values_->setTimeRange(from, to);
    residual_->setTimeRange(from, to);
}

void OutputPlot::showAllValues() {
    for (TimePlot* plot : {values_, residual_}) plot->showAllValues();
}

void OutputPlot::setMarks(const std::vector<double>& times) {
    marks_ = times;
    values_->setMarks(times);
    residual_->setMarks(times);
    readOut(std::nullopt);
}

void OutputPlot::pointAt(std::optional<double> time) {
    values_->setCursorTime(time);
    residual_->setCursorTime(time);
    readOut(time);
}

/// The values at the pointer; without one, the differences between the two marks.
void OutputPlot::readOut(std::optional<double> time) {
    readout_->clear();
    if (!time && marks_.size() == 2 && content_.time && !content_.time->empty()) {
        const auto& stamps = *content_.time;
        const auto indexOf = [&](double t) {
            const auto at = std::lower_bound(stamps.begin(), stamps.end(), t);
            return static_cast<std::size_t>(
                std::min<std::ptrdiff_t>(at - stamps.begin(), static_cast<std::ptrdiff_t>(stamps.size()) - 1));
        };
        const std::size_t a = indexOf(marks_[0]), b = indexOf(marks_[1]);
        QString text = tr("Δ %1 s").arg(style::numberText(stamps[b] - stamps[a]));
        const auto add = [&](const QString& name, std::span<const double> values) {
            if (a < values.size() && b < values.size() && std::isfinite(values[b] - values[a]))
                text += QStringLiteral("   Δ %1 %2").arg(name, style::numberText(values[b] - values[a]));
        };
        add(tr("measured"), content_.measured);
        add(content_.beforeLabel.section(' ', 0, 0), content_.before);
        add(content_.afterLabel.section(' ', 0, 0), content_.after);
        return readout_->setText(text);
    }
    if (!time || !content_.time || content_.time->empty()) return;
    const auto& stamps = *content_.time;
    const auto at = std::lower_bound(stamps.begin(), stamps.end(), *time);
    const auto i = static_cast<std::size_t>(
        std::min<std::ptrdiff_t>(at - stamps.begin(), static_cast<std::ptrdiff_t>(stamps.size()) - 1));
    QString text = tr("%1 s").arg(style::numberText(stamps[i], 6));
    const auto add = [&](const QString& name, std::span<const double> values) {
        if (i < values.size() && std::isfinite(values[i]))
            text += QStringLiteral("   %1 %2").arg(name, style::numberText(values[i]));
    };
    add(tr("measured"), content_.measured);
    add(content_.beforeLabel.section(' ', 0, 0), content_.before);
    add(content_.afterLabel.section(' ', 0, 0), content_.after);
    readout_->setText(text);
}

}  // namespace analogon::ui
