#include "core/signal/range_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace analogon {

RangeFigures figuresWithin(std::span<const double> time, std::span<const double> values, double from, double to) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    RangeFigures figures{none, none, none, none, 0};
    double area = 0, squares = 0;
    const std::size_t size = std::min(time.size(), values.size());
    const auto first = static_cast<std::size_t>(
        std::upper_bound(time.begin(), time.begin() + static_cast<std::ptrdiff_t>(size), from) - time.begin());
    for (std::size_t i = std::max<std::size_t>(first, 1); i < size && time[i - 1] < to; ++i) {
        const double begin = std::max(from, time[i - 1]), end = std::min(to, time[i]), step = time[i] - time[i - 1];
        const auto at = [&](double t) {
            return values[i - 1] + (t - time[i - 1]) / step * (values[i] - values[i - 1]);
        };
        const double a = at(begin), b = at(end);
        if (!(end > begin) || !std::isfinite(a) || !std::isfinite(b)) continue;
        area += (end - begin) * (a + b) / 2;
        squares += (end - begin) * (a * a + a * b + b * b) / 3;
        figures.low = std::fmin(figures.low, std::min(a, b));
        figures.high = std::fmax(figures.high, std::max(a, b));
        figures.length += end - begin;
    }
    if (figures.length > 0) {
        figures.mean = area / figures.length;
        figures.rms = std::sqrt(squares / figures.length);
    }
    return figures;
}

}  // namespace analogon
