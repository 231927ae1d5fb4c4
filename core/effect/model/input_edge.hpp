#pragma once

#include <string>
#include <vector>

#include "core/fit/estimation_task.hpp"

namespace analogon {

constexpr double nearestToSample = 1e-3;  // part of an interval between a jump and a sample

/// An interval in which an input changes faster than it is sampled. Where it is flat on both sides it jumps: the
/// recording tells the values before and after, not when in between, and the straight line that joins them stands for a
/// jump half way. Elsewhere it bends: its mean over the interval is not that of its ends.
struct InputEdge {
    int recording{};  // of the task
    std::string input;
    int sample{};      // at which the interval begins
    double part{0.5};  // a jump: of the interval, that has passed then; a bend: 0 to 1 from the lowest to the highest
    double bend{};     // [unit of the input] by which the middle may leave the straight line; 0: a jump
};

/// Whether all jump just before the next sample: a command that is held in between.
bool areHeld(const std::vector<InputEdge>& edges);

/// Those of the fitted recordings that are far more than the noise. No more than can be looked at one by one, the
/// largest first.
std::vector<InputEdge> inputEdges(const EstimationTask& task);

/// Draws the inputs as they run there, by more samples at which no output is measured.
void place(EstimationTask& task, const std::vector<InputEdge>& edges);
/// The same of one recording; `index`: that of the task.
void place(Recording& recording, int index, const std::vector<InputEdge>& edges);

}  // namespace analogon
