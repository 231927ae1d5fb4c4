#include "core/base/unit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <thread>

namespace analogon {
namespace {

using std::numbers::pi;

void expectConversion(std::string_view from, std::string_view to, double factor, double offset = 0) {
    const auto conversion = convertUnit(from, to);
    ASSERT_TRUE(conversion) << format(conversion.diagnostics());
    EXPECT_NEAR(conversion->factor, factor, 1e-14 * std::abs(factor)) << from << " -> " << to;
    EXPECT_NEAR(conversion->offset, offset, 1e-10) << from << " -> " << to;
}

TEST(Unit, KnowsTheSpellingsOfTheField) {
    for (const char* unit :
         {"degC",  "°C",    "K",     "degF",     "rpm",        "1/min", "rev/min", "min-1", "%",         "1",
          "-",     "Ohm",   "mOhm",  "kOhm",     "Ω",          "N.m",   "Nm",      "mNm",   "N.m.s/rad", "N.m/rad",
          "rad",   "rad/s", "deg",   "deg/s",    "°",          "km/h",  "l/min",   "L/h",   "W/K",       "W/K4",
          "W/m²K", "J/K",   "kg.m2", "W/(m2.K)", "kg.m2",      "kgm²",  "kg/h",    "hPa",   "mbar",      "bar",
          "A",     "mA",    "V",     "mV",       "us",         "µs",    "ms",      "s",     "min",       "h",
          "Hz",    "kHz",   "m/s",   "m/s2",     "m/s²",       "mm",    "V.s/rad", "N.m/A", "H",         "mH",
          "W",     "kW",    "J",     "kWh",      "Ah",         "N·m",   "m3/h",    "m³/h",  "K/W",       "rad/s2",
          "N m",   "m / s", "ppm",   "W/(m.K)",  "N.m.s2/rad2"}) {
        EXPECT_TRUE(isKnownUnit(unit)) << unit;
    }
}

TEST(Unit, ConvertsTemperaturesWithTheirOffset) {
    expectConversion("degC", "K", 1, 273.15);
    expectConversion("°C", "K", 1, 273.15);
    expectConversion("K", "degC", 1, -273.15);
    expectConversion("degF", "K", 5.0 / 9.0, 273.15 - 32 * 5.0 / 9.0);
    expectConversion("degC", "degF", 1.8, 32);
    const auto toKelvin = convertUnit("degC", "K");
    EXPECT_EQ((*toKelvin)(20.0), 293.15);
    // A difference has no offset.
    expectConversion("K/W", "degC/W", 1);
}

TEST(Unit, ConvertsTheUsualChannels) {
    expectConversion("mA", "A", 1e-3);
    expectConversion("%", "1", 0.01);
    expectConversion("km/h", "m/s", 1 / 3.6);
    expectConversion("l/min", "m3/s", 1e-3 / 60);
    expectConversion("mNm", "N.m", 1e-3);
    expectConversion("mbar", "Pa", 100);
    expectConversion("deg", "rad", pi / 180);
    expectConversion("kWh", "J", 3.6e6);
    expectConversion("kgm²", "kg.m2", 1);
    expectConversion("W/m²K", "W/(m2.K)", 1);
    expectConversion("kph", "m/s", 1 / 3.6);
    expectConversion("ms", "s", 1e-3);
    expectConversion("W/K4", "W/K4", 1);
}

TEST(Unit, ReadsTurnsPerTimeAsTheOtherSideAsksFor) {
    for (const char* turns : {"rpm", "1/min", "min-1", "rev/min", "U/min"}) {
        expectConversion(turns, "rad/s", 2 * pi / 60);
        expectConversion("rad/s", turns, 60 / (2 * pi));
        expectConversion(turns, "Hz", 1.0 / 60);
        expectConversion(turns, "1/min", 1);
        expectConversion(turns, "deg/s", 6);
    }
    expectConversion("Hz", "rad/s", 2 * pi);
    expectConversion("kHz", "rad/s", 2000 * pi);
    expectConversion("1/s", "rad/s", 1);
    expectConversion("1/s", "Hz", 1);
    expectConversion("1/min", "1/s", 1.0 / 60);
}

TEST(Unit, RadianIsDimensionlessInCompounds) {
    expectConversion("N.m.s/rad", "N.m.s", 1);
    expectConversion("V.s/rad", "V.s", 1);
    expectConversion("Nm/rad", "N.m/rad", 1);
}

TEST(Unit, TakesLatin1Bytes) {
    expectConversion(
        "\xb0"
        "C",
        "K", 1, 273.15);
    expectConversion("\xb5s", "s", 1e-6);
}

TEST(Unit, TheEmptyUnitConvertsToItselfAlone) {
    expectConversion("", "", 1);
    EXPECT_FALSE(convertUnit("", "K"));
    EXPECT_FALSE(convertUnit("1", ""));
    EXPECT_TRUE(isKnownUnit(""));
}

TEST(Unit, NamesBothUnitsOfAMismatch) {
    const auto conversion = convertUnit("mA", "K");
    ASSERT_FALSE(conversion);
    EXPECT_EQ(conversion.diagnostics().front().message,
              "\"mA\" cannot be converted to \"K\": they measure different quantities");
    EXPECT_TRUE(areConvertible("mbar", "Pa"));
    EXPECT_FALSE(areConvertible("mbar", "K"));
}

TEST(Unit, HintsAtWhatWasMeant) {
    const auto misspelt = convertUnit("Ohn", "Ohm");
    ASSERT_FALSE(misspelt);
    EXPECT_EQ(misspelt.diagnostics().front().message, "unknown unit \"Ohn\"");
    EXPECT_EQ(misspelt.diagnostics().front().hint, "did you mean \"Ohm\"?");
    const auto coulomb = convertUnit("C", "K");
    ASSERT_FALSE(coulomb);
    EXPECT_EQ(coulomb.diagnostics().front().hint, "\"C\" is the coulomb; write \"degC\" for a temperature");
}

TEST(Unit, RefusesWhatIsNoUnit) {
    for (const char* text : {"foo", "))((", "m999999", "m since 1970", "lg(re 1 mW)", "@", "[V]", "V;A", "1//", "\n",
                             "((((((((((((((((((m"}) {
        EXPECT_FALSE(isKnownUnit(text)) << text;
    }
    EXPECT_FALSE(isKnownUnit(std::string(10000, 'm')));
}

TEST(Unit, ReadsTheSpellingsOfLoggers) {
    expectConversion("kPa abs", "Pa", 1000);
    expectConversion("bar abs", "Pa", 1e5);
    expectConversion("Deg C", "K", 1, 273.15);
    expectConversion("deg. C", "K", 1, 273.15);
    expectConversion("r/s", "rad/s", 2 * pi);
    expectConversion("r/min", "rad/s", pi / 30);
    expectConversion("msec", "s", 1e-3);
    expectConversion("milliseconds rel", "s", 1e-3);
    expectConversion("A rms", "A", 1);
    expectConversion("V dc", "V", 1);
    expectConversion("ccps", "m3/s", 1e-6);
}

TEST(Unit, TakesNoUnitForOneOfAnotherZero) {
    for (const char* gauge : {"bar rel", "kPa gauge", "bar g"}) {
        EXPECT_FALSE(isKnownUnit(gauge) && areConvertible(gauge, "Pa")) << gauge;
        EXPECT_EQ(unitAlike(gauge), "") << gauge;
        EXPECT_TRUE(beginsWithUnitOf(gauge, "Pa")) << gauge;
    }
    EXPECT_EQ(unitAlike("kPa at inlet"), "kPa");
    EXPECT_EQ(unitAlike("degCC"), "degC");
    EXPECT_EQ(unitAlike("ambient"), "");
    EXPECT_FALSE(beginsWithUnitOf("in front", "K"));
    EXPECT_FALSE(beginsWithUnitOf("kPa", "Pa")) << "it is one";
}

TEST(Unit, IsSafeToUseFromSeveralThreads) {
    std::vector<std::thread> threads;
    std::vector<int> failures(4, 0);
    for (int t = 0; t < 4; ++t) {
        threads.emplace_back([&failures, t] {
            for (int i = 0; i < 200; ++i) {
                const auto conversion = convertUnit("degC", "K");
                if (!conversion || (*conversion)(0) != 273.15) ++failures[static_cast<std::size_t>(t)];
                if (areConvertible("unit" + std::to_string(i), "m")) ++failures[static_cast<std::size_t>(t)];
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(failures, std::vector<int>(4, 0));
}

TEST(Unit, DoesNotTurnATimeIntoAFrequency) {
    EXPECT_FALSE(convertUnit("rpm", "s"));
    EXPECT_FALSE(convertUnit("s", "Hz"));
    EXPECT_FALSE(areConvertible("Ohm", "S"));
    EXPECT_TRUE(areConvertible("1/s", "Hz"));
}

}  // namespace
}  // namespace analogon
