#pragma once

#include <cmath>
#include <string>

#include "tests/core/effect/block/candidates_of.hpp"
#include "tests/core/effect/warm_body.hpp"

namespace analogon {

/// A body that warms up at 8 W, sampled at an interval [s], with a little that repeats like noise.
struct HeatedRuns {
    static constexpr int samples = 400;
    static constexpr double interval = 0.25, capacity = 4;  // [s], [J/K]

    static Recording recorded(const std::string& name) {
        Recording r = warmBodyRecording(name, samples);
        r.inputs.setConstant(8);
        for (int k = 0; k < samples; ++k) {
            const double t = interval * k, noise = 0.02 * std::sin(12.9898 * k) * std::cos(78.233 * k);
            r.time.push_back(t);
            r.outputs(0, k) = 300 + 40 * (1 - std::exp(-t * 0.2 / capacity)) + noise;
        }
        return r;
    }

    /// The body fitted to so many of them.
    static NullModel fitted(int recordings) {
        EstimationTask task = warmBody({{"joint.G", "", 0.3, 0.01, 10}});
        for (int i = 0; i < recordings; ++i) task.recordings.push_back(recorded("run " + std::to_string(i + 1)));
        return fittedModel(task);
    }
};

}  // namespace analogon
