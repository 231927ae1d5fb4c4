#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/effect/screen.hpp"

namespace analogon {

/// A law for a flow that a node of the model lacks, written as a class with the annotation of an effect.
struct FlowLaw {
    Candidate candidate;
    std::string text;  // of the class
};

/// Short laws that explain much of the residual to first order: single terms and the best pair of each node (orthogonal
/// least squares, Chen, Billings and Luo 1989) from powers, thresholds and products of the node's own quantities and of
/// the inputs, states and outputs of the model. The coefficients carry the unit that makes a term a flow. What they are
/// worth shows when they are fitted. Best first; the classes are numbered on from `before`, the laws written already.
std::vector<FlowLaw> likelyFlowLaws(const NullModel& null, int before, const SimulationOptions& simulation,
                                    const Progress& progress);

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
