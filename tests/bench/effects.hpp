#pragma once

#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "random.hpp"
#include "simulate.hpp"

/// What can be hidden in a plant, where, and how strongly. The same list serves to choose the hidden effect and to ask
/// which other effects would leave the same trace.
namespace bench {

using Parameters = std::vector<std::pair<std::string, double>>;

inline double get(const Parameters& p, const std::string& name, double otherwise = 0.0) {
    for (const auto& [key, value] : p)
        if (key == name) return value;
    return otherwise;
}

/// One kind at one place. `what` is the index of the piece, joint, node, link, output or input.
struct Place {
    std::string kind;
    std::vector<std::string> at;
    int what{};
};

/// A place with the strengths that make sense there; strength 0 is "off".
struct Proposal {
    Place place;
    double typical{}, most{};  // of the strength
    bool bothSigns{};
    std::vector<Parameters> shapes{{}};                               // alternatives for the further parameters
    std::function<Parameters(double, const Parameters&)> parameters;  // strength and shape -> as the library names them
    std::vector<std::string> freed;  // shape parameters that a fit of the effect would adjust
};

struct Effect {
    Place place;
    Parameters parameters;
};

// ---------------------------------------------------------------- the effect in the plant

inline void applyMechanical(Plant& plant, const Effect& e) {
    const auto& [kind, at, what] = e.place;
    const Parameters& p = e.parameters;
    if (kind == "compliance.shaft" || kind == "backlash") {
        Joint& j = plant.joints.at(static_cast<std::size_t>(what));
        j.rigid = false;
        j.stiffness = kind == "backlash" ? get(p, "c") : 1.0 / get(p, "1/c");
        j.damping = get(p, "d");
        j.play = kind == "backlash" ? get(p, "b") : 0.0;
        return;
    }
    Piece& b = plant.pieces.at(static_cast<std::size_t>(what));
    if (kind == "friction.coulomb") b.coulomb += get(p, "tau_c");
    if (kind == "friction.stribeck") {
        b.coulomb += get(p, "tau_c");
        b.stribeck += get(p, "tau_s");
        b.stribeckSpeed = get(p, "w_s", 1.0);
    }
    if (kind == "friction.viscous") b.viscous += get(p, "b");
    if (kind == "drag.quadratic") b.quadratic += get(p, "k_q");
    if (kind == "torque.constant") b.constant += get(p, "tau_0");
    if (kind == "torque.gravity") b.gravity = get(p, "tau_g"), b.gravityPhase = get(p, "phi_0");
    if (kind == "torque.cogging") {
        b.cogging = get(p, "tau_n");
        b.coggingCount = static_cast<int>(get(p, "n", 1));
        b.coggingPhase = get(p, "phi_0");
    }
    if (kind == "spring.return") {
        const double c = get(p, "c_r"), rest = get(p, "phi_r");
        b.springRest = (b.spring * b.springRest + c * rest) / (b.spring + c);
        b.spring += c;
    }
    if (kind == "inertia.added") b.inertia += get(p, "J");
    if (kind == "x.cubic") b.cubic += get(p, "k_c");
    if (kind == "x.sawtooth") b.sawtooth += get(p, "tau");
    if (kind == "x.periodic") b.periodic += get(p, "tau"), b.period = get(p, "period", 1.0);
    if (kind == "x.hysteresis") b.hysteresis += get(p, "tau"), b.hysteresisTravel = get(p, "travel", 1.0);
    if (kind == "x.stop") b.stop = get(p, "phi_max");
    if (kind == "x.hardening") b.hardening = get(p, "c_3");
    if (kind == "x.rub") b.rub = get(p, "tau"), b.rubFrom = get(p, "from"), b.rubTo = get(p, "to");
    if (kind == "x.disturbance") b.disturbance += get(p, "tau");
}

inline void applyThermal(Plant& plant, const Effect& e) {
    const auto& [kind, at, what] = e.place;
    const Parameters& p = e.parameters;
    const auto index = static_cast<std::size_t>(what);
    if (kind == "thermal.resistance" && what < 0) {
        plant.machine.portResistance += get(p, "1/G");
        return;
    }
    if (kind == "thermal.resistance" || kind.starts_with("convection.")) {
        Link& l = plant.links.at(index);
        if (kind == "thermal.resistance") l.resistance += get(p, "1/G");
        if (kind == "convection.flow") l.flowExponent = get(p, "exponent"), l.flowRef = get(p, "ref", 1.0);
        if (kind == "convection.exponent") l.exponent = get(p, "exponent"), l.exponentRef = get(p, "dT_ref", 1.0);
        return;
    }
    Node& n = plant.nodes.at(index);
    if (kind == "thermal.loss") n.lossG += get(p, "G"), n.lossT = get(p, "T_amb", 293.15);
    if (kind == "thermal.radiation") n.radiation += get(p, "k_r"), n.radiationT = get(p, "T_amb", 293.15);
    if (kind == "thermal.mass") n.secondCapacity = get(p, "C2"), n.secondG = get(p, "G2");
    if (kind == "thermal.latent")
        n.latentHeat = get(p, "Q_l"), n.latentT = get(p, "T_l"), n.latentWidth = get(p, "width", 1.0);
    if (kind == "x.heat.periodic") n.periodic += get(p, "Q"), n.period = get(p, "period", 1.0);
    if (kind == "x.heat.event") n.event = get(p, "Q"), n.eventFrom = get(p, "from"), n.eventTo = get(p, "to");
    if (kind == "x.heat.valve") n.valveG = get(p, "G"), n.valveT = get(p, "T_open");
    if (kind == "x.heat.disturbance") n.disturbance += get(p, "Q");
}

inline void applyElectric(Plant& plant, const Effect& e) {
    const std::string& kind = e.place.kind;
    const Parameters& p = e.parameters;
    Machine& m = plant.machine;
    if (kind == "resistance.series") m.seriesR += get(p, "R_s");
    if (kind == "voltage.drop") m.drop += get(p, "V_b");
    if (kind == "x.current.limit") m.currentLimit = get(p, "limit");
    if (kind == "inductance.saturation") m.inverseSatCurrent = get(p, "1/i_s");
    if (kind == "resistance.temperature") m.windingAlpha = get(p, "alpha");
    if (kind == "flux.temperature") m.fluxSlope = get(p, "beta");
    if (kind == "resistance.temperature" || kind == "flux.temperature")
        m.windingC = get(p, "C_w"), m.windingG = get(p, "G_w");
    if (kind == "x.jump") {
        plant.jump.time = get(p, "t");
        plant.jump.factor = get(p, "factor", 1.0);
        static const std::vector<std::string> whats{"R", "k", "load", "G"};
        plant.jump.what = whats.at(static_cast<std::size_t>(e.place.what));
    }
}

inline void applySignal(Plant& plant, const Effect& e) {
    const std::string& kind = e.place.kind;
    const Parameters& p = e.parameters;
    if (kind.starts_with("sensor.") || kind == "x.sensor.saturation") {
        Sensor& s = plant.sensors.at(static_cast<std::size_t>(e.place.what));
        s.lag += get(p, "tau");
        s.delay += get(p, "delay");
        s.offset += get(p, "offset");
        s.gain *= get(p, "gain", 1.0);
        s.drift += get(p, "drift");
        s.limit = get(p, "limit");
    } else {
        Actuator& a = plant.actuators.at(static_cast<std::size_t>(e.place.what));
        a.lag += get(p, "tau");
        a.delay += get(p, "delay");
        a.offset += get(p, "offset");
        a.gain *= get(p, "gain", 1.0);
        a.deadZone += get(p, "width");
        a.limit = get(p, "limit");
    }
}

inline void apply(Plant& plant, const Effect& e) {
    const std::string& k = e.place.kind;
    const auto any = [&k](std::initializer_list<const char*> starts) {
        for (const char* s : starts)
            if (k.starts_with(s)) return true;
        return false;
    };
    if (any({"sensor.", "actuator.", "x.sensor."}))
        applySignal(plant, e);
    else if (any({"resistance.", "voltage.", "inductance.", "flux.", "x.jump", "x.current."}))
        applyElectric(plant, e);
    else if (any({"thermal.", "convection.", "x.heat."}))
        applyThermal(plant, e);
    else
        applyMechanical(plant, e);
}

// ---------------------------------------------------------------- what may be where

/// Lists every effect of the library (or, with `outside`, of none) that makes sense in a model.
class Catalogue {
public:
    Catalogue(const Model& model, const Plant& plant, const Experiment& e, const Recording& base)
        : model_(model), plant_(plant), experiment_(e), base_(base), shafts_(model, true), wired_(model, false) {}

