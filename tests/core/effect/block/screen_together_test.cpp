#include "core/effect/block/screen_together.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/effect/block/candidates_of.hpp"
#include "tests/core/effect/lagging_body.hpp"

namespace analogon {
namespace {

/// Two shafts on a soft coupling, the speed of the far one recorded: it has a dry friction that the model lacks.
EstimationTask twoShafts() {
    EstimationTask task = taskOf(R"(model Shafts
  Analogon.Interfaces.RealInput tau(unit="N.m");
  Analogon.Interfaces.RealOutput w(unit="rad/s");
  Analogon.Sources.PrescribedTorque drive;
  Analogon.Mechanics.Inertia near(J=0.01);
  Analogon.Mechanics.SpringDamper coupling(c=4, d=0.02);
  Analogon.Mechanics.Inertia far(J=0.02);
  Analogon.Mechanics.ViscousLoad drag(b=0.01);
  Analogon.Sensors.SpeedSensor speed;
equation
  connect(tau, drive.tau);
  connect(drive.flange, near.flange_a);
  connect(near.flange_b, coupling.flange_a);
  connect(coupling.flange_b, far.flange_a);
  connect(far.flange_b, drag.flange);
  connect(far.flange_b, speed.flange);
  connect(speed.w, w);
end Shafts;
)",
                                 "Shafts");
    task.parameters = {{"drag.b", "N.m.s/rad", 0.02, 1e-4, 1}};
    constexpr double step = 0.02;
    Recording r = blankRecording("run", {"tau"}, {"w"}, 600);
    std::mt19937 random(4);
    std::normal_distribution<double> noise(0, 0.02);
    double near = 0, far = 0, twist = 0;
    for (int k = 0; k < 600; ++k) {
        const double torque = (k / 60) % 3 == 0 ? 0.5 : (k / 60) % 3 == 1 ? -0.4 : 0.1;
        r.time.push_back(step * k);
        r.inputs(0, k) = torque;
        r.outputs(0, k) = far + noise(random);
        for (int i = 0; i < 200; ++i) {
            const double h = step / 200, passed = 4 * twist + 0.02 * (near - far);
            near += h * (torque - passed) / 0.01;
            far += h * (passed - 0.01 * far - 0.04 * std::tanh(far / 0.01)) / 0.02;
            twist += h * (near - far);
        }
    }
    task.recordings = {std::move(r)};
    return task;
}

/// Two bodies in one, and a third behind a layer, which is warmed and loses heat that the model knows nothing of.
EstimationTask threeBodies() {
    EstimationTask task = taskOf(R"(model Bodies
  Analogon.Interfaces.RealInput P(unit="W");
  Analogon.Interfaces.RealOutput T(unit="K");
  Analogon.Sources.PrescribedHeatFlow heater;
  Analogon.Thermal.HeatCapacitor core(C=3, T_start=300), shell(C=1, T_start=300), cover(C=2, T_start=300);
  Analogon.Thermal.ThermalConductor layer(G=0.5), gap(G=0.8), away(G=0.2);
  Analogon.Sources.FixedTemperature surroundings(T=300);
  Analogon.Sensors.TemperatureSensor sensor;
equation
  connect(P, heater.Q_flow);
  connect(heater.port, core.port);
  connect(core.port, shell.port);
  connect(shell.port, layer.port_a);
  connect(layer.port_b, gap.port_a);
  connect(gap.port_b, cover.port);
  connect(cover.port, away.port_a);
  connect(away.port_b, surroundings.port);
  connect(cover.port, sensor.port);
  connect(sensor.T, T);
end Bodies;
)",
                                 "Bodies");
    task.parameters = {{"away.G", "W/K", 0.1, 0.01, 10}};
    constexpr double step = 0.5;
    Recording r = blankRecording("run", {"P"}, {"T"}, 400);
    std::mt19937 random(8);
    std::normal_distribution<double> noise(0, 0.02);
    double body = 300, cover = 300;
    for (int k = 0; k < 400; ++k) {
        const double power = (k / 80) % 2 == 0 ? 6 : 1;
        r.time.push_back(step * k);
        r.inputs(0, k) = power;
        r.outputs(0, k) = cover + noise(random);
        for (int i = 0; i < 50; ++i) {
            const double passed = 0.5 * 0.8 / (0.5 + 0.8) * (body - cover);
            body += step / 50 * (power - passed - 0.03 * (body - 300)) / 4;
            cover += step / 50 * (passed - 0.2 * (cover - 300)) / 2;
        }
    }
    task.recordings = {std::move(r)};
    return task;
}

std::vector<Candidate> candidatesIn(const Variant& variant) {
    const Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(variant.task.library);
    Outcome<std::vector<Candidate>> candidates = candidatesFor(variant, *catalogue);
    EXPECT_TRUE(candidates);
    return std::move(*candidates);
}

TEST(ScreenTogether, JoinsPlacesOfOneClassThatASlopeShows) {
    const NullModel null = fittedModel(twoShafts());
    const std::vector<Candidate> candidates = candidatesIn(null.variant);
    std::vector<int> seen(candidates.size());
    std::size_t joined = 0;
    for (const std::vector<std::size_t>& group : screenedTogether(candidates)) {
        for (const std::size_t i : group) {
            ++seen[i];
            EXPECT_EQ(candidates[i].effect.className, candidates[group.front()].effect.className);
            EXPECT_TRUE(group.size() == 1 || candidates[i].effect.trial.states == 0);
        }
        joined += group.size() > 1 ? group.size() : 0;
    }
    EXPECT_EQ(seen, std::vector<int>(candidates.size(), 1));
    EXPECT_GT(joined, 8u);
}

/// What was compared with the screening of each by itself.
struct Compared {
    int all{}, shaped{}, fixed{}, secants{}, specialised{};
};

