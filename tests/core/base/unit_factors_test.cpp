#include "core/base/unit_factors.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

std::string again(const char* unit) {
    const std::optional<UnitFactors> factors = UnitFactors::of(unit);
    return factors ? factors->text() : "none";
}

std::string per(const char* unit, const char* by, int power = 1) {
    return UnitFactors::of(unit)->times(*UnitFactors::of(by), -power).text();
}

TEST(UnitFactors, KeepTheSymbolsAsTheyAreWritten) {
    for (const char* unit : {"K", "N.m", "rad/s", "W/(m2.K)", "1/s", "kg.m2/s3", "1"}) EXPECT_EQ(again(unit), unit);
    EXPECT_EQ(again("s-1"), "1/s");
    EXPECT_EQ(again("J/kg/K"), "J/(kg.K)");
    EXPECT_EQ(again("m.K/m"), "K");
}

TEST(UnitFactors, AreNotMadeOfWhatIsNoProductOfSymbols) {
    for (const char* unit : {"", "%", "m/", "(m", "m)", "10", "m..s", "m^2", "m-", ".m", "1/(s"})
        EXPECT_EQ(again(unit), "none") << unit;
}

TEST(UnitFactors, DivideToUnitsThatEngineersWrite) {
    EXPECT_EQ(per("N.m", "rad/s"), "N.m.s/rad");
    EXPECT_EQ(per("W", "K", 4), "W/K4");
    EXPECT_EQ(per("rad/s", "A"), "rad/(s.A)");
    EXPECT_EQ(per("K", "K"), "1");
    EXPECT_EQ(per("K", "1"), "K");
}

}  // namespace
}  // namespace analogon
