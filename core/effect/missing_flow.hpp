#pragma once

#include <optional>

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

/// The place where an unknown flow explains most of the residual, whatever its course in time (piecewise linear, as
/// many pieces everywhere): a connector, or "output y" where an error of that sensor alone explains as much. Empty:
/// none does.
std::string likeliestPlace(const NullModel& null, const SimulationOptions& simulation, const Progress& progress);

}  // namespace analogon
