#include <gtest/gtest.h>

#include <cmath>

#include "tests/resources/bench.hpp"

/// Electric machine and heater against solutions by hand.
namespace analogon::bench {
namespace {

TEST(BasicElectricMechanical, CurrentOfAHeldRotorRisesWithLOverR) {
    const double v = 6, R = 1.5, L = 0.03, k = 0.04;
    const Recording r = run(R"(
  Analogon.Sources.Constant supply(k=6);
  Analogon.ElectricMechanical.BasicElectricMechanical motor(R=1.5, L=0.03, k=0.04);
  Analogon.Sensors.TorqueSensor brake;
  Analogon.Mechanics.Fixed wall;
  Analogon.Interfaces.RealOutput i, tau;
equation
  connect(supply.y, motor.v);
  connect(motor.flange, brake.flange_a);
  connect(brake.flange_b, wall.flange);
  connect(motor.i, i);
  connect(brake.tau, tau);)",
                            0.2);
    ASSERT_EQ(r.fault, "");
    const auto current = [&](double t) { return v / R * (1 - std::exp(-R / L * t)); };
    EXPECT_LT(worst(r, "i", current), 1e-6);
    EXPECT_LT(worst(r, "tau", [&](double t) { return k * current(t); }), 1e-7);
}

TEST(BasicElectricMechanical, RunsUpToItsNoLoadSpeed) {
    const double v = 6, R = 1.5, k = 0.04, J = 1e-4;
    const Recording r = run(R"(
  Analogon.Sources.Constant supply(k=6);
  Analogon.ElectricMechanical.BasicElectricMechanical motor(R=1.5, L=0, k=0.04);
  Analogon.Mechanics.Inertia rotor(J=1e-4);
  Analogon.Sensors.SpeedSensor speed;
  Analogon.Interfaces.RealOutput i, w;
equation
  connect(supply.y, motor.v);
  connect(motor.flange, rotor.flange_a);
  connect(rotor.flange_b, speed.flange);
  connect(motor.i, i);
  connect(speed.w, w);)",
                            0.5);
    ASSERT_EQ(r.fault, "");
    const double rate = k * k / (R * J);
    EXPECT_LT(worst(r, "w", [&](double t) { return v / k * (1 - std::exp(-rate * t)); }), 1e-4);
    EXPECT_LT(worst(r, "i", [&](double t) { return v / R * std::exp(-rate * t); }), 1e-6);
}

// With L the machine is a second-order lag: L J w'' + R J w' + k^2 w = k v.
TEST(BasicElectricMechanical, SwingsBetweenInductanceAndInertia) {
    const double v = 6, R = 0.4, L = 0.05, k = 0.1, J = 2e-4;
    const Recording r = run(R"(
  Analogon.Sources.Constant supply(k=6);
  Analogon.ElectricMechanical.BasicElectricMechanical motor(R=0.4, L=0.05, k=0.1);
  Analogon.Mechanics.Inertia rotor(J=2e-4);
  Analogon.Sensors.SpeedSensor speed;
  Analogon.Interfaces.RealOutput w;
equation
  connect(supply.y, motor.v);
  connect(motor.flange, rotor.flange_a);
  connect(rotor.flange_b, speed.flange);
  connect(speed.w, w);)",
                            0.5);
    ASSERT_EQ(r.fault, "");
    const double decay = R / (2 * L), omega = std::sqrt(k * k / (L * J) - decay * decay);
    EXPECT_LT(worst(r, "w",
                    [&](double t) {
                        return v / k *
                               (1 - std::exp(-decay * t) * (std::cos(omega * t) + decay / omega * std::sin(omega * t)));
                    }),
              1e-5);
}

TEST(BasicElectricThermal, DrawsLessCurrentWhenItIsHot) {
    const Recording r = run(R"(
  Analogon.Interfaces.RealInput v(unit="V"), T(unit="K");
  Analogon.ElectricThermal.BasicElectricThermal heater(R=2.5, alpha=0.004);
  Analogon.Sources.PrescribedTemperature bath;
  Analogon.Sensors.HeatFlowSensor given;
  Analogon.Interfaces.RealOutput i, Q;
equation
  connect(v, heater.v);
  connect(T, bath.T);
  connect(heater.heatPort, given.port_a);
  connect(given.port_b, bath.port);
  connect(heater.i, i);
  connect(given.Q_flow, Q);)",
                            10, 11, {[](double) { return 12.0; }, [](double t) { return 293.15 + 50 * t; }});
    ASSERT_EQ(r.fault, "");
    const auto resistance = [](double t) { return 2.5 * (1 + 0.004 * 50 * t); };
    EXPECT_LT(worst(r, "i", [&](double t) { return 12 / resistance(t); }), 1e-9);
    EXPECT_LT(worst(r, "Q", [&](double t) { return 144 / resistance(t); }), 1e-8);
}

// alpha = 0: a constant power into a body of capacity C.
TEST(BasicElectricThermal, HeatsABody) {
    const Recording r = run(R"(
  Analogon.Sources.Constant supply(k=10);
  Analogon.ElectricThermal.BasicElectricThermal heater(R=4);
  Analogon.Thermal.HeatCapacitor body(C=50, T_start=300);
  Analogon.Sensors.TemperatureSensor sensor;
  Analogon.Interfaces.RealOutput T;
equation
  connect(supply.y, heater.v);
  connect(heater.heatPort, body.port);
  connect(body.port, sensor.port);
  connect(sensor.T, T);)",
                            20);
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "T", [](double t) { return 300 + 0.5 * t; }), 1e-6);
}

}  // namespace
}  // namespace analogon::bench
