#pragma once

#include <vector>

#include "core/study/trace_simulator.hpp"

namespace analogon {

/// What is seen of the simulations of a problem's experiments: one trajectory each, the outputs that were measured.
SimulatedTraces tracesOf(const FitProblem& problem, const std::vector<Trajectory>& trajectories);

}  // namespace analogon
