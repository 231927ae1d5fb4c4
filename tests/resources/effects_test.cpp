#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/effect/catalogue/catalogue.hpp"
#include "tests/resources/bench.hpp"

/// Effects: switched off they change nothing, switched on they do what their documentation says.
namespace analogon::bench {
namespace {

// ------------------------------------------------------------------------------------------------ on a shaft

/// A driven inertia of 0.01 kg.m2 with an effect on its shaft; a damper as well where it must come to rest.
Recording shaftWith(const std::string& name, const std::string& modifiers, double duration, const Signal& torque,
                    const std::string& damper = "") {
    std::string declarations = R"(
  Analogon.Interfaces.RealInput tau(unit="N.m");
  Analogon.Sources.PrescribedTorque drive;
  Analogon.Mechanics.Inertia body(J=0.01);
  Analogon.Sensors.SpeedSensor speed;
  Analogon.Sensors.AngleSensor angle;
  Analogon.Interfaces.RealOutput w(unit="rad/s"), phi(unit="rad");
)";
    std::string equations = R"(
equation
  connect(tau, drive.tau);
  connect(drive.flange, body.flange_a);
  connect(body.flange_b, speed.flange);
  connect(body.flange_b, angle.flange);
  connect(speed.w, w);
  connect(angle.phi, phi);
)";
    declarations += fmt::format("  Analogon.Effects.Mechanics.{} effect({});\n", name, modifiers);
    equations += "  connect(body.flange_b, effect.flange);\n";
    if (!damper.empty()) {
        declarations += fmt::format("  Analogon.Mechanics.ViscousLoad damper(b={});\n", damper);
        equations += "  connect(body.flange_b, damper.flange);\n";
    }
    return run(declarations + equations, duration, 201, {torque});
}

TEST(CoulombFriction, TakesAConstantTorqueFromTheMotion) {
    const Recording r = shaftWith("CoulombFriction", "tau_c=0.05, w_eps=1e-4", 2, constant(0.2));
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "w", [](double t) { return 15 * t; }), 1e-4);
}

TEST(CoulombFriction, HoldsAShaftThatIsDrivenTooWeakly) {
    const Recording r = shaftWith("CoulombFriction", "tau_c=0.05, w_eps=1e-4", 2, constant(0.045));
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "w", constant(0)), 2e-4);
}

TEST(StribeckFriction, BreaksAwayOnlyAboveTheSumOfBothTorques) {
    const std::string modifiers = "tau_c=0.05, tau_s=0.04, w_s=0.5, w_eps=1e-4";
    const Recording held = shaftWith("StribeckFriction", modifiers, 2, constant(0.085));
    const Recording free = shaftWith("StribeckFriction", modifiers, 20, constant(0.095));
    ASSERT_EQ(held.fault, "");
    ASSERT_EQ(free.fault, "");
    EXPECT_LT(worst(held, "w", constant(0)), 1e-3);
    // once fast, only tau_c is left: the acceleration is (0.095 - 0.05)/0.01
    const std::vector<double>& w = free["w"];
    EXPECT_NEAR((w[200] - w[190]) / (free.time[200] - free.time[190]), 4.5, 1e-5);
}

TEST(ViscousFriction, LetsTheSpeedSettle) {
    const Recording r = shaftWith("ViscousFriction", "b=0.05", 1, constant(0.2));
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "w", [](double t) { return 4 * (1 - std::exp(-5 * t)); }), 1e-6);
}

TEST(QuadraticDrag, LetsTheSpeedRunIntoItsLimit) {
    const Recording r = shaftWith("QuadraticDrag", "k_q=5e-4", 3, constant(-0.2));
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "w", [](double t) { return -20 * std::tanh(t); }), 1e-5);
}

TEST(ConstantTorque, ActsAtAnySpeed) {
    const Recording r = shaftWith("ConstantTorque", "tau_0=0.05", 2, constant(0.02));
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "w", [](double t) { return -3 * t; }), 1e-6);
}

TEST(GravityTorque, HoldsTheShaftWhereItsTorqueEqualsTheDrive) {
    const Recording r = shaftWith("GravityTorque", "tau_g=0.5, phi_0=-0.3", 60, constant(0.2), "0.05");
    ASSERT_EQ(r.fault, "");
    EXPECT_NEAR(r.last("phi"), std::asin(0.2 / 0.5) - 0.3, 1e-6);
}

TEST(CoggingTorque, HoldsTheShaftInItsNotch) {
    const Recording r = shaftWith("CoggingTorque", "tau_n=0.5, n=6, phi_0=0.4", 60, constant(0.2), "0.05");
    ASSERT_EQ(r.fault, "");
    EXPECT_NEAR(r.last("phi"), (std::asin(0.2 / 0.5) + 0.4) / 6, 1e-6);
}