    std::vector<Proposal> inside() {
        for (std::size_t k = 0; k < plant_.pieces.size(); ++k) shaft(k);
        for (std::size_t k = 1; k < plant_.joints.size(); ++k) joint(k);
        for (std::size_t k = 0; k < plant_.nodes.size(); ++k) node(k);
        for (std::size_t k = 0; k < plant_.links.size(); ++k) link(k);
        machine();
        for (std::size_t k = 0; k < plant_.sensors.size(); ++k) output(k);
        for (std::size_t k = 0; k < plant_.actuators.size(); ++k) input(k);
        return std::move(list_);
    }

    std::vector<Proposal> outside(Random& random) {
        const double duration = experiment_.duration();
        const double when = duration * random.uniform(0.35, 0.65);
        const auto jump = [&](int what) {
            add({"x.jump", {}, what}, 0.1, 0.8, false, {{{"t", rounded(when, 3)}}},
                [](double s, const Parameters& shape) { return with(shape, "factor", 1.0 + s); });
        };
        jump(0);
        if (plant_.machine.drive == Drive::Motor) {
            jump(1);
            jump(2);
            outsideShaft(random);
        }
        if (!plant_.links.empty() && plant_.machine.drive == Drive::Heater) jump(3);
        const double most = base_.maxCurrent;
        add({"x.current.limit", {plant_.machine.name}, 0}, 0.1, 0.6, false, {{}}, [most](double s, const Parameters&) {
            return Parameters{{"limit", most * (1.0 - s)}};
        });
        for (std::size_t k = 0; k < plant_.nodes.size(); ++k) {
            const double range = std::max(base_.maxT[k] - base_.minT[k], 1.0);
            const double G = std::max(heat() / range, plant_.nodes[k].capacity / duration);
            add({"x.heat.event", plant_.nodes[k].connectors, static_cast<int>(k)}, 0.1 * heat(), heat(), true,
                {{{"from", rounded(when, 3)}, {"to", rounded(when + duration * random.uniform(0.03, 0.2), 3)}}},
                named("Q"));
            add({"x.heat.valve", plant_.nodes[k].connectors, static_cast<int>(k)}, 0.1 * G, 2.0 * G, false,
                {{{"T_open", rounded(base_.minT[k] + random.uniform(0.4, 0.75) * range, 4)}}}, named("G"));
            add({"x.heat.periodic", {}, static_cast<int>(k)}, 0.05 * heat(), 0.8 * heat(), false,
                {{{"period", rounded(duration * random.uniform(0.04, 0.15), 3)}}}, named("Q"));
        }
        for (std::size_t k = 0; k < plant_.sensors.size(); ++k) {
            const auto [low, high] = std::minmax_element(base_.outputs[k].begin(), base_.outputs[k].end());
            const double top = *high, range = *high - *low;
            add({"x.sensor.saturation", {}, static_cast<int>(k)}, 0.1, 0.5, false, {{}},
                [top, range](double s, const Parameters&) {
                    return Parameters{{"limit", top - s * range}};
                });
        }
        return std::move(list_);
    }

