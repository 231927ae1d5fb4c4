// Studies on models that are drawn with the Modelica Standard Library, each with something in the recording that the
// model lacks. The recordings are made here, by equations of their own; without the library the tests are skipped.
#include "standard_library_study.hpp"

namespace analogon {
namespace {

using test::Command;
using test::DiscoveryInStandardLibrary;
using test::dryFriction;

// ------------------------------------------------------------------------------------------ a DC machine

constexpr const char* machineText = R"(model Drive "Machine, rotor and bearing"
  Modelica.Blocks.Interfaces.RealInput v(unit="V");
  Modelica.Blocks.Interfaces.RealOutput i(unit="A");
  Modelica.Blocks.Interfaces.RealOutput w(unit="rad/s");
  Modelica.Electrical.Analog.Sources.SignalVoltage supply;
  Modelica.Electrical.Analog.Basic.Resistor resistor(R=1);
  Modelica.Electrical.Analog.Basic.Inductor inductor(L=2e-3);
  Modelica.Electrical.Analog.Basic.RotationalEMF emf(k=0.04);
  Modelica.Electrical.Analog.Basic.Ground ground;
  Modelica.Electrical.Analog.Sensors.CurrentSensor ammeter;
  Modelica.Mechanics.Rotational.Components.Inertia rotor(J=2e-4, phi(fixed=true, start=0), w(fixed=true, start=0));
  Modelica.Mechanics.Rotational.Components.BearingFriction bearing(tau_pos=[0, 0.015; 200, 0.035]);
  Modelica.Mechanics.Rotational.Sensors.SpeedSensor tacho;
equation
  connect(v, supply.v);
  connect(supply.p, resistor.p);
  connect(resistor.n, inductor.p);
  connect(inductor.n, emf.p);
  connect(emf.n, ammeter.p);
  connect(ammeter.n, supply.n);
  connect(supply.n, ground.p);
  connect(emf.flange, rotor.flange_a);
  connect(rotor.flange_b, bearing.flange_a);
  connect(bearing.flange_b, tacho.flange);
  connect(ammeter.i, i);
  connect(tacho.w, w);
end Drive;
)";

TEST_F(DiscoveryInStandardLibrary, FindsTheLagOfATachometer) {
    put("model.mo", machineText);
    putStudy(
        "Drive", R"("v": "v")", R"("i": "i", "w": "w")",
        R"("resistor.R": {"fit": true, "min": 0.1, "max": 10}, "inductor.L": {"fit": true, "min": 1e-4, "max": 0.1},
                "emf.k": {"fit": true, "min": 0.005, "max": 0.5}, "rotor.J": {"fit": true, "min": 1e-5, "max": 0.01})");
    for (const auto& [file, first] : {std::pair("fit.csv", 0), std::pair("check.csv", 4)}) {
        const Command command{0.005, 60, -12, 12, first};
        // current, speed, what the tachometer shows
        record<3>(
            file, "v [V]", command, 500, 20, {},
            [&](double t, const std::array<double, 3>& x) {
                const double driven = 0.05 * x[0];
                const double friction = dryFriction(driven + 0.3 * x[1], x[1], 0.015 + 1e-4 * std::abs(x[1]), 1e-2);
                return std::array<double, 3>{(command(t) - 1.3 * x[0] - 0.05 * x[1]) / 3e-3, (driven - friction) / 3e-4,
                                             (x[1] - x[2]) / 0.02};
            },
            {{"i [A]", 0.02}, {"w [rad/s]", 0.3}},
            [](double, const std::array<double, 3>& x) {
                return std::vector<double>{x[0], x[2]};
            });
    }
    expectFound(discovered(), "sensor.lag", "output w", 0.02, 4e-4, {{"i [A]", 0.02}, {"w [rad/s]", 0.3}});
}

// ------------------------------------------------------------------------------------------ a heated body

constexpr const char* heatedText = R"(model Heated "A heater on a plate"
  Modelica.Blocks.Interfaces.RealInput P(unit="W");
  Modelica.Blocks.Interfaces.RealOutput T_heater(unit="K");
  Modelica.Blocks.Interfaces.RealOutput T_plate(unit="K");
  Modelica.Thermal.HeatTransfer.Sources.PrescribedHeatFlow source;
  Modelica.Thermal.HeatTransfer.Components.HeatCapacitor heater(C=30, T(fixed=true, start=293.15));
  Modelica.Thermal.HeatTransfer.Components.ThermalConductor joint(G=0.8);
  Modelica.Thermal.HeatTransfer.Components.HeatCapacitor plate(C=100, T(fixed=true, start=293.15));
  Modelica.Thermal.HeatTransfer.Components.Convection convection;
  Modelica.Thermal.HeatTransfer.Sources.FixedTemperature ambient(T=293.15);
  Modelica.Blocks.Sources.Constant G(k=0.3);
  Modelica.Thermal.HeatTransfer.Sensors.TemperatureSensor sensor1;
  Modelica.Thermal.HeatTransfer.Sensors.TemperatureSensor sensor2;
equation
  connect(P, source.Q_flow);
  connect(source.port, heater.port);
  connect(heater.port, joint.port_a);
  connect(joint.port_b, plate.port);
  connect(plate.port, convection.solid);
  connect(convection.fluid, ambient.port);
  connect(G.y, convection.Gc);
  connect(heater.port, sensor1.port);
  connect(plate.port, sensor2.port);
  connect(sensor1.T, T_heater);
  connect(sensor2.T, T_plate);
end Heated;
)";