TEST(ReturnSpringEffect, PullsTowardsItsRelaxedAngle) {
    const Recording r = shaftWith("ReturnSpring", "c_r=2, phi_r=0.1", 2, constant(0.3));
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "phi", [](double t) { return 0.25 * (1 - std::cos(std::sqrt(200.0) * t)); }), 1e-6);
}

TEST(AddedInertia, SharesTheTorque) {
    const Recording r = shaftWith("AddedInertia", "J=0.03", 2, constant(0.2));
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "w", [](double t) { return 5 * t; }), 1e-6);
}

/// Two inertias with an effect between them, driven by 0.2 N.m from the left.
Recording twoBodies(const std::string& effect, double duration, int samples = 201) {
    return run(R"(
  Analogon.Sources.Constant torque(k=0.2);
  Analogon.Sources.PrescribedTorque drive;
  Analogon.Mechanics.Inertia first(J=0.01), second(J=0.03);
  Analogon.Sensors.SpeedSensor left, right;
  Analogon.Interfaces.RealOutput w1, w2;
  Analogon.Effects.Mechanics.)" +
                   effect + R"(;
equation
  connect(torque.y, drive.tau);
  connect(drive.flange, first.flange_a);
  connect(first.flange_b, effect.flange_a);
  connect(effect.flange_b, second.flange_a);
  connect(first.flange_b, left.flange);
  connect(second.flange_b, right.flange);
  connect(left.w, w1);
  connect(right.w, w2);)",
               duration, samples);
}

TEST(ElasticShaft, LetsTheBodiesSwingAgainstEachOther) {
    const Recording r = twoBodies("ElasticShaft effect(e=0.02)", 2);
    ASSERT_EQ(r.fault, "");
    const double omega = std::sqrt(50 * (1 / 0.01 + 1 / 0.03)), twist = 0.2 / 0.01 / (omega * omega);
    EXPECT_LT(worst(r, "w1", [&](double t) { return 5 * t + 0.75 * twist * omega * std::sin(omega * t); }), 1e-4);
    EXPECT_LT(worst(r, "w2", [&](double t) { return 5 * t - 0.25 * twist * omega * std::sin(omega * t); }), 1e-4);
}

TEST(ElasticShaft, IsRigidWithoutCompliance) {
    const Recording r = twoBodies("ElasticShaft effect(e=0, d=3)", 2);
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "w1", [](double t) { return 5 * t; }), 1e-6);
    EXPECT_LT(worst(r, "w2", [](double t) { return 5 * t; }), 1e-6);
}

TEST(SoftCoupling, LetsTheBodiesSwingAgainstEachOtherAboutTheAngleAtWhichItIsRelaxed) {
    const Recording r = twoBodies("SoftCoupling effect(c=50, phi_0=-0.01)", 2);
    ASSERT_EQ(r.fault, "");
    const double omega = std::sqrt(50 * (1 / 0.01 + 1 / 0.03));
    const double twist = 0.2 / 0.01 / (omega * omega) + 0.01;  // of the mean of the swing
    EXPECT_LT(worst(r, "w1", [&](double t) { return 5 * t + 0.75 * twist * omega * std::sin(omega * t); }), 1e-4);
    EXPECT_LT(worst(r, "w2", [&](double t) { return 5 * t - 0.25 * twist * omega * std::sin(omega * t); }), 1e-4);
}

TEST(SoftCoupling, DampsTheSwing) {
    const Recording r = twoBodies("SoftCoupling effect(c=50, d=0.3)", 2);
    ASSERT_EQ(r.fault, "");
    EXPECT_NEAR(r.last("w1"), 10, 1e-3);
    EXPECT_NEAR(r.last("w2"), 10, 1e-3);
}

TEST(Backlash, LeavesTheSecondBodyAloneUntilThePlayIsUsedUp) {
    // half the play of 0.4 rad is passed after sqrt(0.4*0.01/0.2) = 0.141 s
    const Recording before = twoBodies("Backlash effect(b=0.4, c=500, d=0.5, phi_eps=1e-6)", 0.14);
    ASSERT_EQ(before.fault, "");
    EXPECT_LT(worst(before, "w1", [](double t) { return 20 * t; }), 1e-3);
    EXPECT_LT(worst(before, "w2", constant(0)), 1e-3);
    const Recording after = twoBodies("Backlash effect(b=0.4, c=500, d=0.5, phi_eps=1e-6)", 5);
    ASSERT_EQ(after.fault, "");
    // both then run together, and the momentum is that of the drive
    EXPECT_NEAR(0.01 * after.last("w1") + 0.03 * after.last("w2"), 0.2 * 5, 1e-6);
    EXPECT_NEAR(after.last("w1"), after.last("w2"), 1e-2);
}

