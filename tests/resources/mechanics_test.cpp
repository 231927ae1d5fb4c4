#include <gtest/gtest.h>

#include <cmath>

#include "tests/resources/bench.hpp"

/// Blocks of the mechanical domain against solutions by hand. Every bench drives a shaft at rest with a constant
/// torque, so each solution is that of a linear (or one quadratic) equation of motion.
namespace analogon::bench {
namespace {

/// A shaft driven by the constant torque `tau`; the block under test hangs on drive.flange.
std::string driven(const std::string& tau, const std::string& rest) {
    return R"(
  Analogon.Sources.Constant torque(k=)" +
           tau + R"();
  Analogon.Sources.PrescribedTorque drive;
)" + rest;
}

const std::string driveConnections = "  connect(torque.y, drive.tau);\n";

TEST(Inertia, TakesUpATorqueAsAcceleration) {
    const Recording r = run(driven("0.2", R"(
  Analogon.Mechanics.Inertia body(J=0.05);
  Analogon.Sensors.SpeedSensor speed;
  Analogon.Sensors.AngleSensor angle;
  Analogon.Interfaces.RealOutput w, phi;
equation
)") + driveConnections + R"(
  connect(drive.flange, body.flange_a);
  connect(body.flange_b, speed.flange);
  connect(body.flange_b, angle.flange);
  connect(speed.w, w);
  connect(angle.phi, phi);)",
                            3);
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "w", [](double t) { return 4 * t; }), 1e-6);
    EXPECT_LT(worst(r, "phi", [](double t) { return 2 * t * t; }), 1e-6);
}

TEST(Inertia, TwoOnOneRigidShaftTurnAsOne) {
    const Recording r = run(driven("0.2", R"(
  Analogon.Mechanics.Inertia first(J=0.03), second(J=0.02);
  Analogon.Sensors.TorqueSensor between;
  Analogon.Sensors.SpeedSensor speed;
  Analogon.Interfaces.RealOutput w, tau;
equation
)") + driveConnections + R"(
  connect(drive.flange, first.flange_a);
  connect(first.flange_b, between.flange_a);
  connect(between.flange_b, second.flange_a);
  connect(second.flange_b, speed.flange);
  connect(speed.w, w);
  connect(between.tau, tau);)",
                            3);
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "w", [](double t) { return 4 * t; }), 1e-6);
    EXPECT_LT(worst(r, "tau", [](double) { return 0.2 * 0.02 / 0.05; }), 1e-9);
}

// In the coordinates of the slow side (psi = phi1/r) the geared shaft is a two-mass oscillator with the inertias
// r^2 J1 and J2: psi - phi2 = x_s (1 - cos(omega t)), omega^2 = c (1/(r^2 J1) + 1/J2), x_s = tau/(r J1 omega^2).
TEST(BasicMechanics, SwingsLikeATwoMassOscillator) {
    const double tau = 0.1, ratio = 5, J1 = 2e-3, J2 = 0.08, c = 40;
    const double omega2 = c * (1 / (ratio * ratio * J1) + 1 / J2);
    const Recording r = run(driven("0.1", R"(
  Analogon.Mechanics.BasicMechanics shaft(r=5, J1=2e-3, J2=0.08, c=40, d=0);
  Analogon.Sensors.AngleSensor fast, slow;
  Analogon.Interfaces.RealOutput phi1, phi2;
equation
)") + driveConnections + R"(
  connect(drive.flange, shaft.flange_a);
  connect(shaft.flange_a, fast.flange);
  connect(shaft.flange_b, slow.flange);
  connect(fast.phi, phi1);
  connect(slow.phi, phi2);)",
                            1.5, 151);
    ASSERT_EQ(r.fault, "");
    // angle of the slow side without twist: both inertias follow r*tau
    const double total = ratio * ratio * J1 + J2;
    const double twist = tau / (ratio * J1 * omega2);
    const auto x = [&](double t) { return twist * (1 - std::cos(std::sqrt(omega2) * t)); };
    const auto centre = [&](double t) { return 0.5 * ratio * tau / total * t * t; };
    EXPECT_LT(worst(r, "phi1", [&](double t) { return ratio * (centre(t) + J2 / total * x(t)); }), 1e-6);
    EXPECT_LT(worst(r, "phi2", [&](double t) { return centre(t) - ratio * ratio * J1 / total * x(t); }), 1e-6);
}

// J2 = 0: the damped spring hangs on a held flange; J1 phi'' = tau - (c phi + d phi')/1 with r = 1.
TEST(BasicMechanics, DampsAgainstAHeldFlange) {
    const double tau = 0.3, J1 = 0.02, c = 8, d = 0.16;
    const Recording r = run(driven("0.3", R"(
  Analogon.Mechanics.BasicMechanics shaft(J1=0.02, J2=0, c=8, d=0.16);
  Analogon.Mechanics.Fixed wall;
  Analogon.Sensors.AngleSensor angle;
  Analogon.Interfaces.RealOutput phi;
equation
)") + driveConnections + R"(
  connect(drive.flange, shaft.flange_a);
  connect(shaft.flange_b, wall.flange);
  connect(shaft.flange_a, angle.flange);
  connect(angle.phi, phi);)",
                            2);
    ASSERT_EQ(r.fault, "");
    const double decay = d / (2 * J1), omega = std::sqrt(c / J1 - decay * decay);
    EXPECT_LT(worst(r, "phi",
                    [&](double t) {
                        return tau / c *
                               (1 - std::exp(-decay * t) * (std::cos(omega * t) + decay / omega * std::sin(omega * t)));
                    }),
              1e-7);
}

