#include "core/effect/catalogue/combination.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

const Library& library() {
    static const Outcome<Library> built = builtInLibrary();
    return *built;
}

EffectClass effect(const std::string& name) {
    const std::optional<EffectClass> found = effectOf(library(), *library().find("Analogon.Effects." + name));
    EXPECT_TRUE(found) << name;
    return found.value_or(EffectClass());
}

Block component(const std::string& className, std::vector<std::string> modified = {}) {
    Block b;
    b.name = "motor";
    b.className = "Analogon." + className;
    b.isEffect = b.className.starts_with("Analogon.Effects.");
    for (std::string& name : modified) b.parameters.emplace_back(std::move(name), "1");
    return b;
}

const char* const basic = "ElectricMechanical.BasicElectricMechanical";
const char* const drop = "Effects.ElectricMechanical.VoltageDrop";
const char* const ofNode = "Effects.ElectricMechanical.ResistanceOfNode";
const char* const combinedOfNode = "Effects.ElectricMechanical.CombinedOfNode";

TEST(ClassWith, IsTheEffectsOwnWhereTheComponentHasNone) {
    EXPECT_EQ(classWith(library(), component(basic), effect("ElectricMechanical.VoltageDrop")),
              "Analogon.Effects.ElectricMechanical.VoltageDrop");
}

TEST(ClassWith, HoldsWhatTheComponentHasAndTheEffect) {
    const std::string both =
        classWith(library(), component(drop, {"V_b"}), effect("ElectricMechanical.WindingTemperature"));
    EXPECT_EQ(both, "Analogon.Effects.ElectricMechanical.CombinedWithWinding");
    // in a class of several that are off but for those that its modifiers name
    EXPECT_EQ(classWith(library(), component(combinedOfNode, {"V_b"}), effect("ElectricMechanical.WindingTemperature")),
              both);
    EXPECT_EQ(classWith(library(), component(combinedOfNode, {"V_b", "alpha"}),
                        effect("ElectricMechanical.WindingTemperature")),
              "")
        << "no class has both temperatures of the resistance";
}

TEST(ClassWith, IsNoneOfWhatTheComponentHasAlready) {
    EXPECT_EQ(classWith(library(), component(drop, {"V_b"}), effect("ElectricMechanical.VoltageDrop")), "");
}

TEST(NodePort, IsTheConnectorOfAnEffectThatTheComponentHas) {
    EXPECT_EQ(nodePortOf(library(), component(basic)), "");
    EXPECT_EQ(nodePortOf(library(), component(drop, {"V_b"})), "");
    EXPECT_EQ(nodePortOf(library(), component(ofNode, {"alpha"})), "heatPort");
    EXPECT_EQ(nodePortOf(library(), component(combinedOfNode, {"V_b"})), "");
    EXPECT_EQ(nodePortOf(library(), component(combinedOfNode, {"V_b", "alpha"})), "heatPort");
}

}  // namespace
}  // namespace analogon
