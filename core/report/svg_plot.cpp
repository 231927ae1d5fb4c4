#include "core/report/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/number_text.hpp"
#include "core/base/visible.hpp"
#include "core/fit/profile.hpp"

namespace analogon {

namespace {

constexpr double nothing = 1e-12;  // of the values: what rounding leaves between them

struct Range {
    double low{std::numeric_limits<double>::infinity()};
    double high{-std::numeric_limits<double>::infinity()};

    void include(double value) {
        if (!std::isfinite(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    void include(const Eigen::VectorXd& values) {
        for (const double value : values) include(value);
    }
    bool isEmpty() const { return !(low <= high); }
    double size() const { return high - low; }
    /// Never of size zero, and with a little air.
    Range padded() const {
        if (isEmpty()) return {0, 1};
        const bool moves = size() > nothing * std::max(std::abs(low), std::abs(high));
        const double air = moves ? 0.06 * size() : std::max(0.5, 0.1 * std::abs(high));
        return {low - air, high + air};
    }
};

/// A panel's place on the page and its data range.
struct Panel {
    double left{}, top{}, width{}, height{};
    Range x, y;

    double xAt(double value) const { return left + width * (value - x.low) / x.size(); }
    double yAt(double value) const { return top + height * (y.high - value) / y.size(); }
};

constexpr double pageWidth = 960;
constexpr double leftMargin = 78, rightMargin = 16;
constexpr double signalTop = 30, signalHeight = 210;
constexpr double gap = 30, residualHeight = 84;
constexpr double bottomMargin = 44;
constexpr double residualTop = signalTop + signalHeight + gap;
constexpr double pageHeight = residualTop + residualHeight + bottomMargin;

std::string tickText(double value, double step) {
    const double size = std::max(std::abs(value), step);
    if (std::abs(value) < 1e-9 * step) return "0";
    if (size >= 1e6 || size < 1e-3) {
        std::string text = fmt::format("{:.3g}", value);
        return text;
    }
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
    return fmt::format("{:.{}f}", value, decimals);
}

std::string minus(std::string text) {
    if (text.starts_with('-')) text.replace(0, 1, "−");
    return text;
}

std::string axes(const Panel& panel, int yTicks, bool withTimes) {
    std::string svg;
    const auto xs = ticks(panel.x.low, panel.x.high, 8);
    const auto ys = ticks(panel.y.low, panel.y.high, yTicks);
    const double right = panel.left + panel.width, bottom = panel.top + panel.height;
    for (const double tick : ys) {
        const double y = panel.yAt(tick);
        svg += fmt::format("<line class=\"grid\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>", panel.left,
                           y, right, y);
        svg += fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>",
                           panel.left - 8, y + 4, minus(tickText(tick, ys.size() > 1 ? ys[1] - ys[0] : 1)));
    }
    for (const double tick : xs) {
        const double x = panel.xAt(tick);
        svg += fmt::format("<line class=\"grid\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>", x,
                           panel.top, x, bottom);
        if (withTimes)
            svg += fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", x,
                               bottom + 17, minus(tickText(tick, xs.size() > 1 ? xs[1] - xs[0] : 1)));
    }
    svg += fmt::format("<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>",
                       panel.left, panel.top, panel.width, panel.height);
    return svg;
}

std::string line(const Panel& panel, const std::vector<double>& time, const PlotTrace& trace, int columns) {
    std::string svg = fmt::format("<path class=\"trace {}\" d=\"", trace.kind);
    bool isDown = false;  // the pen
    for (const std::size_t i : thinned(time, trace.values, columns)) {
        const double value = trace.values[static_cast<Eigen::Index>(i)];
        if (!std::isfinite(value)) {
            isDown = false;
            continue;
        }
        // Far outside the frame: keep the numbers small, the clip hides them.
        const double y = std::clamp(panel.yAt(value), panel.top - 1000, panel.top + panel.height + 1000);
        fmt::format_to(std::back_inserter(svg), "{}{:.1f} {:.1f}", isDown ? 'L' : 'M', panel.xAt(time[i]), y);
        isDown = true;
    }
    return svg + "\"/>";
}

/// Along the upper edge and back along the lower one.
std::string area(const Panel& panel, const std::vector<double>& time, const PlotBand& band, int columns) {
    std::string path;
    const auto add = [&](std::size_t i, const Eigen::VectorXd& values) {
        const double value = values[static_cast<Eigen::Index>(i)];
        if (!std::isfinite(value)) return;
        const double y = std::clamp(panel.yAt(value), panel.top - 1000, panel.top + panel.height + 1000);
        fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', panel.xAt(time[i]), y);
    };
    for (const std::size_t i : thinned(time, band.upper, columns)) add(i, band.upper);
    const std::vector<std::size_t> back = thinned(time, band.lower, columns);
    for (auto i = back.rbegin(); i != back.rend(); ++i) add(*i, band.lower);
    return path.empty() ? path : fmt::format("<path class=\"band {}\" d=\"{}Z\"/>", band.kind, path);
}

std::string clip(const std::string& id, const Panel& panel) {
    return fmt::format(
        "<clipPath id=\"{}\"><rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/></clipPath>", id,
        panel.left, panel.top, panel.width, panel.height);
}

}  // namespace

std::vector<double> ticks(double low, double high, int count) {
    std::vector<double> out;
    if (!(high - low > nothing * std::max(std::abs(low), std::abs(high))) || !std::isfinite(high - low)) return out;
    const double raw = (high - low) / std::max(1, count);
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    double step = 10 * power;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= raw) {
            step = factor * power;
            break;
        }
    for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) out.push_back(k * step);
    return out;
}