void compareProbes(const Screened& together, const Screened& alone, double within, Compared& compared) {
    ASSERT_EQ(together.probes.size(), alone.probes.size());
    for (std::size_t k = 0; k < alone.probes.size(); ++k) {
        const Probe &a = together.probes[k], &b = alone.probes[k];
        EXPECT_EQ(a.values.size(), b.values.size());
        EXPECT_NEAR(a.secant, b.secant, 1e-6 * std::abs(b.secant));
        const bool isImitated = b.plain.visible < leastVisible;  // then rounding is all that is left of it
        EXPECT_EQ(a.plain.visible < leastVisible, isImitated);
        if (isImitated) continue;
        EXPECT_NEAR(a.plain.explained, b.plain.explained, within * b.plain.explained + 1e-6);
        EXPECT_NEAR(a.whitened.explained, b.whitened.explained, within * b.whitened.explained + 1e-6);
        EXPECT_NEAR(a.strength(), b.strength(), within * std::abs(b.strength()) + 1e-12);
        compared.shaped += !b.values.empty();
        compared.secants += b.secant != 0;
    }
}

/// All that is screened together against what each tells by itself.
Compared compareWithEachAlone(const NullModel& null, double within) {
    const std::vector<Candidate> candidates = candidatesIn(null.variant);
    Compared compared;
    for (const std::vector<std::size_t>& group : screenedTogether(candidates)) {
        if (group.size() < 2) continue;
        std::vector<Candidate> members;
        for (const std::size_t i : group) members.push_back(candidates[i]);
        const std::vector<Screened> all = screenTogether(null, members, {}, {});
        EXPECT_EQ(all.size(), members.size());
        for (std::size_t i = 0; i < members.size(); ++i) {
            SCOPED_TRACE(members[i].effect.className + " at " + members[i].place.at);
            const Screened alone = screen(null, members[i], {}, {});
            EXPECT_EQ(all[i].failure, alone.failure);
            EXPECT_EQ(all[i].candidate.place, members[i].place);
            EXPECT_EQ(all[i].fixed.size(), alone.fixed.size());
            for (const auto& [name, value] : alone.fixed) EXPECT_NEAR(all[i].fixed.at(name), value, 1e-6 * value);
            EXPECT_EQ(all[i].absorbedBy, alone.absorbedBy);
            EXPECT_EQ(all[i].isAbsorbed(), alone.isAbsorbed());
            EXPECT_TRUE(alone.isAbsorbed() || all[i].isWrongSign() == alone.isWrongSign());
            compareProbes(all[i], alone, within, compared);
            compared.fixed += !alone.fixed.empty();
            compared.specialised += members[i].effect.placement.way == Way::Specialise;
            ++compared.all;
        }
    }
    return compared;
}

TEST(ScreenTogether, TellsOfEachWhatItTellsByItself) {
    const Compared compared = compareWithEachAlone(fittedModel(twoShafts()), 1e-5);
    EXPECT_GT(compared.all, 8);
    EXPECT_GT(compared.shaped, 0);
    EXPECT_GT(compared.fixed, 0);
}

/// Resistances between parts are tried at strengths other than 0, conductors are replaced by others. Where two masses
/// are one, a resistance between them makes two of them: that is found out by halves.
TEST(ScreenTogether, TellsOfWhatIsInsertedAndReplacedWhatItTellsByItself) {
    const Compared compared = compareWithEachAlone(fittedModel(threeBodies()), 1e-5);
    EXPECT_GT(compared.secants, 8);
    EXPECT_GT(compared.specialised, 4);
}

/// A mass where there is none is a state more, one at a body is none: told of each as by itself.
TEST(ScreenTogether, ScreensByThemselvesThoseWhoseModelHasMoreStates) {
    EstimationTask task = taskOf(R"(model Block
  Analogon.Interfaces.RealInput P(unit="W");
  Analogon.Interfaces.RealOutput T(unit="K");
  Analogon.Sources.PrescribedHeatFlow heater;
  Analogon.Thermal.HeatCapacitor body(C=4, T_start=300);
  Analogon.Thermal.ThermalConductor near(G=0.4), away(G=0.4);
  Analogon.Sources.FixedTemperature surroundings(T=300);
  Analogon.Sensors.TemperatureSensor sensor;
equation
  connect(P, heater.Q_flow);
  connect(heater.port, body.port);
  connect(body.port, near.port_a);
  connect(near.port_b, away.port_a);
  connect(away.port_b, surroundings.port);
  connect(body.port, sensor.port);
  connect(sensor.T, T);
end Block;
)",
                                 "Block");
    task.parameters = {{"near.G", "W/K", 0.3, 0.01, 10}};
    task.recordings = {recordingOf("warm-up", {3})};
    const NullModel null = fittedModel(task);
    std::vector<Candidate> masses;
    for (Candidate& c : candidatesIn(null.variant))
        if (c.effect.className == "Analogon.Effects.Thermal.Mass") masses.push_back(std::move(c));
    ASSERT_EQ(masses.size(), 2u);
    ASSERT_EQ(screenedTogether(masses).size(), 1u);
    const std::vector<Screened> all = screenTogether(null, masses, {}, {});
    for (std::size_t i = 0; i < 2; ++i) {
        const Screened alone = screen(null, masses[i], {}, {});
        EXPECT_EQ(all[i].failure, alone.failure);
        ASSERT_EQ(all[i].probes.size(), alone.probes.size());
        ASSERT_FALSE(alone.probes.empty()) << alone.failure;
        EXPECT_EQ(all[i].probes[0].plain.explained, alone.probes[0].plain.explained) << "to the bit: the same way";
    }
}

}  // namespace
}  // namespace analogon