TEST_F(DiscoveryInStandardLibrary, FindsASecondHeatLoss) {
    put("model.mo", heatedText);
    putStudy("Heated", R"("P": "P")", R"("T_heater": "T_heater", "T_plate": "T_plate")",
             R"("heater.C": {"fit": true, "min": 1, "max": 1000}, "plate.C": {"fit": true, "min": 1, "max": 1000},
                "joint.G": {"fit": true, "min": 0.01, "max": 10}, "G.k": {"fit": true, "min": 0.01, "max": 10})");
    for (const auto& [file, first] : {std::pair("fit.csv", 0), std::pair("check.csv", 4)}) {
        const Command command{2, 60, 0, 50, first};
        constexpr double ambient = 293.15;
        record<2>(
            file, "P [W]", command, 600, 4, {ambient, ambient},
            [&](double t, const std::array<double, 2>& T) {
                const double joint = 1.1 * (T[0] - T[1]);
                const double radiation = 2e-9 * (std::pow(T[0], 4) - std::pow(ambient, 4));
                return std::array<double, 2>{(command(t) - joint - radiation) / 40,
                                             (joint - 0.4 * (T[1] - ambient)) / 150};
            },
            {{"T_heater [K]", 0.2}, {"T_plate [K]", 0.2}},
            [](double, const std::array<double, 2>& T) {
                return std::vector<double>{T[0], T[1]};
            });
    }
    expectFound(discovered(), "thermal.radiation", "source.port", 2e-9, 6e-11,
                {{"T_heater [K]", 0.2}, {"T_plate [K]", 0.2}});
}

// ------------------------------------------------------------------------------------------ an actuator

constexpr const char* actuatorText = R"(model Actuator "A magnet against a spring, with a stop"
  Modelica.Blocks.Interfaces.RealInput f(unit="N");
  Modelica.Blocks.Interfaces.RealOutput s(unit="m");
  Modelica.Mechanics.Translational.Sources.Force magnet;
  Modelica.Mechanics.Translational.Components.Mass armature(m=0.2, s(fixed=true, start=0), v(fixed=true, start=0));
  Modelica.Mechanics.Translational.Components.SpringDamper spring(c=600, d=5);
  Modelica.Mechanics.Translational.Components.Fixed housing;
  Modelica.Mechanics.Translational.Components.ElastoGap stop(c=3e4, d=50, s_rel0=0);
  Modelica.Mechanics.Translational.Components.Fixed seat(s0=0.012);
  Modelica.Mechanics.Translational.Sensors.PositionSensor position;
equation
  connect(f, magnet.f);
  connect(magnet.flange, armature.flange_a);
  connect(armature.flange_b, spring.flange_b);
  connect(spring.flange_a, housing.flange);
  connect(armature.flange_b, stop.flange_a);
  connect(stop.flange_b, seat.flange);
  connect(armature.flange_b, position.flange);
  connect(position.s, s);
end Actuator;
)";

