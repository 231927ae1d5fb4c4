#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace analogon {

/// One line of a plot. `kind` is its CSS class: "measured", "before" or "after".
struct PlotTrace {
    std::string kind;
    Eigen::VectorXd values;  // NaN: a gap
};

/// A shaded band between two traces. `kind` is its CSS class.
struct PlotBand {
    std::string kind;
    Eigen::VectorXd lower, upper;
};

/// Traces over time above, what is left of them (measured - simulated) below, as inline SVG. Each trace is thinned
/// to its lowest and highest value per pixel column, so that the size does not grow with the recording.
struct SignalPlot {
    std::string id;                  // unique in the page
    std::string title;               // for screen readers
    std::string label;               // "i [A]"
    std::vector<double> time;        // [s]
    std::vector<PlotTrace> signals;  // the first is the measured one: it sets the range
    std::vector<PlotTrace> residuals;
    std::vector<PlotBand> bands{};  // behind the signals, the widest first; they do not set the range
    int columns{640};               // pixel columns of the thinning
};

std::string svgPlot(const SignalPlot& plot);

/// A profile of the likelihood, small.
struct ProfilePlot {
    std::string title;  // for screen readers
    std::string label;  // of the parameter, with its unit
    std::vector<double> values, rises;
    double estimate{};
    double lower{}, upper{};  // the 95 % interval
    bool isOpenBelow{}, isOpenAbove{};
};

/// How far the likelihood falls over the value of a parameter, with the 95 % threshold, the interval it cuts out, and
/// what is said where a side is a valley without an end.
std::string svgProfile(const ProfilePlot& plot);

/// Indices of the samples to draw: first, lowest, highest and last of each of `columns` equal spans of time, in order.
/// Everything when there are few samples.
std::vector<std::size_t> thinned(const std::vector<double>& time, const Eigen::VectorXd& values, int columns);

/// Round values that divide [low, high] into about `count` parts.
std::vector<double> ticks(double low, double high, int count);

/// &, <, >, quotes escaped for HTML text and attributes.
std::string escapeHtml(std::string_view text);

}  // namespace analogon