    /// Where an unmeasured random torque or heat flow may act.
    std::vector<Proposal> disturbance() {
        if (plant_.machine.drive == Drive::Motor) {
            const std::size_t last = plant_.pieces.size() - 1;
            add({"x.disturbance", {}, static_cast<int>(last)}, 0.03 * base_.rmsTorque[last], base_.rmsTorque[last],
                false, {{}}, named("tau"));
        } else {
            add({"x.heat.disturbance", {}, 0}, 0.03 * heat(), heat(), false, {{}}, named("Q"));
        }
        return std::move(list_);
    }

private:
    static Parameters with(const Parameters& shape, const std::string& name, double value) {
        Parameters p{{name, value}};
        p.insert(p.end(), shape.begin(), shape.end());
        return p;
    }
    static std::function<Parameters(double, const Parameters&)> named(const std::string& name) {
        return [name](double s, const Parameters& shape) { return with(shape, name, s); };
    }
    void add(Place place, double typical, double most, bool bothSigns, std::vector<Parameters> shapes,
             std::function<Parameters(double, const Parameters&)> parameters, std::vector<std::string> freed = {}) {
        list_.push_back(
            {std::move(place), typical, most, bothSigns, std::move(shapes), std::move(parameters), std::move(freed)});
    }
    double heat() const { return 0.3 * base_.maxHeat; }

