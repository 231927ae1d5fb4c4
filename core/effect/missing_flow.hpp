#pragma once

#include <optional>

#include "core/effect/screen.hpp"

namespace analogon {

/// A law for a flow that a node of the model lacks, written as a class with the annotation of an effect.
struct FlowLaw {
    Candidate candidate;
    std::string text;  // of the class
};

/// For each node the short law that explains most of the residual: sums of up to three terms, chosen one after the
/// other (orthogonal least squares, Chen, Billings and Luo 1989) from powers and products of the node's own quantities
/// and of the inputs, states and outputs of the model. The coefficients carry the unit that makes a term a flow. A
/// further term must be worth more than chance among all that were there to choose from. The best nodes first, each
/// with its law of one term, of two, of three. The classes are numbered on from `before`, the laws written already.
std::vector<FlowLaw> likelyFlowLaws(const NullModel& null, int before, const SimulationOptions& simulation,
                                    const Progress& progress);

/// The place where an unknown flow explains most of the residual, whatever its course in time (piecewise linear, as
/// many pieces everywhere): a connector, or "output y" where an error of that sensor alone explains as much. Empty:
/// none does.
std::string likeliestPlace(const NullModel& null, const SimulationOptions& simulation, const Progress& progress);

}  // namespace analogon