// ------------------------------------------------------------------------------------------------ thermal

/// A body of 20 J/K, heated with 40 W from 293.15 K, with an effect at its port.
/// The power ripples from sample to sample about its mean, as a measured one does.
Recording heated(const std::string& effect, double duration, double ripple = 0) {
    const int samples = 201;
    const auto power = [=](double t) {
        return std::lround(t / duration * (samples - 1)) % 2 == 0 ? 40 + ripple : 40 - ripple;
    };
    return run(R"(
  Analogon.Interfaces.RealInput P(unit="W");
  Analogon.Sources.PrescribedHeatFlow heating;
  Analogon.Thermal.HeatCapacitor body(C=20);
  Analogon.Sensors.TemperatureSensor sensor;
  Analogon.Interfaces.RealOutput T;
  Analogon.Effects.Thermal.)" +
                   effect + R"(;
equation
  connect(P, heating.Q_flow);
  connect(heating.port, body.port);
  connect(body.port, sensor.port);
  connect(body.port, effect.port);
  connect(sensor.T, T);)",
               duration, samples, {power});
}

TEST(ThermalLoss, LetsTheBodySettle) {
    const Recording r = heated("Loss effect(G=0.5, T_amb=283.15)", 100);
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "T", [](double t) { return 363.15 - 70 * std::exp(-t / 40); }), 1e-5);
}

TEST(Radiation, BalancesTheHeatingWithTheFourthPower) {
    const Recording r = heated("Radiation effect(k_r=1e-9, T_amb=300)", 2000);
    ASSERT_EQ(r.fault, "");
    EXPECT_NEAR(r.last("T"), std::pow(40 / 1e-9 + std::pow(300, 4), 0.25), 1e-4);
}

TEST(ThermalMass, FollowsBehindItsConductance) {
    // C2 = 30 J/K behind G2 = 30/12 W/K: the difference settles, the mean rises with the power
    const Recording r = heated("Mass effect(C2=30, tau_2=12)", 60);
    ASSERT_EQ(r.fault, "");
    const double rate = 2.5 * (1.0 / 20 + 1.0 / 30), difference = 40.0 / 20 / rate;
    EXPECT_LT(
        worst(r, "T",
              [&](double t) { return 293.15 + 40 * t / 50 + 30.0 / 50 * difference * (1 - std::exp(-rate * t)); }),
        1e-5);
}

TEST(LatentHeat, IsTakenUpOnceOnTheWayUp) {
    const Recording r = heated("LatentHeat effect(Q_l=600, T_l=330, width=4, t_f=0.01)", 60, 1);
    ASSERT_EQ(r.fault, "");
    EXPECT_NEAR(r["T"][50], 293.15 + 40.0 * 15 / 20, 1e-2);           // before it sets in
    EXPECT_NEAR(r.last("T"), 293.15 + (40.0 * 60 - 600) / 20, 0.05);  // the heat is missing afterwards
}

TEST(LatentHeat, DoesNotComeBackOnCooling) {
    const Recording r = run(R"(
  Analogon.Interfaces.RealInput P(unit="W");
  Analogon.Sources.PrescribedHeatFlow heating;
  Analogon.Thermal.HeatCapacitor body(C=20);
  Analogon.Sensors.TemperatureSensor sensor;
  Analogon.Interfaces.RealOutput T;
  Analogon.Effects.Thermal.LatentHeat effect(Q_l=600, T_l=330, width=4, t_f=0.01);
equation
  connect(P, heating.Q_flow);
  connect(heating.port, body.port);
  connect(body.port, sensor.port);
  connect(body.port, effect.port);
  connect(sensor.T, T);)",
                            120, 121, {[](double t) { return t < 60   ? 40.0
                                                             : t < 61 ? 40 - 80 * (t - 60)
                                                                      : -40.0; }});
    ASSERT_EQ(r.fault, "");
    const double top = r["T"][60];
    EXPECT_NEAR(r["T"][119], top - 40.0 * 58 / 20, 0.1);  // cools as the plain body does
}

TEST(ThermalResistance, LetsTwoBodiesMeetSlowly) {
    const Recording r = run(R"(
  Analogon.Thermal.HeatCapacitor hot(C=20, T_start=400), cold(C=30, T_start=300);
  Analogon.Effects.Thermal.Resistance effect(R_th=2);
  Analogon.Sensors.TemperatureSensor sensor;
  Analogon.Interfaces.RealOutput T;
equation
  connect(hot.port, effect.port_a);
  connect(effect.port_b, cold.port);
  connect(hot.port, sensor.port);
  connect(sensor.T, T);)",
                            60);
    ASSERT_EQ(r.fault, "");
    const double rate = 0.5 * (1.0 / 20 + 1.0 / 30);
    EXPECT_LT(worst(r, "T", [&](double t) { return 340 + 60 * std::exp(-rate * t); }), 1e-5);
}

