/// Effects on a rod and in a circuit, hidden by equations of their own.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "core/base/work.hpp"
#include "core/effect/search/discover.hpp"
#include "tests/core/effect/text_task.hpp"

namespace analogon {
namespace {

using State = std::array<double, 2>;

/// One step of the classical Runge-Kutta method.
State stepped(const State& x, double t, double h, const std::function<State(double, const State&)>& rate) {
    const auto along = [&](const State& k, double part) {
        return State{x[0] + part * h * k[0], x[1] + part * h * k[1]};
    };
    const State a = rate(t, x), b = rate(t + h / 2, along(a, 0.5)), c = rate(t + h / 2, along(b, 0.5)),
                d = rate(t + h, along(c, 1));
    return {x[0] + h * (a[0] + 2 * b[0] + 2 * c[0] + d[0]) / 6, x[1] + h * (a[1] + 2 * b[1] + 2 * c[1] + d[1]) / 6};
}

/// Levels of many sizes, joined by straight lines from one sample to the next.
double level(double sample, int pause) {
    constexpr std::array<double, 8> levels{0, 0.7, 0.3, 1, 0.5, 0.15, 0.85, 0.4};
    const auto at = [&](int k) { return levels[static_cast<std::size_t>(k / pause) % levels.size()]; };
    const int k = static_cast<int>(std::floor(sample));
    return at(k) + (at(k + 1) - at(k)) * (sample - k);
}

// ------------------------------------------------------------------------------------------------ a rod

constexpr const char* rodText = R"(model Rod
  Analogon.Interfaces.RealInput F(unit="N");
  Analogon.Interfaces.RealOutput s(unit="m");
  Analogon.Sources.PrescribedForce drive;
  Analogon.Translation.Mass mass(m=0.3);
  Analogon.Translation.SpringDamper spring(c=700, d=8);
  Analogon.Translation.Fixed housing;
  Analogon.Sensors.PositionSensor position;
equation
  connect(F, drive.f);
  connect(drive.flange, mass.flange_a);
  connect(mass.flange_b, spring.flange_b);
  connect(spring.flange_a, housing.flange);
  connect(mass.flange_b, position.flange);
  connect(position.s, s);
end Rod;
)";

/// 0.45 kg on a spring of 900 N/m with 6 N.s/m, a force of up to 12 N, the position with a noise of 0.02 mm.
EstimationTask rod(double quadratic, double constant) {
    constexpr double step = 0.002;
    constexpr int samples = 1200, within = 10;
    EstimationTask task = taskOf(rodText, "Rod");
    task.parameters = {
        {"mass.m", "kg", 0.3, 0.05, 5}, {"spring.c", "N/m", 700, 50, 1e4}, {"spring.d", "N.s/m", 8, 0.1, 100}};
    Recording r = blankRecording("steps", {"F"}, {"s"}, samples);
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    const auto force = [&](double t) { return 12 * level(t / step, 60); };
    State x{};
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(k * step);
        r.inputs(0, k) = force(k * step);
        r.outputs(0, k) = x[0] + 2e-5 * normal(random);
        for (int j = 0; j < within; ++j)
            x = stepped(x, (k + static_cast<double>(j) / within) * step, step / within, [&](double t, const State& y) {
                const double drag = 6 * y[1] + quadratic * y[1] * std::abs(y[1]) + constant;
                return State{y[1], (force(t) - 900 * y[0] - drag) / 0.45};
            });
    }
    task.recordings = {std::move(r)};
    return task;
}

TEST(DiscoveryOnARod, AddsNothingWhereNothingIsMissing) {
    const Outcome<Finding> finding = discover(rod(0, 0));
    ASSERT_TRUE(finding) << format(finding.diagnostics());
    EXPECT_EQ(finding->kind, FindingKind::Adequate);
    EXPECT_TRUE(finding->effects.empty());
}

// Its limits of work (thresholds of origin "cost") are there to save time: each must be felt.
TEST(DiscoveryOnARod, NamesADragWithTheSquareOfTheVelocity) {
    const WorkCount work;
    const Outcome<Finding> finding = discover(rod(30, 0));
    EXPECT_NEAR(work.done(), 3.65e6, 0.37e6) << "steps";
    ASSERT_TRUE(finding) << format(finding.diagnostics());
    ASSERT_EQ(finding->effects.size(), 1u);
    EXPECT_EQ(finding->effects.front().kind, "drag.quadratic");
    EXPECT_EQ(finding->effects.front().at, "drive.flange");
    EXPECT_NEAR(finding->effects.front().parameters.front().value, 30, 0.3);
}

