#pragma once

#include <string>
#include <vector>

#include "ui/signals/signal_list.hpp"

namespace analogon::ui {

/// What is drawn of the signals of an axis.
enum class PlotView { Time, Against, Spectrum, Coherence, Histogram };

struct PlotAxis {
    std::vector<SignalRef> traces;
    PlotView view{PlotView::Time};
    friend bool operator==(const PlotAxis&, const PlotAxis&) = default;
};

/// The plots of signals as the study keeps them: the member "plots" of study.json.
struct PlotLayout {
    std::vector<PlotAxis> axes;     // from above
    std::vector<QString> formulas;  // derived signals
    friend bool operator==(const PlotLayout&, const PlotLayout&) = default;
};

/// Of a study's further members (Study::extraJson); what makes no sense in it is left out.
PlotLayout plotLayoutOf(const std::string& extraJson);
/// The same members with another layout; without the member where there is nothing to keep.
std::string withPlotLayout(const std::string& extraJson, const PlotLayout& layout);

}  // namespace analogon::ui
