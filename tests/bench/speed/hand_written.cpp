#include "tests/bench/speed/hand_written.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace analogon::speed {
namespace {

/// A value with N tangents; N fills whole vectors.
template <int N>
struct Tangent {
    typedef double Vector __attribute__((vector_size(N * 8)));
    double value{};
    Vector slope{};
};

template <int N>
Tangent<N> variable(double value, int direction) {
    Tangent<N> t;
    t.value = value;
    t.slope[direction] = 1;
    return t;
}

#define TANGENT      \
    template <int N> \
    [[gnu::always_inline]] inline Tangent<N>
TANGENT operator+(const Tangent<N>& a, const Tangent<N>& b) { return {a.value + b.value, a.slope + b.slope}; }
TANGENT operator-(const Tangent<N>& a, const Tangent<N>& b) { return {a.value - b.value, a.slope - b.slope}; }
TANGENT operator*(const Tangent<N>& a, const Tangent<N>& b) {
    return {a.value * b.value, a.slope * b.value + b.slope * a.value};
}
TANGENT operator/(const Tangent<N>& a, const Tangent<N>& b) {
    const double r = 1 / b.value, q = a.value * r;
    return {q, (a.slope - b.slope * q) * r};
}
TANGENT operator+(double a, const Tangent<N>& b) { return {a + b.value, b.slope}; }
TANGENT operator-(const Tangent<N>& a, double b) { return {a.value - b, a.slope}; }
TANGENT operator*(double a, const Tangent<N>& b) { return {a * b.value, b.slope * a}; }
TANGENT operator/(double a, const Tangent<N>& b) {
    const double q = a / b.value;
    return {q, b.slope * (-q / b.value)};
}
#undef TANGENT

/// C T' = v^2/R - c_o g (T - Ta), R = R0 (1 + a (T - T0)), with the constants of a run taken together.
template <class S>
struct Heater {
    S invR0C, a, cC, R0;
    Heater(const S& r0, const S& slope, const S& C, const S& co)
        : invR0C(1.0 / (r0 * C)), a(slope), cC(co / C), R0(r0) {}
    S rate(const S& T, double v, double ambient, double g) const {
        return (v * v) * invR0C / (1.0 + a * (T - 293.15)) - g * cC * (T - ambient);
    }
    S current(const S& T, double v) const { return v / (R0 * (1.0 + a * (T - 293.15))); }
};

double conductance(double ambient) { return 1e-3 * std::pow(ambient / 3.6, 0.78); }

/// States: i, phi1 - phi2, w1, w2.
template <class S>
struct Motor {
    S invL, RL, kL, rk, b, invJ1, invJ2, c, d;
    explicit Motor(const std::array<S, 8>& p)
        : invL(1.0 / p[1]),
          RL(p[0] * invL),
          kL(5.0 * p[2] * invL),
          rk(5.0 * p[2]),
          b(p[3]),
          invJ1(1.0 / p[4]),
          invJ2(1.0 / p[5]),
          c(p[6]),
          d(p[7]) {}
    [[gnu::always_inline]] void rates(const S* x, double v, S* out) const {
        const S slip = x[2] - x[3];
        const S tau = c * x[1] + d * slip;
        out[0] = v * invL - RL * x[0] - kL * x[2];
        out[1] = slip;
        out[2] = (rk * x[0] - tau) * invJ1;
        out[3] = (tau - b * x[3]) * invJ2;
    }
};

/// The motor on a chain of M masses; states: i, the M - 1 differences of the angles, the M speeds. Parameters: R, L, k,
/// b, M inertias, M - 1 stiffnesses, M - 1 dampings.
template <class S, int M>
struct Chain {
    S invL, RL, kL, rk, b, invJ[M], c[M], d[M];
    explicit Chain(const S* p) : invL(1.0 / p[1]), RL(p[0] * invL), kL(5.0 * p[2] * invL), rk(5.0 * p[2]), b(p[3]) {
        for (int j = 0; j < M; ++j) invJ[j] = 1.0 / p[4 + j];
        for (int j = 0; j + 1 < M; ++j) {
            c[j] = p[4 + M + j];
            d[j] = p[3 + 2 * M + j];
        }
    }
    [[gnu::always_inline]] void rates(const S* x, double v, S* out) const {
        const S* const angle = x + 1;
        const S* const w = x + M;
        out[0] = v * invL - RL * x[0] - kL * w[0];
        S left = rk * x[0];
        for (int j = 0; j + 1 < M; ++j) {
            const S slip = w[j] - w[j + 1];
            const S tau = c[j] * angle[j] + d[j] * slip;
            out[1 + j] = slip;
            out[M + j] = (left - tau) * invJ[j];
            left = tau;
        }
        out[2 * M - 1] = (left - b * w[M - 1]) * invJ[M - 1];
    }
};

/// The classic Runge-Kutta method; `see` gets the first and the last state at every sample.
template <class S, int n, class Rates, class See>
void walk(const Record& record, const Rates& motor, int substeps, See&& see) {
    S x[n]{}, stage[n], k1[n], k2[n], k3[n], k4[n];
    const int samples = record.samples;
    const double* v = record.inputs;
    for (int k = 0;; ++k) {
        see(k, x[0], x[n - 1]);
        if (k + 1 == samples) return;
        const double h = (record.time[k + 1] - record.time[k]) / substeps;
        const double dv = (v[k + 1] - v[k]) / substeps;
        for (int s = 0; s < substeps; ++s) {
            const double begin = v[k] + s * dv;
            motor.rates(x, begin, k1);
            for (int i = 0; i < n; ++i) stage[i] = x[i] + 0.5 * h * k1[i];
            motor.rates(stage, begin + 0.5 * dv, k2);
            for (int i = 0; i < n; ++i) stage[i] = x[i] + 0.5 * h * k2[i];
            motor.rates(stage, begin + 0.5 * dv, k3);
            for (int i = 0; i < n; ++i) stage[i] = x[i] + h * k3[i];
            motor.rates(stage, begin + dv, k4);
            for (int i = 0; i < n; ++i) x[i] = x[i] + h / 6 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
        }
    }
}

template <int N>
class Sums {
public:
    [[gnu::always_inline]] void add(double residual, const typename Tangent<N>::Vector& slope) {
        cost_ += residual * residual;
        gradient_ += residual * slope;
        for (int i = 0; i < N; ++i) hessian_[i] += slope[i] * slope;
    }
    NormalEquations result() const {
        NormalEquations sums{0.5 * cost_, {}, {}};
        for (int i = 0; i < N; ++i) {
            sums.gradient.push_back(gradient_[i]);
            for (int j = 0; j < N; ++j) sums.hessian.push_back(hessian_[i][j]);
        }
        return sums;
    }

private:
    double cost_{};
    typename Tangent<N>::Vector gradient_{}, hessian_[N]{};
};

}  // namespace

