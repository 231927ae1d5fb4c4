#include "core/simulate/recorded_signals.hpp"

#include <algorithm>
#include <limits>

namespace analogon {

RecordedSignals::RecordedSignals(const SampledInputs& inputs, std::vector<int> inputAt, std::vector<int> slopeAt)
    : inputs_(inputs), inputAt_(std::move(inputAt)), slopeAt_(std::move(slopeAt)), stops_(trueKinks(inputs)) {
    const std::vector<int> jumps = jumpsOf(inputs);
    for (const int stop : stops_) jumps_.push_back(std::binary_search(jumps.begin(), jumps.end(), stop) ? 1 : 0);
}

int RecordedSignals::intervalOf(double t) const {
    const int last = static_cast<int>(inputs_.time.size()) - 2;
    const int from = stop_ >= 1 && stop_ - 1 < stops_.size() ? stops_[stop_ - 1] : 0;
    const int to = stop_ < stops_.size() ? stops_[stop_] - 1 : last;
    interval_ = std::clamp(interval_, from, std::max(from, to));
    const auto begin = [&](int k) { return inputs_.time[static_cast<std::size_t>(k)]; };
    while (interval_ > from && t < begin(interval_)) --interval_;
    while (interval_ < to && t >= begin(interval_ + 1)) ++interval_;
    return std::min(interval_, std::max(0, last));
}

double RecordedSignals::slope(Eigen::Index row, int k) const {
    if (inputs_.time.size() < 2 || inputs_.isHeld(row)) return 0;
    const auto i = static_cast<std::size_t>(k);
    return (inputs_.values(row, k + 1) - inputs_.values(row, k)) / (inputs_.time[i + 1] - inputs_.time[i]);
}

void RecordedSignals::at(double t, double* u) const {
    const int k = intervalOf(t);
    const bool isPast = stop_ >= stops_.size() && t >= inputs_.time.back();  // a jump of the last sample is seen
    for (std::size_t i = 0; i < inputAt_.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double rate = slope(row, k);
        const double begin = inputs_.values(row, k), offset = t - inputs_.time[static_cast<std::size_t>(k)];
        if (inputAt_[i] >= 0)
            u[inputAt_[i]] =
                inputs_.isHeld(row) && isPast ? inputs_.values(row, inputs_.values.cols() - 1) : begin + rate * offset;
        if (slopeAt_[i] >= 0) u[slopeAt_[i]] = rate;
    }
}

void RecordedSignals::slopes(double t, double* du) const {
    const int k = intervalOf(t);
    for (std::size_t i = 0; i < inputAt_.size(); ++i)
        if (inputAt_[i] >= 0) du[inputAt_[i]] = slope(static_cast<Eigen::Index>(i), k);
}

double RecordedSignals::nextStop() const {
    return stop_ < stops_.size() ? inputs_.time[static_cast<std::size_t>(stops_[stop_])]
                                 : std::numeric_limits<double>::infinity();
}

bool RecordedSignals::isJumpNext() const { return stop_ < jumps_.size() && jumps_[stop_] != 0; }

}  // namespace analogon
