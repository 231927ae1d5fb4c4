#pragma once

#include <cmath>
#include <random>
#include <string>

#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {

/// A body behind a sensor that lags, into which a heat flow goes that nobody recorded and that changes within 2 s.
/// `size`: root mean square [W].
inline EstimationTask laggingBodyBesideAFlow(double lag, double size, unsigned seed) {
    EstimationTask task = laggingBody(lag);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Recording& r = task.recordings.edit().front();
    const double step = r.time[1] - r.time[0], keeps = std::exp(-step / 2);
    double flow = 0, body = 0, sensor = 0;
    for (Eigen::Index k = 0; k < r.outputs.cols(); ++k) {
        r.outputs(0, k) += lag > 0 ? sensor : body;
        flow = keeps * flow + std::sqrt(1 - keeps * keeps) * size * normal(random);
        for (int i = 0; i < 100; ++i) {
            if (lag > 0) sensor += step / 100 * (body - sensor) / lag;
            body += step / 100 * (flow - 0.2 * body) / 4;
        }
    }
    return task;
}

inline std::string kindsOf(const Node& node) {
    std::string kinds;
    for (const PlacedEffect& e : node.null.variant.effects) kinds += e.effect.kind;
    return kinds;
}

}  // namespace analogon
