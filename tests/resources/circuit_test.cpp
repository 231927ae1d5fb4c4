#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/resources/bench.hpp"

/// Blocks between pins and the effects that go there, against what can be worked out by hand.
namespace analogon::bench {
namespace {

/// A supply, what lies between it and a load, and the load to ground; V is the voltage, or the current, of the supply.
Recording circuit(const std::string& supply, const std::string& between, const std::string& load, double duration,
                  double value, const std::string& further = "", const std::string& equations = "") {
    return run(fmt::format(R"(
  Analogon.Interfaces.RealInput V;
  Analogon.Sources.{};
  Analogon.{};
  Analogon.{};
  Analogon.Electric.Ground ground;
  Analogon.Sensors.CurrentSensor ammeter;
  Analogon.Sensors.VoltageSensor voltmeter;
  Analogon.Interfaces.RealOutput i(unit="A"), u(unit="V");
  {}
equation
  connect(supply.p, between.p);
  connect(between.n, ammeter.p);
  connect(ammeter.n, load.p);
  connect(load.n, ground.p);
  connect(supply.n, ground.p);
  connect(voltmeter.p, load.p);
  connect(voltmeter.n, load.n);
  connect(ammeter.i, i);
  connect(voltmeter.v, u);
  {})",
                           supply, between, load, further, equations),
               duration, 201, {constant(value)});
}

/// The same from an ideal voltage.
Recording supplied(const std::string& between, const std::string& load, double duration, double voltage,
                   const std::string& further = "", const std::string& equations = "") {
    return circuit("PrescribedVoltage supply", between, load, duration, voltage, further,
                   "connect(V, supply.v);\n  " + equations);
}

TEST(Circuit, ACapacitorIsChargedThroughAResistor) {
    const Recording r = supplied("Electric.Resistor between(R=100)", "Electric.Capacitor load(C=1e-4)", 0.05, 5);
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "u", [](double t) { return 5 * (1 - std::exp(-t / 0.01)); }), 1e-5);
    EXPECT_LT(worst(r, "i", [](double t) { return 0.05 * std::exp(-t / 0.01); }), 1e-6);
}

TEST(Circuit, TheCurrentOfACoilRisesToWhatTheResistorLets) {
    const Recording r = supplied("Electric.Inductor between(L=0.02)", "Electric.Resistor load(R=4)", 0.03, 12);
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "i", [](double t) { return 3 * (1 - std::exp(-200 * t)); }), 1e-5);
}

TEST(Circuit, AnImposedCurrentChargesACapacitorEvenly) {
    // positive from p to n through the source: out of n, so that the load is charged the other way round
    const Recording r = circuit("PrescribedCurrent supply", "Electric.Resistor between(R=7)",
                                "Electric.Capacitor load(C=1e-3)", 1, -0.002, "", "connect(V, supply.i);");
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "u", [](double t) { return 2 * t; }), 1e-6);
}

TEST(Diode, LetsThroughWhatItsCharacteristicSaysAndBlocksTheOtherWay) {
    const std::string diode = "Electric.Diode between(I_s=1e-9, V_t=0.05, R_p=1e9)";
    const Recording forward = supplied(diode, "Electric.Resistor load(R=10)", 1, 5);
    const Recording backward = supplied(diode, "Electric.Resistor load(R=10)", 1, -5);
    ASSERT_EQ(forward.fault + backward.fault, "");
    const double i = forward.last("i");
    EXPECT_NEAR(5 - 10 * i, 0.05 * std::log(i / 1e-9 + 1), 1e-6);
    EXPECT_NEAR(backward.last("i"), -1e-9 - 5e-9, 1e-12);
}

TEST(Diode, GoesOnAsATangentWhereTheExponentialWouldOverflow) {
    const Recording r = supplied("Electric.Resistor between(R=1e-9)", "Electric.Diode load(I_s=1e-18, V_t=0.01)", 1, 2);
    ASSERT_EQ(r.fault, "");
    EXPECT_NEAR(r.last("i"), 1e-18 * (std::exp(40.0) * (1 + 200 - 40) - 1) + 2e-8, 1e-3);
}

