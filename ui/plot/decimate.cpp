#include "ui/plot/decimate.hpp"

#include <algorithm>
#include <cmath>

namespace analogon::ui {

QVector<QPointF> decimate(std::span<const double> time, std::span<const double> values, double from, double to,
                          int pixels) {
    QVector<QPointF> result;
    const std::size_t size = std::min(time.size(), values.size());
    if (size == 0 || pixels < 1 || !(to > from)) return result;
    auto begin = static_cast<std::size_t>(std::lower_bound(time.begin(), time.begin() + size, from) - time.begin());
    auto end = static_cast<std::size_t>(std::upper_bound(time.begin(), time.begin() + size, to) - time.begin());
    if (begin > 0) --begin;
    if (end < size) ++end;

    if (end - begin <= 4 * static_cast<std::size_t>(pixels)) {
        result.reserve(static_cast<qsizetype>(end - begin));
        for (std::size_t i = begin; i < end; ++i)
            if (std::isfinite(values[i])) result.append({time[i], values[i]});
        return result;
    }
    result.reserve(4 * pixels + 8);
    const double perPixel = (to - from) / pixels;
    for (std::size_t i = begin; i < end;) {
        const double column = std::floor((time[i] - from) / perPixel);
        const double until = from + (column + 1) * perPixel;
        const auto behind = std::lower_bound(time.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                             time.begin() + static_cast<std::ptrdiff_t>(end), until);
        const auto stop = static_cast<std::size_t>(behind - time.begin());
        std::size_t low = size, high = size, first = size, last = size;
        for (; i < stop; ++i) {
            if (!std::isfinite(values[i])) continue;
            if (first == size) first = low = high = i;
            last = i;
            if (values[i] < values[low]) low = i;
            if (values[i] > values[high]) high = i;
        }
        if (first == size) continue;
        std::size_t picked[] = {first, std::min(low, high), std::max(low, high), last};
        std::size_t previous = size;
        for (const std::size_t p : picked) {
            if (p != previous) result.append({time[p], values[p]});
            previous = p;
        }
    }
    return result;
}

double niceStep(double range, int count) {
    if (!(range > 0) || !std::isfinite(range) || count < 1) return 1;
    const double rough = range / count;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough) return factor * power;
    return 10 * power;
}

}  // namespace analogon::ui
