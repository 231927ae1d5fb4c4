#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/resources/bench.hpp"

/// Blocks on a rod and the effects that go there, against what can be worked out by hand.
namespace analogon::bench {
namespace {

/// A mass of 0.5 kg that a force drives, with a component on its rod.
Recording rodWith(const std::string& component, double duration, double force, const std::string& damper = "") {
    std::string declarations = R"(
  Analogon.Interfaces.RealInput F(unit="N");
  Analogon.Sources.PrescribedForce drive;
  Analogon.Translation.Mass body(m=0.5);
  Analogon.Sensors.PositionSensor position;
  Analogon.Sensors.VelocitySensor velocity;
  Analogon.Interfaces.RealOutput s(unit="m"), v(unit="m/s");
)";
    std::string equations = R"(
equation
  connect(F, drive.f);
  connect(drive.flange, body.flange_a);
  connect(body.flange_b, position.flange);
  connect(body.flange_b, velocity.flange);
  connect(position.s, s);
  connect(velocity.v, v);
)";
    if (!component.empty()) {
        declarations += fmt::format("  Analogon.{};\n", component);
        equations += "  connect(body.flange_b, effect.flange);\n";
    }
    if (!damper.empty()) {
        declarations += fmt::format("  Analogon.Effects.Translation.ViscousFriction damper(b={});\n", damper);
        equations += "  connect(body.flange_b, damper.flange);\n";
    }
    return run(declarations + equations, duration, 201, {constant(force)});
}

TEST(Mass, TakesUpAForceAsAcceleration) {
    const Recording r = rodWith("", 2, 3);
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "v", [](double t) { return 6 * t; }), 1e-6);
    EXPECT_LT(worst(r, "s", [](double t) { return 3 * t * t; }), 1e-6);
}

TEST(SpringDamperOfARod, HoldsAMassToTheHousing) {
    const Recording r = run(R"(
  Analogon.Interfaces.RealInput F(unit="N");
  Analogon.Sources.PrescribedForce drive;
  Analogon.Translation.Mass body(m=0.5);
  Analogon.Translation.SpringDamper spring(c=200, d=0, s_rel0=0.02);
  Analogon.Translation.Fixed housing(s0=-0.02);
  Analogon.Sensors.ForceSensor force;
  Analogon.Sensors.PositionSensor position;
  Analogon.Interfaces.RealOutput s(unit="m"), f(unit="N");
equation
  connect(F, drive.f);
  connect(drive.flange, body.flange_a);
  connect(body.flange_b, force.flange_a);
  connect(force.flange_b, spring.flange_b);
  connect(spring.flange_a, housing.flange);
  connect(body.flange_b, position.flange);
  connect(position.s, s);
  connect(force.f, f);)",
                            2, 201, {constant(4)});
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "s", [](double t) { return 0.02 * (1 - std::cos(20 * t)); }), 1e-6);
    EXPECT_LT(worst(r, "f", [](double t) { return 4 * (1 - std::cos(20 * t)); }), 1e-3);
}

TEST(Rack, JoinsAShaftAndARodWithoutLoss) {
    const Recording r = run(R"(
  Analogon.Interfaces.RealInput tau(unit="N.m");
  Analogon.Sources.PrescribedTorque drive;
  Analogon.Mechanics.Inertia rotor(J=1e-3);
  Analogon.Translation.Rack rack(r=0.02);
  Analogon.Translation.Mass slide(m=5);
  Analogon.Sensors.SpeedSensor speed;
  Analogon.Sensors.VelocitySensor velocity;
  Analogon.Interfaces.RealOutput w(unit="rad/s"), v(unit="m/s");
equation
  connect(tau, drive.tau);
  connect(drive.flange, rotor.flange_a);
  connect(rotor.flange_b, rack.flange_a);
  connect(rack.flange_b, slide.flange_a);
  connect(rotor.flange_b, speed.flange);
  connect(slide.flange_b, velocity.flange);
  connect(speed.w, w);
  connect(velocity.v, v);)",
                            1, 101, {constant(0.06)});
    ASSERT_EQ(r.fault, "");
    // seen from the shaft the slide is m*r^2 = 2e-3 kg.m2
    EXPECT_LT(worst(r, "w", [](double t) { return 20 * t; }), 1e-6);
    EXPECT_LT(worst(r, "v", [](double t) { return 0.4 * t; }), 1e-7);
}

// ------------------------------------------------------------------------------------------------ effects

TEST(FrictionOfARod, TakesAConstantForceFromTheMotionAndHoldsWhatIsDrivenTooWeakly) {
    const std::string effect = "Effects.Translation.CoulombFriction effect(F_c=1, v_eps=1e-6)";
    const Recording moving = rodWith(effect, 2, 3), held = rodWith(effect, 2, 0.9);
    ASSERT_EQ(moving.fault + held.fault, "");
    EXPECT_LT(worst(moving, "v", [](double t) { return 4 * t; }), 1e-4);
    EXPECT_LT(worst(held, "v", constant(0)), 1e-5);
}