/// A body of 4 J/K at 350 K in a stream of 300 K whose conductance by equation 8 is G.
Recording inStream(const std::string& component, const std::string& connection,
                   const std::vector<Signal>& inputs = {}) {
    const std::string input = inputs.empty() ? "" : "  Analogon.Interfaces.RealInput flow_in;\n";
    return run(input + "  Analogon.Effects.ThermalFluid." + component + R"(;
  Analogon.Sources.FixedTemperature gas(T=300);
  Analogon.Sensors.TemperatureSensor sensor;
  Analogon.Interfaces.RealOutput T;
equation
  connect(body.fluid, gas.port);
  connect(body.solid, sensor.port);
  connect(sensor.T, T);
)" + connection,
               10, 101, inputs);
}

const double streamG = 10 * 2e-3 * std::pow(300 / 3.6, 0.78);

TEST(NaturalConvection, SlowsDownAsTheDifferenceFalls) {
    const Recording r =
        inStream("NaturalConvection body(C=4, c_o=10, A=2e-3, T_start=350, n=1, dT_ref=20, dT_eps=1e-6)", "");
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "T", [](double t) { return 300 + 50 / (1 + streamG / 4 * 50 / 20 * t); }), 1e-5);
}

TEST(FlowConvection, FollowsAPowerOfTheFlow) {
    const Recording r = inStream("FlowConvection body(C=4, c_o=10, A=2e-3, T_start=350, n=0.5, flow_ref=3)",
                                 "  connect(flow_in, body.u_flow);", {constant(12)});
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "T", [](double t) { return 300 + 50 * std::exp(-2 * streamG / 4 * t); }), 1e-5);
}

TEST(FlowConvectionByFlowSpeed, FollowsAPowerOfTheSecondFlowBesideTheSpeed) {
    const Recording r = inStream("FlowConvectionByFlowSpeed body(C=4, c_o=10, A=2e-3, T_start=350, n=0.5, flow_ref=3)",
                                 "  connect(flow_in, body.u_flow);\n  connect(flow_in, body.speed);", {constant(12)});
    ASSERT_EQ(r.fault, "");
    const double g = 10 * 2e-3 * std::pow(12 / 3.6, 0.78);
    EXPECT_LT(worst(r, "T", [&](double t) { return 300 + 50 * std::exp(-2 * g / 4 * t); }), 1e-5);
}

// ------------------------------------------------------------------------------------------------ machines, heaters

/// A machine with a held rotor on an input voltage. Outputs i and tau.
Recording heldMachine(const std::string& component, double duration, const Signal& voltage) {
    return run(
        "  Analogon.Interfaces.RealInput v(unit=\"V\");\n  Analogon.Effects.ElectricMechanical." + component + R"(;
  Analogon.Sensors.TorqueSensor brake;
  Analogon.Mechanics.Fixed wall;
  Analogon.Interfaces.RealOutput i, tau;
equation
  connect(v, motor.v);
  connect(motor.flange, brake.flange_a);
  connect(brake.flange_b, wall.flange);
  connect(motor.i, i);
  connect(brake.tau, tau);)",
        duration, 201, {voltage});
}

TEST(SeriesResistance, LimitsTheCurrentOfAMachine) {
    const Recording r = heldMachine("SeriesResistance motor(R=1, L=0, k=0.04, R_s=0.5)", 1, constant(6));
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "i", constant(4)), 1e-9);
    EXPECT_LT(worst(r, "tau", constant(0.16)), 1e-9);
}

TEST(WindingTemperature, SettlesWhereLossAndCoolingBalance) {
    const Recording r =
        heldMachine("WindingTemperature motor(R=1, L=0, k=0.04, e_w=0.05, tau_w=20, alpha=0.004)", 400, constant(6));
    ASSERT_EQ(r.fault, "");
    // R_w = R (1 + alpha e_w tau_w v^2/R_w)
    const double heat = 0.004 * 0.05 * 20 * 36, R_w = (1 + std::sqrt(1 + 4 * heat)) / 2;
    EXPECT_NEAR(r["i"].front(), 6, 1e-6);
    EXPECT_NEAR(r.last("i"), 6 / R_w, 1e-6);
}

TEST(VoltageDropOfAMachine, IsSubtractedAndHoldsTheCurrentAtZeroBelowIt) {
    const std::string motor = "VoltageDrop motor(R=2, L=0.001, k=0.04, V_b=1.5, i_eps=1e-4)";
    const Recording above = heldMachine(motor, 1, constant(-6)), below = heldMachine(motor, 1, constant(1.2));
    ASSERT_EQ(above.fault, "");
    ASSERT_EQ(below.fault, "");
    EXPECT_NEAR(above.last("i"), -2.25, 1e-6);
    EXPECT_LT(std::abs(below.last("i")), 2e-4);
}