TEST(SpringDamper, HoldsAnInertiaToAFixedAngle) {
    const double J = 0.02, c = 8, d = 0.16;
    const Recording r = run(R"(
  Analogon.Mechanics.Fixed wall(phi0=0.25);
  Analogon.Mechanics.SpringDamper spring(c=8, d=0.16);
  Analogon.Mechanics.Inertia body(J=0.02);
  Analogon.Sensors.AngleSensor angle;
  Analogon.Interfaces.RealOutput phi;
equation
  connect(wall.flange, spring.flange_a);
  connect(spring.flange_b, body.flange_a);
  connect(body.flange_b, angle.flange);
  connect(angle.phi, phi);)",
                            2);
    ASSERT_EQ(r.fault, "");
    const double decay = d / (2 * J), omega = std::sqrt(c / J - decay * decay);
    EXPECT_LT(worst(r, "phi",
                    [&](double t) {
                        return 0.25 *
                               (1 - std::exp(-decay * t) * (std::cos(omega * t) + decay / omega * std::sin(omega * t)));
                    }),
              1e-7);
}

TEST(QuadraticLoad, LetsTheSpeedRunIntoItsLimit) {
    const double tau = 0.2, k = 5e-4, J = 0.01;
    const Recording r = run(driven("0.2", R"(
  Analogon.Mechanics.Inertia body(J=0.01);
  Analogon.Mechanics.QuadraticLoad load(k_q=5e-4);
  Analogon.Sensors.SpeedSensor speed;
  Analogon.Interfaces.RealOutput w;
equation
)") + driveConnections + R"(
  connect(drive.flange, body.flange_a);
  connect(body.flange_b, load.flange);
  connect(body.flange_b, speed.flange);
  connect(speed.w, w);)",
                            3);
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "w", [&](double t) { return std::sqrt(tau / k) * std::tanh(std::sqrt(tau * k) / J * t); }),
              1e-5);
}

TEST(QuadraticLoad, OpposesEitherDirection) {
    const Recording r = run(driven("-0.2", R"(
  Analogon.Mechanics.Inertia body(J=0.01);
  Analogon.Mechanics.QuadraticLoad load(k_q=5e-4);
  Analogon.Sensors.SpeedSensor speed;
  Analogon.Interfaces.RealOutput w;
equation
)") + driveConnections + R"(
  connect(drive.flange, body.flange_a);
  connect(body.flange_b, load.flange);
  connect(body.flange_b, speed.flange);
  connect(speed.w, w);)",
                            30);
    ASSERT_EQ(r.fault, "");
    EXPECT_NEAR(r.last("w"), -20, 1e-6);
}

TEST(ViscousLoad, LetsTheSpeedSettleExponentially) {
    const double tau = 0.2, b = 0.05, J = 0.01;
    const Recording r = run(driven("0.2", R"(
  Analogon.Mechanics.Inertia body(J=0.01);
  Analogon.Mechanics.ViscousLoad load(b=0.05);
  Analogon.Sensors.SpeedSensor speed;
  Analogon.Interfaces.RealOutput w;
equation
)") + driveConnections + R"(
  connect(drive.flange, body.flange_a);
  connect(body.flange_b, load.flange);
  connect(body.flange_b, speed.flange);
  connect(speed.w, w);)",
                            1);
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "w", [&](double t) { return tau / b * (1 - std::exp(-b / J * t)); }), 1e-6);
}

TEST(ReturnSpring, PullsTowardsItsRelaxedAngle) {
    const double tau = 0.3, c = 2, J = 0.01, relaxed = 0.1;
    const Recording r = run(driven("0.3", R"(
  Analogon.Mechanics.Inertia body(J=0.01);
  Analogon.Mechanics.ReturnSpring spring(c_r=2, phi_r=0.1);
  Analogon.Sensors.AngleSensor angle;
  Analogon.Interfaces.RealOutput phi;
equation
)") + driveConnections + R"(
  connect(drive.flange, body.flange_a);
  connect(body.flange_b, spring.flange);
  connect(body.flange_b, angle.flange);
  connect(angle.phi, phi);)",
                            2);
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "phi", [&](double t) { return (tau / c + relaxed) * (1 - std::cos(std::sqrt(c / J) * t)); }),
              1e-6);
}

TEST(BasicMechanicThermal, TurnsItsFrictionIntoHeat) {
    const double tau = 0.2, b = 0.05, J = 0.01, C = 30, T0 = 293.15;
    const Recording r = run(driven("0.2", R"(
  Analogon.MechanicThermal.BasicMechanicThermal bearing(b=0.05);
  Analogon.Mechanics.Inertia body(J=0.01);
  Analogon.Thermal.HeatCapacitor housing(C=30);
  Analogon.Sensors.SpeedSensor speed;
  Analogon.Sensors.TemperatureSensor sensor;
  Analogon.Interfaces.RealOutput w, T;
equation
)") + driveConnections + R"(
  connect(drive.flange, bearing.flange_a);
  connect(bearing.flange_b, body.flange_a);
  connect(body.flange_b, speed.flange);
  connect(bearing.heatPort, housing.port);
  connect(housing.port, sensor.port);
  connect(speed.w, w);
  connect(sensor.T, T);)",
                            2);
    ASSERT_EQ(r.fault, "");
    const double rate = b / J, top = tau / b;
    EXPECT_LT(worst(r, "w", [&](double t) { return top * (1 - std::exp(-rate * t)); }), 1e-6);
    // C T' = b w^2 with w = top (1 - e)
    EXPECT_LT(worst(r, "T",
                    [&](double t) {
                        const double e = std::exp(-rate * t);
                        return T0 + b * top * top / C * (t - 2 * (1 - e) / rate + (1 - e * e) / (2 * rate));
                    }),
              1e-6);
}

}  // namespace
}  // namespace analogon::bench
