#include "core/simulate/moving_jump.hpp"

#include <algorithm>

namespace analogon {

MovingJumps::MovingJumps(Dynamics& dynamics, InputSlots& slots) : dynamics_(dynamics), slots_(slots) {
    const auto K = static_cast<std::size_t>(dynamics.shape().directions);
    for (const int d : slots.heldDelays()) {
        const auto from = slots.delayTangents().begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(d) * K);
        if (std::any_of(from, from + static_cast<std::ptrdiff_t>(K), [](double tangent) { return tangent != 0.0; }))
            delays_.push_back(d);
    }
    if (delays_.empty()) return;
    values_.resize(delays_.size());
    before_.resize(static_cast<std::size_t>(dynamics.shape().states));
    after_.resize(before_.size());
}

void MovingJumps::begin(double within) {
    for (std::size_t i = 0; i < delays_.size(); ++i) values_[i] = slots_.heldAt(delays_[i], within);
}

bool MovingJumps::pass(double t, double within, const double* u, const double* x, double* dx) {
    const std::vector<double> old = values_;
    begin(within);
    if (old == values_) return true;
    const auto K = static_cast<std::size_t>(dynamics_.shape().directions);
    u_.assign(u, u + dynamics_.shape().slots);
    const auto slot = [&](std::size_t i) -> double& {
        return u_[static_cast<std::size_t>(slots_.firstDelaySlot() + delays_[i])];
    };
    for (std::size_t i = 0; i < delays_.size(); ++i) slot(i) = old[i];
    if (!dynamics_.derivatives(t, x, u_.data(), before_.data())) return false;
    // one after the other, where several arrive at a time
    for (std::size_t i = 0; i < delays_.size(); ++i) {
        if (old[i] == values_[i]) continue;
        slot(i) = values_[i];
        if (!dynamics_.derivatives(t, x, u_.data(), after_.data())) return false;
        const double* const dT = slots_.delayTangents().data() + static_cast<std::size_t>(delays_[i]) * K;
        for (std::size_t n = 0; n < before_.size(); ++n)
            for (std::size_t k = 0; k < K; ++k) dx[n * K + k] += (before_[n] - after_[n]) * dT[k];
        before_.swap(after_);
    }
    return true;
}

}  // namespace analogon
