#include "core/base/usual_unit.hpp"

#include <gtest/gtest.h>

#include "core/base/unit.hpp"
#include "core/base/unit_alike.hpp"

namespace analogon {
namespace {

TEST(UsualUnits, AreKnownAndAreThoseThatAnUnknownOneIsHeldAgainst) {
    for (const char* unit : {"V", "mV", "rpm", "Nm", "kPa", "degC", "kg", "psi", "us", "%"})
        EXPECT_TRUE(isUsualUnit(unit)) << unit;
    for (const char* unit : {"", "VV", "speed", "Pascal"}) EXPECT_FALSE(isUsualUnit(unit)) << unit;
    for (const char* unit : {"rpm", "km/h", "psi"}) {
        ASSERT_TRUE(isKnownUnit(unit));
        EXPECT_EQ(unitsAlike(unit).front(), unit);
    }
}

}  // namespace
}  // namespace analogon
