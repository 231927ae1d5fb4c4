#include "core/simulate/gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/median.hpp"

namespace analogon {

/// Step s of n begins where (g^(s/n) - 1)/(g - 1) of the time is over.
double Substeps::time(int step) const {
    if (step == count) return end;
    if (!(growth > 1)) return begin + step * ((end - begin) / count);
    return begin + (end - begin) * std::expm1(std::log(growth) * step / count) / (growth - 1);
}

Gaps::Gaps(const SampledInputs& inputs) : time_(inputs.time) {
    constexpr double farLonger = 50;
    constexpr std::size_t few = 100;  // of them at most one among so many
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for (std::size_t k = 1; k < time_.size(); ++k) {
        const double length = time_[k] - time_[k - 1];
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
    }
    if (!(longest > farLonger * shortest)) return;
    std::vector<double> lengths;
    for (std::size_t k = 1; k < time_.size(); ++k) lengths.push_back(time_[k] - time_[k - 1]);
    usual_ = median(lengths);
    for (std::size_t k = 0; k < lengths.size(); ++k)
        if (lengths[k] > farLonger * usual_) intervals_.push_back(static_cast<int>(k));
    if (intervals_.size() * few > lengths.size()) intervals_.clear();
}

bool Gaps::has(int interval) const { return std::binary_search(intervals_.begin(), intervals_.end(), interval); }

Substeps Gaps::implicitSteps(int interval, int count) const {
    const auto k = static_cast<std::size_t>(interval);
    const double length = time_[k + 1] - time_[k];
    return {time_[k], time_[k + 1], count, has(interval) ? length / usual_ : 1.0};
}

}  // namespace analogon
