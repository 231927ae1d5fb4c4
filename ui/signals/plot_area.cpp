#include "ui/signals/plot_area.hpp"

#include <QApplication>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMimeData>
#include <QScrollArea>
#include <QStackedLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/study/recorded.hpp"
#include "ui/document/document.hpp"
#include "ui/signals/signal_strip.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

PlotArea::PlotArea(Document& document, QWidget* parent) : QWidget(parent), document_(document), values_(document) {
    setAcceptDrops(true);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    empty_ =
        new QLabel(tr("Drag signals here, or press Enter on them in the list of signals. Several on one axis: "
                      "choose them together, or drag them onto it."));
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    empty_->setMargin(style::margin);
    empty_->setMinimumHeight(1);  // small screens have no more
    style::makeCaption(empty_);
    difference_ = new QLabel;
    difference_->setContentsMargins(style::margin, style::unit, style::margin, 0);
    difference_->hide();
    auto* inner = new QWidget;
    column_ = new QVBoxLayout(inner);
    column_->setContentsMargins({});
    column_->setSpacing(0);
    area_ = new QScrollArea;
    area_->setWidget(inner);
    area_->setWidgetResizable(true);
    area_->setFrameShape(QFrame::NoFrame);
    page_ = new QWidget;
    auto* whole = new QVBoxLayout(page_);
    whole->setContentsMargins({});
    whole->setSpacing(0);
    whole->addWidget(difference_);
    whole->addWidget(area_, 1);
    pages_ = new QStackedLayout(this);
    pages_->addWidget(empty_);
    pages_->addWidget(page_);
    connect(&document, &Document::opened, this, [this] {
        shown_.clear();
        colours_.clear();
        marks_.clear();
        isWhole_ = true;
        takeLayout();
    });
    connect(&document, &Document::plotsChanged, this, &PlotArea::takeLayout);
    connect(&document, &Document::liveTracesChanged, this, [this] {
        if (isVisible()) refresh();
    });
    connect(&values_, &SignalValues::arrived, this, &PlotArea::refresh);
    connect(&values_, &SignalValues::outdated, this, &PlotArea::refresh);
    takeLayout();
}

void PlotArea::change(PlotLayout layout, const QString& what) {
    std::erase_if(layout.axes, [](const PlotAxis& axis) { return axis.traces.empty(); });
    if (!document_.isOpen() || layout == layout_) return;
    StudySettings settings = document_.settings();
    settings.plots = withPlotLayout(settings.plots, layout);
    document_.applySettings(std::move(settings), what);
}

void PlotArea::show(const std::vector<SignalRef>& references) {
    if (references.empty()) return;
    PlotLayout layout = layout_;
    std::set<QString> units;
    layout.axes.emplace_back();
    for (const SignalRef& reference : references) {
        if (units.insert(unitOf(reference)).second && units.size() > 2) {
            layout.axes.emplace_back();
            units = {unitOf(reference)};
        }
        layout.axes.back().traces.push_back(reference);
    }
    change(std::move(layout), tr("Plot %1").arg(references.front().name));
}

void PlotArea::addTo(int axis, const std::vector<SignalRef>& references) {
    if (references.empty() || axis < 0 || axis >= static_cast<int>(layout_.axes.size())) return;
    PlotLayout layout = layout_;
    PlotAxis& target = layout.axes[static_cast<std::size_t>(axis)];
    std::set<QString> units;
    for (const SignalRef& there : target.traces) units.insert(unitOf(there));
    std::vector<SignalRef> further;
    for (const SignalRef& reference : references) {
        if (std::find(target.traces.begin(), target.traces.end(), reference) != target.traces.end()) continue;
        const bool hasRoom = units.contains(unitOf(reference)) || units.size() < 2;
        if (hasRoom) units.insert(unitOf(reference));
        (hasRoom ? target.traces : further).push_back(reference);
    }
    if (!further.empty()) layout.axes.insert(layout.axes.begin() + axis + 1, {std::move(further), target.view});
    change(std::move(layout), tr("Plot %1").arg(references.front().name));
}

void PlotArea::remove(int axis, int trace) {
    PlotLayout layout = layout_;
    auto& traces = layout.axes[static_cast<std::size_t>(axis)].traces;
    if (trace < 0 || trace >= static_cast<int>(traces.size())) return;
    const QString name = traces[static_cast<std::size_t>(trace)].name;
    traces.erase(traces.begin() + trace);
    change(std::move(layout), tr("Take %1 out of the plots").arg(name));
}

void PlotArea::move(int axis, int by) {
    const int to = axis + by;
    if (to < 0 || to >= static_cast<int>(layout_.axes.size())) return;
    PlotLayout layout = layout_;
    std::swap(layout.axes[static_cast<std::size_t>(axis)], layout.axes[static_cast<std::size_t>(to)]);
    change(std::move(layout), tr("Move an axis of the plots"));
    strips_[static_cast<std::size_t>(to)]->chart()->setFocus();
}

