#include "core/effect/catalogue/kinds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace analogon {
namespace {

TEST(Kinds, OneThatIsMisspeltIsToldWithTheOneThatWasMeant) {
    const Outcome<Library> library = builtInLibrary();
    ASSERT_TRUE(library);
    const Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(*library);
    ASSERT_TRUE(catalogue);
    EXPECT_TRUE(unknownKinds({"friction.coulomb", "sensor.lag"}, *catalogue).empty());
    const Diagnostics faults = unknownKinds({"frction.coulomb", "sensor.lag", "magic"}, *catalogue);
    ASSERT_EQ(faults.size(), 2u);
    EXPECT_EQ(faults[0].message, "there is no kind of effect 'frction.coulomb'");
    EXPECT_EQ(faults[0].hint, "Did you mean 'friction.coulomb'?");
    EXPECT_THAT(faults[1].hint.english(), testing::HasSubstr("thermal.radiation"));
}

}  // namespace
}  // namespace analogon
