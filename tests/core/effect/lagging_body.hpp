#pragma once

#include <cmath>
#include <random>

#include "tests/core/effect/warm_body.hpp"

namespace analogon {

/// A body heated in two steps, read by a sensor that lags by so many seconds and reads so much too high, in white
/// noise.
inline EstimationTask laggingBody(double lag, double offset = 0, double startsAt = 300) {
    constexpr double step = 0.25;
    constexpr int samples = 400;
    EstimationTask task = warmBody({{"joint.G", "W/K", 0.3, 0.01, 10}});
    Recording r = warmBodyRecording("warm-up", samples);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 0.05);
    double body = startsAt, sensor = startsAt;
    const auto powerAt = [](int k) { return k < samples / 2 ? 8.0 : 2.0; };
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(step * k);
        r.inputs(0, k) = powerAt(k);
        r.outputs(0, k) = (lag > 0 ? sensor : body) + offset + noise(random);
        for (int i = 0; i < 100; ++i) {
            const double part = (i + 0.5) / 100, power = (1 - part) * powerAt(k) + part * powerAt(k + 1);
            if (lag > 0) sensor += step / 100 * (body - sensor) / lag;
            body += step / 100 * (power - 0.2 * (body - 300)) / 4;
        }
    }
    task.recordings = {r};
    return task;
}

}  // namespace analogon
