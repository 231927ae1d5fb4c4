#pragma once

#include "tests/core/structure/model_builder.hpp"

/// Small physical models, written as flattening would leave them: connectors, flow sums and all.
namespace analogon::test {

/// C*der(T) = Q_flow - G*(T - T_amb), T(0) = T_start, y = T.
inline std::shared_ptr<const FlatModel> thermalMass() {
    ModelBuilder m("ThermalMass");
    m.parameter("C", 5);
    m.parameter("G", 0.4);
    m.parameter("T_start", 300);
    m.input("Q_flow");
    m.input("T_amb");
    m.output("T_out");
    m.variables({"mass.port.T", "mass.port.Q_flow", "mass.T", "loss.Q_flow", "loss.port_a.T", "loss.port_a.Q_flow",
                 "source.port.Q_flow", "source.port.T"});
    m.component("mass");
    m.eq(m.v("mass.T"), m.v("mass.port.T"));
    m.eq(m.v("C") * m.der("mass.T"), m.v("mass.port.Q_flow"));
    m.start("mass.T", m.v("T_start"));
    m.component("loss");
    m.eq(m.v("loss.Q_flow"), m.v("G") * (m.v("loss.port_a.T") - m.v("T_amb")));
    m.eq(m.v("loss.port_a.Q_flow"), m.v("loss.Q_flow"));
    m.component("source");
    m.eq(m.v("source.port.Q_flow"), -m.v("Q_flow"));
    m.component("");
    m.eq(m.v("mass.port.T"), m.v("loss.port_a.T"));
    m.eq(m.v("mass.port.T"), m.v("source.port.T"));
    m.eq(m.v("mass.port.Q_flow") + m.v("loss.port_a.Q_flow") + m.v("source.port.Q_flow"), 0);
    m.eq(m.v("T_out"), m.v("mass.T"));
    return m.model();
}

enum class Load { None, Quadratic, Viscous };

/// A direct-current motor, its shaft of two inertias around a spring-damper with ratio r (BasicMechanics), and a
/// load: v = R*i + L*der(i) + k*w; the equations of the blocks as in the library.
inline std::shared_ptr<const FlatModel> motorWithShaft(double J2, double L, Load load) {
    ModelBuilder m("MotorWithShaft");
    for (const auto& [name, value] : std::initializer_list<std::pair<const char*, double>>{{"R", 2},
                                                                                           {"L", L},
                                                                                           {"k", 0.05},
                                                                                           {"r", 2},
                                                                                           {"J1", 1e-4},
                                                                                           {"J2", J2},
                                                                                           {"c", 3},
                                                                                           {"d", 0.02},
                                                                                           {"k_q", 1e-3},
                                                                                           {"b", 0.02}})
        m.parameter(name, value);
    m.input("v");
    m.output("i_out");
    m.output("w_out");
    m.variables({"motor.v", "motor.i", "motor.flange.phi", "motor.flange.tau", "shaft.flange_a.phi",
                 "shaft.flange_a.tau", "shaft.flange_b.phi", "shaft.flange_b.tau", "shaft.phi1", "shaft.phi2",
                 "shaft.w1", "shaft.w2", "shaft.tau_s", "load.flange.phi", "load.flange.tau", "load.w"});
    m.component("motor");
    m.eq(m.v("motor.v"),
         m.v("R") * m.v("motor.i") + m.v("L") * m.der("motor.i") + m.v("k") * m.der("motor.flange.phi"));
    m.eq(m.v("motor.flange.tau"), -(m.v("k") * m.v("motor.i")));
    m.component("shaft");
    m.eq(m.v("shaft.phi1"), m.v("shaft.flange_a.phi"));
    m.eq(m.v("shaft.phi2"), m.v("shaft.flange_b.phi"));
    m.eq(m.v("shaft.w1"), m.der("shaft.phi1"));
    m.eq(m.v("shaft.w2"), m.der("shaft.phi2"));
    m.eq(m.v("r") * m.v("J1") * m.der("shaft.w1"), m.v("r") * m.v("shaft.flange_a.tau") - m.v("shaft.tau_s"));
    m.eq(m.v("J2") * m.der("shaft.w2"), m.v("shaft.tau_s") + m.v("shaft.flange_b.tau"));
    m.eq(m.v("shaft.tau_s"), m.v("c") * (m.v("shaft.phi1") / m.v("r") - m.v("shaft.phi2")) +
                                 m.v("d") * (m.v("shaft.w1") / m.v("r") - m.v("shaft.w2")));
    m.component("load");
    m.eq(m.v("load.w"), m.der("load.flange.phi"));
    if (load == Load::Quadratic)
        m.eq(m.v("load.flange.tau"), m.v("k_q") * m.v("load.w") * m.f(Operation::Abs, m.v("load.w")));
    else if (load == Load::Viscous)
        m.eq(m.v("load.flange.tau"), m.v("b") * m.v("load.w"));
    else
        m.eq(m.v("load.flange.tau"), 0);
    m.component("");
    m.eq(m.v("motor.v"), m.v("v"));
    m.eq(m.v("motor.flange.phi"), m.v("shaft.flange_a.phi"));
    m.eq(m.v("motor.flange.tau") + m.v("shaft.flange_a.tau"), 0);
    m.eq(m.v("shaft.flange_b.phi"), m.v("load.flange.phi"));
    m.eq(m.v("shaft.flange_b.tau") + m.v("load.flange.tau"), 0);
    m.eq(m.v("i_out"), m.v("motor.i"));
    m.eq(m.v("w_out"), m.v("shaft.w2"));
    return m.model();
}

/// Two inertias on one rigid shaft; the first is driven by `tau`.
inline std::shared_ptr<const FlatModel> rigidInertias() {
    ModelBuilder m("RigidInertias");
    m.parameter("J1", 0.02);
    m.parameter("J2", 0.03);
    m.input("tau");
    m.output("w");
    m.variables(
        {"a.flange.phi", "a.flange.tau", "a.phi", "a.w", "a.a", "b.flange.phi", "b.flange.tau", "b.phi", "b.w", "b.a"});
    for (const std::string name : {"a", "b"}) {
        m.component(name);
        m.eq(m.v(name + ".phi"), m.v(name + ".flange.phi"));
        m.eq(m.v(name + ".w"), m.der(name + ".phi"));
        m.eq(m.v(name + ".a"), m.der(name + ".w"));
        const auto torque = m.v(name + ".flange.tau");
        m.eq(m.v(name == "a" ? "J1" : "J2") * m.v(name + ".a"), name == "a" ? torque + m.v("tau") : torque);
    }
    m.component("");
    m.eq(m.v("a.flange.phi"), m.v("b.flange.phi"));
    m.eq(m.v("a.flange.tau") + m.v("b.flange.tau"), 0);
    m.eq(m.v("w"), m.v("b.w"));
    return m.model();
}

/// Two inertias coupled by an ideal gear phi1 = r*phi2.
inline std::shared_ptr<const FlatModel> gearedInertias() {
    ModelBuilder m("GearedInertias");
    m.parameter("J1", 0.02);
    m.parameter("J2", 0.5);
    m.parameter("r", 4);
    m.input("tau");
    m.output("w");
    m.variables({"phi1", "w1", "tau1", "phi2", "w2", "tau2"});
    m.component("motor");
    m.eq(m.v("w1"), m.der("phi1"));
    m.eq(m.v("J1") * m.der("w1"), m.v("tau") + m.v("tau1"));
    m.component("wheel");
    m.eq(m.v("w2"), m.der("phi2"));
    m.eq(m.v("J2") * m.der("w2"), m.v("tau2"));
    m.component("gear");
    m.eq(m.v("phi1"), m.v("r") * m.v("phi2"));
    m.eq(m.v("tau2"), -(m.v("r") * m.v("tau1")));
    m.component("");
    m.eq(m.v("w"), m.v("w2"));
    m.start("phi2", 0.1);
    m.start("w2", 2);
    return m.model();
}

/// A temperature is imposed on a capacitance by an input, through a chain of connectors: the heat that flows
/// needs the derivative of the input.
inline std::shared_ptr<const FlatModel> prescribedTemperature() {
    ModelBuilder m("PrescribedTemperature");
    m.parameter("C", 12);
    m.parameter("G", 0.5);
    m.input("T_in");
    m.output("Q");
    m.variables({"source.port.T", "source.port.Q_flow", "mass.T", "mass.port.T", "mass.port.Q_flow", "far.T"});
    m.component("source");
    m.eq(m.v("source.port.T"), m.v("T_in"));
    m.component("mass");
    m.eq(m.v("mass.T"), m.v("mass.port.T"));
    m.eq(m.v("C") * m.der("mass.T"), m.v("mass.port.Q_flow") - m.v("G") * (m.v("mass.T") - m.v("far.T")));
    m.component("far");
    m.eq(3.0 * m.der("far.T"), m.v("G") * (m.v("mass.T") - m.v("far.T")));
    m.start("far.T", 290);
    m.component("");
    m.eq(m.v("source.port.T"), m.v("mass.port.T"));
    m.eq(m.v("source.port.Q_flow") + m.v("mass.port.Q_flow"), 0);
    m.eq(m.v("Q"), m.v("mass.port.Q_flow"));
    return m.model();
}

}  // namespace analogon::test
