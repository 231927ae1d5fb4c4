#include "core/simulate/input_slots.hpp"

#include <algorithm>

namespace analogon {

InputSlots::InputSlots(Dynamics& dynamics, const SampledInputs& inputs, const Gaps* known)
    : inputs_(inputs), known_(known) {
    const Dynamics::Shape& shape = dynamics.shape();
    delays_ = shape.delays;
    sampleCount_ = static_cast<int>(inputs.time.size());
    inputCount_ = shape.inputs;
    needsSlopes_ = shape.needsInputDerivative;
    firstDelay_ = inputCount_ * (needsSlopes_ ? 2 : 1);
    held_ = inputs.heldInputs();
    for (std::size_t d = 0; d < delays_.size(); ++d)
        if (delays_[d].input >= 0 && inputs.isHeld(delays_[d].input)) heldDelays_.push_back(static_cast<int>(d));
    directions_ = shape.directions;
    const std::size_t tangentCount = delays_.size() * static_cast<std::size_t>(directions_);
    times_.assign(delays_.size(), 0.0);
    timeTangents_.assign(tangentCount, 0.0);
    tapValues_.assign(delays_.size(), 0.0);
    tapTangents_.assign(tangentCount, 0.0);
    cursors_.assign(delays_.size(), 0);
    arrivals_.assign(delays_.size(), 0);
    if (!delays_.empty()) dynamics.delayTimes(times_.data(), timeTangents_.data());
    // The future is not known: a negative delay is none.
    for (double& time : times_) time = std::max(time, 0.0);
    const auto isTap = [](const DelayInfo& delay) { return delay.input < 0; };
    hasTangents_ = directions_ > 0 && (std::any_of(delays_.begin(), delays_.end(), isTap) ||
                                       std::any_of(timeTangents_.begin(), timeTangents_.end(),
                                                   [](double tangent) { return tangent != 0.0; }));
}

int InputSlots::intervalOf(double t, int hint) const {
    const std::vector<double>& time = inputs_.time;
    int k = std::clamp(hint, 0, std::max(0, sampleCount_ - 2));
    while (k > 0 && t < time[static_cast<std::size_t>(k)]) --k;
    while (k + 2 < sampleCount_ && t >= time[static_cast<std::size_t>(k) + 1]) ++k;
    return k;
}

const Gaps& InputSlots::gaps() {
    if (known_) return *known_;
    if (!gaps_) gaps_.emplace(inputs_);
    return *gaps_;
}

double InputSlots::slope(int input, int interval) const {
    if (sampleCount_ < 2 || inputs_.isHeld(input)) return 0.0;
    const auto k = static_cast<std::size_t>(interval);
    return (inputs_.values(input, interval + 1) - inputs_.values(input, interval)) /
           (inputs_.time[k + 1] - inputs_.time[k]);
}

void InputSlots::at(int interval, double t, double* u, double* du, const double* dt) {
    const double offset = t - inputs_.time[static_cast<std::size_t>(interval)];
    const double* left = inputCount_ ? inputs_.values.data() + static_cast<Eigen::Index>(interval) * inputCount_ : u;
    if (sampleCount_ < 2) {
        for (int i = 0; i < inputCount_; ++i) u[i] = left[i];
    } else {
        const double fraction = offset / (inputs_.time[static_cast<std::size_t>(interval) + 1] -
                                          inputs_.time[static_cast<std::size_t>(interval)]);
        const double* right = left + inputCount_;
        for (int i = 0; i < inputCount_; ++i) u[i] = left[i] + fraction * (right[i] - left[i]);
        for (const int i : held_) u[i] = left[i];
    }
    if (needsSlopes_) {
        for (int i = 0; i < inputCount_; ++i) u[inputCount_ + i] = slope(i, interval);
    }
    if (du) {
        std::fill(du, du + firstDelay_ * directions_, 0.0);
        for (int i = 0; dt && i < inputCount_; ++i) {
            const double rate = slope(i, interval);
            for (int k = 0; k < directions_; ++k) du[i * directions_ + k] = rate * dt[k];
        }
    }
    for (std::size_t d = 0; d < delays_.size(); ++d) {
        const auto slot = static_cast<std::size_t>(firstDelay_) + d;
        double* tangents = du ? du + slot * static_cast<std::size_t>(directions_) : nullptr;
        const double* stored = tapTangents_.data() + d * static_cast<std::size_t>(directions_);
        const int input = delays_[d].input;
        if (input < 0) {
            u[slot] = tapValues_[d];
            if (tangents) std::copy(stored, stored + directions_, tangents);
            continue;
        }
        const double past = t - times_[d];
        if (!holdsLines_) cursors_[d] = lineOf(past, cursors_[d]);
        if (cursors_[d] < 0) {
            u[slot] = inputs_.values(input, 0);
            if (tangents) std::fill(tangents, tangents + directions_, 0.0);
            continue;
        }
        const double rate = slope(input, cursors_[d]);
        u[slot] =
            inputs_.values(input, cursors_[d]) + rate * (past - inputs_.time[static_cast<std::size_t>(cursors_[d])]);
        const double* dT = timeTangents_.data() + d * static_cast<std::size_t>(directions_);
        for (int k = 0; tangents && k < directions_; ++k) tangents[k] = rate * ((dt ? dt[k] : 0.0) - dT[k]);
    }
}

void InputSlots::atSample(int sample, double* u, double* du, const double* dt) {
    const double t = inputs_.time[static_cast<std::size_t>(sample)];
    const int interval = std::min(sample, std::max(0, intervals() - 1));
    at(interval, t, u, du, dt);
    for (const int i : held_) u[i] = inputs_.values(i, sample);
    for (const int d : heldDelays_) {
        const auto at = static_cast<std::size_t>(d);
        u[firstDelay_ + d] = inputs_.values(delays_[at].input, heldSampleOf(t - times_[at], interval));
    }
}

int InputSlots::heldSampleOf(double past, int hint) const {
    if (sampleCount_ < 2) return 0;
    const double rounding = 1e-9 * (inputs_.time.back() - inputs_.time.front()) / intervals();
    if (past + rounding >= inputs_.time.back()) return sampleCount_ - 1;
    return intervalOf(past + rounding, hint);
}

double InputSlots::heldAt(int delay, double t) const {
    const auto d = static_cast<std::size_t>(delay);
    return inputs_.values(delays_[d].input, heldSampleOf(t - times_[d], cursors_[d]));
}

int InputSlots::lineOf(double past, int hint) const {
    return past <= inputs_.time.front() || sampleCount_ < 2 ? -1 : intervalOf(past, hint);
}

void InputSlots::holdLines(double t) {
    for (std::size_t d = 0; d < delays_.size(); ++d) {
        if (delays_[d].input >= 0) cursors_[d] = lineOf(t - times_[d], cursors_[d]);
    }
    holdsLines_ = true;
}

const std::vector<double>& InputSlots::piecesOf(int interval) {
    const auto k = static_cast<std::size_t>(interval);
    const double begin = inputs_.time[k], end = inputs_.time[k + 1];
    const double least = 1e-6 * (end - begin);
    pieces_.clear();
    for (std::size_t d = 0; d < delays_.size(); ++d) {
        if (delays_[d].input < 0 || times_[d] == 0.0) continue;
        for (; arrivals_[d] < sampleCount_; ++arrivals_[d]) {
            const double arrival = inputs_.time[static_cast<std::size_t>(arrivals_[d])] + times_[d];
            if (arrival >= end - least) break;
            if (arrival > begin + least) pieces_.push_back(arrival);
        }
    }
    std::sort(pieces_.begin(), pieces_.end());
    pieces_.erase(std::unique(pieces_.begin(), pieces_.end(), [&](double a, double b) { return b - a < least; }),
                  pieces_.end());
    pieces_.push_back(end);
    return pieces_;
}

void InputSlots::setTapSlot(int delay, double value, const double* tangents) {
    const auto d = static_cast<std::size_t>(delay);
    tapValues_[d] = value;
    if (tangents) {
        std::copy(tangents, tangents + directions_, tapTangents_.data() + d * static_cast<std::size_t>(directions_));
    }
}

std::vector<double> InputSlots::delayedTimes(const std::vector<int>& samples) const {
    std::vector<double> times;
    for (std::size_t d = 0; d < delays_.size(); ++d) {
        if (delays_[d].input < 0 || times_[d] == 0.0) continue;
        for (int sample : samples) {
            const double time = inputs_.time[static_cast<std::size_t>(sample)] + times_[d];
            if (time < inputs_.time.back()) times.push_back(time);
        }
    }
    std::sort(times.begin(), times.end());
    return times;
}

}  // namespace analogon
