#include "core/effect/model/place.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/effect/model/wire_in.hpp"
#include "core/eval/system.hpp"
#include "core/syntax/text_edit.hpp"

namespace analogon {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

//  v -> motor - rotor - impeller - load      (one rigid shaft)
//                          |
//                        speed -> w
constexpr const char* pump = R"(model Pump
  Analogon.Interfaces.RealInput v(unit="V");
  Analogon.Interfaces.RealOutput w(unit="rad/s");
  Analogon.ElectricMechanical.BasicElectricMechanical motor(R=0.4, L=0, k=0.03);
  Analogon.Mechanics.Inertia rotor(J=3e-5); // the rotor alone
  Analogon.Mechanics.Inertia impeller(J=1e-5);
  Analogon.Mechanics.QuadraticLoad load(k_q=1e-6);
  Analogon.Sensors.SpeedSensor speed;
equation
  connect(v, motor.v);
  connect(motor.flange, rotor.flange_a);
  connect(rotor.flange_b, impeller.flange_a);
  connect(impeller.flange_b, load.flange);
  connect(impeller.flange_b, speed.flange);
  connect(speed.w, w);
end Pump;
)";

class Places : public testing::Test {
protected:
    void SetUp() override {
        Outcome<Library> builtIn = builtInLibrary();
        ASSERT_TRUE(builtIn) << format(builtIn.diagnostics());
        Outcome<Library> with = builtIn->withSource(std::make_shared<Source>("model.mo", pump));
        ASSERT_TRUE(with) << format(with.diagnostics());
        library = std::move(*with);
        Outcome<std::vector<EffectClass>> effects = effectCatalogue(library);
        ASSERT_TRUE(effects);
        EXPECT_THAT(effects.diagnostics(), IsEmpty());
        catalogue = std::move(*effects);
    }

    const EffectClass& effect(const std::string& kind) const {
        for (const EffectClass& e : catalogue)
            if (e.kind == kind) return e;
        throw std::runtime_error("no effect " + kind);
    }

    std::vector<std::string> placesOf(const std::string& kind) const {
        Outcome<FlatModel> flat = flatten(library, "Pump");
        Outcome<Structure> structure = analyse(std::make_shared<FlatModel>(std::move(*flat)));
        Outcome<Diagram> diagram = readDiagram(library, "Pump");
        std::vector<std::string> names;
        for (const EffectPlace& p : ModelNodes(library, *diagram, *structure).placesFor(effect(kind), {}))
            names.push_back(p.at);
        return names;
    }

    std::string wired(const std::string& kind, const EffectPlace& place, const std::map<std::string, double>& values) {
        const syntax::ClassDefinition& model = *library.find("Pump")->definition;
        const std::string before(model.span.source->text());
        Outcome<WiredEffect> w = wireIn(library, model, effect(kind), place, values);
        EXPECT_TRUE(w) << format(w.diagnostics());
        if (!w) return {};
        const syntax::AppliedEdit applied = syntax::apply(before, w->edit);
        EXPECT_EQ(syntax::apply(applied.text, applied.inverse).text, before) << "undone byte for byte";
        Outcome<Library> with = library.withSource(std::make_shared<Source>("model.mo", applied.text));
        EXPECT_TRUE(with) << format(with.diagnostics());
        Outcome<SystemPtr> system = compile(*with, "Pump");
        EXPECT_TRUE(system) << format(system.diagnostics());
        return applied.text;
    }

    Library library;
    std::vector<EffectClass> catalogue;
};

TEST_F(Places, TakeOneRigidShaftForOnePlace) { EXPECT_THAT(placesOf("friction.coulomb"), SizeIs(1)); }

TEST_F(Places, CountTheBlocksOnAShaftAlsoWhereWiresDoNotMeet) {
    Outcome<FlatModel> flat = flatten(library, "Pump");
    Outcome<Structure> structure = analyse(std::make_shared<FlatModel>(std::move(*flat)));
    Outcome<Diagram> diagram = readDiagram(library, "Pump");
    const ModelNodes nodes(library, *diagram, *structure);
    EXPECT_EQ(nodes.blocksAt("motor.flange"), 5u);
    EXPECT_EQ(nodes.blocksAt("load.flange"), 5u);
    EXPECT_EQ(nodes.blocksAt("v"), 0u);
}

