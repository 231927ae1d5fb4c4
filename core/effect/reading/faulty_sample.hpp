#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/effect/catalogue/finding.hpp"
#include "core/effect/model/null_model.hpp"

/// What a recording holds that is a fault of the measurement (a spark, a telegram that was lost, a reading that stuck)
/// and not what the component does.
namespace analogon {

/// Samples [begin, end) of an output.
struct FaultySamples {
    int recording{};  // of the task
    std::string output;
    int begin{}, end{};
    bool isStuck{};   // they read the same; else they stand alone
    bool isMoving{};  // the recording begins in motion, the model of this output at rest
};

/// Those of the fitted recordings, channel by channel. A sample stands alone that is far from its neighbours and from
/// what the model leaves beside it, while no input jumps and no other output does the same; none of a channel that has
/// many or whose noise has long tails. A reading stuck that stays exactly the same for long, other than 0, hardly ever
/// does so elsewhere, and jumps when it goes on. The first samples are left out where the model alone is far from them
/// and has soon caught up: a current, say, has no start value of its own.
std::vector<FaultySamples> faultySamples(const NullModel& model);

/// The same of the recordings that are not fitted, by what a model leaves of them: samples that stand alone, and
/// readings that stuck. `recordings`: those that the state was told of.
std::vector<FaultySamples> faultySamples(const std::vector<Recording>& recordings, const ModelState& state);

/// Runs of samples, [begin, end), that read exactly the same, where a channel hardly ever does so elsewhere.
std::vector<std::pair<int, int>> runsAlike(const Eigen::VectorXd& values);

/// Takes them for not measured.
void leaveOut(EstimationTask& task, const std::vector<FaultySamples>& faults);

/// A state whose errors are those without them.
ModelState withoutFaults(ModelState state, const std::vector<FaultySamples>& faults);

/// What people should know of them; `recordings`: with these samples as they were read, or without.
std::vector<Text> faultRemarks(const std::vector<Recording>& recordings, const std::vector<FaultySamples>& faults);

/// The same of those of recordings that are not fitted, which the errors that are reported are with: `sound` is the
/// state without them.
std::vector<Text> faultRemarks(const std::vector<Recording>& recordings, const std::vector<FaultySamples>& faults,
                               const ModelState& state, const ModelState& sound);

}  // namespace analogon
