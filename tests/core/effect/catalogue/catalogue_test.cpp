#include "core/effect/catalogue/catalogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/effect/text_task.hpp"

namespace analogon {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A library with a class of this annotation beside the built-in ones.
Library libraryWith(const std::string& annotation, const std::string& declarations = "") {
    return taskOf(
               "block Own \"Of its own\"\n  extends Analogon.Interfaces.PartialSignal;\n  parameter Real k = 0;\n  "
               "parameter Real T(unit=\"s\") = 1;\n" +
                   declarations + "equation\n  y = (1 + k)*u;\n  annotation (__Analogon(effect(" + annotation +
                   ")));\nend Own;\n",
               "Own")
        .library;
}

std::optional<EffectClass> own(const std::string& annotation) {
    const Library library = libraryWith(annotation);
    return effectOf(library, *library.find("Own"));
}

constexpr const char* whole = R"(kind = "sensor.own", way = "insert", ports = {"u", "y"}, at = "output",
  strength = "k", oneSided = true, linear = {"T"}, fixed(T = "2*sample"), reach(k = 3), sharper(T = 0.25),
  part(T = 0.05), shape(T = {"1*sample", "4*sample"}), whole = {"T"}, secant = {"2*sample"}, quantity = "K",
  inSignalUnit = {"k"}, valid = "T", states = 2, flexible = true)";

TEST(EffectOf, ReadsAllThatTheAnnotationSays) {
    const std::optional<EffectClass> effect = own(whole);
    ASSERT_TRUE(effect);
    EXPECT_EQ(effect->className, "Own");
    EXPECT_EQ(effect->description, "Of its own");
    EXPECT_EQ(effect->kind, "sensor.own");
    EXPECT_EQ(effect->placement.way, Way::Insert);
    EXPECT_THAT(effect->placement.ports, ElementsAre("u", "y"));
    EXPECT_EQ(effect->placement.signalSide, "output");
    EXPECT_EQ(effect->parameters.strength, "k");
    EXPECT_TRUE(effect->parameters.oneSided);
    EXPECT_TRUE(effect->trial.flexible);
    EXPECT_EQ(effect->trial.states, 2);
    EXPECT_THAT(effect->parameters.linear, ElementsAre("T"));
    EXPECT_EQ(effect->parameters.fixed.at("T"), "2*sample");
    EXPECT_EQ(effect->trial.reach.at("k"), 3);
    EXPECT_EQ(effect->trial.sharper.at("T"), 0.25);
    EXPECT_EQ(effect->trial.part.at("T"), 0.05);
    EXPECT_THAT(effect->parameters.shape.at("T"), ElementsAre("1*sample", "4*sample"));
    EXPECT_THAT(effect->parameters.whole, ElementsAre("T"));
    EXPECT_THAT(effect->trial.secant, ElementsAre("2*sample"));
    EXPECT_EQ(effect->placement.quantity, "K");
    EXPECT_EQ(effect->parameters.units.at("T"), "s");
    EXPECT_TRUE(effect->proposal.empty()) << "a named effect";
    EXPECT_EQ(faultOf(*effect), "own");
}

TEST(EffectOf, IsNoneOfAClassWithoutTheAnnotation) {
    const Library library = libraryWith(whole);
    EXPECT_FALSE(effectOf(library, *library.find("Analogon.Thermal.HeatCapacitor")));
    EXPECT_TRUE(effectOf(library, *library.find("Analogon.Effects.Sensor.Lag")));
}

TEST(EffectCatalogue, WarnsOfAMalformedAnnotationByItsPlace) {
    const auto warned = [](const std::string& annotation) {
        const Outcome<std::vector<EffectClass>> all = effectCatalogue(libraryWith(annotation));
        EXPECT_TRUE(all);
        EXPECT_TRUE(std::none_of(all->begin(), all->end(), [](const EffectClass& e) { return e.className == "Own"; }));
        EXPECT_GT(all->size(), 20u) << "the others are there";
        return format(all.diagnostics());
    };
    EXPECT_THAT(warned(R"(kind = "a.b", way = "glue", ports = {"u", "y"}, strength = "k")"),
                HasSubstr("unknown way 'glue' of the effect Own"));
    EXPECT_THAT(warned(R"(kind = "a.b", way = "insert", ports = {"u"}, strength = "k")"),
                HasSubstr("names 1 connectors, 'insert' takes 2"));
    EXPECT_THAT(warned(R"(kind = "a.b", way = "insert", ports = {"u", "y"}, strength = "g")"),
                HasSubstr("has no parameter 'g'"));
    EXPECT_THAT(warned(R"(way = "insert", ports = {"u", "y"}, strength = "k")"), HasSubstr("kind"));
}

TEST(EffectCatalogue, IsInTheOrderOfTheLibrary) {
    const Outcome<std::vector<EffectClass>> all = effectCatalogue(libraryWith(whole));
    ASSERT_TRUE(all);
    EXPECT_TRUE(all.diagnostics().empty()) << format(all.diagnostics());
    const auto placeOf = [&](const std::string& name) {
        return std::find_if(all->begin(), all->end(), [&](const EffectClass& e) { return e.className == name; }) -
               all->begin();
    };
    EXPECT_LT(placeOf("Analogon.Effects.Mechanics.CoulombFriction"),
              placeOf("Analogon.Effects.Mechanics.QuadraticDrag"));
    EXPECT_LT(placeOf("Own"), static_cast<std::ptrdiff_t>(all->size()));
}

TEST(CombinedIn, AreTheClassesThatOneHoldsAtOnce) {
    const Library library = libraryWith(whole);
    EXPECT_THAT(combinedIn(*library.find("Analogon.Effects.ElectricThermal.Combined")),
                ElementsAre("Analogon.Effects.ElectricThermal.SeriesResistance",
                            "Analogon.Effects.ElectricThermal.VoltageDrop"));
    EXPECT_TRUE(combinedIn(*library.find("Own")).empty());
}

}  // namespace
}  // namespace analogon