TEST_F(DiscoveryInStandardLibrary, FindsTheDryFrictionOfAnActuatorWithAStop) {
    put("model.mo", actuatorText);
    putStudy("Actuator", R"("f": "f")", R"("s": "s")",
             R"("armature.m": {"fit": true, "min": 0.01, "max": 5}, "spring.c": {"fit": true, "min": 10, "max": 1e4},
                "spring.d": {"fit": true, "min": 0.1, "max": 100}, "stop.c": {"fit": true, "min": 1e3, "max": 1e6})");
    for (const auto& [file, first] : {std::pair("fit.csv", 0), std::pair("check.csv", 4)}) {
        const Command command{0.002, 60, 0, 14, first};
        record<2>(
            file, "f [N]", command, 1000, 40, {},
            [&](double t, const std::array<double, 2>& x) {
                const double gap = 0.012 - x[0];
                const double spring = std::min(0.0, 5e4 * gap);
                const double stop = gap < 0 ? spring + std::clamp(-50 * x[1], spring, -spring) : 0;
                const double driven = command(t) - 800 * x[0] - 7 * x[1] + stop;
                return std::array<double, 2>{x[1], (driven - dryFriction(driven + 250 * x[1], x[1], 0.8, 2e-4)) / 0.25};
            },
            {{"s [m]", 2e-5}}, [](double, const std::array<double, 2>& x) { return std::vector<double>{x[0]}; });
    }
    expectFound(discovered(), "friction.coulomb", "magnet.flange", 0.8, 0.01, {{"s [m]", 2e-5}});
}

// ------------------------------------------------------------------------------------------ a rectifier

constexpr const char* rectifierText = R"(model Rectifier "A diode into a filter and a load"
  Modelica.Blocks.Interfaces.RealInput v(unit="V");
  Modelica.Blocks.Interfaces.RealOutput i(unit="A");
  Modelica.Blocks.Interfaces.RealOutput u(unit="V");
  Modelica.Electrical.Analog.Sources.SignalVoltage supply;
  Modelica.Electrical.Analog.Basic.Resistor lead(R=0.5);
  Modelica.Electrical.Analog.Basic.Inductor coil(L=1e-3, i(fixed=true, start=0));
  Modelica.Electrical.Analog.Ideal.IdealDiode diode(Vknee=0.7);
  Modelica.Electrical.Analog.Basic.Capacitor filter(C=5e-4, v(fixed=true, start=0));
  Modelica.Electrical.Analog.Basic.Resistor load(R=20);
  Modelica.Electrical.Analog.Basic.Ground ground;
  Modelica.Electrical.Analog.Sensors.CurrentSensor ammeter;
  Modelica.Electrical.Analog.Sensors.VoltageSensor voltmeter;
equation
  connect(v, supply.v);
  connect(supply.p, lead.p);
  connect(lead.n, coil.p);
  connect(coil.n, diode.p);
  connect(diode.n, ammeter.p);
  connect(ammeter.n, filter.p);
  connect(ammeter.n, load.p);
  connect(filter.n, ground.p);
  connect(load.n, ground.p);
  connect(supply.n, ground.p);
  connect(voltmeter.p, load.p);
  connect(voltmeter.n, ground.p);
  connect(ammeter.i, i);
  connect(voltmeter.v, u);
end Rectifier;
)";

TEST_F(DiscoveryInStandardLibrary, FindsTheResistanceInsideAFilter) {
    put("model.mo", rectifierText);
    putStudy("Rectifier", R"("v": "v")", R"("i": "i", "u": "u")",
             R"("lead.R": {"fit": true, "min": 0.01, "max": 10}, "coil.L": {"fit": true, "min": 1e-5, "max": 0.1},
                "filter.C": {"fit": true, "min": 1e-5, "max": 0.01}, "load.R": {"fit": true, "min": 1, "max": 1000})");
    for (const auto& [file, first] : {std::pair("fit.csv", 0), std::pair("check.csv", 4)}) {
        const Command command{1e-4, 40, -10, 15, first};
        constexpr double within = 0.3, load = 25;                  // [Ohm] in the filter, of the load
        const auto voltage = [](const std::array<double, 2>& x) {  // of the load, by the current of both
            return (x[1] + within * x[0]) / (1 + within / load);
        };
        record<2>(
            file, "v [V]", command, 450, 40, {},
            [&](double t, const std::array<double, 2>& x) {
                const double drop = 0.8 * x[0] + voltage(x) + 0.7;
                const double rise = (command(t) - drop) / 1.5e-3;
                return std::array<double, 2>{x[0] <= 0 ? std::max(0.0, rise) - x[0] / 1e-5 : rise,
                                             (x[0] - voltage(x) / load) / 8e-4};
            },
            {{"i [A]", 0.02}, {"u [V]", 0.02}},
            [&](double, const std::array<double, 2>& x) {
                return std::vector<double>{x[0], voltage(x)};
            });
    }
    expectFound(discovered(), "resistance.series", "filter.p", 0.3, 0.01, {{"i [A]", 0.02}, {"u [V]", 0.02}});
}

