#pragma once

#include <string>
#include <vector>

#include "core/effect/null_model.hpp"

namespace analogon {

/// A measured sample that stands alone, far from its neighbours and from what a model leaves beside it, while no input
/// jumps and no other output does the same: a fault of the measurement (a spark, a telegram that was lost), not of the
/// component.
struct Spike {
    int recording{};  // of the task
    std::string output;
    int sample{};
};

/// Those of the fitted recordings, in order. None of a channel that has more than a few: what comes often is no fault.
std::vector<Spike> spikes(const NullModel& model);

/// Takes them for not measured.
void leaveOut(EstimationTask& task, const std::vector<Spike>& spikes);

/// What people should know of them, a sentence for each channel.
std::vector<Text> spikeRemarks(const EstimationTask& task, const std::vector<Spike>& spikes);

}  // namespace analogon
