#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/effect/model/null_model.hpp"

namespace analogon {

/// An input whose column is stamped late, in every recording: a mean over the last sample (by half of one), a logger
/// or a bus that passes it on later than the outputs. A dead time of the component is the opposite and an effect.
struct InputClock {
    std::string input;
    double late{};  // [s], positive: what is stamped t was so at t - late
};

/// Draws the inputs as they were at the true times. `stamped`: the same recordings as they were recorded.
void setClocks(std::vector<Recording>& recordings, const std::vector<Recording>& stamped,
               const std::vector<InputClock>& clocks);

/// Inputs that may be late by as much: each that changes, and all of them together.
std::vector<std::vector<std::string>> clockGroups(const EstimationTask& task, const std::vector<Recording>& stamped);

/// How late a column may be at most: a part of the shortest recording that is fitted. [s]
double latestOf(const EstimationTask& task);

/// Offsets and what the model leaves with each, from none on.
struct OffsetsTried {
    std::vector<double> offsets, misfits;
    std::size_t least{};  // index
};
/// Tries ever larger offsets, by parts of the sampling interval and none of `latest` or more, until they have only done
/// worse for a while. `first`: what the model leaves without one.
OffsetsTried offsetsFrom(double first, double interval, double latest, const std::function<double(double)>& misfitAt);

/// How late the inputs of one of the groups are by what the outputs of a model say: of that which gains most, of
/// several at once where they gain clearly more. `now`: what the model reckons with already. Least squares beside the
/// parameters; empty where nothing is gained. `group` becomes the index of the one that was taken.
std::vector<InputClock> likeliestClocks(const NullModel& null, const std::vector<Recording>& stamped,
                                        const std::vector<InputClock>& now,
                                        const std::vector<std::vector<std::string>>& groups,
                                        const SimulationOptions& simulation, const Progress& progress,
                                        std::size_t& group);

/// Decrease of chi-square of what a model leaves when each output may pick up these inputs directly: that looks
/// much as if they were late, and is an effect.
double explainedByPickUp(const NullModel& null, const std::vector<InputClock>& clocks);

}  // namespace analogon
