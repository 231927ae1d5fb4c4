#include "core/effect/model/wire_in.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/effect/block/screen.hpp"
#include "tests/core/effect/text_task.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;

EffectClass effectOf(const Library& library, const std::string& kind) {
    const Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(library);
    for (const EffectClass& e : *catalogue)
        if (e.kind == kind) return e;
    ADD_FAILURE() << "no " << kind;
    return {};
}

/// Inputs and outputs need not be connectors: many write them as variables of the model.
const char* const heater = R"(model Heater
  input Real u(unit="V");
  output Real i(unit="A") = u/R;
  output Real T(unit="K");
  parameter Real R = 2;
  Real E(start=0, fixed=true);
equation
  der(E) = u*i - 0.1*E;
  T = 293.15 + E;
end Heater;
)";

TEST(WireIn, PutsASensorsEffectBehindAPlainOutput) {
    const Variant variant{taskOf(heater, "Heater"), {}, {}};
    const EffectClass lag = effectOf(variant.task.library, "sensor.lag");
    const Outcome<Variant> current = withEffect(variant, lag, {"output i", "i", {}}, {{"T", 0.5}});
    ASSERT_TRUE(current) << format(current.diagnostics());
    // the model goes on with what the sensor sees, not with what it shows
    EXPECT_THAT(current->task.model->text(), HasSubstr("der(E) = u*lag.u - 0.1*E"));
    EXPECT_THAT(current->task.model->text(), HasSubstr("lag.u = u/R"));
    EXPECT_THAT(current->task.model->text(), HasSubstr("i = lag.y"));
    const Outcome<Variant> both = withEffect(*current, lag, {"output T", "T", {}}, {{"T", 2}});
    ASSERT_TRUE(both) << format(both.diagnostics());
    const Outcome<FlatModel> flat = flatten(both->task.library, "Heater");
    ASSERT_TRUE(flat) << format(flat.diagnostics());
    EXPECT_TRUE(analyse(std::make_shared<FlatModel>(*flat), {}));
}

TEST(WireIn, PutsAnActuatorsEffectBeforeAPlainInput) {
    const Variant variant{taskOf(heater, "Heater"), {}, {}};
    const EffectClass offset = effectOf(variant.task.library, "actuator.offset");
    const Outcome<Variant> with = withEffect(variant, offset, {"input u", "u", {}}, {});
    ASSERT_TRUE(with) << format(with.diagnostics());
    EXPECT_THAT(with->task.model->text(), HasSubstr("offset.u = u"));
    EXPECT_THAT(with->task.model->text(), HasSubstr("der(E) = offset.y*i - 0.1*E"));
    const Outcome<FlatModel> flat = flatten(with->task.library, "Heater");
    ASSERT_TRUE(flat) << format(flat.diagnostics());
    EXPECT_TRUE(analyse(std::make_shared<FlatModel>(*flat), {}));
}

TEST(WireIn, HangsNothingOnTheConnectorsOfAProposal) {
    Variant variant{taskOf(R"(model Shafts
  Analogon.Interfaces.RealInput tau(unit="N.m");
  Analogon.Sources.PrescribedTorque drive;
  Analogon.Mechanics.Inertia rotor(J=0.1), disk(J=0.2);
equation
  connect(tau, drive.tau);
  connect(drive.flange, rotor.flange_a);
  connect(rotor.flange_b, disk.flange_a);
end Shafts;
)",
                           "Shafts"),
                    {},
                    {}};
    const Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(variant.task.library);
    ASSERT_TRUE(catalogue);
    const Outcome<Library> wider = variant.task.library.withSource(std::make_shared<Source>("MissingTorque1.mo", R"(
model MissingTorque1
  Analogon.Interfaces.Flange_a port;
  parameter Real a1 = 0;
equation
  port.tau = a1*der(port.phi)^3;
end MissingTorque1;
)"));
    ASSERT_TRUE(wider) << format(wider.diagnostics());
    variant.task.library = *wider;
    EffectClass law;
    law.className = "MissingTorque1";
    law.kind = "proposal.law";
    law.placement.ports = {"port"};
    law.parameters.strength = "a1";
    for (const std::string proposal : {"port.tau = a1*w^3", ""}) {
        law.proposal = proposal;
        Outcome<Variant> with = withEffect(variant, law, {"rotor.flange_b", "rotor.flange_b", {}}, {});
        ASSERT_TRUE(with) << format(with.diagnostics());
        with->values.push_back({with->effects.back().instance + ".a1", -1, 0.5});
        const Outcome<std::vector<Candidate>> candidates = candidatesFor(*with, *catalogue);
        ASSERT_TRUE(candidates) << format(candidates.diagnostics());
        const std::string own = with->effects.back().instance + ".";
        const bool hasOwn = std::any_of(candidates->begin(), candidates->end(),
                                        [&](const Candidate& c) { return c.place.connector.starts_with(own); });
        EXPECT_EQ(hasOwn, law.proposal.empty());
    }
}

/// A body in a room whose temperature is an input of the model, declared like that.
void expectRoomAroundOtherParts(const std::string& declaration) {
    const Variant variant{taskOf("model Body\n  " + declaration + R"(
  Analogon.Interfaces.RealInput P(unit="W");
  Analogon.Sources.PrescribedHeatFlow heater;
  Analogon.Thermal.HeatCapacitor core(C=4), shell(C=2);
  Analogon.Thermal.ThermalConductor joint(G=0.2), skin(G=0.1);
  Analogon.Sources.PrescribedTemperature room;
equation
  connect(P, heater.Q_flow);
  connect(heater.port, core.port);
  connect(core.port, joint.port_a);
  connect(joint.port_b, shell.port);
  connect(shell.port, skin.port_a);
  connect(skin.port_b, room.port);
  connect(T_room, room.T);
end Body;
)",
                                 "Body"),
                          {},
                          {}};
    const Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(variant.task.library);
    ASSERT_TRUE(catalogue);
    const Outcome<std::vector<Candidate>> candidates = candidatesFor(variant, *catalogue);
    ASSERT_TRUE(candidates) << format(candidates.diagnostics());
    const auto found = std::find_if(candidates->begin(), candidates->end(), [](const Candidate& c) {
        return c.effect.kind == "thermal.radiation" && c.place.spare == "input T_room" && c.place.at == "heater.port";
    });
    ASSERT_NE(found, candidates->end());
    const Outcome<Variant> with = withEffect(variant, found->effect, found->place, {});
    ASSERT_TRUE(with) << format(with.diagnostics());
    EXPECT_THAT(with->task.model->text(), HasSubstr("connect(T_room, radiationToMeasured."));
    EXPECT_TRUE(with->effects.back().newInput.empty()) << "it is there already";
    const Outcome<FlatModel> flat = flatten(with->task.library, "Body");
    ASSERT_TRUE(flat) << format(flat.diagnostics());
    EXPECT_TRUE(analyse(std::make_shared<FlatModel>(*flat), {}));
}

TEST(WireIn, LetsAnInputOfTheModelBeTheSurroundingsOfAnotherPart) {
    expectRoomAroundOtherParts("Analogon.Interfaces.RealInput T_room(unit=\"K\");");
}

TEST(WireIn, TakesTheUnitOfAnInputFromWhatItIsConnectedTo) {
    expectRoomAroundOtherParts("Analogon.Interfaces.RealInput T_room;");
}

}  // namespace
}  // namespace analogon