TEST_F(Places, OfSignalsAreTheInputsAndOutputsOfTheModel) {
    EXPECT_EQ(placesOf("sensor.lag"), std::vector<std::string>{"output w"});
    EXPECT_EQ(placesOf("actuator.deadzone"), std::vector<std::string>{"input v"});
}

TEST_F(Places, OfSpecialisedClassesAreTheComponentsOfTheirBase) {
    EXPECT_EQ(placesOf("resistance.series"), std::vector<std::string>{"motor"});
}

TEST_F(Places, OfHeatEffectsAreNoneWithoutHeatPorts) { EXPECT_THAT(placesOf("thermal.loss"), IsEmpty()); }

TEST_F(Places, NeverCutOffAnIdealSensor) {
    const std::vector<std::string> cuts = placesOf("compliance.shaft");
    EXPECT_THAT(cuts, Not(IsEmpty()));
    EXPECT_THAT(cuts, Not(Contains(HasSubstr("speed"))));
}

TEST_F(Places, TakeAnAttachedEffectAsAComponentAndAConnection) {
    const std::string text = wired("friction.coulomb", {"rotor.flange_a", "rotor.flange_a", {}}, {{"tau_c", 0.01}});
    EXPECT_THAT(text, HasSubstr("tau_c=0.01"));
    EXPECT_THAT(text, HasSubstr("rotor.flange_a)"));
    EXPECT_THAT(text, HasSubstr("// the rotor alone"));
}

TEST_F(Places, TakeASensorEffectBetweenTheSensorAndTheOutput) {
    const std::string text = wired("sensor.lag", {"output w", "w", {}}, {{"T", 0.1}});
    EXPECT_THAT(text, HasSubstr("connect(speed.w, lag.u)"));
    EXPECT_THAT(text, HasSubstr("lag.y, w)"));
}

TEST_F(Places, TakeAnActuatorEffectBehindTheInput) {
    const std::string text = wired("actuator.offset", {"input v", "v", {}}, {{"b", 0.1}});
    EXPECT_THAT(text, HasSubstr("connect(offset.y, motor.v)"));
}

TEST_F(Places, TakeASpecialisedEffectAsAnotherClassOfTheComponent) {
    const std::string text = wired("resistance.series", {"motor", "motor", {}}, {{"R_s", 0.1}});
    EXPECT_THAT(text, HasSubstr("SeriesResistance motor("));
    EXPECT_THAT(text, HasSubstr("R_s=0.1"));
}

TEST_F(Places, OfAComponentThatIsSpecialisedAlreadyAreThoseThatOneClassCanHold) {
    const auto withMotor = [this](const std::string& declaration) {
        std::string text = pump;
        const std::string plain = "BasicElectricMechanical motor(";
        text.replace(text.find("ElectricMechanical." + plain), std::string("ElectricMechanical.").size() + plain.size(),
                     declaration);
        Outcome<Library> with = library.withSource(std::make_shared<Source>("model.mo", text));
        ASSERT_TRUE(with) << format(with.diagnostics());
        library = std::move(*with);
    };
    withMotor("Effects.ElectricMechanical.VoltageDrop motor(V_b=0.3, ");
    EXPECT_EQ(placesOf("resistance.temperature"), std::vector<std::string>{"motor"});
    EXPECT_THAT(placesOf("voltage.drop"), IsEmpty()) << "it is there";
    const std::string text = wired("resistance.temperature", {"motor", "motor", {}}, {{"tau_w", 20}});
    EXPECT_THAT(text, HasSubstr("CombinedWithWinding motor("));
    EXPECT_THAT(text, HasSubstr("V_b=0.3"));
    EXPECT_THAT(text, HasSubstr("e_w=0"));
    EXPECT_THAT(text, HasSubstr("tau_w=20"));

    withMotor("Effects.ElectricMechanical.CombinedWithWinding motor(V_b=0.3, e_w=0.1, ");
    EXPECT_EQ(placesOf("resistance.series"), std::vector<std::string>{"motor"});
    EXPECT_THAT(placesOf("voltage.drop"), IsEmpty()) << "it is there";
    EXPECT_EQ(placesOf("flux.temperature"), std::vector<std::string>{"motor"}) << "the magnets beside the winding";
    EXPECT_THAT(wired("flux.temperature", {"motor", "motor", {}}, {{"tau_m", 30}}),
                HasSubstr("CombinedWithWindingAndFlux motor("));
    EXPECT_THAT(placesOf("resistance.temperature"), IsEmpty()) << "no class holds a second one";
}

