#include "core/base/number_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace analogon {
namespace {

TEST(NumberText, CarriesTheDigitsItIsWorth) {
    EXPECT_EQ(numberText(0.03120), "0.0312");
    EXPECT_EQ(numberText(2.1e-11), "2.1e-11");
    EXPECT_EQ(numberText(std::nan("")), "–");
    EXPECT_EQ(numberText(12345.678), "12346");
    EXPECT_EQ(percentText(8.6), "8.60 %");
    EXPECT_EQ(percentTexts(0.5024, 0.4971), std::make_pair(std::string("0.502 %"), std::string("0.497 %")));
    EXPECT_EQ(percentTexts(8.6, 1.1), std::make_pair(std::string("8.60 %"), std::string("1.10 %")));
    EXPECT_EQ(percentText(0.012345), "0.0123 %");
    EXPECT_EQ(percentText(123.4), "123 %");
}

TEST(ValueText, CarriesTheDigitsOfItsStandardError) {
    EXPECT_EQ(valueText(3.0961, 0.0213), "3.096 ± 0.021");
    EXPECT_EQ(valueText(2.1034e-11, 3.1e-13), "(2.103 ± 0.031)e-11");
    EXPECT_EQ(valueText(1.5, std::nan("")), "1.5");
}

TEST(ValueText, TellsAValueThatIsSmallerThanItsStandardError) {
    EXPECT_EQ(valueText(3.2, 6.9), "3 ± 7");
    EXPECT_EQ(valueText(-3.2, 6.9), "-3 ± 7");
    EXPECT_EQ(valueText(0.0312, 6.9), "0.03 ± 7");
    EXPECT_EQ(valueText(-0.2, 6.9), "-0.2 ± 7");
    EXPECT_EQ(valueText(3.2e-8, 6.9e-8), "(3 ± 7)e-8");
    EXPECT_EQ(valueText(0.0, 0.5), "0 ± 0.5");
    EXPECT_EQ(valueText(12.0, 340.0), "12 ± 300");
    EXPECT_EQ(valueText(296.0, 18796.0), "296 ± 20000");
    EXPECT_EQ(valueText(1.2e-6, 3.6e-4), "1e-6 ± 4e-4");
    EXPECT_EQ(valueText(1.8, 2.9e14), "0 ± 3e14") << "nothing beside its error";
}

TEST(ValueText, HasNoMoreThanTwoDigitsOfTheErrorAndOneExponent) {
    struct Pair {
        double value, error;
        const char* text;
    };
    const Pair table[] = {
        {12345.6, 678.9, "12350 ± 680"},
        {123456, 7012, "123500 ± 7000"},
        {99.96, 0.0996, "99.96 ± 0.10"},
        {9.96, 9.96, "10 ± 10"},
        {0.6, 9.6, "0.6 ± 10"},
        {293.15, 1.2e-13, "293.15 ± 1e-13"},
        {1234567, 1234, "(1.2346 ± 0.0012)e6"},
        {-2.5e-5, 1.04e-5, "(-2.5 ± 1.0)e-5"},
        {9.996e-4, 2e-5, "0.001000 ± 0.000020"},
        {0.001, 0.00012, "0.00100 ± 0.00012"},
        {3e-306, 1.2e-306, "(3.0 ± 1.2)e-306"},
        {1.5e308, 1.2e307, "(1.50 ± 0.12)e308"},
        {600, 7e15, "0 ± 7e15"},
        {1, 1, "1.0 ± 1.0"},
    };
    for (const Pair& p : table) EXPECT_EQ(valueText(p.value, p.error), p.text) << p.value << ' ' << p.error;
}

}  // namespace
}  // namespace analogon