TEST(InductanceSaturation, LetsTheCurrentRunAway) {
    const Recording r = heldMachine("InductanceSaturation motor(R=0, L=0.03, k=0.04, s_i=0.2)", 0.02, constant(6));
    ASSERT_EQ(r.fault, "");
    // without resistance: L/s atan(s i) = v t
    EXPECT_LT(worst(r, "i", [](double t) { return std::tan(0.2 * 6 * t / 0.03) / 0.2; }), 1e-5);
}

TEST(FluxTemperature, TakesTorqueFromAWarmMachine) {
    const Recording r =
        heldMachine("FluxTemperature motor(R=1, L=0, k=0.04, e_m=0.05, tau_m=20, beta=0.002)", 50, constant(6));
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "tau", [](double t) { return 0.24 * (1 - 0.002 * 0.05 * 36 * 20 * (1 - std::exp(-t / 20))); }),
              1e-7);
}

/// A heater at a fixed temperature. Outputs i and Q.
Recording heater(const std::string& component, const Signal& voltage) {
    return run("  Analogon.Interfaces.RealInput v(unit=\"V\");\n  Analogon.Effects.ElectricThermal." + component + R"(;
  Analogon.Sources.FixedTemperature bath(T=393.15);
  Analogon.Sensors.HeatFlowSensor given;
  Analogon.Interfaces.RealOutput i, Q;
equation
  connect(v, heater.v);
  connect(heater.heatPort, given.port_a);
  connect(given.port_b, bath.port);
  connect(heater.i, i);
  connect(given.Q_flow, Q);)",
               1, 5, {voltage});
}

TEST(SeriesResistance, LosesHeatOutsideTheHeater) {
    const Recording r = heater("SeriesResistance heater(R=2, alpha=0.005, R_s=1)", constant(12));
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "i", constant(3)), 1e-9);
    EXPECT_LT(worst(r, "Q", constant(27)), 1e-9);
}

TEST(VoltageDropOfAHeater, IsSubtractedAndHoldsTheCurrentAtZeroBelowIt) {
    const std::string component = "VoltageDrop heater(R=2, alpha=0.005, V_b=1.5, v_eps=1e-5)";
    const Recording above = heater(component, constant(12)), below = heater(component, constant(1.2));
    ASSERT_EQ(above.fault, "");
    ASSERT_EQ(below.fault, "");
    EXPECT_NEAR(above.last("i"), 3.5, 1e-6);
    EXPECT_NEAR(below.last("i"), 0, 1e-6);
}

// ------------------------------------------------------------------------------------------------ signals

Recording signal(const std::string& effect, double duration, const Signal& u, int samples = 101) {
    return run("  Analogon.Interfaces.RealInput u;\n  Analogon.Effects." + effect + R"(;
  Analogon.Interfaces.RealOutput y;
equation
  connect(u, effect.u);
  connect(effect.y, y);)",
               duration, samples, {u});
}

class SignalEffect : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Both, SignalEffect, testing::Values("Sensor", "Actuator"));

TEST_P(SignalEffect, LagStartsAtItsInputAndFollowsByOnePole) {
    const Recording r = signal(std::string(GetParam()) + ".Lag effect(T=0.5)", 4, [](double t) { return 3 + 2 * t; });
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "y", [](double t) { return 3 + 2 * (t - 0.5 * (1 - std::exp(-t / 0.5))); }), 1e-6);
}

TEST_P(SignalEffect, DelayShiftsInTime) {
    const Recording r =
        signal(std::string(GetParam()) + ".Delay effect(T=0.13)", 4, [](double t) { return 3 + 2 * t; });
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "y", [](double t) { return 3 + 2 * std::max(t - 0.13, 0.0); }), 1e-6);
}

TEST_P(SignalEffect, OffsetAndGainShiftAndScale) {
    const auto ramp = [](double t) { return 3 + 2 * t; };
    const Recording offset = signal(std::string(GetParam()) + ".Offset effect(b=-0.7)", 4, ramp);
    const Recording gain = signal(std::string(GetParam()) + ".Gain effect(g=0.1)", 4, ramp);
    ASSERT_EQ(offset.fault + gain.fault, "");
    EXPECT_LT(worst(offset, "y", [&](double t) { return ramp(t) - 0.7; }), 1e-12);
    EXPECT_LT(worst(gain, "y", [&](double t) { return 1.1 * ramp(t); }), 1e-12);
}