// ------------------------------------------------------------------------------------------ a pump

constexpr const char* pumpText = R"(model Pump "A pump whose load and flow stand in tables"
  Modelica.Blocks.Interfaces.RealInput tau(unit="N.m");
  Modelica.Blocks.Interfaces.RealOutput w(unit="rad/s");
  Modelica.Blocks.Interfaces.RealOutput q;
  Modelica.Mechanics.Rotational.Sources.Torque motor;
  Modelica.Mechanics.Rotational.Components.Inertia wheel(J=1e-3, phi(fixed=true, start=0), w(fixed=true, start=0));
  Modelica.Mechanics.Rotational.Sources.Torque water;
  Modelica.Mechanics.Rotational.Sensors.SpeedSensor speed;
  Modelica.Blocks.Tables.CombiTable1Ds characteristic(table=[0, 0, 0; 50, -0.02, 0.2; 100, -0.09, 0.6; 200, -0.4, 1.3;
    300, -0.9, 1.9], smoothness=Modelica.Blocks.Types.Smoothness.ContinuousDerivative);
  Modelica.Blocks.Math.Gain loss(k=1);
  Modelica.Blocks.Math.Gain delivery(k=1);
equation
  connect(tau, motor.tau);
  connect(motor.flange, wheel.flange_a);
  connect(wheel.flange_b, water.flange);
  connect(wheel.flange_b, speed.flange);
  connect(speed.w, characteristic.u);
  connect(characteristic.y[1], loss.u);
  connect(loss.y, water.tau);
  connect(characteristic.y[2], delivery.u);
  connect(delivery.y, q);
  connect(speed.w, w);
end Pump;
)";

/// The cubic pieces of Akima through what a maker wrote down of the pump.
struct Characteristic {
    std::vector<double> x, y;
    double operator()(double at) const {
        const std::size_t n = x.size();
        std::vector<double> slope(n + 3);  // of the pieces, two more at either end
        for (std::size_t k = 0; k + 1 < n; ++k) slope[k + 2] = (y[k + 1] - y[k]) / (x[k + 1] - x[k]);
        slope[1] = 2 * slope[2] - slope[3];
        slope[0] = 2 * slope[1] - slope[2];
        slope[n + 1] = 2 * slope[n] - slope[n - 1];
        slope[n + 2] = 2 * slope[n + 1] - slope[n];
        const auto tangent = [&](std::size_t k) {
            const double a = std::abs(slope[k + 3] - slope[k + 2]), b = std::abs(slope[k + 1] - slope[k]);
            return a + b > 0 ? (a * slope[k + 1] + b * slope[k + 2]) / (a + b) : (slope[k + 1] + slope[k + 2]) / 2;
        };
        std::size_t k = 0;
        while (k + 2 < n && at > x[k + 1]) ++k;
        const double h = x[k + 1] - x[k], s = (at - x[k]) / h;
        return y[k] * (1 + 2 * s) * (1 - s) * (1 - s) + h * tangent(k) * s * (1 - s) * (1 - s) +
               y[k + 1] * s * s * (3 - 2 * s) + h * tangent(k + 1) * s * s * (s - 1);
    }
};

