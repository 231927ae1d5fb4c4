#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/effect/block/screen.hpp"

namespace analogon {

/// What the hats of an unknown course over one recording do there; outside of these rows of the residual they do
/// nothing.
struct ResponseBlock {
    int recording{};          // among those that are fitted
    Eigen::Index begin{};     // its first row of the residual
    Eigen::MatrixXd columns;  // rows from there on x hats, evenly over the time
};

/// What an unknown flow at one node does to the residual, or an unknown error of one sensor.
struct FlowResponse {
    std::string place;                  // a connector, or "output y"
    bool isFlow{};                      // at a node
    std::vector<ResponseBlock> blocks;  // of each recording that it is felt in, in their order
    double spacing{};                   // of its hats [s]; of an error of a sensor 0
    std::string unit{};                 // of the flow

    const ResponseBlock* of(int recording) const;  // nullptr: none
};

/// The responses of the nodes and outputs that are `wanted` (empty: all), each flow piecewise linear with as many
/// `pieces` over a recording.
std::vector<FlowResponse> flowResponses(const NullModel& null, int pieces, const SimulationOptions& simulation,
                                        const Progress& progress, const std::set<std::string>& wanted = {});

}  // namespace analogon
