#include "ui/signals/figure.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "core/signal/formula.hpp"
#include "core/signal/spectrum.hpp"
#include "ui/style/number.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

constexpr int longestSegment = 8192;  // finer frequencies than a screen has columns say nothing

QString tr(const char* text) { return QCoreApplication::translate("Figure", text); }

/// The samples of a trace within the part.
struct Part {
    const ChartLine* line{};
    std::span<const double> time, values;
};

std::vector<Part> partsOf(const std::vector<ChartLine>& lines, double from, double to) {
    std::vector<Part> parts;
    for (const ChartLine& line : lines) {
        if (!line.data || !line.data->time || line.data->time->empty()) continue;
        const std::vector<double>& time = *line.data->time;
        const auto begin = std::lower_bound(time.begin(), time.end(), from) - time.begin();
        const auto end = std::upper_bound(time.begin(), time.end(), to) - time.begin();
        if (end <= begin) continue;
        const auto first = static_cast<std::size_t>(begin), count = static_cast<std::size_t>(end - begin);
        parts.push_back(
            {&line, std::span(time).subspan(first, count), line.data->values.values().subspan(first, count)});
    }
    return parts;
}

int segmentOf(const Part& part) { return part.time.size() / 8 > longestSegment ? longestSegment : 0; }

Figure failedFigure(const Diagnostics& faults) { return Figure::failed(faults.front()); }

/// A point that falls onto the one before it is not drawn again.
QPolygonF thinned(std::span<const double> x, std::span<const double> y) {
    constexpr double columns = 1500, rows = 600;
    ValueRange across, along;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (std::isfinite(x[i]) && std::isfinite(y[i])) {
            across.add(x[i]);
            along.add(y[i]);
        }
    QPolygonF points;
    if (across.isEmpty()) return points;
    const double wide = std::max(across.high - across.low, 1e-300), high = std::max(along.high - along.low, 1e-300);
    std::pair<int, int> before{-1, -1};
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
        const std::pair cell{static_cast<int>((x[i] - across.low) / wide * columns),
                             static_cast<int>((y[i] - along.low) / high * rows)};
        if (cell != before) points << QPointF(x[i], y[i]);
        before = cell;
    }
    return points;
}

Figure against(const std::vector<Part>& parts) {
    const Part& x = parts.front();
    Figure figure;
    figure.xLabel = style::nameWithUnit(x.line->reference.name, x.line->data->unit);
    if (parts.size() == 2)
        figure.yLabel = style::nameWithUnit(parts[1].line->reference.name, parts[1].line->data->unit);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const std::vector<double> y = valuesAt(parts[i].time, parts[i].values, x.time);
        figure.curves.push_back({parts[i].line->reference.name, parts[i].line->colour, thinned(x.values, y)});
    }
    return figure;
}

Figure spectra(const std::vector<Part>& parts) {
    Figure figure;
    figure.isLogarithmic = true;
    figure.xLabel = tr("Frequency [Hz]");
    figure.yLabel = tr("Power spectral density [unit²/Hz]");
    for (const Part& part : parts) {
        const Outcome<Spectrum> spectrum = welchSpectrum(part.time, part.values, segmentOf(part));
        if (!spectrum) return failedFigure(spectrum.diagnostics());
        QPolygonF points;
        for (std::size_t k = 1; k < spectrum->frequency.size(); ++k)
            if (spectrum->density[k] > 0) points << QPointF(spectrum->frequency[k], spectrum->density[k]);
        figure.curves.push_back({part.line->reference.name, part.line->colour, points});
    }
    return figure;
}

Figure coherences(const std::vector<Part>& parts) {
    Figure figure;
    figure.xLabel = tr("Frequency [Hz]");
    figure.yLabel = tr("Coherence with %1").arg(parts.front().line->reference.name);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const std::vector<double> y = valuesAt(parts[i].time, parts[i].values, parts.front().time);
        const Outcome<Coherence> found =
            coherence(parts.front().time, parts.front().values, y, segmentOf(parts.front()));
        if (!found) return failedFigure(found.diagnostics());
        QPolygonF points;
        for (std::size_t k = 1; k < found->frequency.size(); ++k)
            points << QPointF(found->frequency[k], found->value[k]);
        figure.curves.push_back({parts[i].line->reference.name, parts[i].line->colour, points});
    }
    return figure;
}

Figure histograms(const std::vector<Part>& parts) {
    Figure figure;
    figure.xLabel = parts.size() == 1 ? style::nameWithUnit(parts[0].line->reference.name, parts[0].line->data->unit)
                                      : tr("Value, each in its own unit");
    figure.yLabel = tr("Share of the samples");
    for (const Part& part : parts) {
        const Outcome<Histogram> counted = histogram(part.values);
        if (!counted) return failedFigure(counted.diagnostics());
        QPolygonF points;
        points << QPointF(counted->edges.front(), 0);
        for (std::size_t k = 0; k < counted->counts.size(); ++k)
            points << QPointF(counted->edges[k], counted->counts[k])
                   << QPointF(counted->edges[k + 1], counted->counts[k]);
        points << QPointF(counted->edges.back(), 0);
        figure.curves.push_back({part.line->reference.name, part.line->colour, points});
    }
    return figure;
}

}  // namespace

Figure Figure::failed(const Diagnostic& fault) {
    Figure figure;
    figure.fault = inWords(fault.message);
    return figure;
}

Figure figureOf(PlotView view, const std::vector<ChartLine>& lines, double from, double to) {
    const std::vector<Part> parts = partsOf(lines, from, to);
    const bool needsTwo = view == PlotView::Against || view == PlotView::Coherence;
    if (parts.size() < (needsTwo ? 2u : 1u)) {
        Figure none;
        none.fault = needsTwo ? tr("This view needs two signals on the axis.") : tr("Nothing to show yet.");
        return none;
    }
    switch (view) {
        case PlotView::Against:
            return against(parts);
        case PlotView::Coherence:
            return coherences(parts);
        case PlotView::Histogram:
            return histograms(parts);
        default:
            return spectra(parts);
    }
}

}  // namespace analogon::ui
