#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "plant.hpp"

/// Integration of a plant over an experiment with hard, set-valued effects: dry friction sticks, a stop stops, play is
/// free, a brush drop blocks the current. Each of these is a mode; the classic Runge-Kutta step of order 4 runs with
/// the modes held, and a step at whose end a mode's condition is violated is shortened by bisection to the moment of
/// the change (Filippov 1988 for what sticking means; Hairer, Norsett, Wanner I, II.6 for the location of events).
namespace bench {

/// What drives a run; all series are sampled at k*dt and linear in between. Inputs in the model's units.
struct Experiment {
    double dt{};
    int samples{};
    std::vector<std::vector<double>> inputs;
    std::vector<double> flow;         // the channel that a conductance may depend on; empty: none
    std::vector<double> disturbance;  // unit variance; empty: none

    double duration() const { return dt * (samples - 1); }
};

using Series = std::vector<double>;

struct Recording {
    std::vector<Series> outputs;
    bool ok{true};
    double maxCurrent{}, rmsCurrent{}, maxVoltage{}, maxHeat{};
    std::vector<double> maxSpeed, angleMin, angleMax, rmsTorque;  // a piece
    std::vector<double> minT, maxT;                               // a node
};

class Simulator {
public:
    Simulator(const Plant& plant, const Experiment& experiment, double stepFactor = 1.0)
        : plant_(plant), experiment_(experiment) {
        hasJump_ = plant.jump.time >= 0.0;
        mergePieces();
        layOut();
        // Dead time reads between the steps, and the band of a latent heat has sharp ends.
        bool sharp = false;
        for (const auto& s : plant.sensors) sharp = sharp || s.delay > 0.0;
        sharp = sharp || plant.machine.currentLimit > 0.0;
        for (const auto& n : plant.nodes) sharp = sharp || n.latentHeat > 0.0;
        substeps_ =
            static_cast<int>(std::ceil(std::max(sharp ? 6.0 : 1.0, std::ceil(experiment.dt * fastest())) / stepFactor));
        h_ = experiment.dt / substeps_;
    }

    Recording run();

private:
    static constexpr int maxState = 28, maxBody = 5;
    using State = std::array<double, maxState>;

    struct Probe {
        // Not initialised: evaluate() sets what the plant has, and this is the innermost loop.
        State dx;
        std::array<double, 6> raw;        // sensors before their own dynamics
        std::array<double, maxBody> net;  // torque without dry friction
        std::array<double, maxBody> w;
        std::array<double, maxBody> jointTorque;  // in contact, also where there is none at present
        std::array<double, maxBody> angle;        // of a joint
        double current, voltage, gap, heat;       // gap: voltage left over for the current
    };

    void mergePieces();
    void layOut();
    double fastest() const;
    void start();
    void evaluate(double t, const State& x, Probe& p) const;
    double electric(double t, const State& x, Probe& p) const;
    void mechanics(double t, const State& x, Probe& p) const;
    void thermal(double t, const State& x, double joule, double friction, Probe& p) const;
    void jointTorques(const State& x, Probe& p) const;
    double loads(const Piece& b, double t, double phi) const;
    double masslessSpeed(const Piece& b, double a, double s) const;
    static bool rubs(const Piece& b) { return b.coulomb + b.stribeck + b.rub > 0.0; }
    /// The torque under which a body that stands at an angle stays there.
    static double hold(const Piece& b, double phi) {
        return b.coulomb + b.stribeck + (phi > b.rubFrom && phi < b.rubTo ? b.rub : 0.0);
    }
    double input(std::size_t k, double t) const {
        return sampled(experiment_.inputs[k], experiment_.dt, t - plant_.actuators[k].delay);
    }
    double driven(std::size_t k, double t, const State& x) const;
    static double sampled(const Series& series, double dt, double t);
    double jumped(const char* what, double t) const {
        return hasJump_ && t >= plant_.jump.time && plant_.jump.what == what ? plant_.jump.factor : 1.0;
    }
    void advance(double t);
    void rungeKutta(double t, double h, const State& x, const Probe& first, State& out) const;
    bool violated(const State& x, const Probe& p) const;
    void changeModes(double t);
    void note(Recording& r, double t) const;

    Plant plant_;
    const Experiment& experiment_;
    int substeps_{1};
    bool hasJump_{};
    double h_{};