TEST_F(DiscoveryInStandardLibrary, FindsTheFrictionOfAPump) {
    put("model.mo", pumpText);
    putStudy("Pump", R"("tau": "tau")", R"("w": "w", "q": "q")",
             R"("wheel.J": {"fit": true, "min": 1e-5, "max": 0.1}, "loss.k": {"fit": true, "min": 0.1, "max": 10},
                "delivery.k": {"fit": true, "min": 0.1, "max": 10})");
    const std::vector<double> speeds{0, 50, 100, 200, 300};
    const Characteristic load{speeds, {0, 0.02, 0.09, 0.4, 0.9}}, flow{speeds, {0, 0.2, 0.6, 1.3, 1.9}};
    for (const auto& [file, first] : {std::pair("fit.csv", 0), std::pair("check.csv", 4)}) {
        const Command command{0.02, 60, 0.1, 0.9, first};
        record<1>(
            file, "tau [N.m]", command, 800, 20, {},
            [&](double t, const std::array<double, 1>& x) {
                return std::array<double, 1>{(command(t) - 1.1 * load(x[0]) - 6e-4 * x[0]) / 1.5e-3};
            },
            {{"w [rad/s]", 0.5}, {"q", 0.01}},
            [&](double, const std::array<double, 1>& x) {
                return std::vector<double>{x[0], 0.9 * flow(x[0])};
            });
    }
    expectFound(discovered(), "friction.viscous", "motor.flange", 6e-4, 1e-5, {{"w [rad/s]", 0.5}, {"q", 0.01}});
}

// ------------------------------------------------------------------------------------------ a machine as a whole

constexpr const char* wholeMachineText = R"(model Machine "A machine with a load"
  Modelica.Blocks.Interfaces.RealInput v(unit="V");
  Modelica.Blocks.Interfaces.RealOutput i(unit="A");
  Modelica.Blocks.Interfaces.RealOutput w(unit="rad/s");
  Modelica.Electrical.Machines.BasicMachines.DCMachines.DC_PermanentMagnet machine(VaNominal=100, IaNominal=100,
    wNominal=149.22565104552, TaNominal=293.15, Ra=0.05, TaRef=293.15, alpha20a=0, La=0.0015, Jr=0.15,
    TaOperational=293.15, phiMechanical(fixed=true, start=0), wMechanical(fixed=true, start=0), ia(fixed=true, start=0));
  Modelica.Electrical.Analog.Sources.SignalVoltage supply;
  Modelica.Electrical.Analog.Basic.Ground ground;
  Modelica.Electrical.Analog.Sensors.CurrentSensor ammeter;
  Modelica.Mechanics.Rotational.Components.Inertia load(J=0.15);
  Modelica.Mechanics.Rotational.Sensors.SpeedSensor tacho;
equation
  connect(v, supply.v);
  connect(supply.p, ammeter.p);
  connect(ammeter.n, machine.pin_ap);
  connect(machine.pin_an, supply.n);
  connect(supply.n, ground.p);
  connect(machine.flange, load.flange_a);
  connect(load.flange_b, tacho.flange);
  connect(ammeter.i, i);
  connect(tacho.w, w);
end Machine;
)";

TEST_F(DiscoveryInStandardLibrary, FindsTheFanOfAMachine) {
    put("model.mo", wholeMachineText);
    putStudy(
        "Machine", R"("v": "v")", R"("i": "i", "w": "w")",
        R"("machine.Ra": {"fit": true, "min": 0.005, "max": 1}, "machine.La": {"fit": true, "min": 1e-4, "max": 0.1},
                "load.J": {"fit": true, "min": 0.01, "max": 10})");
    const double k = (100 - 0.06 * 100) / 149.22565104552;  // [V.s]
    for (const auto& [file, first] : {std::pair("fit.csv", 0), std::pair("check.csv", 4)}) {
        const Command command{0.02, 60, -40, 100, first};
        record<2>(
            file, "v [V]", command, 800, 40, {},
            [&](double t, const std::array<double, 2>& x) {
                return std::array<double, 2>{(command(t) - 0.06 * x[0] - k * x[1]) / 2e-3,
                                             (k * x[0] - 1.5e-3 * x[1] * std::abs(x[1])) / (0.15 + 0.2)};
            },
            {{"i [A]", 1.5}, {"w [rad/s]", 0.3}},
            [](double, const std::array<double, 2>& x) {
                return std::vector<double>{x[0], x[1]};
            });
    }
    expectFound(discovered(), "drag.quadratic", "machine.flange", 1.5e-3, 3e-5, {{"i [A]", 1.5}, {"w [rad/s]", 0.3}});
}

}  // namespace
}  // namespace analogon
