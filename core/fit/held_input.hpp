#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/fit/estimation_task.hpp"

/// Inputs that are held between their samples, where other samples than theirs are wanted.
namespace analogon {

/// More samples of a recording, at which nothing is measured: at these moments, ascending, within it and on none of its
/// own.
void addMoments(Recording& recording, const std::vector<double>& moments);

/// A held input as it ran at the true times, its column stamped by a clock that is ahead by `offset`: where it then
/// jumps between the samples of the recording, that becomes one more of them.
void shiftHeld(Recording& recording, std::size_t input, double offset);

/// The mean of a held column from each of these times to the next, in ascending order, and its value at the last one:
/// the held column on another raster that moves a plant most nearly alike. Constant beyond its ends.
Eigen::RowVectorXd heldMeans(const std::vector<double>& time, const Eigen::RowVectorXd& column,
                             const std::vector<double>& at);

}  // namespace analogon
