#include "core/flat/range.hpp"

#include "tests/core/flat/flat_support.hpp"

namespace analogon {
namespace {

using namespace test;

TEST(Range, AValueOutsideOfItIsAFaultWhereTheValueStands) {
    const FlatModel m = flatOf(
        "model M\n  parameter Real a(min = 0, max = 1) = 2;\n  parameter Real b(min = 0) = -a;\n"
        "  parameter Real c(max = 3) = 3;\n  Real x = a + b + c;\nend M;");
    const Diagnostics faults = outsideRange(m);
    ASSERT_EQ(faults.size(), 2u);
    EXPECT_EQ(faults[0].severity, Severity::Error);
    EXPECT_EQ(faults[0].message, "the parameter 'a' is 2, above its max 1");
    EXPECT_EQ(faults[0].place.line, 2);
    EXPECT_EQ(faults[0].place.column, 40);
    EXPECT_EQ(faults[1].message, "the parameter 'b' is -2, below its min 0");
    EXPECT_EQ(faults[1].place.line, 3);
}

TEST(Range, ANegativeInertiaIsOneOfThem) {
    const FlatModel m = flatOf("model M\n  Parts.Inertia rotor(J = -1e-3);\nend M;");
    const Diagnostics faults = outsideRange(m);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].message, "the parameter 'rotor.J' is -0.001, below its min 0");
    EXPECT_EQ(faults[0].place.line, 2);
}

TEST(Range, TheLastDigitOfAValueThatRestsAtItsBoundIsNone) {
    EXPECT_TRUE(
        outsideRange(flatOf("model M parameter Real a(min = 0.1) = 0.09999999999999; Real x = a; end M;")).empty());
    EXPECT_FALSE(outsideRange(flatOf("model M parameter Real a(min = 0.1) = 0.0999; Real x = a; end M;")).empty());
}

}  // namespace
}  // namespace analogon
