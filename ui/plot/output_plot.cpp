#include <QAbstractButton>
#include <QLabel>
#include <QPainter>
#include <QResizeEvent>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "ui/plot/flow_layout.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/style/breakable.hpp"
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
        QSizePolicy policy(QSizePolicy::Maximum, QSizePolicy::Preferred);
        policy.setHeightForWidth(true);
        setSizePolicy(policy);
    }
    TraceRole role() const { return role_; }
    void setSmall(bool isSmall) {
        if (isSmall == isSmall_) return;
        isSmall_ = isSmall;
        updateGeometry();
        update();
    }
    QSize minimumSizeHint() const override { return sizeHint().boundedTo({least, sizeHint().height()}); }
    QSize sizeHint() const override {
        const int width = QFontMetrics(inkFont()).horizontalAdvance(text()) + swatch + 3 * style::unit;
        return {width, heightForWidth(width)};
    }
    /// A name that is longer than the row breaks, wherever it must: no word of it is lost.
    int heightForWidth(int width) const override {
        return QFontMetrics(inkFont())
                   .boundingRect(QRect(0, 0, width - swatch - style::unit, 1 << 20), flags, text())
                   .height() +
               style::unit;
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        QColor colour = traceColour(role_, palette());
        QColor ink = palette().color(QPalette::WindowText);
        if (!isChecked()) colour = ink = style::mix(ink, palette().color(QPalette::Window), 0.65);
        painter.setPen(QPen(colour, 2.4, Qt::SolidLine, Qt::RoundCap));
        painter.setFont(inkFont());
        const double middle = (painter.fontMetrics().height() + style::unit) / 2.0;  // of the first line
        painter.drawLine(QPointF(2, middle), QPointF(swatch - 2, middle));
        painter.setPen(ink);
        painter.drawText(rect().adjusted(swatch + style::unit, 0, 0, 0), flags, text());
        if (hasFocus()) {
            painter.setPen(style::accent(palette()));
            painter.drawLine(swatch + style::unit, height() - 1, width() - 2 * style::unit, height() - 1);
        }
    }

private:
    QFont inkFont() const {
        QFont ink = font();
        if (isSmall_) ink.setPointSizeF(0.85 * ink.pointSizeF());
        return ink;
    }
    static constexpr int swatch = 18, least = 56;
    static constexpr int flags = Qt::AlignVCenter | Qt::AlignLeft | Qt::TextWordWrap | Qt::TextWrapAnywhere;
    TraceRole role_;
    bool isSmall_{};
};

namespace {

constexpr int usualValues = 74, leastValues = 52;  // [px] two outputs have room one below the other

}  // namespace

OutputPlot::OutputPlot(QWidget* parent)
    : QWidget(parent),
      name_(new QLabel(this)),
      readout_(new QLabel(this)),
      values_(new TimePlot(this)),
      residual_(new TimePlot(this)) {
    head_ = new QWidget(this);
    heading_ = new FlowLayout(head_);
    heading_->setContentsMargins(style::margin, style::unit, style::margin, 0);
    heading_->setSpacing(3 * style::unit);
    style::makeHeading(name_, 1.0);
    heading_->addWidget(name_);
    for (const TraceRole role : {TraceRole::Measured, TraceRole::Before, TraceRole::After}) {
        auto* entry = new LegendEntry(role, head_);
        legend_.push_back(entry);
        heading_->addWidget(entry);
        connect(entry, &QAbstractButton::toggled, this, [this, role](bool isShown) {
            values_->setVisible(role, isShown);
            residual_->setVisible(role, isShown);
        });
    }
    style::makeCaption(readout_);
    readout_->setAutoFillBackground(true);
    readout_->setAttribute(Qt::WA_TransparentForMouseEvents);
    readout_->hide();

    values_->setTimeLabels(false);
    values_->setMinimumHeight(usualValues);
    residual_->setSymmetric(true);
    residual_->setCaption(tr("measured − simulated"));
    residual_->setMinimumHeight(60);
    name_->setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(head_);
    fitLegend();
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
    room_ = height;
    fitLegend();
}

/// The legend takes as many rows as its words need. Where that leaves too little room, it is written smaller, then the
/// residual gives way, then the values are lower; what still has no room is scrolled to.
void OutputPlot::fitLegend() {
    struct Way {
        bool isSmall, hasResidual;
        int values;  // [px]
    };
    constexpr Way ways[]{{false, true, usualValues},
                         {true, true, usualValues},
                         {false, false, usualValues},
                         {true, false, usualValues},
                         {true, false, leastValues}};
    const bool isMeasured = hasValues(content_.measured);
    for (const Way& way : ways) {
        if (way.hasResidual && !isMeasured) continue;
        for (LegendEntry* entry : legend_) entry->setSmall(way.isSmall);
        const int rows = heading_->heightOfRows(width());
        const int needed = rows + way.values + (way.hasResidual ? residual_->minimumHeight() : 0);
        if (needed > room_ && &way != std::end(ways) - 1) continue;
        head_->setFixedHeight(rows);
        values_->setMinimumHeight(way.values);
        values_->setTimeLabels(!way.hasResidual);
        residual_->setHidden(!way.hasResidual);
        return;
    }
}

void OutputPlot::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitLegend();
}

void OutputPlot::setLegend(TraceRole role, const QString& text) {
    for (LegendEntry* entry : legend_) {
        if (entry->role() != role) continue;
        entry->setText(text);
        entry->setVisible(!text.isEmpty());
        entry->updateGeometry();
    }
    fitLegend();
}

QString OutputPlot::legendText(TraceRole role) const {
    for (const LegendEntry* entry : legend_)
        if (entry->role() == role) return entry->text();
    return {};
}

void OutputPlot::show(Content content) {
    content_ = std::move(content);
    constexpr int shortName = 24;  // letters that every plot has room for
    const bool isLong = content_.name.size() > shortName;
    name_->setTextFormat(isLong ? Qt::RichText : Qt::PlainText);
    const QString name = isLong ? breakable(content_.name) : content_.name;
    name_->setText(content_.unit.isEmpty() ? name : name + "  [" + content_.unit + "]");
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

/// Beside the legend where there is room, else over the top of the plot: nothing moves while the pointer does.
void OutputPlot::showReadout(const QString& text) {
    readout_->setVisible(!text.isEmpty());
    if (text.isEmpty()) return;
    readout_->setText(text);
    readout_->adjustSize();
    const int left = std::max(0, width() - style::margin - readout_->width());
    const bool isBeside = left >= heading_->firstRowEnd() + 3 * style::unit;
    readout_->move(left, isBeside ? style::unit + (name_->height() - readout_->height()) / 2 : values_->y());
    readout_->raise();
}

/// The values at the pointer; without one, the differences between the two marks.
void OutputPlot::readOut(std::optional<double> time) { showReadout(readoutText(time)); }

QString OutputPlot::readoutText(std::optional<double> time) const {
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
        return text;
    }
    if (!time || !content_.time || content_.time->empty()) return {};
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
    return text;
}

}  // namespace analogon::ui
