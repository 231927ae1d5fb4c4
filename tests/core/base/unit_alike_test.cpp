#include "core/base/unit_alike.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/unit.hpp"

namespace analogon {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(UnitsAlike, AreThoseThatDifferInTheSizeOfLetters) {
    EXPECT_THAT(unitsAlike("kpa"), ElementsAre("kPa"));
    EXPECT_THAT(unitsAlike("mpa"), ElementsAre("MPa", "mPa")) << "a billion times apart: nobody may choose";
    EXPECT_THAT(unitsAlike("KHZ"), ElementsAre("kHz"));
    EXPECT_THAT(unitsAlike("mhz"), ElementsAre("MHz", "mHz"));
}

TEST(UnitsAlike, AreElseTheOneThatIsWrittenNearly) {
    EXPECT_THAT(unitsAlike("degCC"), ElementsAre("degC"));
    EXPECT_THAT(unitsAlike("\xC3\xB8"
                           "C"),
                ElementsAre("degC"))
        << "a degree sign of another set of letters";
    EXPECT_THAT(unitsAlike("ambient"), IsEmpty());
    EXPECT_THAT(unitsAlike(""), IsEmpty());
    EXPECT_THAT(unitsAlike("kPa gauge"), IsEmpty()) << "which counts from another zero";
    EXPECT_THAT(unitsAlike(std::string(1000, 'm')), IsEmpty());
}

TEST(UnitsAlike, AreAllKnown) {
    for (const char* const text : {"mpa", "ma", "mv", "kpa", "khz", "mohm", "knm", "kg/H", "L/Min", "BAR", "Volts"})
        for (const std::string& unit : unitsAlike(text)) EXPECT_TRUE(isKnownUnit(unit)) << text << ": " << unit;
}

}  // namespace
}  // namespace analogon
