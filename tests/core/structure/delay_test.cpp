#include "core/structure/delay.hpp"

#include <gtest/gtest.h>

#include "core/flat/flat_model.hpp"
#include "core/library/library.hpp"
#include "core/structure/structure.hpp"

namespace analogon {
namespace {

Outcome<Structure> structureOf(const std::string& equations) {
    const auto library = Library().withSource(
        std::make_shared<const Source>("m.mo", "model M input Real u; Real a, b; equation " + equations + " end M;"));
    const Outcome<FlatModel> flat = flatten(*library, "M");
    if (!flat) return flat.diagnostics();
    return analyse(std::make_shared<const FlatModel>(*flat));
}

TEST(Delay, ASignalOfInputsAloneIsThatOfDelayedInputs) {
    const Outcome<Structure> structure = structureOf("a = 2*u + 1; b = delay(a, 0.25);");
    ASSERT_TRUE(structure) << format(structure.diagnostics());
    for (const ExpressionId delay : delaysOf(*structure))
        EXPECT_EQ((*structure->model)[(*structure->pool)[(*structure->pool)[delay].a].variable].name, "u");
}

TEST(Delay, SignalsThatWaitForEachOtherStayAsTheyAre) {
    // neither is made of inputs alone: each holds itself as it was
    const Outcome<Structure> structure = structureOf("a = 0.5*delay(b, 0.1) + u; b = 1 + delay(a, 0.2)/2;");
    ASSERT_TRUE(structure) << format(structure.diagnostics());
    EXPECT_EQ(delaysOf(*structure).size(), 2u);
}

}  // namespace
}  // namespace analogon
