#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/effect/block/screen.hpp"

namespace analogon {

/// What an unknown flow at one node does to the residual, or an unknown error of one sensor.
struct FlowResponse {
    std::string place;  // a connector, or "output y"
    bool isFlow{};      // at a node
    Eigen::MatrixXd
        columns;  // rows of the residual x hats of the flow, evenly over the time; of each recording its own
};

/// The responses of the nodes and outputs that are `wanted` (empty: all), each flow piecewise linear with as many
/// `pieces` over a recording.
std::vector<FlowResponse> flowResponses(const NullModel& null, int pieces, const SimulationOptions& simulation,
                                        const Progress& progress, const std::set<std::string>& wanted = {});

}  // namespace analogon
