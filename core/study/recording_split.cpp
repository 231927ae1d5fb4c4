#include "core/study/recording_split.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace analogon {

namespace {

/// Mean of the `window` values before `end`.
double meanBefore(const std::vector<double>& values, std::size_t end, std::size_t window) {
    const auto last = values.begin() + static_cast<std::ptrdiff_t>(end);
    return std::accumulate(last - static_cast<std::ptrdiff_t>(window), last, 0.0) / static_cast<double>(window);
}

}  // namespace

std::size_t restingSample(const std::vector<std::vector<double>>& channels) {
    constexpr double from = 0.6, to = 0.85, near = 0.05;
    if (channels.empty()) return 0;
    const auto count = static_cast<double>(channels.front().size());
    const auto window = static_cast<std::size_t>(std::max(1.0, count / 200));
    std::vector<double> ranges, starts;
    for (const std::vector<double>& values : channels) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        ranges.push_back(std::max(*high - *low, 1e-300));
        starts.push_back(meanBefore(values, std::min(window, values.size()), std::min(window, values.size())));
    }
    std::size_t best = 0;
    double nearest = near;
    for (auto k = static_cast<std::size_t>(from * count); k < static_cast<std::size_t>(to * count); ++k) {
        if (k < 2 * window) continue;
        double distance = 0;
        for (std::size_t i = 0; i < channels.size() && distance < nearest; ++i)
            distance = std::max(distance, std::abs(meanBefore(channels[i], k, window) - starts[i]) / ranges[i]);
        if (distance >= nearest) continue;
        best = k;
        nearest = distance;
    }
    return best;
}

}  // namespace analogon
