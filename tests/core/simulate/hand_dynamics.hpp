#pragma once

#include <array>
#include <cmath>

#include "core/simulate/dynamics.hpp"

namespace analogon::test {

/// A number with its partial derivatives (forward mode), as slow and plain as a test may be.
struct Dual {
    static constexpr int width = 16;
    double v{};
    std::array<double, width> d{};

    Dual() = default;
    Dual(double value) : v(value) {}
    template <class F>
    Dual map(double value, F partial) const {
        Dual r(value);
        for (std::size_t i = 0; i < width; ++i) r.d[i] = partial(d[i]);
        return r;
    }
};
inline Dual combine(double value, const Dual& a, double fa, const Dual& b, double fb) {
    Dual r(value);
    for (std::size_t i = 0; i < Dual::width; ++i) r.d[i] = fa * a.d[i] + fb * b.d[i];
    return r;
}
inline Dual operator+(const Dual& a, const Dual& b) { return combine(a.v + b.v, a, 1, b, 1); }
inline Dual operator-(const Dual& a, const Dual& b) { return combine(a.v - b.v, a, 1, b, -1); }
inline Dual operator-(const Dual& a) { return combine(-a.v, a, -1, a, 0); }
inline Dual operator*(const Dual& a, const Dual& b) { return combine(a.v * b.v, a, b.v, b, a.v); }
inline Dual operator/(const Dual& a, const Dual& b) { return combine(a.v / b.v, a, 1 / b.v, b, -a.v / (b.v * b.v)); }
inline Dual sin(const Dual& a) { return combine(std::sin(a.v), a, std::cos(a.v), a, 0); }
inline Dual cos(const Dual& a) { return combine(std::cos(a.v), a, -std::sin(a.v), a, 0); }
inline Dual exp(const Dual& a) { return combine(std::exp(a.v), a, std::exp(a.v), a, 0); }
inline Dual sqrt(const Dual& a) { return combine(std::sqrt(a.v), a, 0.5 / std::sqrt(a.v), a, 0); }
inline Dual tanh(const Dual& a) {
    const double value = std::tanh(a.v);
    return combine(value, a, 1 - value * value, a, 0);
}

/// A model written by hand:
///   struct Model {
///       static constexpr int states, inputs, outputNumber;
///       template <class T> void start(const T* p, T* x) const;
///       template <class T> void rates(double t, const T* x, const T* u, const T* p, T* xdot) const;
///       template <class T> void outputs(double t, const T* x, const T* u, const T* p, T* y) const;
///   };
/// Delays: `delayOf[i]` is the parameter that is the time of delay i. Delayed signals of the model (taps) follow
/// the outputs in what outputs() yields.
template <class Model>
class HandDynamics final : public Dynamics {
public:
    /// `directions`: parameters with respect to which tangents are carried.
    HandDynamics(Model model, std::vector<double> parameters, std::vector<int> directions = {},
                 std::vector<DelayInfo> delays = {}, std::vector<int> delayParameters = {}, int tapCount = 0)
        : model_(model),
          parameters_(std::move(parameters)),
          directions_(std::move(directions)),
          delayParameters_(std::move(delayParameters)) {
        shape_.states = Model::states;
        shape_.inputs = Model::inputs;
        shape_.delays = std::move(delays);
        shape_.slots = Model::inputs + static_cast<int>(shape_.delays.size());
        shape_.outputs = Model::outputNumber;
        shape_.taps = tapCount;
        shape_.directions = static_cast<int>(directions_.size());
        shape_.stateNominal.assign(Model::states, 1.0);
        shape_.outputNominal.assign(Model::outputNumber, 1.0);
        for (int i = 0; i < Model::states; ++i) shape_.stateNames.push_back("x" + std::to_string(i + 1));
        for (int k : directions_) {
            const double size = std::abs(parameters_[static_cast<std::size_t>(k)]);
            shape_.directionScale.push_back(size > 0 ? size : 1.0);
        }
    }