TEST(Switch, ConductsWhereItsSignalIsAboveOneHalf) {
    const std::string closed = "Electric.Switch between(R_on=1, G_off=1e-3)", load = "Electric.Resistor load(R=3)";
    const Recording on =
        supplied(closed, load, 1, 8, "Analogon.Sources.Constant command(k=1);", "connect(command.y, between.control);");
    const Recording off =
        supplied(closed, load, 1, 8, "Analogon.Sources.Constant command(k=0);", "connect(command.y, between.control);");
    ASSERT_EQ(on.fault + off.fault, "");
    EXPECT_NEAR(on.last("i"), 2, 1e-9);
    EXPECT_NEAR(off.last("i"), 8.0 / 1003, 1e-9);
}

TEST(EMF, RunsUpToTheSpeedAtWhichItsVoltageIsTheSupplys) {
    const Recording r = run(R"(
  Analogon.Interfaces.RealInput V(unit="V");
  Analogon.Sources.PrescribedVoltage supply;
  Analogon.Electric.Resistor winding(R=2);
  Analogon.Electric.EMF emf(k=0.1);
  Analogon.Electric.Ground ground;
  Analogon.Mechanics.Inertia rotor(J=1e-3);
  Analogon.Sensors.SpeedSensor speed;
  Analogon.Interfaces.RealOutput w(unit="rad/s");
equation
  connect(V, supply.v);
  connect(supply.p, winding.p);
  connect(winding.n, emf.p);
  connect(emf.n, ground.p);
  connect(supply.n, ground.p);
  connect(emf.flange, rotor.flange_a);
  connect(rotor.flange_b, speed.flange);
  connect(speed.w, w);)",
                            1, 101, {constant(12)});
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "w", [](double t) { return 120 * (1 - std::exp(-5 * t)); }), 1e-4);
}

// ------------------------------------------------------------------------------------------------ effects

TEST(EffectsInACircuit, AResistanceADropAndAnInductanceLieInTheWire) {
    const Recording resistance =
        supplied("Effects.Electric.SeriesResistance between(R_s=1)", "Electric.Resistor load(R=3)", 1, 8);
    const Recording drop =
        supplied("Effects.Electric.VoltageDrop between(V_b=2, i_eps=1e-4)", "Electric.Resistor load(R=3)", 1, 8);
    const Recording weak =
        supplied("Effects.Electric.VoltageDrop between(V_b=2, i_eps=1e-6)", "Electric.Resistor load(R=3)", 1, 1.5);
    const Recording coil =
        supplied("Effects.Electric.SeriesInductance between(L_s=0.02)", "Electric.Resistor load(R=4)", 0.03, 12);
    ASSERT_EQ(resistance.fault + drop.fault + weak.fault + coil.fault, "");
    EXPECT_NEAR(resistance.last("i"), 2, 1e-9);
    EXPECT_NEAR(drop.last("i"), 2, 1e-6);
    EXPECT_NEAR(weak.last("i"), 0, 1e-5);
    EXPECT_LT(worst(coil, "i", [](double t) { return 3 * (1 - std::exp(-200 * t)); }), 1e-5);
}

TEST(EffectsInACircuit, LeakageAndCapacitanceTakeCurrentBesideTheLoad) {
    const std::string between = "Electric.Resistor between(R=2)", load = "Electric.Resistor load(R=4)";
    const Recording leak = supplied(between, load, 1, 8, "Analogon.Effects.Electric.Leakage effect(G_p=0.25);",
                                    "connect(effect.pin, load.p);");
    const Recording across = supplied(between, load, 1, 8, "Analogon.Effects.Electric.LeakageBetween effect(G_p=0.5);",
                                      "connect(effect.p, supply.p);\n  connect(effect.n, load.p);");
    const Recording stray =
        supplied(between, load, 0.05, 6, "Analogon.Effects.Electric.ParallelCapacitance effect(C_p=3e-3);",
                 "connect(effect.pin, load.p);");
    ASSERT_EQ(leak.fault + across.fault + stray.fault, "");
    EXPECT_NEAR(leak.last("u"), 4, 1e-9);                                                        // 2 Ohm and 4 || 4 Ohm
    EXPECT_NEAR(across.last("u"), 8 * 4.0 / 5, 1e-9);                                            // 2 || 2 Ohm and 4 Ohm
    EXPECT_LT(worst(stray, "u", [](double t) { return 4 * (1 - std::exp(-t / 4e-3)); }), 1e-5);  // (2 || 4)*C
}

}  // namespace
}  // namespace analogon::bench
