#include "core/signal/formula.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace analogon {
namespace {

const std::vector<double> time{0, 1, 2, 3};

Outcome<DerivedValues> evaluated(const std::string& text, const std::map<std::string, FormulaOperand>& operands) {
    const Outcome<Formula> formula = Formula::parse(text);
    if (!formula) return formula.diagnostics();
    return formula->evaluate(time, operands);
}

TEST(Formula, MultipliesSignalsAndTheirUnits) {
    const std::vector<double> volts{1, 2, 3, 4}, milliamperes{500, 500, 1000, 0};
    const auto power = evaluated("motor.v*motor.i", {{"motor.v", {"V", volts}}, {"motor.i", {"mA", milliamperes}}});
    ASSERT_TRUE(power) << format(power.diagnostics());
    EXPECT_EQ(power->unit, "W");
    EXPECT_EQ(power->values, (std::vector<double>{0.5, 1, 3, 0}));
}

TEST(Formula, TakesTemperaturesInKelvinSoThatDifferencesAreRight) {
    const std::vector<double> inside{60, 61, 62, 63}, outside{293.15, 293.15, 293.15, 293.15};
    const auto rise = evaluated("'T Wasser' - T[2]", {{"T Wasser", {"degC", inside}}, {"T[2]", {"K", outside}}});
    ASSERT_TRUE(rise) << format(rise.diagnostics());
    EXPECT_EQ(rise->unit, "K");
    EXPECT_NEAR(rise->values[0], 40, 1e-9);
}

TEST(Formula, NamesTheUnitsThatDoNotAgree) {
    const std::vector<double> one{1, 1, 1, 1};
    const auto sum = evaluated("u + i", {{"u", {"V", one}}, {"i", {"A", one}}});
    ASSERT_FALSE(sum);
    EXPECT_EQ(sum.diagnostics()[0].message, "the units V and A do not agree");
    EXPECT_FALSE(evaluated("sin(u)", {{"u", {"V", one}}}));
    EXPECT_FALSE(evaluated("u", {}));
    EXPECT_EQ(evaluated("u*x", {{"u", {"V", one}}, {"x", {"", one}}})->unit, "");  // nobody knows
    EXPECT_EQ(evaluated("2*u + 1", {{"u", {"V", one}}})->unit, "V");
    EXPECT_EQ(evaluated("u^2", {{"u", {"m", one}}})->unit, "m2");
}

TEST(Formula, DifferentiatesAndIntegratesOverTime) {
    const std::vector<double> way{0, 2, 4, 6}, gap{1, std::nan(""), 1, 1};
    const auto speed = evaluated("der(s)", {{"s", {"m", way}}});
    ASSERT_TRUE(speed);
    EXPECT_EQ(speed->unit, "m/s");
    EXPECT_EQ(speed->values, (std::vector<double>{2, 2, 2, 2}));
    const auto charge = evaluated("integral(i)", {{"i", {"A", way}}});
    ASSERT_TRUE(charge);
    EXPECT_EQ(charge->unit, "C");
    EXPECT_EQ(charge->values, (std::vector<double>{0, 1, 4, 9}));
    const auto over = evaluated("integral(i)", {{"i", {"A", gap}}});
    EXPECT_TRUE(std::isnan(over->values[1]));
    EXPECT_EQ(over->values[3], 1);
}

TEST(Formula, RefusesWhatIsNoFormulaOfSignals) {
    for (const char* wrong : {"", "u +", "if u then 1 else 2", "u > 1", "foo(u)", "sin(u, u)", "{u}", "not u", "u[k]"})
        EXPECT_FALSE(Formula::parse(wrong)) << wrong;
    EXPECT_EQ(Formula::parse("a*b + a/c.d")->names(), (std::vector<std::string>{"a", "b", "c.d"}));
}

TEST(ValuesAt, FollowTheLineBetweenSamplesAndEndWhereItEnds) {
    const std::vector<double> from{0, 10, 20}, values{0, 10, 0}, wanted{-1, 0, 5, 12, 20, 21};
    const std::vector<double> at = valuesAt(from, values, wanted);
    EXPECT_TRUE(std::isnan(at.front()));
    EXPECT_TRUE(std::isnan(at.back()));
    EXPECT_EQ((std::vector<double>(at.begin() + 1, at.end() - 1)), (std::vector<double>{0, 5, 8, 0}));
}

}  // namespace
}  // namespace analogon