    void shaft(std::size_t k);
    void outsideShaft(Random& random);
    void joint(std::size_t k);
    void node(std::size_t k);
    void link(std::size_t k);
    void machine();
    void output(std::size_t k);
    void input(std::size_t k);

    const Model& model_;
    const Plant& plant_;
    const Experiment& experiment_;
    const Recording& base_;
    Groups shafts_, wired_;
    std::vector<Proposal> list_;
};

inline void Catalogue::shaft(std::size_t k) {
    const Piece& b = plant_.pieces[k];
    // A rigid shaft is one place: its last piece stands for it.
    if (k + 1 < plant_.pieces.size() && plant_.joints[k].rigid) return;
    const auto at = shafts_.members(b.connector);
    const bool ridesOnGear = k > 0 && !plant_.joints[k - 1].rigid;
    const bool massless = b.inertia == 0.0 && ridesOnGear;
    const double tau = base_.rmsTorque[k], w = std::max(base_.maxSpeed[k], 1e-9);
    const double angle = std::max(base_.angleMax[k] - base_.angleMin[k], 1e-9);
    const int what = static_cast<int>(k);
    const bool turns = angle > 3.0 * std::numbers::pi, slow = w * experiment_.dt < 0.35;
    add({"friction.coulomb", at, what}, 0.1 * tau, 0.7 * tau, false, {{}}, named("tau_c"));
    if (!massless) {
        const auto stribeck = [](double s, const Parameters& shape) {
            return Parameters{{"tau_s", s}, {"tau_c", s * get(shape, "ratio", 1.0)}, {"w_s", get(shape, "w_s", 1.0)}};
        };
        std::vector<Parameters> shapes;
        for (double f : {0.04, 0.1, 0.25}) shapes.push_back({{"ratio", 1.0}, {"w_s", rounded(f * w, 2)}});
        add({"friction.stribeck", at, what}, 0.07 * tau, 0.35 * tau, false, shapes, stribeck, {"ratio", "w_s"});
    }
    add({"friction.viscous", at, what}, 0.1 * tau / w, 1.5 * tau / w, false, {{}}, named("b"));
    if (b.quadratic == 0.0)
        add({"drag.quadratic", at, what}, 0.1 * tau / (w * w), 1.5 * tau / (w * w), false, {{}}, named("k_q"));
    add({"torque.constant", at, what}, 0.1 * tau, 0.7 * tau, true, {{}}, named("tau_0"));
    if (slow && (turns || b.spring > 0.0)) {
        std::vector<Parameters> phases, counts;
        for (double phase : {0.0, 0.9, 1.8, 2.7}) phases.push_back({{"phi_0", phase}});
        add({"torque.gravity", at, what}, 0.1 * tau, 0.7 * tau, true, phases, named("tau_g"), {"phi_0"});
        for (int n : {2, 3, 4, 6})
            if (w * n * experiment_.dt < 0.7)
                for (double phase : {0.0, 0.25, 0.5, 0.75})
                    counts.push_back({{"n", n}, {"phi_0", rounded(phase * 2.0 * std::numbers::pi / n, 3)}});
        if (!counts.empty())
            add({"torque.cogging", at, what}, 0.1 * tau, 0.7 * tau, false, counts, named("tau_n"), {"phi_0"});
    }
    if (slow) {
        const double middle = 0.5 * (base_.angleMax[k] + base_.angleMin[k]);
        std::vector<Parameters> rests{{{"phi_r", 0.0}}};
        if (b.spring > 0.0)
            rests = {{{"phi_r", -rounded(2.0 * angle, 2)}}, {{"phi_r", rounded(2.0 * angle, 2)}}};
        else
            rests.push_back({{"phi_r", rounded(middle, 2)}});
        add({"spring.return", at, what}, 0.1 * tau / angle, 1.5 * tau / angle, false, rests, named("c_r"), {"phi_r"});
    }
    if (!massless) add({"inertia.added", at, what}, 0.1 * b.inertia, 2.0 * b.inertia, false, {{}}, named("J"));
}

inline void Catalogue::outsideShaft(Random& random) {
    const std::size_t k = plant_.pieces.size() - 1;
    const int what = static_cast<int>(k);
    const auto at = shafts_.members(plant_.pieces[k].connector);
    const double tau = base_.rmsTorque[k], w = std::max(base_.maxSpeed[k], 1e-9);
    const double angle = base_.angleMax[k] - base_.angleMin[k], duration = experiment_.duration();
    add({"x.cubic", at, what}, 0.1 * tau / (w * w * w), 3.0 * tau / (w * w * w), false, {{}}, named("k_c"));
    add({"x.periodic", at, what}, 0.05 * tau, tau, false,
        {{{"period", rounded(duration * random.uniform(0.03, 0.12), 3)}}}, named("tau"));
    const bool spring = plant_.pieces[k].spring > 0.0;
    if (w * experiment_.dt < 0.35 && !spring && angle > 3.0 * std::numbers::pi)
        add({"x.sawtooth", at, what}, 0.05 * tau, tau, false, {{}}, named("tau"));
    if (spring) {
        add({"x.hysteresis", at, what}, 0.1 * tau, tau, false,
            {{{"travel", rounded(random.uniform(0.08, 0.2) * angle, 3)}}}, named("tau"));
        add({"x.hardening", at, what}, 0.1 * tau / std::pow(angle, 3), 3.0 * tau / std::pow(angle, 3), false, {{}},
            named("c_3"));
        const double from = base_.angleMin[k] + random.uniform(0.2, 0.6) * angle;
        if (plant_.pieces[k].inertia > 0.0)
            add({"x.rub", at, what}, 0.1 * tau, 0.8 * tau, false,
                {{{"from", rounded(from, 3)}, {"to", rounded(from + random.uniform(0.1, 0.25) * angle, 3)}}},
                named("tau"));
    }
    // what is driven both ways may run against its end
    const double top = base_.angleMax[k];
    const bool returns =
        spring || (angle < 20.0 * std::numbers::pi && base_.angleMin[k] > -0.7 * angle && top > 0.3 * angle);
    if (returns && plant_.pieces[k].inertia > 0.0)
        add({"x.stop", at, what}, 0.1, 0.5, false, {{}}, [top](double s, const Parameters&) {
            return Parameters{{"phi_max", top * (1.0 - s)}};
        });
}

/// Insertion between two pieces that are wired to nothing else there and both have inertia.
inline void Catalogue::joint(std::size_t k) {
    const Joint& j = plant_.joints[k];
    const Piece &a = plant_.pieces[k], &b = plant_.pieces[k + 1];
    if (!j.rigid || j.left.empty() || a.inertia == 0.0 || b.inertia == 0.0 || wired_.members(j.left).size() != 2)
        return;
    std::vector<std::string> at{j.left, j.right};
    std::sort(at.begin(), at.end());
    const double J = a.inertia * b.inertia / (a.inertia + b.inertia);
    const double total = a.inertia + b.inertia;
    const double tau = base_.rmsTorque[k + 1], w = std::max(base_.maxSpeed[k + 1], 1e-9);
    const int what = static_cast<int>(k);
    // Soft enough to be seen in the samples: typical angular frequency 1/(6 dt); damping 0.3 of critical.
    const double c = total * std::pow(1.0 / (6.0 * experiment_.dt), 2);
    const auto compliance = [J](double s, const Parameters& shape) {
        return Parameters{{"1/c", s}, {"d", rounded(2.0 * get(shape, "zeta", 0.3) * std::sqrt(J / s), 4)}};
    };
    add({"compliance.shaft", at, what}, 1.0 / c, 400.0 / c, false, {{{"zeta", 0.3}}, {{"zeta", 0.1}}, {{"zeta", 0.8}}},
        compliance, {"zeta"});
    const bool reverses =
        base_.angleMin[k + 1] < -0.2 || plant_.pieces[k + 1].spring > 0.0 || plant_.pieces[k].spring > 0.0;
    if (!reverses || w * experiment_.dt > 0.35) return;
    double stiffness = 1.5 * std::max(plant_.joints[k - 1].stiffness, tau / 0.1);
    stiffness = rounded(stiffness, 2);
    const double damping = rounded(0.5 * std::sqrt(stiffness * J), 3);
    add({"backlash", at, what}, 0.05, 0.6, false, {{{"c", stiffness}, {"d", damping}}}, named("b"), {"c"});
}

inline void Catalogue::node(std::size_t k) {
    const Node& n = plant_.nodes[k];
    const int what = static_cast<int>(k);
    const double range = std::max(base_.maxT[k] - base_.minT[k], 1.0), C = n.capacity, T = experiment_.duration();
    double G = 0.0;  // of what is there already
    for (const auto& l : plant_.links)
        if (l.from == what || l.to == what)
            G += l.conductance * (l.convective ? std::pow(0.5 * (base_.maxT[k] + base_.minT[k]) / 3.6, 0.78) : 1.0);
    const double power = std::max(G, C / T);
    add({"thermal.loss", n.connectors, what}, 0.1 * power, 1.5 * power, false, {{{"T_amb", 293.15}}}, named("G"));
    const double fourth = std::pow(base_.maxT[k], 4) - std::pow(293.15, 4);
    add({"thermal.radiation", n.connectors, what}, 0.1 * power * range / fourth, 2.0 * power * range / fourth, false,
        {{{"T_amb", 293.15}}}, named("k_r"));
    std::vector<Parameters> masses, latents;
    for (double slow : {0.03, 0.1, 0.3}) masses.push_back({{"time", rounded(slow * T, 2)}});
    // The conductance is the strength: it is what makes the second mass disappear.
    const auto mass = [C](double s, const Parameters& shape) {
        return Parameters{{"C2", s * C}, {"G2", rounded(s * C / get(shape, "time", 1.0), 4)}};
    };
    add({"thermal.mass", n.connectors, what}, 0.1, 3.0, false, masses, mass, {"time"});
    for (double f : {0.2, 0.4}) {
        double at = std::round(base_.minT[k] + f * range), width = std::max(2.0, std::round(0.06 * range));
        if (base_.minT[k] < 350.0 && base_.maxT[k] > 390.0) at = f < 0.3 ? 373.0 : 353.0, width = f < 0.3 ? 12.0 : 20.0;
        latents.push_back({{"T_l", at}, {"width", width}});
    }
    add({"thermal.latent", n.connectors, what}, 0.05 * C * range, 1.0 * C * range, false, latents, named("Q_l"),
        {"T_l", "width"});
}

inline void Catalogue::link(std::size_t k) {
    const Link& l = plant_.links[k];
    const int what = static_cast<int>(k);
    if (l.to >= 0 || !l.convective) return;
    const auto from = static_cast<std::size_t>(l.from);
    const double mid = 0.5 * (base_.minT[from] + base_.maxT[from]);
    const double G = l.conductance * std::pow(mid / 3.6, 0.78);
    if (!l.left.empty()) {
        std::vector<std::string> at{l.left, l.right};
        std::sort(at.begin(), at.end());
        add({"thermal.resistance", at, what}, 0.1 / G, 4.0 / G, false, {{}}, named("1/G"));
    }
    const double range = std::max(base_.maxT[from] - base_.minT[from], 1.0);
    add({"convection.exponent", {l.component}, what}, 0.1, 0.6, false, {{{"dT_ref", rounded(0.3 * range, 1)}}},
        named("exponent"));
    if (!experiment_.flow.empty()) {
        double mean = 0.0;
        for (double f : experiment_.flow) mean += f / static_cast<double>(experiment_.flow.size());
        add({"convection.flow", {l.component}, what}, 0.2, 1.2, false, {{{"ref", rounded(mean, 1)}}},
            named("exponent"));
    }
}

inline void Catalogue::machine() {
    const Machine& m = plant_.machine;
    if (m.drive == Drive::None) return;
    const std::vector<std::string> at{m.name};
    add({"voltage.drop", at, 0}, 0.02 * base_.maxVoltage, 0.2 * base_.maxVoltage, false, {{}}, named("V_b"));
    if (m.drive == Drive::Heater) {
        add({"resistance.series", at, 0}, 0.05 * m.R, 0.8 * m.R, false, {{}}, named("R_s"));
        const auto heatPort = wired_.members(m.name + ".heatPort");
        std::vector<std::string> ends{m.name + ".heatPort"};
        if (heatPort.size() == 2) ends = heatPort;
        const double hot = 0.05 * (base_.maxT[static_cast<std::size_t>(m.node)] - 280.0);
        add({"thermal.resistance", ends, -1}, hot / base_.maxHeat, 15.0 * hot / base_.maxHeat, false, {{}},
            named("1/G"));
        return;
    }
    if (m.L > 0.0)
        add({"inductance.saturation", at, 0}, 1.0 / base_.maxCurrent, 6.0 / base_.maxCurrent, false, {{}},
            named("1/i_s"));
    const double loss = m.R * base_.rmsCurrent * base_.rmsCurrent, T = experiment_.duration();
    std::vector<Parameters> windings;
    if (m.jouleNode >= 0) {
        windings = {{}};
    } else {
        // A winding that ends at some 60 K over ambient, with a time constant of a third of the record or more.
        for (double slow : {0.3, 1.0}) {
            const double G = rounded(loss / 60.0, 2);
            windings.push_back({{"C_w", rounded(G * slow * T, 2)}, {"G_w", G}});
        }
    }
    const std::vector<std::string> freed =
        m.jouleNode >= 0 ? std::vector<std::string>{} : std::vector<std::string>{"C_w", "G_w"};
    add({"resistance.temperature", at, 0}, 0.001, m.jouleNode >= 0 ? 0.006 : 0.012, false, windings, named("alpha"),
        freed);
    add({"flux.temperature", at, 0}, 0.0005, 0.005, false, windings, named("beta"), freed);
}

inline void Catalogue::output(std::size_t k) {
    const std::vector<std::string> at{"output " + model_.names(false)[k]};
    const int what = static_cast<int>(k);
    const double dt = experiment_.dt, T = experiment_.duration();
    const auto [low, high] = std::minmax_element(base_.outputs[k].begin(), base_.outputs[k].end());
    const double range = *high - *low;
    add({"sensor.lag", at, what}, 2.0 * dt, 0.05 * T, false, {{}}, named("tau"));
    add({"sensor.delay", at, what}, 2.0 * dt, 0.03 * T, false, {{}}, named("delay"));
    add({"sensor.offset", at, what}, 0.01 * range, 0.15 * range, true, {{}}, named("offset"));
    add({"sensor.drift", at, what}, 0.02 * range / T, 0.25 * range / T, true, {{}}, named("drift"));
    if (plant_.sensors[k].quantity == Quantity::Temperature)
        add({"sensor.gain", at, what}, 0.01, 0.15, true, {{}}, [](double s, const Parameters&) {
            return Parameters{{"gain", 1.0 + s}};
        });
}

inline void Catalogue::input(std::size_t k) {
    const std::vector<std::string> at{"input " + model_.names(true)[k]};
    const int what = static_cast<int>(k);
    const double dt = experiment_.dt, T = experiment_.duration();
    const auto [low, high] = std::minmax_element(experiment_.inputs[k].begin(), experiment_.inputs[k].end());
    const bool voltage = what == plant_.machine.voltageInput;
    const double top = std::max(std::abs(*low), std::abs(*high)), range = *high - *low;
    add({"actuator.lag", at, what}, voltage ? 2.0 * dt : 0.01 * T, voltage ? 0.03 * T : 0.15 * T, false, {{}},
        named("tau"));
    add({"actuator.delay", at, what}, voltage ? 2.0 * dt : 0.01 * T, voltage ? 0.02 * T : 0.1 * T, false, {{}},
        named("delay"));
    add({"actuator.offset", at, what}, 0.01 * range, 0.2 * range, true, {{}}, named("offset"));
    add({"actuator.gain", at, what}, 0.01, 0.2, true, {{}}, [](double s, const Parameters&) {
        return Parameters{{"gain", 1.0 + s}};
    });
    if (!voltage) return;
    add({"actuator.deadzone", at, what}, 0.02 * top, 0.25 * top, false, {{}}, named("width"));
    add({"actuator.saturation", at, what}, 0.1, 0.5, false, {{}}, [top](double s, const Parameters&) {
        return Parameters{{"limit", top * (1.0 - s)}};
    });
}

}  // namespace bench