TEST(StribeckFrictionOfARod, BreaksAwayOnlyAboveTheSumOfBothForces) {
    const std::string effect = "Effects.Translation.StribeckFriction effect(F_c=1, F_s=0.5, v_s=0.1, v_eps=1e-5)";
    const Recording held = rodWith(effect, 2, 1.45), free = rodWith(effect, 20, 1.6);
    ASSERT_EQ(held.fault + free.fault, "");
    EXPECT_LT(worst(held, "v", constant(0)), 1e-3);
    const std::vector<double>& v = free["v"];
    EXPECT_NEAR((v[200] - v[190]) / (free.time[200] - free.time[190]), 1.2, 1e-5);  // F_c alone is left: 0.6/0.5
}

TEST(ViscousFrictionOfARod, LetsTheVelocitySettle) {
    const Recording r = rodWith("Effects.Translation.ViscousFriction effect(b=2)", 1, 3);
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "v", [](double t) { return 1.5 * (1 - std::exp(-4 * t)); }), 1e-6);
}

TEST(QuadraticDragOfARod, LetsTheVelocityRunIntoItsLimit) {
    const Recording r = rodWith("Effects.Translation.QuadraticDrag effect(k_q=2)", 2, -2);
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "v", [](double t) { return -std::tanh(4 * t); }), 1e-5);
}

TEST(ConstantForce, ActsAtAnyVelocity) {
    const Recording r = rodWith("Effects.Translation.ConstantForce effect(F_0=4)", 1, 3);
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "v", [](double t) { return -2 * t; }), 1e-6);
}

TEST(ReturnSpringOfARod, HoldsTheMassWhereItsForceEqualsTheDrive) {
    const Recording r = rodWith("Effects.Translation.ReturnSpring effect(c_r=50, s_r=0.1)", 30, 3, "5");
    ASSERT_EQ(r.fault, "");
    EXPECT_NEAR(r.last("s"), 0.1 + 3.0 / 50, 1e-6);
}

TEST(AddedMass, SlowsTheAcceleration) {
    const Recording r = rodWith("Effects.Translation.AddedMass effect(m=1)", 1, 3);
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "v", [](double t) { return 2 * t; }), 1e-6);
}

/// Two masses with an effect between them, driven by 0.2 N from the left.
Recording twoMasses(const std::string& effect, double duration) {
    return run(fmt::format(R"(
  Analogon.Sources.Constant force(k=0.2);
  Analogon.Sources.PrescribedForce drive;
  Analogon.Translation.Mass first(m=0.01), second(m=0.03);
  Analogon.Sensors.VelocitySensor left, right;
  Analogon.Interfaces.RealOutput v1, v2;
  Analogon.Effects.Translation.{};
equation
  connect(force.y, drive.f);
  connect(drive.flange, first.flange_a);
  connect(first.flange_b, effect.flange_a);
  connect(effect.flange_b, second.flange_a);
  connect(first.flange_b, left.flange);
  connect(second.flange_b, right.flange);
  connect(left.v, v1);
  connect(right.v, v2);)",
                           effect),
               duration, 201);
}

TEST(ElasticRod, LetsTheMassesSwingAgainstEachOtherAndIsRigidWithoutCompliance) {
    const Recording soft = twoMasses("ElasticRod effect(e=0.02)", 2),
                    rigid = twoMasses("ElasticRod effect(e=0, d=3)", 2);
    ASSERT_EQ(soft.fault + rigid.fault, "");
    const double omega = std::sqrt(50 * (1 / 0.01 + 1 / 0.03)), stretch = 0.2 / 0.01 / (omega * omega);
    EXPECT_LT(worst(soft, "v1", [&](double t) { return 5 * t + 0.75 * stretch * omega * std::sin(omega * t); }), 1e-4);
    EXPECT_LT(worst(soft, "v2", [&](double t) { return 5 * t - 0.25 * stretch * omega * std::sin(omega * t); }), 1e-4);
    EXPECT_LT(worst(rigid, "v2", [](double t) { return 5 * t; }), 1e-6);
}

TEST(BacklashOfARod, LeavesTheSecondMassAloneUntilThePlayIsUsedUp) {
    // half the play of 0.4 m is passed after sqrt(0.4*0.01/0.2) = 0.141 s
    const Recording before = twoMasses("Backlash effect(b=0.4, c=500, d=0.5, s_eps=1e-6)", 0.14);
    const Recording after = twoMasses("Backlash effect(b=0.4, c=500, d=0.5, s_eps=1e-6)", 5);
    ASSERT_EQ(before.fault + after.fault, "");
    EXPECT_LT(worst(before, "v1", [](double t) { return 20 * t; }), 1e-3);
    EXPECT_LT(worst(before, "v2", constant(0)), 1e-3);
    EXPECT_NEAR(0.01 * after.last("v1") + 0.03 * after.last("v2"), 0.2 * 5, 1e-6);
    EXPECT_NEAR(after.last("v1"), after.last("v2"), 1e-2);
}

}  // namespace
}  // namespace analogon::bench