std::vector<std::size_t> thinned(const std::vector<double>& time, const Eigen::VectorXd& values, int columns) {
    const std::size_t count = std::min(time.size(), static_cast<std::size_t>(values.size()));
    std::vector<std::size_t> out;
    if (count == 0) return out;
    if (count <= 2 * static_cast<std::size_t>(columns)) {
        for (std::size_t i = 0; i < count; ++i) out.push_back(i);
        return out;
    }
    const double begin = time.front(), span = time[count - 1] - begin;
    const auto columnOf = [&](std::size_t i) {
        return span > 0 ? std::min(columns - 1, static_cast<int>((time[i] - begin) / span * columns)) : 0;
    };
    const auto value = [&](std::size_t i) { return values[static_cast<Eigen::Index>(i)]; };
    for (std::size_t first = 0; first < count;) {
        std::size_t next = first, lowest = first, highest = first;
        bool hasGap = false;
        for (; next < count && columnOf(next) == columnOf(first); ++next) {
            if (!std::isfinite(value(next))) {
                hasGap = true;
                continue;
            }
            if (!(value(lowest) <= value(next))) lowest = next;
            if (!(value(highest) >= value(next))) highest = next;
        }
        std::vector<std::size_t> kept{lowest, highest};
        // A gap must stay a gap: its first missing sample and the first one behind it are kept.
        for (std::size_t i = first; hasGap && i < next; ++i)
            if (i == first || std::isfinite(value(i)) != std::isfinite(value(i - 1))) kept.push_back(i);
        std::sort(kept.begin(), kept.end());
        kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
        out.insert(out.end(), kept.begin(), kept.end());
        first = next;
    }
    if (out.front() != 0) out.insert(out.begin(), 0);
    if (out.back() != count - 1) out.push_back(count - 1);
    return out;
}

std::string svgPlot(const SignalPlot& plot) {
    Range times, signal, residual;
    for (const double t : plot.time) times.include(t);
    if (times.isEmpty() || times.size() == 0) times = {0, 1};
    for (std::size_t i = 0; i < plot.signals.size(); ++i) {
        // A simulation that runs away must not flatten the measurement: it may at most triple the range.
        Range own;
        own.include(plot.signals[i].values);
        const Range measured = signal;
        if (i > 0 && !measured.isEmpty() && !own.isEmpty()) {
            own.low = std::max(own.low, measured.low - measured.size());
            own.high = std::min(own.high, measured.high + measured.size());
        }
        signal.include(own.low);
        signal.include(own.high);
    }
    for (const PlotTrace& trace : plot.residuals) residual.include(trace.values);
    residual.include(0);
    const double limit = signal.isEmpty() ? 1 : std::max(signal.size(), 1e-300);
    residual.low = std::max(residual.low, -limit);
    residual.high = std::min(residual.high, limit);

    const double width = pageWidth - leftMargin - rightMargin;
    const Panel upper{leftMargin, signalTop, width, signalHeight, times, signal.padded()};
    const Panel lower{leftMargin, residualTop, width, residualHeight, times, residual.padded()};

    std::string svg = fmt::format(
        "<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\"><defs>{}{}</defs>", pageWidth,
        pageHeight, escapeHtml(plot.title), clip(plot.id + "a", upper), clip(plot.id + "b", lower));
    svg += axes(upper, 6, false) + axes(lower, 4, true);
    svg += fmt::format("<text class=\"axis\" x=\"{}\" y=\"{}\">{}</text>", leftMargin, signalTop - 11,
                       escapeHtml(plot.label));
    svg +=
        fmt::format("<text class=\"axis\" x=\"{}\" y=\"{}\">measured − simulated</text>", leftMargin, residualTop - 9);
    svg += fmt::format("<text class=\"axis\" x=\"{}\" y=\"{}\" text-anchor=\"end\">time [s]</text>",
                       pageWidth - rightMargin, pageHeight - 8);
    svg += fmt::format("<g clip-path=\"url(#{}a)\">", plot.id);
    for (const PlotBand& band : plot.bands) svg += area(upper, plot.time, band, plot.columns);
    for (const PlotTrace& trace : plot.signals) svg += line(upper, plot.time, trace, plot.columns);
    svg += fmt::format("</g><g class=\"residual\" clip-path=\"url(#{}b)\">", plot.id);
    svg += fmt::format("<line class=\"zero\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>", lower.left,
                       lower.yAt(0), lower.left + lower.width, lower.yAt(0));
    for (const PlotTrace& trace : plot.residuals) svg += line(lower, plot.time, trace, plot.columns);
    return svg + "</g></svg>";
}

