#pragma once

#include <vector>

#include "core/effect/model/input_edge.hpp"
#include "core/effect/model/null_model.hpp"

namespace analogon {

/// How the inputs ran there by what the outputs of a model say, none of it placed yet: least squares beside the
/// parameters, each part equally likely beforehand. `told` becomes the number of those that the data tell. `areAlike`:
/// the jumps alone, all at the same part of their interval (a command that is held).
std::vector<InputEdge> likeliestEdges(const NullModel& null, std::vector<InputEdge> edges, bool areAlike,
                                      const SimulationOptions& simulation, int threads, const Progress& progress,
                                      int& told);

}  // namespace analogon
