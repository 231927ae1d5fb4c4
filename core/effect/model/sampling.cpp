#include "core/effect/model/sampling.hpp"

#include <utility>
#include <vector>

#include "core/base/median.hpp"

namespace analogon {

double samplingInterval(const EstimationTask& task) {
    std::vector<double> steps;
    for (const Recording& r : task.recordings)
        for (std::size_t k = 1; r.role == Role::Fit && k < r.time.size(); ++k)
            steps.push_back(r.time[k] - r.time[k - 1]);
    return steps.empty() ? 0 : median(std::move(steps));
}

std::size_t fittedSamples(const EstimationTask& task) {
    std::size_t samples = 0;
    for (const Recording& r : task.recordings)
        if (r.role == Role::Fit) samples += r.time.size();
    return samples;
}

}  // namespace analogon