TEST(DiscoveryOnARod, NamesAConstantForceOrWhatIsTheSame) {
    const Outcome<Finding> finding = discover(rod(0, 2));
    ASSERT_TRUE(finding) << format(finding.diagnostics());
    ASSERT_EQ(finding->effects.size(), 1u);
    const AddedEffect& effect = finding->effects.front();
    const auto isForce = [](const std::string& kind) { return kind == "force.constant"; };
    EXPECT_TRUE(isForce(effect.kind) || std::any_of(effect.instead.effects.begin(), effect.instead.effects.end(),
                                                    [&](const auto& other) { return isForce(other.kind); }))
        << effect.kind;
}

// ------------------------------------------------------------------------------------------------ a circuit

constexpr const char* circuitText = R"(model Circuit
  Analogon.Interfaces.RealInput V(unit="V");
  Analogon.Interfaces.RealOutput i(unit="A");
  Analogon.Interfaces.RealOutput u(unit="V");
  Analogon.Sources.PrescribedVoltage supply;
  Analogon.Electric.Resistor resistor(R=2);
  Analogon.Electric.Inductor coil(L=1e-3);
  Analogon.Sensors.CurrentSensor ammeter;
  Analogon.Electric.Capacitor filter(C=3e-5);
  Analogon.Electric.Resistor load(R=15);
  Analogon.Electric.Ground ground;
  Analogon.Sensors.VoltageSensor voltmeter;
equation
  connect(V, supply.v);
  connect(supply.p, resistor.p);
  connect(resistor.n, coil.p);
  connect(coil.n, ammeter.p);
  connect(ammeter.n, filter.p);
  connect(ammeter.n, load.p);
  connect(filter.n, ground.p);
  connect(load.n, ground.p);
  connect(supply.n, ground.p);
  connect(voltmeter.p, load.p);
  connect(voltmeter.n, ground.p);
  connect(ammeter.i, i);
  connect(voltmeter.v, u);
end Circuit;
)";

/// 2 Ohm and 1.5 mH into 40 uF beside 15 Ohm; what else the resistor has, and what flows to ground in front of the coil
/// (beside the load it would be another value of the load).
EstimationTask circuit(double furtherResistance, double leakage) {
    constexpr double step = 2e-5;
    constexpr int samples = 1600, within = 10;
    EstimationTask task = taskOf(circuitText, "Circuit");
    task.parameters = {{"coil.L", "H", 1e-3, 1e-5, 1}, {"filter.C", "F", 3e-5, 1e-7, 1e-3}};
    Recording r = blankRecording("steps", {"V"}, {"i", "u"}, samples);
    std::mt19937 random(6);
    std::normal_distribution<double> normal;
    const auto voltage = [&](double t) { return 12 * level(t / step, 80); };
    State x{};  // current, voltage of the load
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(k * step);
        r.inputs(0, k) = voltage(k * step);
        r.outputs(0, k) = x[0] + 0.004 * normal(random);
        r.outputs(1, k) = x[1] + 0.02 * normal(random);
        for (int j = 0; j < within; ++j)
            x = stepped(x, (k + static_cast<double>(j) / within) * step, step / within, [&](double t, const State& y) {
                const double R = 2 + furtherResistance, shared = 1 / (1 + R * leakage);  // as Thevenin's source
                return State{(shared * voltage(t) - shared * R * y[0] - y[1]) / 1.5e-3, (y[0] - y[1] / 15) / 40e-6};
            });
    }
    task.recordings = {std::move(r)};
    return task;
}

TEST(DiscoveryInACircuit, AddsNothingWhereNothingIsMissing) {
    const Outcome<Finding> finding = discover(circuit(0, 0));
    ASSERT_TRUE(finding) << format(finding.diagnostics());
    EXPECT_EQ(finding->kind, FindingKind::Adequate);
    EXPECT_TRUE(finding->effects.empty());
}

TEST(DiscoveryInACircuit, NamesALeakage) {
    const Outcome<Finding> finding = discover(circuit(0, 0.05));
    ASSERT_TRUE(finding) << format(finding.diagnostics());
    ASSERT_EQ(finding->effects.size(), 1u);
    EXPECT_EQ(finding->effects.front().kind, "leakage");
    EXPECT_EQ(finding->effects.front().at, "resistor.n");
    EXPECT_NEAR(finding->effects.front().parameters.front().value, 0.05, 5e-4);
}

TEST(DiscoveryInACircuit, NamesTheResistanceOfALead) {
    const WorkCount work;
    const Outcome<Finding> finding = discover(circuit(0.7, 0));
    EXPECT_NEAR(work.done(), 2.73e6, 0.28e6) << "steps";
    ASSERT_TRUE(finding) << format(finding.diagnostics());
    ASSERT_EQ(finding->effects.size(), 1u);
    EXPECT_EQ(finding->effects.front().kind, "resistance.series");
    EXPECT_NEAR(finding->effects.front().parameters.front().value, 0.7, 5e-3);
}

}  // namespace
}  // namespace analogon
