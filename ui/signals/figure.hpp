#pragma once

#include <QPolygonF>
#include <vector>

#include "ui/signals/signal_chart.hpp"

namespace analogon::ui {

/// What is made of the traces of an axis but their course over time.
struct Figure {
    struct Curve {
        QString name;
        QColor colour;
        QPolygonF points;
    };
    std::vector<Curve> curves;
    QString xLabel, yLabel;  // with the unit
    bool isLogarithmic{};    // both axes
    QString fault;           // why there is none; empty: there is one

    static Figure failed(const Diagnostic& fault);
};

/// Of the part of the traces between two times: the others against the first one, power spectral densities (Welch),
/// the coherence of the others with the first one, or histograms.
Figure figureOf(PlotView view, const std::vector<ChartLine>& lines, double from, double to);

}  // namespace analogon::ui
