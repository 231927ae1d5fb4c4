#pragma once

#include <cmath>
#include <random>

#include "tests/core/effect/warm_body.hpp"

namespace analogon {

/// What a body heated in two steps is read at, by a sensor that lags by so many seconds and reads so much too high, in
/// white noise. `conductance` to its surroundings of 300 K. [W/K]
struct HeatedInTwoSteps {
    double lag{}, offset{}, startsAt{300}, conductance{0.2};
    unsigned seed{5};
};

inline Recording recordingOf(const std::string& name, const HeatedInTwoSteps& what) {
    constexpr double step = 0.25;
    constexpr int samples = 400;
    Recording r = warmBodyRecording(name, samples);
    std::mt19937 random(what.seed);
    std::normal_distribution<double> noise(0, 0.05);
    double body = what.startsAt, sensor = what.startsAt;
    const auto powerAt = [](int k) { return k < samples / 2 ? 8.0 : 2.0; };
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(step * k);
        r.inputs(0, k) = powerAt(k);
        r.outputs(0, k) = (what.lag > 0 ? sensor : body) + what.offset + noise(random);
        for (int i = 0; i < 100; ++i) {
            const double part = (i + 0.5) / 100, power = (1 - part) * powerAt(k) + part * powerAt(k + 1);
            if (what.lag > 0) sensor += step / 100 * (body - sensor) / what.lag;
            body += step / 100 * (power - what.conductance * (body - 300)) / 4;
        }
    }
    return r;
}

/// The same as the one recording of a task in which the conductance is fitted.
inline EstimationTask laggingBody(double lag, double offset = 0, double startsAt = 300) {
    EstimationTask task = warmBody({{"joint.G", "W/K", 0.3, 0.01, 10}});
    task.recordings = {recordingOf("warm-up", {lag, offset, startsAt})};
    return task;
}

/// Adds to the output what a draught would that nobody recorded.
inline void addDraught(EstimationTask& task, double size, unsigned seed = 3) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Recording& r = task.recordings.edit().front();
    double course = 0;
    for (Eigen::Index k = 0; k < r.outputs.cols(); ++k) {
        course = 0.98 * course + size * normal(random);
        r.outputs(0, k) += course;
    }
}

}  // namespace analogon
