#include <gtest/gtest.h>

#include <cmath>

#include "tests/resources/bench.hpp"

/// Thermal and fluid blocks against solutions by hand: all are a body that settles exponentially.
namespace analogon::bench {
namespace {

TEST(BasicThermalFluid, SettlesAtTheRateOfEquation8) {
    const double C = 4, G = 30 * 2e-3 * std::pow(600 / 3.6, 0.78), P = 25, gas = 600, start = 350;
    const Recording r = run(R"(
  Analogon.Sources.Constant power(k=25);
  Analogon.Sources.PrescribedHeatFlow heating;
  Analogon.ThermalFluid.BasicThermalFluid body(C=4, c_o=30, A=2e-3, T_start=350);
  Analogon.Sources.FixedTemperature gas(T=600);
  Analogon.Sensors.TemperatureSensor sensor;
  Analogon.Sensors.HeatFlowSensor given;
  Analogon.Interfaces.RealOutput T, Q;
equation
  connect(power.y, heating.Q_flow);
  connect(heating.port, body.solid);
  connect(body.solid, sensor.port);
  connect(body.fluid, given.port_a);
  connect(given.port_b, gas.port);
  connect(sensor.T, T);
  connect(given.Q_flow, Q);)",
                            10);
    ASSERT_EQ(r.fault, "");
    const double settled = gas + P / G;
    const auto temperature = [&](double t) { return settled + (start - settled) * std::exp(-G / C * t); };
    EXPECT_LT(worst(r, "T", temperature), 1e-5);
    EXPECT_LT(worst(r, "Q", [&](double t) { return G * (temperature(t) - gas); }), 1e-4);
}

TEST(ConvectionByFlowSpeed, SettlesFasterInAFasterStream) {
    const Recording r = run(R"(
  Analogon.Sources.Constant speed(k=72);
  Analogon.ThermalFluid.ConvectionByFlowSpeed body(C=4, c_o=7, A=0.01, T_start=350);
  Analogon.Sources.FixedTemperature gas(T=300);
  Analogon.Sensors.TemperatureSensor sensor;
  Analogon.Interfaces.RealOutput T;
equation
  connect(speed.y, body.speed);
  connect(body.fluid, gas.port);
  connect(body.solid, sensor.port);
  connect(sensor.T, T);)",
                            10);
    ASSERT_EQ(r.fault, "");
    const double G = 7 * 0.01 * std::pow(20, 0.78);
    EXPECT_LT(worst(r, "T", [&](double t) { return 300 + 50 * std::exp(-G / 4 * t); }), 1e-5);
}

TEST(ConvectionByFlowSpeed, TakesNoHeatWhenTheStreamStands) {
    const Recording r = run(R"(
  Analogon.Interfaces.RealInput v(unit="km/h");
  Analogon.ThermalFluid.ConvectionByFlowSpeed body(C=4, c_o=7, A=0.01, T_start=350);
  Analogon.Sources.FixedTemperature gas(T=300);
  Analogon.Sensors.TemperatureSensor sensor;
  Analogon.Interfaces.RealOutput T;
equation
  connect(v, body.speed);
  connect(body.fluid, gas.port);
  connect(body.solid, sensor.port);
  connect(sensor.T, T);)",
                            10, 11, {[](double) { return 0.0; }});
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "T", [](double) { return 350.0; }), 1e-9);
}

TEST(ThermalConductor, LetsTwoBodiesMeetInTheMiddle) {
    const double C1 = 20, C2 = 30, G = 1.5;
    const Recording r = run(R"(
  Analogon.Thermal.HeatCapacitor hot(C=20, T_start=400), cold(C=30, T_start=300);
  Analogon.Thermal.ThermalConductor wall(G=1.5);
  Analogon.Sensors.TemperatureSensor left, right;
  Analogon.Interfaces.RealOutput T1, T2;
equation
  connect(hot.port, wall.port_a);
  connect(wall.port_b, cold.port);
  connect(hot.port, left.port);
  connect(cold.port, right.port);
  connect(left.T, T1);
  connect(right.T, T2);)",
                            40);
    ASSERT_EQ(r.fault, "");
    const double middle = (C1 * 400 + C2 * 300) / (C1 + C2), rate = G * (1 / C1 + 1 / C2);
    EXPECT_LT(worst(r, "T1", [&](double t) { return middle + C2 / (C1 + C2) * 100 * std::exp(-rate * t); }), 1e-5);
    EXPECT_LT(worst(r, "T2", [&](double t) { return middle - C1 / (C1 + C2) * 100 * std::exp(-rate * t); }), 1e-5);
}

TEST(PrescribedTemperature, ImposesTheMeasuredTemperature) {
    const Recording r = run(R"(
  Analogon.Interfaces.RealInput T_in(unit="K");
  Analogon.Sources.PrescribedTemperature bath;
  Analogon.Sensors.TemperatureSensor sensor;
  Analogon.Interfaces.RealOutput T;
equation
  connect(T_in, bath.T);
  connect(bath.port, sensor.port);
  connect(sensor.T, T);)",
                            5, 6, {[](double t) { return 300 + 7 * t; }});
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "T", [](double t) { return 300 + 7 * t; }), 1e-9);
}

}  // namespace
}  // namespace analogon::bench
