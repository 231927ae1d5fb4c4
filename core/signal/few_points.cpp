#include "core/signal/few_points.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <set>

namespace analogon {

namespace {

/// The samples between two that are kept, and the one of them that is farthest from the line between these.
struct Stretch {
    double distance{};
    std::size_t from{}, to{}, farthest{};
    bool operator<(const Stretch& other) const { return distance < other.distance; }
};

Stretch stretchOf(std::span<const double> time, std::span<const double> values, const std::vector<std::size_t>& known,
                  std::size_t from, std::size_t to) {
    Stretch stretch{0, from, to, from};
    const double t = time[known[from]], v = values[known[from]];
    const double slope = (values[known[to]] - v) / (time[known[to]] - t);
    for (std::size_t i = from + 1; i < to; ++i)
        if (const double off = std::abs(values[known[i]] - v - slope * (time[known[i]] - t)); off > stretch.distance) {
            stretch.distance = off;
            stretch.farthest = i;
        }
    return stretch;
}

}  // namespace

std::vector<std::size_t> fewPoints(std::span<const double> time, std::span<const double> values, std::size_t most,
                                   double share) {
    std::vector<std::size_t> known;
    double low = 0, high = 0;
    for (std::size_t i = 0; i < std::min(time.size(), values.size()); ++i) {
        if (!std::isfinite(values[i]) || (!known.empty() && !(time[i] > time[known.back()]))) continue;
        low = known.empty() ? values[i] : std::min(low, values[i]);
        high = known.empty() ? values[i] : std::max(high, values[i]);
        known.push_back(i);
    }
    if (known.size() < 3) return known;
    std::set<std::size_t> kept{0, known.size() - 1};
    std::priority_queue<Stretch> stretches;
    stretches.push(stretchOf(time, values, known, 0, known.size() - 1));
    while (kept.size() < most && stretches.top().distance > share * (high - low)) {
        const Stretch parted = stretches.top();
        stretches.pop();
        kept.insert(parted.farthest);
        stretches.push(stretchOf(time, values, known, parted.from, parted.farthest));
        stretches.push(stretchOf(time, values, known, parted.farthest, parted.to));
    }
    std::vector<std::size_t> points;
    for (const std::size_t i : kept) points.push_back(known[i]);
    return points;
}

}  // namespace analogon