std::vector<double> heaterTable(const Record& record) {
    std::vector<double> table;
    for (int k = 0; k < record.samples; ++k) {
        const double* u = record.inputs + 2 * k;
        table.push_back(conductance(u[1]));
        if (k + 1 < record.samples) table.push_back(conductance(0.5 * (u[1] + u[3])));
    }
    return table;
}

std::vector<double> heaterOutputs(const Record& record, const double* p, int substeps) {
    const Heater<double> heater(p[0], p[1], p[2], p[3]);
    std::vector<double> y;
    double T = record.inputs[1];
    for (int k = 0;; ++k) {
        const double* u = record.inputs + 2 * k;
        y.push_back(heater.current(T, u[0]));
        if (k + 1 == record.samples) return y;
        const double h = (record.time[k + 1] - record.time[k]) / substeps;
        const auto rate = [&](double fraction, double at) {
            const double ambient = u[1] + fraction * (u[3] - u[1]);
            return heater.rate(at, u[0] + fraction * (u[2] - u[0]), ambient, conductance(ambient));
        };
        for (int s = 0; s < substeps; ++s) {
            const double begin = static_cast<double>(s) / substeps, half = 0.5 / substeps;
            const double k1 = rate(begin, T), k2 = rate(begin + half, T + 0.5 * h * k1);
            const double k3 = rate(begin + half, T + 0.5 * h * k2), k4 = rate(begin + 2 * half, T + h * k3);
            T += h / 6 * (k1 + 2 * (k2 + k3) + k4);
        }
    }
}

std::vector<double> motorOutputs(const Record& record, const double* p, int substeps) {
    std::vector<double> y;
    std::array<double, 8> q;
    std::copy_n(p, 8, q.begin());
    walk<double, 4>(record, Motor<double>(q), substeps, [&](int, double i, double w2) {
        y.push_back(i);
        y.push_back(w2);
    });
    return y;
}

