#include <algorithm>

#include "core/simulate/step_method.hpp"

namespace analogon {

std::unique_ptr<StepMethod> makeStepMethod(GridMethod method, Dynamics& dynamics, InputSlots& slots,
                                           const SimulationOptions& options) {
    if (method == GridMethod::Esdirk) return std::make_unique<Esdirk>(dynamics, slots, options);
    return std::make_unique<RungeKutta4>(dynamics, slots);
}

RungeKutta4::RungeKutta4(Dynamics& dynamics, InputSlots& slots) : dynamics_(dynamics), slots_(slots) {
    const Dynamics::Shape& shape = dynamics.shape();
    n_ = shape.states;
    total_ = n_ * (1 + shape.directions);
    u_.resize(static_cast<std::size_t>(shape.slots));
    if (slots.hasTangents()) du_.resize(static_cast<std::size_t>(shape.slots * shape.directions));
    for (std::vector<double>* v : {&stage_, &slope_, &sum_}) v->resize(static_cast<std::size_t>(total_));
}

bool RungeKutta4::evaluate(double t, const double* x, const double* dx, double* slope) {
    if (total_ == n_) return dynamics_.derivatives(t, x, u_.data(), slope);
    return dynamics_.derivatives(t, x, dx, u_.data(), du_.empty() ? nullptr : du_.data(), slope, slope + n_);
}

bool RungeKutta4::step(int interval, double t, double h, double* x, double* dx) {
    double* const stage = stage_.data();
    double* const slope = slope_.data();
    double* const sum = sum_.data();
    double* const du = du_.empty() ? nullptr : du_.data();
    const int n = n_, rest = total_ - n_;
    // stage = state + factor * slope, for values and tangents alike
    const auto advance = [&](double factor, const double* slopes, double* toX, double* toDx) {
        for (int i = 0; i < n; ++i) toX[i] = x[i] + factor * slopes[i];
        for (int i = 0; i < rest; ++i) toDx[i] = dx[i] + factor * slopes[n + i];
    };
    const auto accumulate = [&](double weight) {
        for (int i = 0; i < total_; ++i) sum[i] += weight * slope[i];
    };

    slots_.at(interval, t, u_.data(), du);
    if (!evaluate(t, x, dx, slope)) return false;
    std::copy(slope, slope + total_, sum);
    advance(0.5 * h, slope, stage, stage + n);

    slots_.at(interval, t + 0.5 * h, u_.data(), du);
    if (!evaluate(t + 0.5 * h, stage, stage + n, slope)) return false;
    accumulate(2.0);
    advance(0.5 * h, slope, stage, stage + n);
    if (!evaluate(t + 0.5 * h, stage, stage + n, slope)) return false;
    accumulate(2.0);
    advance(h, slope, stage, stage + n);

    slots_.at(interval, t + h, u_.data(), du);
    if (!evaluate(t + h, stage, stage + n, slope)) return false;
    accumulate(1.0);
    advance(h / 6.0, sum, x, dx);
    return true;
}

}  // namespace analogon