    std::vector<Piece> bodies_;
    std::vector<Joint> elastic_;
    std::vector<int> bodyOf_;  // piece -> body
    bool lastIsMassless_{};

    int size_{}, iCurrent_{-1}, iWinding_{-1}, iNode_{}, iSecond_{};
    std::array<int, 4> iActuator_{-1, -1, -1, -1};
    std::array<int, 6> iSensor_{-1, -1, -1, -1, -1, -1};
    std::array<int, maxBody> iDahl_{};

    State x_{};
    Probe now_;
    std::array<int, maxBody> friction_{};  // -1, 0 (sticks), 1
    std::array<int, maxBody> play_{};      // -1, 0 (free), 1
    std::array<bool, maxBody> stopped_{};
    int conduction_{1};            // -1, 0 (blocked), 1
    std::vector<double> hottest_;  // of each node, so far
};

// ---------------------------------------------------------------- layout

inline void Simulator::mergePieces() {
    bodyOf_.assign(plant_.pieces.size(), 0);
    for (std::size_t k = 0; k < plant_.pieces.size(); ++k) {
        const Piece& p = plant_.pieces[k];
        if (k == 0 || !plant_.joints[k - 1].rigid) {
            if (k > 0) elastic_.push_back(plant_.joints[k - 1]);
            bodies_.push_back(p);
        } else {
            Piece& b = bodies_.back();
            b.inertia += p.inertia;
            b.viscous += p.viscous, b.quadratic += p.quadratic, b.cubic += p.cubic;
            b.constant += p.constant, b.coulomb += p.coulomb, b.disturbance += p.disturbance;
            if (p.spring != 0.0) {
                b.springRest = (b.spring * b.springRest + p.spring * p.springRest) / (b.spring + p.spring);
                b.spring += p.spring;
            }
            if (p.gravity != 0.0) b.gravity = p.gravity, b.gravityPhase = p.gravityPhase;
            if (p.cogging != 0.0)
                b.cogging = p.cogging, b.coggingPhase = p.coggingPhase, b.coggingCount = p.coggingCount;
            if (p.sawtooth != 0.0) b.sawtooth = p.sawtooth;
            if (p.stribeck != 0.0) b.stribeck = p.stribeck, b.stribeckSpeed = p.stribeckSpeed;
            if (p.hysteresis != 0.0) b.hysteresis = p.hysteresis, b.hysteresisTravel = p.hysteresisTravel;
            if (p.stop != 0.0) b.stop = p.stop;
            if (p.hardening != 0.0) b.hardening = p.hardening;
            if (p.rub != 0.0) b.rub = p.rub, b.rubFrom = p.rubFrom, b.rubTo = p.rubTo;
            if (p.periodic != 0.0) b.periodic = p.periodic, b.period = p.period;
        }
        bodyOf_[k] = static_cast<int>(bodies_.size()) - 1;
    }
    lastIsMassless_ = bodies_.size() > 1 && bodies_.back().inertia == 0.0;
    for (std::size_t k = 0; k + (lastIsMassless_ ? 1 : 0) < bodies_.size(); ++k)
        if (bodies_[k].inertia <= 0.0) throw std::runtime_error("a shaft without inertia");
}

inline void Simulator::layOut() {
    size_ = 2 * static_cast<int>(bodies_.size());
    const Machine& m = plant_.machine;
    if (m.drive == Drive::Motor && m.L > 0.0) iCurrent_ = size_++;
    if (m.windingC > 0.0) iWinding_ = size_++;
    iNode_ = size_;
    size_ += static_cast<int>(plant_.nodes.size());
    iSecond_ = size_;
    size_ += static_cast<int>(plant_.nodes.size());
    for (std::size_t k = 0; k < plant_.actuators.size(); ++k)
        if (plant_.actuators[k].lag > 0.0) iActuator_[k] = size_++;
    for (std::size_t k = 0; k < plant_.sensors.size(); ++k)
        if (plant_.sensors[k].lag > 0.0) iSensor_[k] = size_++;
    for (std::size_t k = 0; k < bodies_.size(); ++k) iDahl_[k] = bodies_[k].hysteresis > 0.0 ? size_++ : -1;
    if (size_ > maxState || bodies_.size() > maxBody) throw std::runtime_error("plant too large");
}

/// Rate [1/s] of the quickest motion, scaled so that one step a unit is accurate enough.
inline double Simulator::fastest() const {
    double rate = 0.0;
    const auto add = [&rate](double r, double weight) { rate = std::max(rate, weight * r); };
    const Machine& m = plant_.machine;
    constexpr double oscillating = 1.4, decaying = 0.7;
    if (m.drive == Drive::Motor) {
        const double J = bodies_[0].inertia;
        if (m.L > 0.0) {
            const double saturated = m.L / (1.0 + std::pow(m.inverseSatCurrent * 12.0 / m.R, 2));
            add(m.R / m.L, decaying);
            add(m.R / saturated, 0.5);  // only for moments
            add(m.k / std::sqrt(m.L * J), oscillating);
        } else {
            add(m.k * m.k / (m.R * J), oscillating);
        }
        for (std::size_t k = 0; k < bodies_.size(); ++k) {
            double stiffness = bodies_[k].spring, damping = bodies_[k].viscous;
            if (k > 0) stiffness += elastic_[k - 1].stiffness, damping += elastic_[k - 1].damping;
            if (k + 1 < bodies_.size()) {
                const double r2 = elastic_[k].ratio * elastic_[k].ratio;
                stiffness += elastic_[k].stiffness / r2, damping += elastic_[k].damping / r2;
            }
            if (bodies_[k].inertia > 0.0) {
                add(std::sqrt(stiffness / bodies_[k].inertia), oscillating);
                add(damping / bodies_[k].inertia, decaying);
            } else {
                add(stiffness / damping, decaying);
            }
        }
    }
    for (const auto& l : plant_.links)
        add(l.conductance * (l.convective ? 60.0 : 1.0) / plant_.nodes[static_cast<std::size_t>(l.from)].capacity,
            oscillating);
    for (const auto& n : plant_.nodes) {
        add((n.secondG + n.lossG) / n.capacity, oscillating);
        if (n.secondCapacity > 0.0) add(n.secondG / n.secondCapacity, oscillating);
    }
    for (const auto& a : plant_.actuators)
        if (a.lag > 0.0) add(1.0 / a.lag, decaying);
    for (const auto& s : plant_.sensors)
        if (s.lag > 0.0) add(1.0 / s.lag, decaying);
    return rate;
}

// ---------------------------------------------------------------- equations

inline double Simulator::sampled(const Series& series, double dt, double t) {
    const double s = std::max(0.0, t / dt);
    const auto k = std::min(static_cast<std::size_t>(s), series.size() - 2);
    return series[k] + (series[k + 1] - series[k]) * (s - static_cast<double>(k));
}

/// Input k behind its actuator.
inline double Simulator::driven(std::size_t k, double t, const State& x) const {
    const Actuator& a = plant_.actuators[k];
    double u = iActuator_[k] >= 0 ? x[static_cast<std::size_t>(iActuator_[k])] : input(k, t);
    u = a.gain * u + a.offset;
    if (a.deadZone > 0.0) u = std::abs(u) <= a.deadZone ? 0.0 : u - std::copysign(a.deadZone, u);
    if (a.limit > 0.0) u = std::clamp(u, -a.limit, a.limit);
    return u;
}

/// Current and, for a motor, its torque (returned); for a heater the heat into its node.
inline double Simulator::electric(double t, const State& x, Probe& p) const {
    const Machine& m = plant_.machine;
    p.voltage = m.voltageGain * driven(static_cast<std::size_t>(m.voltageInput), t, x);
    const double R = m.R * jumped("R", t);
    if (m.drive == Drive::Heater) {
        const double T = x[static_cast<std::size_t>(iNode_ + m.node)];
        const double v = std::abs(p.voltage) <= m.drop ? 0.0 : p.voltage - std::copysign(m.drop, p.voltage);
        double heat = 0.0, RT = R * (1.0 + m.alpha * (T - m.alphaRef));
        if (m.portResistance > 0.0)  // the element is hotter than its node by resistance*heat: Newton on the heat
            for (int pass = 0; pass < 6; ++pass) {
                RT = R * (1.0 + m.alpha * (T + m.portResistance * heat - m.alphaRef));
                const double sum = RT + m.seriesR, f = heat - v * v * RT / (sum * sum);
                const double slope =
                    1.0 - v * v * (m.seriesR - RT) / (sum * sum * sum) * R * m.alpha * m.portResistance;
                heat -= f / slope;
            }
        p.current = v / (RT + m.seriesR);
        p.heat = RT * p.current * p.current;
        return 0.0;
    }
    double rise = 0.0;
    if (iWinding_ >= 0)
        rise = x[static_cast<std::size_t>(iWinding_)];
    else if (m.node >= 0)
        rise = x[static_cast<std::size_t>(iNode_ + m.node)] - m.alphaRef;
    const double Rw = R * (1.0 + m.windingAlpha * rise), k = m.k * jumped("k", t) * (1.0 - m.fluxSlope * rise);
    p.gap = p.voltage - k * p.w[0];
    if (iCurrent_ >= 0) {
        p.current = x[static_cast<std::size_t>(iCurrent_)];
        const double L = m.L / (1.0 + std::pow(p.current * m.inverseSatCurrent, 2));
        const bool blocked = m.drop > 0.0 && conduction_ == 0;
        const double drop = m.drop > 0.0 ? m.drop * conduction_ : 0.0;
        double rate = blocked ? 0.0 : (p.gap - Rw * p.current - drop) / L;
        if (m.currentLimit > 0.0 && std::abs(p.current) >= m.currentLimit && rate * p.current > 0.0) rate = 0.0;
        p.dx[static_cast<std::size_t>(iCurrent_)] = rate;
    } else {
        p.current = std::abs(p.gap) <= m.drop ? 0.0 : (p.gap - std::copysign(m.drop, p.gap)) / Rw;
        if (m.currentLimit > 0.0) p.current = std::clamp(p.current, -m.currentLimit, m.currentLimit);
    }
    p.heat = Rw * p.current * p.current;
    if (iWinding_ >= 0) p.dx[static_cast<std::size_t>(iWinding_)] = (p.heat - m.windingG * rise) / m.windingC;
    return k * p.current;
}

/// Load torque that depends on the angle and on time only.
inline double Simulator::loads(const Piece& b, double t, double phi) const {
    double tau = b.constant + b.spring * jumped("load", t) * (phi - b.springRest);
    if (b.hardening != 0.0) tau += b.hardening * std::pow(phi - b.springRest, 3);
    if (b.gravity != 0.0) tau += b.gravity * std::sin(phi - b.gravityPhase);
    if (b.cogging != 0.0) tau += b.cogging * std::sin(b.coggingCount * (phi - b.coggingPhase));
    if (b.sawtooth != 0.0) {
        const double turn = phi / (2.0 * std::numbers::pi);
        tau += b.sawtooth * (2.0 * (turn - std::floor(turn)) - 1.0);
    }
    if (b.periodic != 0.0) tau += b.periodic * std::sin(2.0 * std::numbers::pi * t / b.period);
    if (b.disturbance != 0.0) tau += b.disturbance * sampled(experiment_.disturbance, experiment_.dt, t);
    return tau;
}

/// Speed of a body without inertia, from a*w + k_q*w*|w| + k_c*w^3 + tau_c*sign(w) = s.
inline double Simulator::masslessSpeed(const Piece& b, double a, double s) const {
    const double S = std::abs(s) - b.coulomb;
    if (S <= 0.0) return 0.0;
    double w = 2.0 * S / (a + std::sqrt(a * a + 4.0 * b.quadratic * S));
    if (b.cubic > 0.0)
        for (int pass = 0; pass < 8; ++pass)
            w -= (a * w + b.quadratic * w * w + b.cubic * w * w * w - S) /
                 (a + 2.0 * b.quadratic * w + 3.0 * b.cubic * w * w);
    return std::copysign(w, s);
}

inline void Simulator::jointTorques(const State& x, Probe& p) const {
    for (std::size_t k = 0; k < elastic_.size(); ++k) {
        const Joint& j = elastic_[k];
        p.angle[k] = x[k] / j.ratio - x[k + 1];
        const double side = j.play > 0.0 ? (play_[k] != 0 ? play_[k] : (p.angle[k] > 0.0 ? 1.0 : -1.0)) : 0.0;
        p.jointTorque[k] =
            j.stiffness * (p.angle[k] - 0.5 * side * j.play) + j.damping * (p.w[k] / j.ratio - p.w[k + 1]);
    }
}

inline void Simulator::mechanics(double t, const State& x, Probe& p) const {
    const std::size_t n = bodies_.size();
    const double factor = jumped("load", t);
    for (std::size_t k = 0; k < n; ++k) p.net[k] -= loads(bodies_[k], t, x[k]);
    for (std::size_t k = 0; k + 1 < n; ++k) {
        if (elastic_[k].play > 0.0 && play_[k] == 0) continue;
        p.net[k] -= p.jointTorque[k] / elastic_[k].ratio;
        p.net[k + 1] += p.jointTorque[k];
    }
    for (std::size_t k = 0; k < n; ++k) {
        const Piece& b = bodies_[k];
        const double w = p.w[k], speed = std::abs(w);
        p.dx[k] = w;
        if (k + 1 == n && lastIsMassless_) continue;
        p.net[k] -= factor * (b.viscous + b.quadratic * speed) * w + b.cubic * w * w * w;
        double tau = p.net[k];
        if (iDahl_[k] >= 0) {
            const double force = x[static_cast<std::size_t>(iDahl_[k])];
            p.net[k] = tau -= b.hysteresis * force;
            p.dx[static_cast<std::size_t>(iDahl_[k])] = (w - force * speed) / b.hysteresisTravel;
        }
        if (rubs(b)) {
            const double ratio = w / b.stribeckSpeed, stribeck = b.stribeck * std::exp(-ratio * ratio);
            tau = friction_[k] == 0 ? 0.0 : tau - friction_[k] * (hold(b, x[k]) - b.stribeck + stribeck);
        }
        if (stopped_[k]) tau = 0.0;
        p.dx[n + k] = tau / b.inertia;
    }
}

inline void Simulator::thermal(double t, const State& x, double joule, double friction, Probe& p) const {
    const auto T = [&](int node) { return x[static_cast<std::size_t>(iNode_ + node)]; };
    std::array<double, 4> q{};
    for (const auto& l : plant_.links) {
        const double far = l.to >= 0      ? T(l.to)
                           : l.input >= 0 ? driven(static_cast<std::size_t>(l.input), t, x)
                                          : l.imposed;
        const double difference = T(l.from) - far;
        double G = l.conductance * (l.convective ? std::pow(far / 3.6, 0.78) : 1.0) * jumped("G", t);
        if (l.exponent != 0.0) G *= std::pow(std::abs(difference) / l.exponentRef, l.exponent);
        if (l.flowExponent != 0.0) {
            const double flow = sampled(experiment_.flow, experiment_.dt, t);
            G *= std::pow(std::max(flow / l.flowRef, 1e-3), l.flowExponent);
        }
        if (l.resistance > 0.0) G /= 1.0 + G * l.resistance;
        q[static_cast<std::size_t>(l.from)] -= G * difference;
        if (l.to >= 0) q[static_cast<std::size_t>(l.to)] += G * difference;
    }
    const Machine& m = plant_.machine;
    if (m.drive == Drive::Heater) q[static_cast<std::size_t>(m.node)] += p.heat;
    if (m.jouleNode >= 0) q[static_cast<std::size_t>(m.jouleNode)] += joule;
    if (plant_.bearing.node >= 0) q[static_cast<std::size_t>(plant_.bearing.node)] += friction;
    for (std::size_t k = 0; k < plant_.nodes.size(); ++k) {
        const Node& n = plant_.nodes[k];
        const std::size_t own = static_cast<std::size_t>(iNode_) + k, second = static_cast<std::size_t>(iSecond_) + k;
        const double here = x[own];
        if (n.lossG != 0.0) q[k] -= n.lossG * (here - n.lossT);
        if (n.radiation != 0.0) q[k] -= n.radiation * (std::pow(here, 4) - std::pow(n.radiationT, 4));
        if (n.secondCapacity > 0.0) {
            const double flow = n.secondG * (here - x[second]);
            q[k] -= flow;
            p.dx[second] = flow / n.secondCapacity;
        }
        if (t >= n.eventFrom && t < n.eventTo) q[k] += n.event;
        if (n.valveG != 0.0) q[k] -= n.valveG * std::max(0.0, here - n.valveT);
        if (n.periodic != 0.0) q[k] += n.periodic * std::sin(2.0 * std::numbers::pi * t / n.period);
        if (n.disturbance != 0.0) q[k] += n.disturbance * sampled(experiment_.disturbance, experiment_.dt, t);
        double capacity = n.capacity;
        const bool firstHeating = here >= hottest_[k] - 1e-9 && q[k] > 0.0;
        if (n.latentHeat > 0.0 && firstHeating && std::abs(here - n.latentT) < 0.5 * n.latentWidth)
            capacity += n.latentHeat / n.latentWidth;
        p.dx[own] = q[k] / capacity;
    }
}

inline void Simulator::evaluate(double t, const State& x, Probe& p) const {
    const std::size_t n = bodies_.size();
    std::fill_n(p.dx.begin(), size_, 0.0);
    for (std::size_t k = 0; k < n; ++k) p.net[k] = 0.0, p.w[k] = x[n + k];
    if (lastIsMassless_) {
        const Joint& j = elastic_[n - 2];
        const Piece& b = bodies_[n - 1];
        const double s =
            j.stiffness * (x[n - 2] / j.ratio - x[n - 1]) + j.damping * p.w[n - 2] / j.ratio - loads(b, t, x[n - 1]);
        p.w[n - 1] = masslessSpeed(b, j.damping + b.viscous, s);
    }
    jointTorques(x, p);
    const double torque = electric(t, x, p);
    if (n > 0) {
        p.net[0] += torque;
        mechanics(t, x, p);
    }
    if (!plant_.nodes.empty()) {
        double friction = 0.0;
        if (plant_.bearing.node >= 0) {
            const double w = p.w[static_cast<std::size_t>(bodyOf_[static_cast<std::size_t>(plant_.bearing.piece)])];
            friction = plant_.bearing.b * w * w;
        }
        // The copper heat is what the model's gain makes of the current, also where the resistance rises.
        thermal(t, x, plant_.machine.jouleGain * p.current * p.current, friction, p);
    }
    for (std::size_t k = 0; k < plant_.actuators.size(); ++k)
        if (iActuator_[k] >= 0) {
            const auto own = static_cast<std::size_t>(iActuator_[k]);
            p.dx[own] = (input(k, t) - x[own]) / plant_.actuators[k].lag;
        }
    for (std::size_t k = 0; k < plant_.sensors.size(); ++k) {
        const Sensor& s = plant_.sensors[k];
        switch (s.quantity) {
            case Quantity::Current:
                p.raw[k] = p.current;
                break;
            case Quantity::Speed:
                p.raw[k] = p.w[static_cast<std::size_t>(bodyOf_[static_cast<std::size_t>(s.index)])];
                break;
            case Quantity::Angle:
                p.raw[k] = x[static_cast<std::size_t>(bodyOf_[static_cast<std::size_t>(s.index)])];
                break;
            case Quantity::Temperature:
                p.raw[k] = x[static_cast<std::size_t>(iNode_ + s.index)];
                break;
        }
        if (iSensor_[k] >= 0) {
            const auto own = static_cast<std::size_t>(iSensor_[k]);
            p.dx[own] = (p.raw[k] - x[own]) / s.lag;
        }
    }
}

// ---------------------------------------------------------------- steps and modes

inline void Simulator::rungeKutta(double t, double h, const State& x, const Probe& first, State& out) const {
    const auto n = static_cast<std::size_t>(size_);
    Probe p2, p3, p4;
    State y;
    for (std::size_t k = 0; k < n; ++k) y[k] = x[k] + 0.5 * h * first.dx[k];
    evaluate(t + 0.5 * h, y, p2);
    for (std::size_t k = 0; k < n; ++k) y[k] = x[k] + 0.5 * h * p2.dx[k];
    evaluate(t + 0.5 * h, y, p3);
    for (std::size_t k = 0; k < n; ++k) y[k] = x[k] + h * p3.dx[k];
    evaluate(t + h, y, p4);
    for (std::size_t k = 0; k < n; ++k)
        out[k] = x[k] + h / 6.0 * (first.dx[k] + 2.0 * (p2.dx[k] + p3.dx[k]) + p4.dx[k]);
}

/// Whether the state has left what its modes allow.
inline bool Simulator::violated(const State& x, const Probe& p) const {
    const std::size_t massive = bodies_.size() - (lastIsMassless_ ? 1 : 0);
    for (std::size_t k = 0; k < massive; ++k) {
        const Piece& b = bodies_[k];
        if (rubs(b) && (friction_[k] == 0 ? std::abs(p.net[k]) > hold(b, x[k]) : friction_[k] * p.w[k] < 0.0))
            return true;
        if (b.stop > 0.0 && (stopped_[k] ? p.net[k] < 0.0 : x[k] > b.stop && p.w[k] > 0.0)) return true;
    }
    for (std::size_t k = 0; k < elastic_.size(); ++k) {
        if (elastic_[k].play <= 0.0) continue;
        if (play_[k] != 0 ? play_[k] * p.jointTorque[k] < 0.0
                          : std::abs(p.angle[k]) > 0.5 * elastic_[k].play && p.jointTorque[k] * p.angle[k] > 0.0)
            return true;
    }
    if (plant_.machine.drop > 0.0 && iCurrent_ >= 0 &&
        (conduction_ == 0 ? std::abs(p.gap) > plant_.machine.drop : conduction_ * p.current < 0.0))
        return true;
    return false;
}

/// Gives every mode whose condition is violated its new value. x_ lies just behind the change.
inline void Simulator::changeModes(double t) {
    const std::size_t n = bodies_.size(), massive = n - (lastIsMassless_ ? 1 : 0);
    const auto direction = [](double force, double hold) { return std::abs(force) <= hold ? 0 : force > 0.0 ? 1 : -1; };
    for (std::size_t k = 0; k < massive; ++k) {
        const Piece& b = bodies_[k];
        const double most = hold(b, x_[k]);
        if (rubs(b) && (friction_[k] == 0 ? std::abs(now_.net[k]) > most : friction_[k] * now_.w[k] < 0.0)) {
            x_[n + k] = 0.0;
            friction_[k] = direction(now_.net[k], most);
        }
        if (b.stop > 0.0) {
            if (stopped_[k])
                stopped_[k] = now_.net[k] >= 0.0;
            else if (x_[k] > b.stop && now_.w[k] > 0.0)
                stopped_[k] = true, x_[k] = b.stop, x_[n + k] = 0.0;
        }
    }
    for (std::size_t k = 0; k < elastic_.size(); ++k) {
        if (elastic_[k].play <= 0.0) continue;
        if (play_[k] != 0) {
            if (play_[k] * now_.jointTorque[k] < 0.0) play_[k] = 0;
        } else if (std::abs(now_.angle[k]) > 0.5 * elastic_[k].play && now_.jointTorque[k] * now_.angle[k] > 0.0) {
            play_[k] = now_.angle[k] > 0.0 ? 1 : -1;
        }
    }
    const Machine& m = plant_.machine;
    if (m.drop > 0.0 && iCurrent_ >= 0 &&
        (conduction_ == 0 ? std::abs(now_.gap) > m.drop : conduction_ * now_.current < 0.0)) {
        x_[static_cast<std::size_t>(iCurrent_)] = 0.0;
        conduction_ = direction(now_.gap, m.drop);
    }
    evaluate(t, x_, now_);
}

/// One step of h_ from t, with as many stops at mode changes as it takes. now_ belongs to x_ before and after.
inline void Simulator::advance(double t) {
    double left = h_;
    for (int changes = 0; left > 1e-9 * h_; ++changes) {
        State trial;
        Probe there;
        rungeKutta(t, left, x_, now_, trial);
        evaluate(t + left, trial, there);
        if (changes >= 12 || !violated(trial, there)) {
            x_ = trial;
            now_ = there;
            if (changes >= 12) changeModes(t + left);
            break;
        }
        double good = 0.0, bad = left;
        for (int pass = 0; pass < 14; ++pass) {
            const double middle = 0.5 * (good + bad);
            State y;
            Probe p;
            rungeKutta(t, middle, x_, now_, y);
            evaluate(t + middle, y, p);
            if (violated(y, p))
                bad = middle, trial = y, there = p;
            else
                good = middle;
        }
        x_ = trial;
        now_ = there;
        t += bad;
        left -= bad;
        changeModes(t);
    }
    for (std::size_t k = 0; k < plant_.nodes.size(); ++k)
        hottest_[k] = std::max(hottest_[k], x_[static_cast<std::size_t>(iNode_) + k]);
}

/// At rest, at the start temperatures; lags are settled on what they see.
inline void Simulator::start() {
    x_.fill(0.0);
    hottest_.clear();
    for (std::size_t k = 0; k < plant_.nodes.size(); ++k) {
        const double T = plant_.nodes[k].start;
        x_[static_cast<std::size_t>(iNode_) + k] = x_[static_cast<std::size_t>(iSecond_) + k] = T;
        hottest_.push_back(T);
    }
    for (std::size_t k = 0; k < plant_.actuators.size(); ++k)
        if (iActuator_[k] >= 0) x_[static_cast<std::size_t>(iActuator_[k])] = input(k, 0.0);
    conduction_ = 0;
    evaluate(0.0, x_, now_);
    for (std::size_t k = 0; k < plant_.sensors.size(); ++k)
        if (iSensor_[k] >= 0) x_[static_cast<std::size_t>(iSensor_[k])] = now_.raw[k];
    changeModes(0.0);
}

inline void Simulator::note(Recording& r, double) const {
    r.maxCurrent = std::max(r.maxCurrent, std::abs(now_.current));
    r.rmsCurrent += now_.current * now_.current;
    r.maxVoltage = std::max(r.maxVoltage, std::abs(now_.voltage));
    r.maxHeat = std::max(r.maxHeat, now_.heat);
    for (std::size_t k = 0; k < plant_.pieces.size(); ++k) {
        const auto b = static_cast<std::size_t>(bodyOf_[k]);
        r.maxSpeed[k] = std::max(r.maxSpeed[k], std::abs(now_.w[b]));
        r.angleMin[k] = std::min(r.angleMin[k], x_[b]);
        r.angleMax[k] = std::max(r.angleMax[k], x_[b]);
    }
    for (std::size_t k = 0; k < plant_.nodes.size(); ++k) {
        const double T = x_[static_cast<std::size_t>(iNode_) + k];
        r.minT[k] = std::min(r.minT[k], T);
        r.maxT[k] = std::max(r.maxT[k], T);
    }
}

inline Recording Simulator::run() {
    Recording r;
    const std::size_t pieces = plant_.pieces.size(), nodes = plant_.nodes.size(), channels = plant_.sensors.size();
    r.outputs.assign(channels, Series(static_cast<std::size_t>(experiment_.samples)));
    r.maxSpeed.assign(pieces, 0.0), r.angleMin.assign(pieces, 0.0), r.angleMax.assign(pieces, 0.0);
    r.minT.assign(nodes, 1e9), r.maxT.assign(nodes, -1e9);
    std::vector<Series> history(channels);  // at every step, for dead time
    start();
    for (int k = 0; k < experiment_.samples; ++k) {
        note(r, k * experiment_.dt);
        for (std::size_t c = 0; c < channels; ++c)
            r.outputs[c][static_cast<std::size_t>(k)] =
                iSensor_[c] >= 0 ? x_[static_cast<std::size_t>(iSensor_[c])] : now_.raw[c];
        for (int j = 0; j < substeps_; ++j) {
            for (std::size_t c = 0; c < channels; ++c)
                if (plant_.sensors[c].delay > 0.0) history[c].push_back(now_.raw[c]);
            if (k + 1 < experiment_.samples) advance(k * experiment_.dt + j * h_);
        }
    }
    r.rmsCurrent = std::sqrt(r.rmsCurrent / experiment_.samples);
    for (std::size_t p = 0; p < pieces; ++p) {
        double ratio = 1.0;
        for (std::size_t j = 0; j < p; ++j) ratio *= plant_.joints[j].ratio;
        r.rmsTorque.push_back(plant_.machine.k * r.rmsCurrent * ratio);
    }
    for (std::size_t c = 0; c < channels; ++c) {
        const Sensor& s = plant_.sensors[c];
        for (int k = 0; k < experiment_.samples; ++k) {
            const double t = k * experiment_.dt;
            double& y = r.outputs[c][static_cast<std::size_t>(k)];
            if (s.delay > 0.0) y = sampled(history[c], h_, t - s.delay);
            y = s.gain * y + s.offset + s.drift * t;
            if (s.limit > 0.0) y = std::min(y, s.limit);
            if (!std::isfinite(y)) r.ok = false;
        }
    }
    return r;
}

inline Recording simulate(const Plant& plant, const Experiment& experiment, double stepFactor = 1.0) {
    return Simulator(plant, experiment, stepFactor).run();
}

}  // namespace bench