/// The keys go on with the axis that takes its place.
void PlotArea::closeAxis(int axis) {
    if (axis >= static_cast<int>(strips_.size())) return;
    const bool hasFocus = strips_[static_cast<std::size_t>(axis)]->isAncestorOf(QApplication::focusWidget());
    PlotLayout layout = layout_;
    layout.axes.erase(layout.axes.begin() + axis);
    change(std::move(layout), tr("Remove an axis of the plots"));
    if (hasFocus && !strips_.empty())
        strips_[std::min(static_cast<std::size_t>(axis), strips_.size() - 1)]->chart()->setFocus();
}

std::shared_ptr<const SignalData> PlotArea::moving(const SignalRef& reference, const SignalData& shown) const {
    const SimulatedTraces* traces = document_.liveTraces();
    if (!traces && document_.preview()) traces = &document_.preview()->traces;
    if (!traces || reference.kind != SignalKind::Variable) return nullptr;
    for (const SimulatedExperiment& experiment : traces->experiments)
        for (const SimulatedTrace& trace : experiment.outputs)
            if (QString::fromStdString(experiment.name) == reference.recording &&
                QString::fromStdString(trace.output) == reference.name && trace.values.size() == shown.time->size())
                return std::make_shared<const SignalData>(SignalData{shown.time, Series(trace.values), shown.unit, {}});
    return nullptr;
}

QString PlotArea::unitOf(const SignalRef& reference) {
    const std::string name = reference.name.toStdString();
    if (const auto shown = shown_.find(reference.key()); shown != shown_.end() && shown->second)
        return shown->second->unit;
    if (reference.kind == SignalKind::Variable)
        return QString::fromStdString(ui::unitOf(document_.facts().variables, name));
    if (reference.kind == SignalKind::Residual)
        return QString::fromStdString(ui::unitOf(document_.facts().outputs, name));
    if (reference.kind == SignalKind::Sensitivity)
        return QString::fromStdString(
            ui::unitOf(document_.facts().outputs, sensitiveOutput(reference.name).toStdString()));
    if (reference.kind == SignalKind::Recorded)
        for (const StudyExperiment& e : document_.study().experiments)
            if (QString::fromStdString(e.name) == reference.recording)
                if (const auto table = fileTable(document_.study().tables, e))
                    if (const Column* column = table->find(name)) return QString::fromStdString(column->unit);
    return reference.kind == SignalKind::Derived ? reference.name : QString();
}

/// What was measured of an output, and what the model says of it, have their colours in every plot of the window.
QColor PlotArea::colourOf(const SignalRef& reference, const std::set<QString>& taken) {
    const std::string name = reference.name.toStdString();
    std::optional<QColor> known;
    for (const StudyExperiment& e : document_.study().experiments)
        for (const auto& [output, mapping] : e.outputs) {
            const bool isOf = QString::fromStdString(e.name) == reference.recording;
            if (reference.kind == SignalKind::Recorded && isOf && mapping.column == name)
                known = style::measuredTrace(palette());
            const bool isResidual = reference.kind == SignalKind::Residual && isOf;
            if ((reference.kind == SignalKind::Variable || isResidual) && output == name)
                known = document_.after() ? style::afterTrace(palette()) : style::beforeTrace(palette());
        }
    if (known && !taken.contains(known->name())) return *known;
    const int next = static_cast<int>(colours_.size());
    return style::signalTrace(colours_.try_emplace(reference.key(), next).first->second, palette());
}

void PlotArea::takeLayout() {
    const PlotLayout before =
        std::exchange(layout_, document_.isOpen() ? plotLayoutOf(document_.study().extraJson) : PlotLayout{});
    dropClosed(before);
    makeStrips();
    pages_->setCurrentWidget(strips_.empty() ? empty_ : page_);
    refresh();
}

int PlotArea::axisOf(const SignalStrip* strip) const {
    return static_cast<int>(std::find(strips_.begin(), strips_.end(), strip) - strips_.begin());
}

/// An axis that is closed takes its own strip with it: what is drawn in the others need not be drawn anew.
void PlotArea::dropClosed(const PlotLayout& before) {
    std::vector<SignalStrip*> kept, closed;
    for (std::size_t k = 0; k < strips_.size(); ++k) {
        const bool stays = k < before.axes.size() && kept.size() < layout_.axes.size() &&
                           before.axes[k].traces == layout_.axes[kept.size()].traces;
        (stays ? kept : closed).push_back(strips_[k]);
    }
    if (kept.size() != layout_.axes.size()) return;  // more has changed
    for (SignalStrip* strip : closed) {
        strip->hide();
        strip->deleteLater();  // it may be the one that asked for it
    }
    strips_ = std::move(kept);
}

