#include "core/simulate/sample_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/memory.hpp"

namespace analogon {

void makeRoom(Trajectory& trajectory, const Dynamics& dynamics, int samples, bool keepStates, bool isPoured) {
    const Dynamics::Shape& shape = dynamics.shape();
    if (keepStates) resizeLarge(trajectory.states, shape.states, samples);
    if (dynamics.observedCount() > 0) resizeLarge(trajectory.observed, dynamics.observedCount(), samples);
    if (isPoured) return;
    resizeLarge(trajectory.outputs, shape.outputs, samples);
    trajectory.tangents.resize(shape.directions > 0 ? static_cast<std::size_t>(shape.outputs) : 0);
    for (Eigen::MatrixXd& tangents : trajectory.tangents) resizeLarge(tangents, samples, shape.directions);
}

SampleRecorder::SampleRecorder(Dynamics& dynamics, InputSlots& slots, const SampledInputs& inputs, int first, int last,
                               bool keepStates, Trajectory& trajectory)
    : dynamics_(dynamics),
      slots_(slots),
      inputs_(inputs),
      first_(first),
      last_(last),
      keepStates_(keepStates),
      trajectory_(trajectory) {
    const Dynamics::Shape& shape = dynamics.shape();
    n_ = shape.states;
    K_ = shape.directions;
    const auto K = static_cast<std::size_t>(K_);
    const int count = last - first + 1;
    makeRoom(trajectory, dynamics, count, keepStates, false);
    observed_.resize(static_cast<std::size_t>(dynamics.observedCount()));

    u_.resize(static_cast<std::size_t>(shape.slots));
    if (slots.hasTangents()) du_.resize(static_cast<std::size_t>(shape.slots) * K);
    y_.resize(static_cast<std::size_t>(shape.outputs));
    dy_.resize(y_.size() * K);
    taps_.resize(static_cast<std::size_t>(shape.taps));
    dtaps_.resize(taps_.size() * K);
    x_.resize(static_cast<std::size_t>(n_));
    xdot_.resize(x_.size());
    dx_.resize(x_.size() * K);
    dt_.resize(K);
    for (std::size_t d = 0; d < shape.delays.size(); ++d) {
        if (shape.delays[d].input >= 0) continue;
        DelayedTap delayed;
        delayed.delay = static_cast<int>(d);
        delayed.tap = shape.delays[d].tap;
        delayed.next = first;
        delayed.values.resize(static_cast<std::size_t>(count));
        delayed.tangents.resize(static_cast<std::size_t>(count) * K);
        delayed_.push_back(std::move(delayed));
    }
}

bool SampleRecorder::evaluateTaps(int interval, double t, const double* dt, const double* x, const double* dx) {
    double* const du = du_.empty() ? nullptr : du_.data();
    const int sample = slots_.hasHeld() ? sampleAt(interval, t) : -1;
    if (sample >= 0)
        slots_.atSample(sample, u_.data(), du, dt);
    else
        slots_.at(interval, t, u_.data(), du, dt);
    return K_ > 0 ? dynamics_.outputs(t, x, dx, u_.data(), du, y_.data(), dy_.data(), taps_.data(), dtaps_.data())
                  : dynamics_.outputs(t, x, u_.data(), y_.data(), taps_.data());
}

int SampleRecorder::sampleAt(int interval, double t) const {
    if (t == sampleTime(interval)) return interval;
    return interval < slots_.intervals() && t == sampleTime(interval + 1) ? interval + 1 : -1;
}

void SampleRecorder::keepTap(DelayedTap& delayed, int sample) {
    const auto column = static_cast<std::size_t>(sample - first_), K = static_cast<std::size_t>(K_);
    const auto tap = static_cast<std::size_t>(delayed.tap);
    delayed.values[column] = taps_[tap];
    std::copy_n(dtaps_.data() + tap * K, K, delayed.tangents.data() + column * K);
}

/// Values before the first sample, and proof that no delayed signal depends on a delayed signal.
bool SampleRecorder::startTaps(const double* x, const double* dx) {
    const int interval = std::min(first_, std::max(0, slots_.intervals() - 1));
    const double t0 = sampleTime(first_);
    if (!evaluateTaps(interval, t0, nullptr, x, dx)) return false;
    const std::vector<double> values = taps_;
    for (DelayedTap& delayed : delayed_) {
        const double time = slots_.delayTimes()[static_cast<std::size_t>(delayed.delay)];
        while (delayed.next <= last_ && sampleTime(delayed.next) - time <= t0) keepTap(delayed, delayed.next++);
    }
    for (const DelayedTap& delayed : delayed_) {
        const double value = values[static_cast<std::size_t>(delayed.tap)];
        slots_.setTapSlot(delayed.delay, value + 1.0 + std::abs(value), nullptr);
    }
    const bool isIndependent = !evaluateTaps(interval, t0, nullptr, x, dx) || taps_ == values;
    if (!isIndependent) reason_ = "a delay of a delayed signal cannot be simulated";
    for (const DelayedTap& delayed : delayed_) {
        slots_.setTapSlot(delayed.delay, values[static_cast<std::size_t>(delayed.tap)], nullptr);
    }
    return isIndependent;
}

bool SampleRecorder::start(const double* x, const double* dx) {
    if (!delayed_.empty() && !startTaps(x, dx)) return false;
    return record(first_, x, dx);
}

bool SampleRecorder::needsInterpolant(double until) const {
    return std::any_of(delayed_.begin(), delayed_.end(), [&](const DelayedTap& delayed) {
        return delayed.next <= last_ &&
               sampleTime(delayed.next) - slots_.delayTimes()[static_cast<std::size_t>(delayed.delay)] <= until;
    });
}

bool SampleRecorder::advance(StateInterpolant& interpolant, double until, int interval) {
    const auto K = static_cast<std::size_t>(K_);
    for (DelayedTap& delayed : delayed_) {
        const auto d = static_cast<std::size_t>(delayed.delay);
        for (; delayed.next <= last_; ++delayed.next) {
            const double past = sampleTime(delayed.next) - slots_.delayTimes()[d];
            if (past > until) break;
            if (!interpolant.at(past, x_.data(), K_ > 0 ? dx_.data() : nullptr, xdot_.data())) return false;
            for (std::size_t k = 0; k < K; ++k) dt_[k] = -slots_.delayTangents()[d * K + k];
            for (std::size_t i = 0; i < x_.size(); ++i) {
                for (std::size_t k = 0; k < K; ++k) dx_[i * K + k] += xdot_[i] * dt_[k];
            }
            // A time on a sample belongs to the piece that ends there, as the interpolant does.
            int within = slots_.intervalOf(past, interval);
            if (within > 0 && past == sampleTime(within)) --within;
            if (!evaluateTaps(within, past, dt_.data(), x_.data(), dx_.data())) return false;
            keepTap(delayed, delayed.next);
        }
    }
    return true;
}

bool SampleRecorder::record(int sample, const double* x, const double* dx) {
    const int column = sample - first_;
    const auto K = static_cast<std::size_t>(K_);
    for (const DelayedTap& delayed : delayed_) {
        slots_.setTapSlot(delayed.delay, delayed.values[static_cast<std::size_t>(column)],
                          K_ > 0 ? delayed.tangents.data() + static_cast<std::size_t>(column) * K : nullptr);
    }
    const double t = sampleTime(sample);
    double* const du = du_.empty() ? nullptr : du_.data();
    slots_.atSample(sample, u_.data(), du);
    reason_ = "not finite";
    double* const y = trajectory_.outputs.data() + static_cast<Eigen::Index>(column) * trajectory_.outputs.rows();
    if (K_ == 0) {
        if (!dynamics_.outputs(t, x, u_.data(), y, nullptr)) return false;
    } else {
        if (!dynamics_.outputs(t, x, dx, u_.data(), du, y, dy_.data(), nullptr, nullptr)) return false;
        const double* dy = dy_.data();
        for (Eigen::MatrixXd& tangents : trajectory_.tangents) {
            double* to = tangents.data() + column;
            for (std::size_t k = 0; k < K; ++k) to[static_cast<Eigen::Index>(k) * tangents.rows()] = dy[k];
            dy += K;
        }
    }
    if (keepStates_) std::copy_n(x, n_, trajectory_.states.data() + static_cast<Eigen::Index>(column) * n_);
    if (!observed_.empty()) {
        if (!dynamics_.observed(t, x, u_.data(), observed_.data())) {
            std::fill(observed_.begin(), observed_.end(), std::numeric_limits<double>::quiet_NaN());
        }
        std::copy(observed_.begin(), observed_.end(), trajectory_.observed.col(column).data());
    }
    return true;
}

void SampleRecorder::abandon(int sample) { trajectory_.leaveOpen(last_ - sample + 1); }

}  // namespace analogon