    bool initialise(double, const double*, const double*, double* x, double* dx) override {
        std::vector<Dual> start(Model::states);
        model_.start(seeded(0).data(), start.data());
        return scatter(start, 0, shape_.directions, x, dx);
    }
    bool derivatives(double t, const double* x, const double* u, double* xdot) override {
        ++evaluations;
        std::vector<double> slope(Model::states);
        model_.rates(t, x, u, parameters_.data(), slope.data());
        std::copy(slope.begin(), slope.end(), xdot);
        return finite(xdot, Model::states);
    }
    bool derivatives(double t, const double* x, const double* dx, const double* u, const double* du, double* xdot,
                     double* dxdot) override {
        std::vector<Dual> slope(Model::states);
        model_.rates(t, lifted(x, dx, Model::states).data(), lifted(u, du, shape_.slots).data(), seeded(0).data(),
                     slope.data());
        return scatter(slope, 0, shape_.directions, xdot, dxdot);
    }
    bool jacobian(double t, const double* x, const double* u, double* xdot, double* jacobian) override {
        std::vector<Dual> slope(Model::states), state = lifted(x, nullptr, Model::states);
        for (std::size_t i = 0; i < state.size(); ++i) state[i].d[i] = 1.0;
        std::vector<Dual> p(parameters_.begin(), parameters_.end());
        model_.rates(t, state.data(), lifted(u, nullptr, shape_.slots).data(), p.data(), slope.data());
        return scatter(slope, 0, Model::states, xdot, jacobian);
    }
    bool linearised(double t, const double* x, const double* u, const double* du, double* xdot,
                    double* partials) override {
        std::vector<Dual> slope(Model::states), state = lifted(x, nullptr, Model::states);
        for (std::size_t i = 0; i < state.size(); ++i) state[i].d[i] = 1.0;
        std::vector<Dual> slots = lifted(u, nullptr, shape_.slots);
        for (std::size_t i = 0; du && i < slots.size(); ++i) {
            for (std::size_t k = 0; k < directions_.size(); ++k) {
                slots[i].d[Model::states + k] = du[i * directions_.size() + k];
            }
        }
        model_.rates(t, state.data(), slots.data(), seeded(Model::states).data(), slope.data());
        return scatter(slope, 0, Model::states + shape_.directions, xdot, partials);
    }
    bool outputs(double t, const double* x, const double* u, double* y, double* taps) override {
        std::vector<double> out(static_cast<std::size_t>(shape_.outputs + shape_.taps));
        model_.outputs(t, x, u, parameters_.data(), out.data());
        std::copy_n(out.begin(), shape_.outputs, y);
        if (taps) std::copy_n(out.begin() + shape_.outputs, shape_.taps, taps);
        return finite(out.data(), static_cast<int>(out.size()));
    }
    bool outputs(double t, const double* x, const double* dx, const double* u, const double* du, double* y, double* dy,
                 double* taps, double* dtaps) override {
        std::vector<Dual> out(static_cast<std::size_t>(shape_.outputs + shape_.taps));
        model_.outputs(t, lifted(x, dx, Model::states).data(), lifted(u, du, shape_.slots).data(), seeded(0).data(),
                       out.data());
        const std::vector<Dual> own(out.begin(), out.begin() + shape_.outputs);
        const std::vector<Dual> tapped(out.begin() + shape_.outputs, out.end());
        return scatter(own, 0, shape_.directions, y, dy) &&
               (!taps || scatter(tapped, 0, shape_.directions, taps, dtaps));
    }
    void delayTimes(double* times, double* dtimes) override {
        for (std::size_t i = 0; i < delayParameters_.size(); ++i) {
            times[i] = parameters_[static_cast<std::size_t>(delayParameters_[i])];
            for (std::size_t k = 0; k < directions_.size(); ++k) {
                dtimes[i * directions_.size() + k] = directions_[k] == delayParameters_[i] ? 1.0 : 0.0;
            }
        }
    }
    bool roots(double, const double*, const double*, double*) override { return true; }
    std::string failure() const override { return failure_; }

    long evaluations{};

private:
    std::vector<Dual> lifted(const double* v, const double* dv, int count) const {
        std::vector<Dual> r(v, v + count);
        const std::size_t K = directions_.size();
        for (std::size_t i = 0; dv && i < r.size(); ++i) {
            for (std::size_t k = 0; k < K; ++k) r[i].d[k] = dv[i * K + k];
        }
        return r;
    }
    std::vector<Dual> seeded(int offset) const {
        std::vector<Dual> p(parameters_.begin(), parameters_.end());
        for (std::size_t k = 0; k < directions_.size(); ++k) {
            p[static_cast<std::size_t>(directions_[k])].d[static_cast<std::size_t>(offset) + k] = 1.0;
        }
        return p;
    }
    bool scatter(const std::vector<Dual>& from, int first, int count, double* values, double* tangents) {
        for (std::size_t i = 0; i < from.size(); ++i) {
            values[i] = from[i].v;
            for (int k = 0; tangents && k < count; ++k) {
                tangents[i * static_cast<std::size_t>(count) + static_cast<std::size_t>(k)] =
                    from[i].d[static_cast<std::size_t>(first + k)];
            }
        }
        return finite(values, static_cast<int>(from.size()));
    }
    bool finite(const double* v, int count) {
        for (int i = 0; i < count; ++i) {
            if (!std::isfinite(v[i])) {
                failure_ = "x" + std::to_string(i + 1);
                return false;
            }
        }
        return true;
    }

    Model model_;
    std::vector<double> parameters_;
    std::vector<int> directions_, delayParameters_;
    std::string failure_;
};

}  // namespace analogon::test
