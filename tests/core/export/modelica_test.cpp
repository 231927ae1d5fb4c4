#include "core/export/modelica.hpp"

#include <gtest/gtest.h>

#include "core/flat/flat_model.hpp"
#include "core/syntax/parser.hpp"

namespace analogon {
namespace {

Study example(const char* name) {
    Outcome<Study> study = readStudy(std::string(ANALOGON_ROOT "/examples/") + name);
    EXPECT_TRUE(study) << format(study.diagnostics());
    return std::move(*study);
}

TEST(Modelica, StandsAloneAndFlattensToTheSameEquations) {
    for (const char* name : {"lambda-sensor-heating", "water-pump"}) {
        const Study study = example(name);
        const Outcome<std::string> text = modelicaText(study);
        ASSERT_TRUE(text) << format(text.diagnostics());
        const Outcome<Library> alone = Library().withSource(std::make_shared<const Source>("alone.mo", *text));
        ASSERT_TRUE(alone) << format(alone.diagnostics());
        const Outcome<FlatModel> flat = flatten(*alone, study.className);
        ASSERT_TRUE(flat) << format(flat.diagnostics());
        const Outcome<Library> library = studyLibrary(study);
        ASSERT_TRUE(library);
        const Outcome<FlatModel> own = flatten(*library, study.className);
        ASSERT_TRUE(own);
        EXPECT_EQ(print(*flat), print(*own)) << name;
    }
}

TEST(Modelica, HoldsOnlyWhatIsUsed) {
    const Outcome<std::string> text = modelicaText(example("lambda-sensor-heating"));
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("model BasicThermalFluid"), std::string::npos);
    EXPECT_EQ(text->find("SpringDamper"), std::string::npos);
    EXPECT_EQ(text->find("package Effects"), std::string::npos);
}

TEST(Modelica, WritesTheStartValuesOfTheStudy) {
    Study study = example("lambda-sensor-heating");
    study.parameters["heater.R"].value = 4.125;
    const Outcome<std::string> text = modelicaText(study);
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("heater(R=4.125"), std::string::npos);
}

}  // namespace
}  // namespace analogon