TEST_F(Places, OfASpecialisedClassAreThoseWhoseConnectorsItHas) {
    constexpr const char* cooler = R"(model Cooler
  Analogon.Interfaces.RealInput speed(unit="km/h");
  Analogon.ThermalFluid.BasicThermalFluid plain(C=10, c_o=5);
  Analogon.ThermalFluid.ConvectionByFlowSpeed blown(C=10, c_o=5);
  Analogon.Thermal.ThermalConductor between(G=0.1);
  Analogon.Sources.FixedTemperature air(T=293.15);
equation
  connect(speed, blown.speed);
  connect(plain.fluid, air.port);
  connect(blown.fluid, air.port);
  connect(plain.solid, between.port_a);
  connect(blown.solid, between.port_b);
end Cooler;
)";
    Outcome<Library> with = library.withSource(std::make_shared<Source>("model.mo", cooler));
    ASSERT_TRUE(with) << format(with.diagnostics());
    Outcome<FlatModel> flat = flatten(*with, "Cooler");
    ASSERT_TRUE(flat) << format(flat.diagnostics());
    Outcome<Structure> structure = analyse(std::make_shared<FlatModel>(std::move(*flat)));
    Outcome<Diagram> diagram = readDiagram(*with, "Cooler");
    const ModelNodes nodes(*with, *diagram, *structure);
    std::vector<std::string> found;
    for (const EffectClass& e : catalogue)
        if (e.kind == "convection.exponent")
            for (const EffectPlace& p : nodes.placesFor(e, {}))
                found.push_back(p.at + " " + e.className.substr(e.className.rfind('.') + 1));
    EXPECT_THAT(found, testing::UnorderedElementsAre("plain NaturalConvection", "blown NaturalConvectionByFlowSpeed"));
}

// Resistance and torque constant that follow one measured winding: the second effect joins no other node.
TEST_F(Places, OfASecondEffectWithANodeAreThoseOfTheFirst) {
    std::string text = pump;
    const auto put = [&](const std::string& before, const std::string& more) { text.insert(text.find(before), more); };
    text.replace(text.find("ElectricMechanical.Basic"),
                 std::string("ElectricMechanical.BasicElectricMechanical").size(),
                 "Effects.ElectricMechanical.ResistanceOfNode");
    text.insert(text.find("R=0.4"), "alpha=0.004, ");
    put("equation", R"(  Analogon.Thermal.HeatCapacitor housing(C=100);
  Analogon.Thermal.HeatCapacitor winding(C=10);
  Analogon.Thermal.ThermalConductor between(G=0.5);
)");
    put("end Pump", R"(  connect(winding.port, between.port_a);
  connect(between.port_b, housing.port);
  connect(motor.heatPort, winding.port);
)");
    Outcome<Library> with = library.withSource(std::make_shared<Source>("model.mo", text));
    ASSERT_TRUE(with) << format(with.diagnostics());
    library = std::move(*with);
    std::erase_if(catalogue,
                  [](const EffectClass& e) { return e.className != "Analogon.Effects.ElectricMechanical.FluxOfNode"; });
    EXPECT_EQ(placesOf("flux.temperature"), std::vector<std::string>{"motor"}) << "at the winding, not at the housing";
    const std::string both = wired("flux.temperature", {"motor", "motor", {}, "winding.port"}, {{"beta", 0.002}});
    EXPECT_THAT(both, HasSubstr("CombinedOfNode motor("));
    EXPECT_THAT(both, HasSubstr("alpha=0.004"));
    const std::string joined = "motor.heatPort";
    EXPECT_EQ(both.find(joined), both.rfind(joined)) << "joined once: " << both;
}

}  // namespace
}  // namespace analogon
