/// Effects of two driven shafts, simulated by equations of their own: a soft coupling, a curved command, a tachometer
/// without sign.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/effect/search/discover.hpp"
#include "tests/core/effect/text_task.hpp"

namespace analogon {
namespace {

constexpr const char* shaftsText = R"(model Shafts
  Analogon.Interfaces.RealInput u1(unit="N.m");
  Analogon.Interfaces.RealInput u2(unit="N.m");
  Analogon.Interfaces.RealOutput w1(unit="rad/s");
  Analogon.Interfaces.RealOutput w2(unit="rad/s");
  Analogon.Sources.PrescribedTorque drive1;
  Analogon.Sources.PrescribedTorque drive2;
  Analogon.Mechanics.Inertia rotor1(J=0.01);
  Analogon.Mechanics.Inertia rotor2(J=0.01);
  Analogon.Mechanics.ViscousLoad load1(b=0.02);
  Analogon.Mechanics.ViscousLoad load2(b=0.02);
  Analogon.Sensors.SpeedSensor speed1;
  Analogon.Sensors.SpeedSensor speed2;
equation
  connect(u1, drive1.tau);
  connect(u2, drive2.tau);
  connect(drive1.flange, rotor1.flange_a);
  connect(drive2.flange, rotor2.flange_a);
  connect(rotor1.flange_b, load1.flange);
  connect(rotor2.flange_b, load2.flange);
  connect(rotor1.flange_b, speed1.flange);
  connect(rotor2.flange_b, speed2.flange);
  connect(speed1.w, w1);
  connect(speed2.w, w2);
end Shafts;
)";

struct Hidden {
    double c{}, d{};       // of a coupling between the shafts [N.m/rad], [N.m.s/rad]
    double exponent{};     // of the first command beyond proportion, about 0.3 N.m
    bool isWithoutSign{};  // the second tachometer
};

/// Torques in steps of many sizes and both signs, the speeds with a noise of 0.02 rad/s; integrated in small steps.
EstimationTask shafts(const Hidden& hidden) {
    constexpr double step = 0.02;
    constexpr int samples = 900, within = 60;
    EstimationTask task = taskOf(shaftsText, "Shafts");
    for (const char* name : {"rotor1.J", "rotor2.J"}) task.parameters.push_back({name, "kg.m2", 0.02, 1e-3, 1});
    for (const char* name : {"load1.b", "load2.b"}) task.parameters.push_back({name, "N.m.s/rad", 0.03, 1e-3, 1});
    Recording r = blankRecording("steps", {"u1", "u2"}, {"w1", "w2"}, samples);
    std::mt19937 random(8);
    std::normal_distribution<double> normal;
    const auto torque = [](int shaft, int k) {
        constexpr double levels[] = {0.3, -0.1, 0.2, 0.05, -0.25, 0.15, -0.02, 0.1};
        return levels[static_cast<std::size_t>(k / (shaft == 0 ? 60 : 85)) % 8];
    };
    double w[2] = {0, 0}, twist = 0;
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(step * k);
        for (const int s : {0, 1}) {
            r.inputs(s, k) = torque(s, k);
            const bool isLost = s == 1 && hidden.isWithoutSign;
            r.outputs(s, k) = (isLost ? std::abs(w[s]) : w[s]) + 0.02 * normal(random);
        }
        for (int i = 0; i < within; ++i) {
            const double part = (i + 0.5) / within, dt = step / within;
            const double over = hidden.c * twist + hidden.d * (w[0] - w[1]);
            double tau[2];
            for (const int s : {0, 1}) tau[s] = (1 - part) * torque(s, k) + part * torque(s, k + 1);
            tau[0] *= std::pow(std::abs(tau[0]) / 0.3, hidden.exponent);
            w[0] += dt / 0.01 * (tau[0] - 0.02 * w[0] - over);
            w[1] += dt / 0.01 * (tau[1] - 0.02 * w[1] + over);
            twist += dt * (w[0] - w[1]);
        }
    }
    task.recordings = {r};
    return task;
}

/// The one effect that is found, with a value.
void expectFound(const Hidden& hidden, const std::string& kind, const std::string& at, double value) {
    const Outcome<Finding> finding = discover(shafts(hidden));
    ASSERT_TRUE(finding) << format(finding.diagnostics());
    EXPECT_EQ(finding->kind, FindingKind::Effect);
    ASSERT_EQ(finding->effects.size(), 1u);
    const AddedEffect& effect = finding->effects.front();
    EXPECT_EQ(effect.kind, kind);
    EXPECT_EQ(effect.at, at);
    EXPECT_EQ(effect.confidence, Confidence::Established);
    ASSERT_FALSE(effect.parameters.empty());
    EXPECT_NEAR(effect.parameters.front().value, value, 4 * effect.parameters.front().standardError);
}

TEST(DiscoveryOnTwoShafts, NamesASoftCouplingOfThem) {
    expectFound({.c = 0.05, .d = 0.002}, "compliance.bridge", "drive1.flange <-> drive2.flange", 0.05);
}

TEST(DiscoveryOnTwoShafts, NamesATorqueThatIsNoMultipleOfTheCommand) {
    expectFound({.exponent = 0.4}, "actuator.curve", "input u1", 0.4);
}

TEST(DiscoveryOnTwoShafts, NamesATachometerWithoutSign) {
    expectFound({.isWithoutSign = true}, "sensor.absolute", "output w2", 1);
}

TEST(DiscoveryOnTwoShafts, FindsNothingWhereNothingIsHidden) {
    const Outcome<Finding> finding = discover(shafts({}));
    ASSERT_TRUE(finding) << format(finding.diagnostics());
    EXPECT_EQ(finding->kind, FindingKind::Adequate);
    EXPECT_TRUE(finding->effects.empty());
}

}  // namespace
}  // namespace analogon