TEST(SensorDrift, RunsAwayWithTime) {
    const Recording r = signal("Sensor.Drift effect(a=0.25)", 4, constant(3));
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "y", [](double t) { return 3 + 0.25 * t; }), 1e-9);
}

TEST(ActuatorDeadZone, DoesNothingWithinItsWidthAndSubtractsItBeyond) {
    const Recording r = signal("Actuator.DeadZone effect(b=0.5, u_eps=1e-6)", 4, [](double t) { return 2 * (t - 2); });
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "y",
                    [](double t) {
                        const double u = 2 * (t - 2);
                        return u > 0.5 ? u - 0.5 : u < -0.5 ? u + 0.5 : 0;
                    }),
              1e-6);
}

TEST(ActuatorSaturation, IsFaithfulBelowAndFlatAboveItsLimit) {
    const Recording r = signal("Actuator.Saturation effect(s=0.25)", 4, [](double t) { return 4 * (t - 2); });
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "y",
                    [](double t) {
                        return std::abs(t - 2) > 1.15 || std::abs(t - 2) < 0.85
                                   ? std::clamp(4 * (t - 2), -4.0, 4.0)
                                   : 4 * (t - 2) / std::pow(1 + std::pow(t - 2, 32), 1.0 / 32);
                    }),
              1e-2);
}

TEST(ActuatorCurve, RaisesTheCommandToAPowerAboutTheOneThatPassesUnchanged) {
    const Recording r =
        signal("Actuator.Curve effect(p=1, u_ref=4, u_eps=1e-6)", 4, [](double t) { return 4 * (t - 2); });
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "y", [](double t) { return 4 * (t - 2) * std::abs(t - 2); }), 1e-5);
}

TEST(SensorAbsolute, LosesTheSign) {
    const Recording whole = signal("Sensor.Absolute effect(s=1, u_eps=1e-6)", 4, [](double t) { return 3 * (t - 2); });
    const Recording half = signal("Sensor.Absolute effect(s=0.5, u_eps=1e-6)", 4, [](double t) { return 3 * (t - 2); });
    ASSERT_EQ(whole.fault + half.fault, "");
    EXPECT_LT(worst(whole, "y", [](double t) { return 3 * std::abs(t - 2); }), 1e-5);
    EXPECT_LT(worst(half, "y", [](double t) { return 3 * std::max(t - 2, 0.0); }), 1e-5);
}

// ------------------------------------------------------------------------------------------------ switched off

bool isBlown(const EffectClass& effect) { return effect.className.ends_with("ByFlowSpeed"); }

/// Whether an effect goes on a rod or in a circuit: those have a bench of their own.
bool isOf(const EffectClass& effect, const std::string& package) {
    return effect.className.starts_with("Analogon.Effects." + package + ".");
}

/// A spindle that moves two masses on a rod, and a filter, with places for an effect.
std::string rodAndCircuit(const EffectClass* effect) {
    std::string text = R"(
  Analogon.Interfaces.RealInput v, other;
  Analogon.Interfaces.RealOutput w(unit="m/s"), i(unit="A"), T(unit="V");
  Analogon.Sources.PrescribedForce drive;
  Analogon.Translation.Mass first(m=0.3), second(m=0.2), apart(m=1);
  Analogon.Translation.SpringDamper spring(c=40, d=1);
  Analogon.Translation.Fixed housing;
  Analogon.Sensors.VelocitySensor velocity;
  Analogon.Sources.PrescribedVoltage supply;
  Analogon.Electric.Resistor lead(R=2), load(R=9), bleeder(R=50);
  Analogon.Electric.Capacitor filter(C=0.02), store(C=0.1);
  Analogon.Electric.Ground ground;
  Analogon.Sensors.CurrentSensor ammeter;
  Analogon.Sensors.VoltageSensor voltmeter;
)";
    if (effect) text += "  " + effect->className + " effect;\n";
    text += R"(equation
  connect(v, drive.f);
  connect(drive.flange, first.flange_a);
  connect(second.flange_b, spring.flange_b);
  connect(spring.flange_a, housing.flange);
  connect(second.flange_b, velocity.flange);
  connect(velocity.v, w);
  connect(v, supply.v);
  connect(supply.n, ground.p);
  connect(supply.p, lead.p);
  connect(ammeter.n, filter.p);
  connect(ammeter.n, load.p);
  connect(filter.n, ground.p);
  connect(load.n, ground.p);
  connect(supply.p, bleeder.p);
  connect(bleeder.n, store.p);
  connect(store.n, ground.p);
  connect(voltmeter.p, load.p);
  connect(voltmeter.n, ground.p);
  connect(ammeter.i, i);
  connect(voltmeter.v, T);
)";
    const bool insert = effect && effect->placement.way == Way::Insert;
    const bool onRod = effect && isOf(*effect, "Translation");
    text += insert && onRod
                ? "  connect(first.flange_b, effect.flange_a);\n  connect(effect.flange_b, second.flange_a);\n"
                : "  connect(first.flange_b, second.flange_a);\n";
    text += insert && !onRod ? "  connect(lead.n, effect.p);\n  connect(effect.n, ammeter.p);\n"
                             : "  connect(lead.n, ammeter.p);\n";
    if (effect && effect->placement.way == Way::Attach)
        text += "  connect(effect." + effect->placement.ports[0] + (onRod ? ", first.flange_b);\n" : ", load.p);\n");
    if (effect && effect->placement.way == Way::Bridge)
        text += "  connect(effect.p, load.p);\n  connect(effect.n, store.p);\n";
    return text;
}

