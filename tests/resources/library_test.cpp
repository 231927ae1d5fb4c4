#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "core/base/unit.hpp"
#include "core/effect/catalogue/catalogue.hpp"
#include "core/flat/flat_model.hpp"
#include "core/syntax/parser.hpp"

/// What every class of the library must have, whatever it describes.
namespace analogon {
namespace {

namespace fs = std::filesystem;
using syntax::ClassDefinition;
using syntax::Component;
using syntax::Modification;

fs::path root() { return fs::path(ANALOGON_ROOT) / "resources/Analogon"; }

const Library& library() {
    static const Outcome<Library> loaded = Library().withPath(root());
    if (!loaded) throw std::runtime_error(format(loaded.diagnostics()));
    return *loaded;
}

bool isConnector(const LibraryClass& c) { return c.definition->restriction == ClassDefinition::Restriction::Connector; }
bool isFunction(const LibraryClass& c) { return c.definition->restriction == ClassDefinition::Restriction::Function; }
bool isPackage(const LibraryClass& c) { return c.definition->restriction == ClassDefinition::Restriction::Package; }
bool isBlock(const LibraryClass& c) { return !isConnector(c) && !isPackage(c) && !isFunction(c); }

/// Signals have the unit of what they are connected to: blocks that only compute with signals give none.
bool isSignalBlock(const std::string& name) {
    for (const char* package :
         {"Analogon.Signals.", "Analogon.Effects.Signals.", "Analogon.Effects.Sensor.", "Analogon.Effects.Actuator.",
          "Analogon.Interfaces.PartialSignal", "Analogon.Sources.Constant", "Analogon.Sources.Step",
          "Analogon.Sources.Ramp", "Analogon.Sources.Sine", "Analogon.Sources.Pulse", "Analogon.Sources.Trapezoid",
          "Analogon.Sources.Chirp", "Analogon.Sources.TimeTable"})
        if (name.starts_with(package)) return true;
    return false;
}

std::string attribute(const Component& component, const std::string& name) {
    for (const Modification& m : component.modifications)
        if (m.name.text() == name && m.value) return m.value->text;
    return {};
}

const Modification* child(const Modification& parent, const std::string& name) {
    for (const Modification& m : parent.arguments)
        if (m.name.text() == name) return &m;
    return nullptr;
}

/// Parameters and variables a class declares or inherits.
void collectVariables(const LibraryClass& of, std::map<std::string, const Component*>& variables) {
    for (const syntax::Extends& base : of.definition->bases)
        if (const LibraryClass* b = library().lookup(base.base, of.qualifiedName)) collectVariables(*b, variables);
    for (const Component& c : of.definition->components) variables[c.name] = &c;
}

TEST(BlockLibrary, EveryFileIsReadWithoutAComplaint) {
    const Outcome<Library> loaded = Library().withPath(root());
    ASSERT_TRUE(loaded) << format(loaded.diagnostics());
    EXPECT_TRUE(loaded.diagnostics().empty()) << format(loaded.diagnostics());
    for (const auto& entry : fs::recursive_directory_iterator(root())) {
        if (entry.path().extension() != ".mo") continue;
        const bool isDirectory = entry.path().filename() == "package.mo";
        const fs::path place =
            isDirectory ? entry.path().parent_path() : entry.path().parent_path() / entry.path().stem();
        std::string name = fs::relative(place, root().parent_path()).generic_string();
        std::replace(name.begin(), name.end(), '/', '.');
        EXPECT_NE(loaded->find(name), nullptr) << name;
    }
}

TEST(BlockLibrary, EveryPackageOrderNamesWhatIsThere) {
    for (const auto& entry : fs::recursive_directory_iterator(root())) {
        if (entry.path().filename() != "package.order") continue;
        const fs::path directory = entry.path().parent_path();
        std::ifstream text(entry.path());
        std::set<std::string> listed, present;
        for (std::string line; std::getline(text, line);) listed.insert(line);
        for (const auto& file : fs::directory_iterator(directory)) {
            if (file.is_directory()) present.insert(file.path().filename().string());
            if (file.path().extension() == ".mo" && file.path().stem() != "package")
                present.insert(file.path().stem().string());
        }
        EXPECT_EQ(listed, present) << directory;
    }
}

TEST(BlockLibrary, HasEveryClassOfTheDomains) {
    for (const char* name : {"Interfaces.Flange_a",
                             "Interfaces.Flange_b",
                             "Interfaces.HeatPort_a",
                             "Interfaces.HeatPort_b",
                             "Interfaces.RealInput",
                             "Interfaces.RealOutput",
                             "Mechanics.BasicMechanics",
                             "Mechanics.Inertia",
                             "Mechanics.SpringDamper",
                             "Mechanics.Fixed",
                             "Mechanics.QuadraticLoad",
                             "Mechanics.ViscousLoad",
                             "Mechanics.ReturnSpring",
                             "ElectricMechanical.BasicElectricMechanical",
                             "ElectricThermal.BasicElectricThermal",
                             "ThermalFluid.BasicThermalFluid",
                             "ThermalFluid.ConvectionByFlowSpeed",
                             "MechanicThermal.BasicMechanicThermal",
                             "Thermal.HeatCapacitor",
                             "Thermal.ThermalConductor",
                             "Sources.PrescribedTemperature",
                             "Sources.FixedTemperature",
                             "Sources.PrescribedHeatFlow",
                             "Sources.PrescribedTorque",
                             "Sources.Constant",
                             "Sensors.SpeedSensor",
                             "Sensors.AngleSensor",
                             "Sensors.TemperatureSensor",
                             "Sensors.HeatFlowSensor",
                             "Sensors.TorqueSensor",
                             "Signals.Gain",
                             "Signals.Sum",
                             "Signals.Product",
                             "Signals.FirstOrder",
                             "Interfaces.TranslationalFlange_a",
                             "Interfaces.TranslationalFlange_b",
                             "Interfaces.PositivePin",
                             "Interfaces.NegativePin",
                             "Translation.Mass",
                             "Translation.SpringDamper",
                             "Translation.Fixed",
                             "Translation.Rack",
                             "Electric.Resistor",
                             "Electric.Capacitor",
                             "Electric.Inductor",
                             "Electric.Ground",
                             "Electric.Diode",
                             "Electric.Switch",
                             "Electric.EMF",
                             "Sources.PrescribedForce",
                             "Sources.PrescribedVoltage",
                             "Sources.PrescribedCurrent",
                             "Sensors.PositionSensor",
                             "Sensors.VelocitySensor",
                             "Sensors.ForceSensor",
                             "Sensors.VoltageSensor",
                             "Sensors.CurrentSensor"})
        EXPECT_NE(library().find(std::string("Analogon.") + name), nullptr) << name;
}

TEST(BlockLibrary, EveryClassHasADescriptionAnIconAndADocumentation) {
    for (const LibraryClass* c : library().classes()) {
        SCOPED_TRACE(c->qualifiedName);
        EXPECT_FALSE(c->definition->description.empty());
        if (isFunction(*c)) continue;  // the program knows it itself; its text is for other tools
        ASSERT_TRUE(c->definition->annotation);
        EXPECT_NE(c->definition->annotation->find("Icon"), nullptr);
        const Modification* documentation = c->definition->annotation->find("Documentation");
        ASSERT_NE(documentation, nullptr);
        const Modification* info = child(*documentation, "info");
        ASSERT_NE(info, nullptr);
        ASSERT_TRUE(info->value);
        EXPECT_TRUE(info->value->text.starts_with("<html>"));
        if (isBlock(*c) && !c->definition->equationSections.empty() && !c->definition->isPartial) {
            EXPECT_NE(info->value->text.find("<pre>"), std::string::npos) << "the documentation states no equation";
        }
    }
}

TEST(BlockLibrary, EveryVariableHasADescriptionAndAKnownUnit) {
    for (const LibraryClass* c : library().classes()) {
        if (isPackage(*c)) continue;
        for (const Component& v : c->definition->components) {
            if (isFunction(*c) && v.isProtected) continue;  // what an algorithm keeps for itself
            SCOPED_TRACE(c->qualifiedName + "." + v.name);
            EXPECT_FALSE(v.description.empty());
            const std::string type = v.type.text();
            const bool isSignal = type.ends_with("RealInput") || type.ends_with("RealOutput");
            if (type != "Real" && !isSignal) continue;
            const std::string unit = attribute(v, "unit");
            // a recorded flow may be anything that measures the stream
            const bool isFree = isSignalBlock(c->qualifiedName) || v.name == "u_flow" || v.name == "flow_ref" ||
                                c->qualifiedName.starts_with("Analogon.Effects.Proposals.Sensor") || isFunction(*c);
            EXPECT_TRUE(isFree || !unit.empty()) << "no unit";
            EXPECT_TRUE(unit.empty() || isKnownUnit(unit)) << unit;
        }
    }
}

TEST(BlockLibrary, EveryConnectorOfABlockHasItsPlaceInTheIcon) {
    for (const LibraryClass* c : library().classes()) {
        if (!isBlock(*c)) continue;
        for (const Component& v : c->definition->components) {
            const LibraryClass* type = library().lookup(v.type, c->qualifiedName);
            if (type == nullptr || !isConnector(*type)) continue;
            ASSERT_TRUE(v.annotation) << c->qualifiedName << "." << v.name;
            EXPECT_NE(v.annotation->find("Placement"), nullptr) << c->qualifiedName << "." << v.name;
        }
    }
}

TEST(BlockLibrary, EveryBlockIsBalanced) {
    int flattened = 0;
    for (const LibraryClass* c : library().classes()) {
        if (!isBlock(*c) || c->definition->isPartial) continue;
        const Outcome<FlatModel> model = flatten(library(), c->qualifiedName);
        EXPECT_TRUE(model) << c->qualifiedName << "\n" << format(model.diagnostics());
        ++flattened;
    }
    EXPECT_GT(flattened, 50);
}

TEST(BlockLibrary, TheExtensionsOfADomainInheritFromItsBase) {
    for (const auto& [derived, base] :
         {std::pair{"Analogon.ElectricMechanical.BasicElectricMechanical",
                    "Analogon.ElectricMechanical.PartialElectricMechanical"},
          std::pair{"Analogon.ThermalFluid.ConvectionByFlowSpeed", "Analogon.ThermalFluid.PartialThermalFluid"},
          std::pair{"Analogon.Effects.ElectricThermal.SeriesResistance",
                    "Analogon.ElectricThermal.PartialElectricThermal"}})
        EXPECT_TRUE(library().isDerived(derived, base)) << derived;
}

// ------------------------------------------------------------------------------------------------ effects

TEST(EffectAnnotations, AreAllWellFormed) {
    const Outcome<std::vector<EffectClass>> effects = effectCatalogue(library());
    ASSERT_TRUE(effects);
    EXPECT_TRUE(effects.diagnostics().empty()) << format(effects.diagnostics());
    std::size_t blocks = 0;
    for (const LibraryClass* c : library().classes())
        if (c->qualifiedName.starts_with("Analogon.Effects.") && isBlock(*c) && !c->definition->isPartial &&
            combinedIn(*c).empty())
            ++blocks;
    EXPECT_EQ(effects->size(), blocks) << "a class below Effects has no effect annotation";
}

TEST(EffectAnnotations, AClassOfSeveralEffectsTakesTheParametersOfEach) {
    int checked = 0;
    for (const LibraryClass* c : library().classes())
        for (const std::string& name : combinedIn(*c)) {
            SCOPED_TRACE(c->qualifiedName + " for " + name);
            const LibraryClass* single = library().find(name);
            ASSERT_TRUE(single);
            const std::optional<EffectClass> effect = effectOf(library(), *single);
            ASSERT_TRUE(effect);
            EXPECT_TRUE(library().isDerived(c->qualifiedName, effect->base));
            std::map<std::string, const Component*> of, own;
            collectVariables(*single, of);
            collectVariables(*c, own);
            for (const auto& [parameter, unit] : effect->parameters.units) {
                ASSERT_TRUE(own.contains(parameter)) << parameter;
                ASSERT_TRUE(own[parameter]->binding && of[parameter]->binding) << parameter;
                EXPECT_EQ(own[parameter]->isFinal, of[parameter]->isFinal) << parameter;
                const bool isNode = name.ends_with("OfNode") || !own[parameter]->binding->number;
                EXPECT_TRUE(isNode || own[parameter]->binding->number == of[parameter]->binding->number) << parameter;
            }
            ++checked;
        }
    EXPECT_GE(checked, 15);
}

TEST(EffectAnnotations, CoverEveryKind) {
    const Outcome<std::vector<EffectClass>> effects = effectCatalogue(library());
    ASSERT_TRUE(effects);
    std::set<std::string> kinds;
    for (const EffectClass& e : *effects) kinds.insert(e.kind);
    for (const char* kind :
         {"friction.coulomb",  "friction.stribeck",     "friction.viscous",  "drag.quadratic",
          "torque.constant",   "torque.gravity",        "torque.cogging",    "spring.return",
          "inertia.added",     "compliance.shaft",      "backlash",          "thermal.loss",
          "thermal.radiation", "thermal.mass",          "thermal.latent",    "thermal.resistance",
          "convection.flow",   "convection.exponent",   "resistance.series", "resistance.temperature",
          "voltage.drop",      "inductance.saturation", "flux.temperature",  "sensor.lag",
          "sensor.delay",      "sensor.offset",         "sensor.gain",       "sensor.drift",
          "actuator.lag",      "actuator.delay",        "actuator.offset",   "actuator.gain",
          "actuator.deadzone", "actuator.saturation",   "force.constant",    "mass.added",
          "compliance.rod",    "inductance.series",     "leakage",           "capacitance.parallel"})
        EXPECT_TRUE(kinds.contains(kind)) << kind;
}

TEST(EffectAnnotations, TheStrengthIsAParameterThatIsZeroByDefault) {
    const Outcome<std::vector<EffectClass>> effects = effectCatalogue(library());
    ASSERT_TRUE(effects);
    for (const EffectClass& e : *effects) {
        SCOPED_TRACE(e.className);
        std::map<std::string, const Component*> variables;
        collectVariables(*library().find(e.className), variables);
        ASSERT_TRUE(variables.contains(e.parameters.strength));
        const Component& strength = *variables[e.parameters.strength];
        EXPECT_EQ(strength.variability, syntax::Variability::Parameter);
        ASSERT_TRUE(strength.binding);
        EXPECT_EQ(strength.binding->kind, syntax::Expression::Kind::Number);
        EXPECT_EQ(strength.binding->number, 0);
        for (const std::string& port : e.placement.ports) EXPECT_TRUE(variables.contains(port)) << port;
        EXPECT_EQ(e.placement.channel.empty() || variables.contains(e.placement.channel), true);
    }
}

/// Names used in the texts: statistics of variables of the class itself, and the three times.
void checkText(const syntax::Expression& e, const std::map<std::string, const Component*>& variables,
               const std::string& strength) {
    static const std::set<std::string> statistics{"range",   "maxabs",  "rms",  "mean",   "start",
                                                  "minimum", "maximum", "rate", "through"};
    using Kind = syntax::Expression::Kind;
    if (e.kind == Kind::Call) {
        if (e.name.text() == "sqrt") return checkText(e.operands.at(0), variables, strength);
        if (e.name.text() == "min" || e.name.text() == "max") {
            ASSERT_EQ(e.operands.size(), 2u);
            for (const syntax::Expression& operand : e.operands) checkText(operand, variables, strength);
            return;
        }
        EXPECT_TRUE(statistics.contains(e.name.text())) << e.name.text();
        ASSERT_EQ(e.operands.size(), 1u);
        ASSERT_EQ(e.operands[0].kind, Kind::Reference);
        EXPECT_TRUE(variables.contains(e.operands[0].name.text())) << e.operands[0].name.text();
        return;
    }
    if (e.kind == Kind::Reference) {
        EXPECT_TRUE(e.name.text() == "sample" || e.name.text() == "duration" || e.name.text() == "period" ||
                    e.name.text() == strength)
            << e.name.text();
    }
    for (const syntax::Expression& operand : e.operands) checkText(operand, variables, strength);
}

TEST(EffectAnnotations, TheTextsSpeakOfVariablesOfTheClass) {
    const Outcome<std::vector<EffectClass>> effects = effectCatalogue(library());
    ASSERT_TRUE(effects);
    for (const EffectClass& effect : *effects) {
        SCOPED_TRACE(effect.className);
        std::map<std::string, const Component*> variables;
        collectVariables(*library().find(effect.className), variables);
        const auto check = [&](const std::string& text, const std::string& strength) {
            const Outcome<syntax::Expression> parsed = syntax::parseExpression(std::make_shared<Source>("text", text));
            ASSERT_TRUE(parsed) << text;
            checkText(*parsed, variables, strength);
        };
        for (const std::string& text : effect.trial.secant) check(text, {});
        for (const auto& [parameter, text] : effect.parameters.fixed) check(text, {});
        // a shape may be told in terms of the strength that it is tried with
        for (const auto& [parameter, values] : effect.parameters.shape)
            for (const std::string& text : values) check(text, effect.parameters.strength);
    }
}

TEST(EffectAnnotations, ASpecialisedClassTakesTheParametersOfTheBasicOne) {
    const Outcome<std::vector<EffectClass>> effects = effectCatalogue(library());
    ASSERT_TRUE(effects);
    int checked = 0;
    for (const EffectClass& effect : *effects) {
        if (effect.placement.way != Way::Specialise) continue;
        for (const LibraryClass* plain : library().classes()) {
            const std::string name = plain->qualifiedName.substr(plain->qualifiedName.rfind('.') + 1);
            if (!name.starts_with("Basic") || !library().isDerived(plain->qualifiedName, effect.base)) continue;
            std::map<std::string, const Component*> of, own;
            collectVariables(*plain, of);
            collectVariables(*library().find(effect.className), own);
            for (const auto& [variable, component] : of)
                EXPECT_TRUE(own.contains(variable)) << effect.className << " lacks " << variable;
            ++checked;
        }
    }
    EXPECT_GE(checked, 9);
}

}  // namespace
}  // namespace analogon
