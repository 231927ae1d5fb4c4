#include "core/measure/plausibility.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/measure/text/text_recording.hpp"

namespace analogon {
namespace {

using testing::HasSubstr;

Diagnostics told(const std::string& text) {
    const Outcome<Table> table = textTables(text, "test.csv");
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

/// A reading of a sensor, rounded to `step`, with noise of this size.
class Reading {
public:
    Reading(double step, double noise) : step_(step), scatter_(0, noise) {}
    double operator()(double value) { return step_ * std::round((value + scatter_(random_)) / step_); }

private:
    double step_;
    std::mt19937 random_{3};
    std::normal_distribution<double> scatter_;
};

TEST(Plausibility, TellsANoisyColumnThatIsHeldThoughItGoesOnWithoutAJump) {
    for (const double step : {0.05, 0.1, 1e-6}) {
        Reading angle(step, 0.1), current(0.01, 0.03);
        double last = 0;
        const auto rows = [&](int i) {
            // it rests at times, too, and ends where it has begun
            const double now = angle(30 + 20 * std::sin(2 * M_PI * i / 1000.0) * (std::fmod(i, 700) < 300 ? 1 : 0));
            if (i < 1000 || i >= 2000) last = now;
            return fmt::format("{:.6f},{:.2f}", last, current(2 + std::sin(0.01 * i)));
        };
        const Diagnostics of = told(column("phi,i", 4000, rows));
        ASSERT_EQ(of.size(), 1u) << step;
        EXPECT_EQ(of[0].place.line, 1001) << "the last true reading counts among them";
        EXPECT_THAT(of[0].message.english(), HasSubstr("from line 1001 to line 2001 while 'i' moves")) << step;
    }
}

TEST(Plausibility, HasNothingToSayOfWhatMayRest) {
    Reading noisy(0.01, 0.03);
    const auto beside = [&](const auto& value) {
        return told(column("x,i", 4000, [&](int i) { return fmt::format("{},{:.2f}", value(i), noisy(2)); }));
    };
    const auto rests = [](int i) { return i >= 1000 && i < 2000; };
    // a command along a course of few digits that rests in its midst
    for (const char* const digits : {"{:.1f}", "{:.3f}", "{:.9f}"})
        EXPECT_TRUE(beside([&](int i) {
                        const double phase = rests(i) ? 1000 : i < 1000 ? i : i - 1000;
                        return fmt::format(fmt::runtime(digits), 12 * std::sin(0.003 * phase));
                    }).empty())
            << digits;
    // a command at random, at rest for a while; a speed at rest; a reading at the end of its range; a status
    std::mt19937 random(1);
    std::uniform_int_distribution<int> level(-500, 500);
    EXPECT_TRUE(beside([&](int i) { return rests(i) ? 7 : level(random); }).empty());
    EXPECT_TRUE(beside([&](int i) { return rests(i) ? 0.0 : noisy(std::sin(0.003 * i)); }).empty());
    EXPECT_TRUE(beside([&](int i) { return std::min(0.5, noisy(2 * std::sin(M_PI * i / 2000.0))); }).empty());
    EXPECT_TRUE(beside([&](int i) { return rests(i) ? 1 : i % 3; }).empty());
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
