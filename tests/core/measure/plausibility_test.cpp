#include "core/measure/plausibility.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace analogon {
namespace {

using testing::HasSubstr;

Diagnostics told(const std::string& text) {
    const Outcome<Table> table = readCsvText(text, "test.csv");
    EXPECT_TRUE(table) << format(table.diagnostics());
    if (!table) return {};
    std::vector<const Column*> used;
    for (std::size_t i = 1; i < table->columns.size(); ++i) used.push_back(&table->columns[i]);
    return implausibilities(*table, used);
}

/// A column beside a time in steps of 0.1 s, by its row.
template <class Value>
std::string column(const std::string& head, int rows, const Value& value) {
    std::string text = "t [s]," + head + "\n";
    for (int i = 0; i < rows; ++i) text += fmt::format("{},{}\n", 0.1 * i, value(i));
    return text;
}

TEST(Plausibility, HasNothingToSayOfUsualColumns) {
    EXPECT_TRUE(told(column("T [degC],w [rad/s],phi [rad],u [V]", 200, [](int i) {
                    return fmt::format("{},{},{},{}", 20 + 0.3 * i, 100 * std::sin(0.05 * i), 0.4 * i,
                                       i > 100 ? 12 : 0);
                })).empty());
    // an impulse in a command that rests otherwise, and a counter
    EXPECT_TRUE(told(column("M [N.m],n", 200, [](int i) { return fmt::format("{},{}", i == 50 ? 3 : 0, i); })).empty());
}

TEST(Plausibility, TellsTemperaturesBelowAbsoluteZero) {
    const Diagnostics of = told("t [s],T [degC]\n0,20\n1,-300\n2,21\n3,-274\n");
    ASSERT_EQ(of.size(), 1u);
    EXPECT_EQ(of[0].severity, Severity::Warning);
    EXPECT_EQ(of[0].place.line, 3);
    EXPECT_EQ(of[0].message, "column 'T' is below absolute zero in lines 3 and 5: -300 degC");
    EXPECT_TRUE(told("t [s],U [V]\n0,20\n1,-300\n").empty());
    EXPECT_EQ(told("t [s],T [K]\n0,293\n1,-1\n").size(), 1u);
}

TEST(Plausibility, TellsAnAngleThatStartsAnew) {
    const auto angle = [](double turn) {
        return [turn](int i) { return fmt::format("{}", std::fmod(0.03 * turn * i, turn)); };
    };
    const Diagnostics of = told(column("phi [deg]", 200, angle(360)));
    ASSERT_EQ(of.size(), 1u);
    EXPECT_THAT(of[0].message.english(), HasSubstr("the angle in column 'phi' starts anew after each turn, in 5 rows, "
                                                   "first in lines"));
    EXPECT_EQ(told(column("phi [rad]", 200, angle(2 * M_PI))).size(), 1u);
    EXPECT_TRUE(told(column("phi [deg]", 200, [](int i) { return 20.0 * i; })).empty());  // it runs on
}

TEST(Plausibility, TellsAColumnThatStandsWhileOthersMove) {
    const auto rows = [](int i) {
        const int read = i < 100 || i > 150 ? i : 100;
        return fmt::format("{},{}", std::sin(0.01 * read), std::cos(0.013 * i));
    };
    const Diagnostics of = told(column("w,u", 300, rows));
    ASSERT_EQ(of.size(), 1u);
    EXPECT_EQ(of[0].place.line, 102);
    EXPECT_THAT(of[0].message.english(),
                HasSubstr("column 'w' stands at 0.841471 from line 102 to line 152 while 'u' moves"));
    // a command that is held between two ramps, or before the first
    const auto ramps = [](int i) {
        return fmt::format("{},{}", i < 100 ? i : i < 160 ? 100 : i - 60, std::cos(0.013 * i));
    };
    EXPECT_TRUE(told(column("w,u", 300, ramps)).empty());
    EXPECT_TRUE(told(column("w,u", 300, [&](int i) { return ramps(i + 100); })).empty());
    // at rest all of them stand
    EXPECT_TRUE(told(column("w,u", 300, [&](int i) { return rows(i < 100 ? 0 : i + 100); })).empty());
}

TEST(Plausibility, TellsASingleValueFarBeyondAllOthers) {
    const Diagnostics of = told(column("w", 100, [](int i) { return i == 40 ? 1e12 : std::sin(0.1 * i); }));
    ASSERT_EQ(of.size(), 1u);
    EXPECT_EQ(of[0].place.line, 42);
    EXPECT_THAT(of[0].message.english(), HasSubstr("column 'w' holds 1e+12 in line 42, far beyond"));
    EXPECT_TRUE(told(column("w", 100, [](int i) { return i == 40 ? 5.0 : std::sin(0.1 * i); })).empty());
}

}  // namespace
}  // namespace analogon