void PlotArea::makeStrips() {
    while (strips_.size() > layout_.axes.size()) {
        strips_.back()->hide();
        strips_.back()->deleteLater();
        strips_.pop_back();
    }
    while (strips_.size() < layout_.axes.size()) {
        auto* strip = new SignalStrip;
        SignalChart* chart = strip->chart();
        connect(chart, &SignalChart::timeRangeWanted, this, [this](double from, double to) {
            isWhole_ = false;
            setTimeRange(from, to);
        });
        connect(chart, &SignalChart::allWanted, this, [this] {
            isWhole_ = true;
            setTimeRange(first_, last_);
        });
        connect(chart, &SignalChart::markWanted, this, &PlotArea::mark);
        connect(chart, &SignalChart::pointedAt, this, [this](double time) { pointAt(time); });
        connect(chart, &SignalChart::pointerLeft, this, [this] { pointAt(std::nullopt); });
        connect(strip, &SignalStrip::dropped, this,
                [this, strip](const std::vector<SignalRef>& references) { addTo(axisOf(strip), references); });
        connect(strip, &SignalStrip::removeWanted, this, [this, strip](int trace) { remove(axisOf(strip), trace); });
        connect(strip, &SignalStrip::moveWanted, this, [this, strip](int by) { move(axisOf(strip), by); });
        connect(strip, &SignalStrip::viewWanted, this, [this, strip](PlotView view) {
            PlotLayout layout = layout_;
            layout.axes[static_cast<std::size_t>(axisOf(strip))].view = view;
            change(std::move(layout), tr("Change the view of an axis"));
        });
        connect(strip, &SignalStrip::closeWanted, this, [this, strip] { closeAxis(axisOf(strip)); });
        column_->addWidget(strip, 1);
        strip->setMarks(marks_);
        strip->setTimeRange(from_, to_);
        strips_.push_back(strip);
    }
    for (std::size_t i = 0; i < strips_.size(); ++i) {
        strips_[i]->setTimeLabels(i == 0, i + 1 == strips_.size());
        strips_[i]->setView(layout_.axes[i].view);
    }
}

void PlotArea::refresh() {
    if (!document_.isOpen()) return;
    std::set<QString> recordings;
    for (const PlotAxis& axis : layout_.axes)
        for (const SignalRef& trace : axis.traces) recordings.insert(trace.recording);
    double first = 0, last = 0;
    bool isFirst = true;
    for (std::size_t i = 0; i < strips_.size(); ++i) {
        std::vector<ChartLine> lines;
        std::set<QString> taken;
        for (const SignalRef& trace : layout_.axes[i].traces) {
            auto& shown = shown_[trace.key()];
            if (auto fresh = values_.at(trace)) shown = std::move(fresh);
            const auto moved = shown && shown->time ? moving(trace, *shown) : nullptr;
            lines.push_back({trace, colourOf(trace, taken), moved ? moved : shown});
            taken.insert(lines.back().colour.name());
            if (!shown || !shown->time || shown->time->empty()) continue;
            first = isFirst ? shown->time->front() : std::min(first, shown->time->front());
            last = isFirst ? shown->time->back() : std::max(last, shown->time->back());
            isFirst = false;
        }
        strips_[i]->setLines(std::move(lines), recordings.size() > 1);
    }
    if (isFirst || !(last > first)) return;
    first_ = first;
    last_ = last;
    setTimeRange(isWhole_ ? first_ : from_, isWhole_ ? last_ : to_);
}

void PlotArea::setTimeRange(double from, double to) {
    const double whole = last_ - first_;
    const double span = std::clamp(to - from, whole * 1e-6, whole);
    from_ = std::clamp(from, first_, last_ - span);
    to_ = from_ + span;
    for (SignalStrip* strip : strips_) strip->setTimeRange(from_, to_);
}

void PlotArea::pointAt(std::optional<double> time) {
    for (SignalStrip* strip : strips_) strip->pointAt(time);
}

void PlotArea::mark(double time) {
    if (marks_.size() == 2) marks_.clear();
    marks_.push_back(time);
    for (SignalStrip* strip : strips_) strip->setMarks(marks_);
    difference_->setVisible(marks_.size() == 2);
    if (marks_.size() == 2)
        difference_->setText(tr("Between the cursors: %1 s to %2 s, %3 s")
                                 .arg(style::numberText(std::min(marks_[0], marks_[1])),
                                      style::numberText(std::max(marks_[0], marks_[1])),
                                      style::numberText(std::abs(marks_[1] - marks_[0]))));
}

void PlotArea::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasFormat(signalMime)) event->acceptProposedAction();
}

void PlotArea::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    show(signalsOf(event->mimeData()->data(signalMime)));
}

void PlotArea::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
}

void PlotArea::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) refresh();
}

}  // namespace analogon::ui