/// The bench of an effect: a heated sensor and a motor in one model, with places for every way. `blown`: the sensor in
/// a stream of measured speed.
std::string rig(const EffectClass* effect, bool blown = false) {
    blown = blown || (effect && isBlown(*effect));
    if (effect && (isOf(*effect, "Translation") || isOf(*effect, "Electric"))) return rodAndCircuit(effect);
    const bool attach = effect && effect->placement.way == Way::Attach,
               insert = effect && effect->placement.way == Way::Insert;
    const bool signal = insert && !effect->placement.signalSide.empty();
    const bool specialise = effect && effect->placement.way == Way::Specialise;
    const auto of = [&](const char* base, const char* plain) {
        return specialise && effect->base == base ? effect->className : std::string(plain);
    };
    std::string text =
        R"(
  Analogon.Interfaces.RealInput v(unit="V"), gas_flow;
  Analogon.Interfaces.RealOutput w, i, T;
  )" +
        of("Analogon.ElectricMechanical.PartialElectricMechanical",
           "Analogon.ElectricMechanical.BasicElectricMechanical") +
        " motor(R=0.5, L=0.002, k=0.03);\n  " +
        of("Analogon.ElectricThermal.PartialElectricThermal", "Analogon.ElectricThermal.BasicElectricThermal") +
        " heater(R=3, alpha=0.002);\n  " +
        of("Analogon.ThermalFluid.PartialThermalFluid",
           blown ? "Analogon.ThermalFluid.ConvectionByFlowSpeed" : "Analogon.ThermalFluid.BasicThermalFluid") +
        R"( element(C=1, c_o=2, A=3e-4);
  Analogon.Mechanics.Inertia first(J=1e-4), second(J=2e-4), apart(J=1e-4);
  Analogon.Mechanics.ViscousLoad load(b=1e-3);
  Analogon.Sensors.SpeedSensor speed;
  Analogon.Sensors.TemperatureSensor sensor;
  Analogon.Sources.FixedTemperature gas(T=400);
)";
    if (effect && !specialise) text += "  " + effect->className + " effect;\n";
    text += R"(equation
  connect(motor.flange, first.flange_a);
  connect(second.flange_b, load.flange);
  connect(second.flange_b, speed.flange);
  connect(element.fluid, gas.port);
  connect(element.solid, sensor.port);
  connect(heater.i, i);
  connect(sensor.T, T);
)";
    const bool onFlange = (attach || (insert && !signal)) && effect->placement.ports.front().starts_with("flange");
    const std::string in = signal && effect->placement.signalSide == "input" ? "effect.y" : "v";
    const std::string out = signal && effect->placement.signalSide == "output" ? "effect.y" : "speed.w";
    if (signal) text += in == "v" ? "  connect(speed.w, effect.u);\n" : "  connect(v, effect.u);\n";
    text += "  connect(" + in + ", motor.v);\n  connect(" + in + ", heater.v);\n  connect(" + out + ", w);\n";
    if (attach)
        text += "  connect(effect." + effect->placement.ports[0] +
                (onFlange ? ", first.flange_b);\n" : ", element.solid);\n");
    if (effect && effect->placement.way == Way::Bridge) {
        const bool isOfShafts = effect->placement.ports[0].starts_with("flange");
        text += fmt::format("  connect(effect.{}, {});\n  connect(effect.{}, {});\n", effect->placement.ports[0],
                            isOfShafts ? "first.flange_b" : "element.solid", effect->placement.ports[1],
                            isOfShafts ? "apart.flange_a" : "gas.port");
    }
    if (insert && !signal && onFlange)
        text += "  connect(first.flange_b, effect.flange_a);\n  connect(effect.flange_b, second.flange_a);\n";
    else
        text += "  connect(first.flange_b, second.flange_a);\n";
    if (insert && !signal && !onFlange)
        text += "  connect(heater.heatPort, effect.port_a);\n  connect(effect.port_b, element.solid);\n";
    else
        text += "  connect(heater.heatPort, element.solid);\n";
    if (specialise && !effect->placement.node.empty())
        text += "  connect(motor." + effect->placement.node + ", element.solid);\n";
    if (attach && !effect->placement.channel.empty())
        text += "  connect(gas_flow, effect." + effect->placement.channel + ");\n";
    if (specialise && !effect->placement.channel.empty())
        text += "  connect(gas_flow, element." + effect->placement.channel + ");\n";
    if (blown) text += "  connect(gas_flow, element.speed);\n";
    return text;
}

