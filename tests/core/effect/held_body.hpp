#pragma once

#include "tests/core/effect/lagging_body.hpp"

namespace analogon {

/// The recording of a body of 4 J/K beside a model that has so much for it.
inline EstimationTask bodyHeldAt(double capacity, const std::vector<FitParameter>& fitted) {
    const EstimationTask recorded = laggingBody(0);
    std::string text = recorded.model->text();
    const std::string right = "C=4";
    text.replace(text.find(right), right.size(), "C=" + std::to_string(capacity));
    EstimationTask task = taskOf(text, "Body");
    task.parameters = fitted;
    task.recordings = recorded.recordings;
    return task;
}

}  // namespace analogon