std::string svgProfile(const ProfilePlot& plot) {
    constexpr double width = 300, top = 16, base = 116, left = 8, height = 150, threshold = profileThreshold,
                     most = 1.3 * threshold;
    Range range;
    for (const double value : plot.values) range.include(value);
    if (range.isEmpty() || range.size() == 0) return {};
    const auto x = [&](double value) { return left + (value - range.low) / range.size() * (width - 2 * left); };
    const auto y = [&](double rise) { return base - std::clamp(rise, 0.0, most) / most * (base - top); };
    std::string svg = fmt::format("<svg class=\"plot profile\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">",
                                  width, height, escapeHtml(plot.title));
    const double from = plot.isOpenBelow ? range.low : plot.lower, to = plot.isOpenAbove ? range.high : plot.upper;
    svg += fmt::format("<rect class=\"band after\" x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\"/>", x(from),
                       top, std::max(0.0, x(to) - x(from)), base - top);
    const auto mark = [&](const char* kind, double value) {
        svg += fmt::format("<line class=\"{}\" x1=\"{:.1f}\" y1=\"{}\" x2=\"{:.1f}\" y2=\"{}\"/>", kind, x(value), top,
                           x(value), base);
    };
    if (!plot.isOpenBelow) mark("limit", plot.lower);
    if (!plot.isOpenAbove) mark("limit", plot.upper);
    svg += fmt::format(
        "<line class=\"zero\" x1=\"{}\" y1=\"{:.1f}\" x2=\"{}\" y2=\"{:.1f}\"/>"
        "<text class=\"tick\" x=\"{}\" y=\"{:.1f}\">95 %</text>",
        left, y(threshold), width - left, y(threshold), left, y(threshold) - 4);
    svg +=
        fmt::format("<line class=\"frame\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>", left, base, width - left, base);
    std::string points;
    for (std::size_t i = 0; i < plot.values.size() && i < plot.rises.size(); ++i)
        if (std::isfinite(plot.values[i]) && std::isfinite(plot.rises[i]))
            points += fmt::format("{:.1f},{:.1f} ", x(plot.values[i]), y(plot.rises[i]));
    svg += "<polyline class=\"trace after\" points=\"" + points + "\"/>";
    if (plot.estimate >= range.low && plot.estimate <= range.high)
        svg += fmt::format("<circle class=\"estimate\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"/>", x(plot.estimate), y(0));
    const auto text = [&](double at, double height_, const char* anchor, const std::string& words) {
        svg += fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{}\" text-anchor=\"{}\">{}</text>", at, height_,
                           anchor, escapeHtml(words));
    };
    if (plot.isOpenBelow) text(left, top - 5, "start", "← open");
    if (plot.isOpenAbove) text(width - left, top - 5, "end", "open →");
    text(left, base + 14, "start", minus(numberText(range.low)));
    text(width - left, base + 14, "end", minus(numberText(range.high)));
    text(width / 2, height - 4, "middle", plot.label);
    return svg + "</svg>";
}

std::string escapeHtml(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (const char c : visible(text)) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\'':
                out += "&#39;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

}  // namespace analogon
