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
    EXPECT_EQ(valueText(0.0312, 6.9), "0.03 ± 7") << "its digits are hidden by those of the error";
    EXPECT_EQ(valueText(-0.2, 6.9), "-0.2 ± 7") << "not -0";
    EXPECT_EQ(valueText(3.2e-8, 6.9e-8), "(3 ± 7)e-8");
    EXPECT_EQ(valueText(0.0, 0.5), "0.0 ± 0.5");
    EXPECT_EQ(valueText(12.0, 340.0), "12 ± 340");
}

}  // namespace
}  // namespace analogon
