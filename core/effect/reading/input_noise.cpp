#include "core/effect/reading/input_noise.hpp"

#include <algorithm>
#include <cmath>

#include "core/effect/model/white_noise.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::inputNoise;

namespace {

constexpr Eigen::Index reach = 12;  // of the filter, in samples to either side

Eigen::RowVectorXd filtered(const Eigen::RowVectorXd& signal, double noise) {
    Eigen::RowVectorXd result = signal;
    for (Eigen::Index k = 0; k < signal.size(); ++k) {
        double sum = signal[k], count = 1;
        // as many on either side, so that a ramp stays where it is
        for (Eigen::Index d = 1; d <= std::min({reach, k, signal.size() - 1 - k}); ++d) {
            const double before = signal[k - d], after = signal[k + d];
            if (std::abs(0.5 * (before + after) - signal[k]) > within * noise ||
                std::abs(before - after) > 2 * within * noise)
                break;
            sum += before + after;
            count += 2;
        }
        result[k] = sum / count;
    }
    return result;
}

}  // namespace

std::vector<NoisyInput> quieten(EstimationTask& task) {
    std::vector<NoisyInput> found;
    for (std::size_t r = 0; r < task.recordings.size(); ++r) {
        Recording& recording = task.recordings.edit()[r];
        if (recording.role != Role::Fit) continue;
        for (Eigen::Index i = 0; i < recording.inputs.rows(); ++i) {
            // what is held is what was commanded, not what was measured of it
            if (recording.isHeld(recording.inputNames[static_cast<std::size_t>(i)])) continue;
            const double noise = whiteNoise(recording.inputs.row(i).transpose());
            if (!(noise > 0)) continue;
            recording.inputs.row(i) = filtered(recording.inputs.row(i), noise);
            found.push_back({static_cast<int>(r), recording.inputNames[static_cast<std::size_t>(i)], noise});
        }
    }
    return found;
}

}  // namespace analogon
