#include "core/flat/declared.hpp"

#include "tests/core/flat/flat_support.hpp"

namespace analogon {
namespace {

using namespace test;

FlatModel declaredOf(const std::string& text) { return declared(libraryOf(text), "M"); }

}  // namespace

TEST(Declared, TellsVariablesAndValuesOfAModelWithWrongEquations) {
    const FlatModel m = declaredOf(
        "model M\n  parameter Real k = 2;\n  parameter Real twice = 2 * k;\n  parameter Real lost = nobody;\n"
        "  Real x;\n  Nowhere part;\nequation\n  x = unheard;\n  connect(a, b);\nend M;");
    ASSERT_TRUE(m.find("twice").valid());
    EXPECT_EQ(m.parameterValue(m.find("twice")), 4);
    ASSERT_TRUE(m.find("lost").valid());
    EXPECT_FALSE(m.parameterValue(m.find("lost"))) << "its value is not known";
    EXPECT_TRUE(m.find("x").valid());
    EXPECT_TRUE(m.equations.empty());
}

TEST(Declared, ACircleOfParametersAndAnUnknownClassAreNoObstacle) {
    const FlatModel m =
        declaredOf("model M\n  parameter Real a = b;\n  parameter Real b = a;\n  parameter Real c = 1;\nend M;");
    EXPECT_FALSE(m.parameterValue(m.find("a")));
    EXPECT_EQ(m.parameterValue(m.find("c")), 1);
    EXPECT_TRUE(declared(libraryOf("model M\nend M;"), "Nobody").variables.empty());
}

}  // namespace analogon
