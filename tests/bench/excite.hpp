#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulate.hpp"
#include "systems.hpp"

/// Test-bench manoeuvres: steps, ramps, holds, bursts, pauses, chirps; slowly wandering temperatures and flows.
namespace bench {

class Manoeuvre {
public:
    Manoeuvre(const Design& d, int samples, Random& random)
        : design_(d), random_(random), size_(static_cast<std::size_t>(samples)) {}

    Series drive() {
        hold(std::max(2, count(random_.uniform(0.25, 0.6) * std::min(design_.pace, 4.0))));
        if (design_.bipolar)
            reversing();
        else
            oneWay();
        values_.resize(size_);
        return values_;
    }

private:
    int count(double seconds) const { return std::max(1, static_cast<int>(std::lround(seconds / design_.dt))); }
    void hold(int n) { values_.insert(values_.end(), static_cast<std::size_t>(n), now_); }
    void go(double to, int n) {
        const double from = now_;
        for (int k = 1; k <= n; ++k) values_.push_back(from + (to - from) * k / n);
        now_ = to;
    }
    double stretch() { return design_.pace * random_.uniform(0.5, 1.6); }
    double level() { return design_.top * random_.uniform(0.18, 1.0); }
    bool full() const { return values_.size() >= size_; }

    /// Every kind of stretch appears before any appears again.
    void oneWay() {
        std::vector<int> order;
        while (!full()) {
            if (order.empty()) {
                order = {0, 0, 0, 1, 2, 3, 4};
                if (!design_.chirps) order.back() = 0;
                random_.shuffle(order);
            }
            const int what = order.back();
            order.pop_back();
            if (what == 0) {
                go(level(), design_.edge);
                hold(count(stretch()));
            } else if (what == 1) {
                go(level(), count(stretch() * random_.uniform(1.0, 2.5)));
                hold(count(0.3 * design_.pace));
            } else if (what == 2) {
                burst();
            } else if (what == 3) {
                go(design_.chirps ? 0.08 * design_.top : 0.0, random_.chance(0.7) ? design_.edge : count(stretch()));
                hold(count(0.5 * stretch()));
            } else {
                chirp();
            }
        }
    }
    void burst() {
        const double high = design_.top * random_.uniform(0.6, 1.0), low = high * random_.uniform(0.3, 0.65);
        const bool jitter = random_.chance(0.4);
        const double half = design_.pace * random_.uniform(0.1, 0.35);
        for (int k = random_.integer(4, 8); k > 0; --k) {
            go(k % 2 ? low : high, design_.edge);
            hold(count(half * (jitter ? random_.uniform(0.4, 1.6) : 1.0)));
        }
    }
    void chirp() {
        const double middle = design_.top * random_.uniform(0.4, 0.65),
                     swing = design_.top * random_.uniform(0.15, 0.3);
        go(middle, std::max(design_.edge, count(0.15)));
        const double f0 = random_.uniform(0.8, 1.5) / design_.pace, f1 = f0 * random_.uniform(4.0, 10.0),
                     T = design_.pace * random_.uniform(3.0, 5.0);
        for (int k = 1, n = count(T); k <= n; ++k) {
            const double t = k * design_.dt;
            now_ = middle + swing * std::sin(2.0 * std::numbers::pi * (f0 * t + 0.5 * (f1 - f0) * t * t / T));
            values_.push_back(now_);
        }
    }
    /// Both ways, with pauses.
    void reversing() {
        double side = random_.sign();
        while (!full()) {
            go(side * design_.top * random_.uniform(0.4, 1.0), design_.edge);
            hold(count(stretch()));
            if (random_.chance(0.5)) {
                go(side * design_.top * random_.uniform(0.2, 0.5), design_.edge);
                hold(count(0.7 * stretch()));
            }
            if (random_.chance(0.65)) {
                go(0.0, design_.edge);
                hold(count(0.35 * stretch()));
            }
            if (random_.chance(0.75)) side = -side;
        }
    }

    const Design& design_;
    Random& random_;
    std::size_t size_;
    Series values_;
    double now_{};
};

/// Smooth (cubic between knots with level tangents at turning points, as by Fritsch and Carlson) or broken-line course.
inline Series wander(Random& random, int samples, double dt, double first, double low, double high, double pace) {
    const double T = dt * samples;
    std::vector<double> t{0.0}, y{first};
    while (t.back() < T) {
        t.push_back(t.back() + pace * random.uniform(0.5, 1.5));
        y.push_back(random.uniform(low, high));
    }
    const std::size_t n = t.size();
    const bool smooth = random.chance(0.75);
    std::vector<double> slope(n, 0.0);
    for (std::size_t k = 1; k + 1 < n; ++k) {
        const double a = (y[k] - y[k - 1]) / (t[k] - t[k - 1]), b = (y[k + 1] - y[k]) / (t[k + 1] - t[k]);
        if (a * b > 0.0) slope[k] = 2.0 * a * b / (a + b);
    }
    Series out;
    std::size_t k = 0;
    for (int j = 0; j < samples; ++j) {
        const double now = j * dt;
        while (k + 2 < n && t[k + 1] <= now) ++k;
        const double h = t[k + 1] - t[k], s = (now - t[k]) / h;
        const double line = y[k] + (y[k + 1] - y[k]) * s;
        const double cubic = y[k] * (1 + 2 * s) * (1 - s) * (1 - s) + slope[k] * h * s * (1 - s) * (1 - s) +
                             y[k + 1] * s * s * (3 - 2 * s) + slope[k + 1] * h * s * s * (s - 1);
        out.push_back(smooth ? cubic : line);
    }
    return out;
}

/// First-order coloured noise of unit variance.
inline Series coloured(Random& random, int samples, double correlationSamples) {
    const double a = std::exp(-1.0 / correlationSamples);
    Series out;
    double x = random.normal();
    for (int k = 0; k < samples; ++k) {
        out.push_back(x);
        x = a * x + std::sqrt(1.0 - a * a) * random.normal();
    }
    return out;
}

inline Experiment excite(const Design& d, double duration, Random& random) {
    Experiment e;
    e.dt = d.dt;
    e.samples = static_cast<int>(std::lround(duration / d.dt)) + 1;
    for (const auto& s : d.model.signals) {
        if (!s.input) continue;
        if (s.unit == "K") {
            const double ambient = rounded(random.uniform(288.0, 299.0), 4);
            e.inputs.push_back(wander(random, e.samples, d.dt, ambient, d.gasLow, d.gasHigh, d.gasPace));
        } else {
            e.inputs.push_back(Manoeuvre(d, e.samples, random).drive());
        }
    }
    if (!d.flow.name.empty()) {
        const double top = d.flow.unit == "l/min" ? 16.0 : d.flow.unit == "km/h" ? 190.0 : 52.0;
        e.flow =
            wander(random, e.samples, d.dt, random.uniform(0.2, 0.8) * top, 0.08 * top, top, random.uniform(6.0, 20.0));
    }
    return e;
}

}  // namespace bench
