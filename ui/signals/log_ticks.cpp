#include "ui/signals/log_ticks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/plot/decimate.hpp"

namespace analogon::ui {

namespace {

/// The range of an axis and its length.
struct LogSpan {
    double low, high, length;  // [px]

    double decades() const { return std::log10(high / low); }
    bool contains(double value) const { return value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9); }
    double smallestGap(const std::vector<double>& values) const {
        double gap = std::numeric_limits<double>::infinity();
        for (std::size_t i = 1; i < values.size(); ++i)
            gap = std::min(gap, std::log10(values[i] / values[i - 1]) / decades() * length);
        return gap;
    }
};

/// In every `each`-th decade these digits.
std::vector<double> digitsOf(const LogSpan& span, const std::vector<int>& digits, int each = 1) {
    std::vector<double> values;
    const int first = static_cast<int>(std::floor(std::log10(span.low))),
              last = static_cast<int>(std::ceil(std::log10(span.high)));
    for (int decade = first; decade <= last; ++decade)
        if (decade % each == 0)
            for (const int digit : digits)
                if (const double value = digit * std::pow(10.0, decade); span.contains(value)) values.push_back(value);
    return values;
}

std::vector<double> stepsOf(const LogSpan& span, double step) {
    constexpr std::size_t most = 1000;  // of a range that rounding hardly leaves
    std::vector<double> values;
    for (double k = std::ceil(span.low / step * (1 - 1e-9));
         span.contains(k * step) && k * step > 0 && values.size() < most; ++k)
        values.push_back(k * step);
    return values;
}

/// The digits of the decades, where those are few.
std::vector<double> minorOf(const LogSpan& span) {
    constexpr double mostWithDigits = 6;  // decades; beyond, digits run together
    return span.decades() > mostWithDigits ? digitsOf(span, {1}) : digitsOf(span, {1, 2, 3, 4, 5, 6, 7, 8, 9});
}

/// Minor marks where no label is.
LogTicks ticksOf(std::vector<double> labelled, std::vector<double> minor) {
    std::erase_if(minor, [&](double value) {
        return std::any_of(labelled.begin(), labelled.end(),
                           [value](double at) { return std::abs(value - at) < 1e-6 * at; });
    });
    return {std::move(labelled), std::move(minor)};
}

}  // namespace

LogTicks logTicks(double low, double high, double length, double gap) {
    const LogSpan span{low, high, length};
    if (!(low > 0) || !(high > low) || !std::isfinite(high) || !(length > 0)) return {};
    std::vector<double> labelled, minor = minorOf(span);
    for (int each = 1; labelled.empty() && each < 300; each *= 2)
        if (std::vector<double> values = digitsOf(span, {1}, each); span.smallestGap(values) >= gap)
            labelled = std::move(values);
    for (const std::vector<int>& digits : {std::vector{1, 3}, std::vector{1, 2, 5}, std::vector{1, 2, 3, 5, 7}})
        if (std::vector<double> values = digitsOf(span, digits); span.smallestGap(values) >= gap)
            labelled = std::move(values);
    constexpr std::size_t enough = 4;  // labels: they show that the scale is not even
    for (int count = 1; labelled.size() < enough && count <= 20; ++count) {
        const double step = niceStep(high - low, count);
        std::vector<double> values = stepsOf(span, step);
        if (values.size() <= labelled.size() || span.smallestGap(values) < gap) continue;
        labelled = std::move(values);
        minor = stepsOf(span, step / 5);
    }
    return ticksOf(std::move(labelled), std::move(minor));
}

}  // namespace analogon::ui