NormalEquations heaterPass(const Record& record, const std::vector<double>& table, const double* p) {
    using S = Tangent<4>;
    const Heater<S> heater(variable<4>(p[0], 0), variable<4>(p[1], 1), variable<4>(p[2], 2), variable<4>(p[3], 3));
    Sums<4> sums;
    S T;
    T.value = record.inputs[1];
    const double weight = 1 / record.sigma[0];
    for (int k = 0;; ++k) {
        const double* u = record.inputs + 2 * k;
        const S y = heater.current(T, u[0]);
        sums.add(weight * (y.value - record.measured[k]), weight * y.slope);
        if (k + 1 == record.samples) return sums.result();
        const double h = record.time[k + 1] - record.time[k];
        const double v1 = 0.5 * (u[0] + u[2]), a1 = 0.5 * (u[1] + u[3]);
        const double* g = &table[2 * static_cast<std::size_t>(k)];
        const S k1 = heater.rate(T, u[0], u[1], g[0]);
        const S k2 = heater.rate(T + 0.5 * h * k1, v1, a1, g[1]);
        const S k3 = heater.rate(T + 0.5 * h * k2, v1, a1, g[1]);
        const S k4 = heater.rate(T + h * k3, u[2], u[3], g[2]);
        T = T + h / 6 * (k1 + 2.0 * (k2 + k3) + k4);
    }
}

NormalEquations motorPass(const Record& record, const double* p) {
    using S = Tangent<8>;
    std::array<S, 8> q;
    for (int i = 0; i < 8; ++i) q[static_cast<std::size_t>(i)] = variable<8>(p[i], i);
    Sums<8> sums;
    const double wi = 1 / record.sigma[0], ww = 1 / record.sigma[1];
    walk<S, 4>(record, Motor<S>(q), 1, [&](int k, const S& i, const S& w2) {
        sums.add(wi * (i.value - record.measured[2 * k]), wi * i.slope);
        sums.add(ww * (w2.value - record.measured[2 * k + 1]), ww * w2.slope);
    });
    return sums.result();
}

namespace {

template <int M, int W>
NormalEquations chainOf(const Record& record, const double* p, int count) {
    using S = Tangent<W>;
    S q[3 * M + 2];
    for (int i = 0; i < 3 * M + 2; ++i) {
        q[i] = S{p[i], {}};
        if (i < count) q[i].slope[i] = 1;
    }
    Sums<W> sums;
    const double wi = 1 / record.sigma[0], ww = 1 / record.sigma[1];
    walk<S, 2 * M>(record, Chain<S, M>(q), 1, [&](int k, const S& i, const S& w) {
        sums.add(wi * (i.value - record.measured[2 * k]), wi * i.slope);
        sums.add(ww * (w.value - record.measured[2 * k + 1]), ww * w.slope);
    });
    return sums.result();
}

template <int M>
std::vector<double> chainValues(const Record& record, const double* p, int substeps) {
    std::vector<double> y;
    walk<double, 2 * M>(record, Chain<double, M>(p), substeps, [&](int, double i, double w) {
        y.push_back(i);
        y.push_back(w);
    });
    return y;
}

}  // namespace

NormalEquations chainPass(const Record& record, const double* p, int masses, int count) {
    if (masses == 1) return chainOf<1, 8>(record, p, count);
    if (masses == 2) return chainOf<2, 8>(record, p, count);
    if (masses == 4) return chainOf<4, 16>(record, p, count);
    if (masses == 10) return chainOf<10, 32>(record, p, count);
    if (count <= 4) return chainOf<20, 4>(record, p, count);
    if (count <= 8) return chainOf<20, 8>(record, p, count);
    if (count <= 16) return chainOf<20, 16>(record, p, count);
    if (count <= 32) return chainOf<20, 32>(record, p, count);
    return chainOf<20, 64>(record, p, count);
}

std::vector<double> chainOutputs(const Record& record, const double* p, int masses, int substeps) {
    if (masses == 1) return chainValues<1>(record, p, substeps);
    if (masses == 2) return chainValues<2>(record, p, substeps);
    if (masses == 4) return chainValues<4>(record, p, substeps);
    if (masses == 10) return chainValues<10>(record, p, substeps);
    return chainValues<20>(record, p, substeps);
}

}  // namespace analogon::speed