TEST(CombinedEffects, AreEachOfThemWhereTheOthersAreOff) {
    const Outcome<Library> library = builtInLibrary();
    ASSERT_TRUE(library) << format(library.diagnostics());
    const std::map<std::string, double> strengths{{"R_s", 0.2},  {"V_b", 1.5},    {"s_i", 0.3},  {"e_w", 0.05},
                                                  {"e_m", 0.05}, {"alpha", 4e-3}, {"beta", 2e-3}};
    const std::vector<Signal> inputs{[](double t) { return 6 + 4 * std::sin(3 * t); }, [](double t) { return 2 + t; }};
    const Recording plain = run(rig(nullptr), 2, 101, inputs);
    int checked = 0;
    for (const LibraryClass* combined : library->classes())
        for (const std::string& name : combinedIn(*combined)) {
            SCOPED_TRACE(combined->qualifiedName + " for " + name);
            const std::optional<EffectClass> effect = effectOf(*library, *library->find(name));
            ASSERT_TRUE(effect);
            // the others' switches are told where they are no strength of this one: alpha of a winding without warmth
            std::string alone = rig(&*effect);
            const std::string component = effect->base.ends_with("Thermal") ? " heater(" : " motor(";
            const std::size_t at = alone.find(component) + component.size();
            alone.insert(at, effect->parameters.strength + "=" +
                                 std::to_string(strengths.at(effect->parameters.strength)) + ", ");
            std::string both = alone;
            both.replace(both.find(name), name.size(), combined->qualifiedName);
            if (combined->qualifiedName.ends_with("OfNode") && effect->placement.node.empty())
                both += "  connect(motor.heatPort, element.solid);\n";
            const Recording single = run(alone, 2, 101, inputs), among = run(both, 2, 101, inputs);
            ASSERT_EQ(single.fault, "");
            ASSERT_EQ(among.fault, "");
            double change = 0;
            for (const char* output : {"w", "i", "T"}) {
                const auto& a = single[output];
                const auto& b = among[output];
                const auto& c = plain[output];
                ASSERT_EQ(a.size(), b.size());
                for (std::size_t k = 0; k < a.size(); ++k) {
                    EXPECT_NEAR(a[k], b[k], 1e-6 * (1 + std::abs(a[k]))) << output << " at sample " << k;
                    change = std::max(change, std::abs(a[k] - c[k]));
                }
            }
            EXPECT_GT(change, 1e-3) << "the effect is off as well";
            ++checked;
        }
    EXPECT_GE(checked, 20);
}

TEST(Effects, ChangeNothingWhileTheirStrengthIsZero) {
    const Outcome<Library> library = builtInLibrary();
    ASSERT_TRUE(library) << format(library.diagnostics());
    const Outcome<std::vector<EffectClass>> effects = effectCatalogue(*library);
    ASSERT_TRUE(effects);
    const std::vector<Signal> inputs{[](double t) { return 6 + 4 * std::sin(3 * t); }, [](double t) { return 2 + t; }};
    const Recording still = run(rig(nullptr), 2, 101, inputs), blown = run(rig(nullptr, true), 2, 101, inputs);
    const Recording rods = run(rodAndCircuit(nullptr), 2, 101, inputs);
    ASSERT_EQ(still.fault + blown.fault + rods.fault, "");
    for (const EffectClass& effect : *effects) {
        SCOPED_TRACE(effect.className);
        const bool isApart = isOf(effect, "Translation") || isOf(effect, "Electric");
        const Recording& plain = isApart ? rods : isBlown(effect) ? blown : still;
        const Recording off = run(rig(&effect), 2, 101, inputs);
        ASSERT_EQ(off.fault, "");
        // play without width still has elastic teeth, very stiff ones
        const double tolerance = effect.kind == "backlash" ? 1e-3 : 1e-6;
        for (const char* output : {"w", "i", "T"})
            for (std::size_t k = 0; k < plain.time.size(); ++k)
                ASSERT_NEAR(off[output][k], plain[output][k], tolerance * std::max(1.0, std::abs(plain[output][k])))
                    << output << " at " << plain.time[k];
    }
}

}  // namespace
}  // namespace analogon::bench
