#include "ui/style/number.hpp"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <cmath>
#include <numbers>

#include "core/base/number_text.hpp"
#include "ui/style/translator.hpp"

namespace analogon::ui::style {
namespace {

/// A window in German, as far as numbers know of it.
class German {
public:
    German() {
        EXPECT_TRUE(translator_.loadLanguage("de"));
        QCoreApplication::installTranslator(&translator_);
    }
    ~German() { QCoreApplication::removeTranslator(&translator_); }

private:
    Translator translator_;
};

TEST(Number, HasTheExponentOfTheReport) {
    EXPECT_EQ(numberText(5e-5), "5e-5");
    EXPECT_EQ(numberText(-1.4e-12, 3), "-1.4e-12");
    for (const double value : {5e-5, 1.6918e-11, 2e7, 0.49, 293.15, 0.0})
        EXPECT_EQ(numberText(value).toStdString(), analogon::numberText(value, 5)) << value;
}

TEST(Number, HasTheDecimalSignOfTheWindow) {
    EXPECT_EQ(numberText(0.25), "0.25");
    EXPECT_EQ(percentText(8.6), "8.60 %");
    {
        const German german;
        EXPECT_EQ(numberText(0.25), "0,25");
        EXPECT_EQ(numberText(-1.4e-12, 3), "-1,4e-12");
        EXPECT_EQ(fixedText(12.5, 2), "12,50");
        EXPECT_EQ(percentText(8.6), "8,60 %");
        EXPECT_EQ(percentText(12.34), "12,3 %");
        EXPECT_EQ(withDecimalSign("(2.10 ± 0.03)e-11"), QString::fromUtf8("(2,10 ± 0,03)e-11"));
        EXPECT_EQ(numberText(std::nan("")), QString::fromUtf8("–"));
        EXPECT_EQ(windowLocale().language(), QLocale::German);
    }
    EXPECT_EQ(fixedText(12.5, 2), "12.50");
}

TEST(Number, HasNoSignBetweenThousands) {
    EXPECT_EQ(numberText(1234567.25, 9), "1234567.25");
    const German german;
    EXPECT_EQ(numberText(1234567.25, 9), "1234567,25");
    EXPECT_EQ(fixedText(98765.4, 1), "98765,4");
}

TEST(Number, IsTypedWithEitherSignInAnyLanguage) {
    const auto readsAll = [] {
        EXPECT_EQ(readNumber("1,5"), 1.5);
        EXPECT_EQ(readNumber("1.5"), 1.5);
        EXPECT_EQ(readNumber(" -2,5e-3 "), -2.5e-3);
        EXPECT_EQ(readNumber(",5"), 0.5);
        EXPECT_EQ(readNumber("+.5E2"), 50);
        EXPECT_EQ(readNumber("12."), 12);
        EXPECT_EQ(readNumber(QString::fromUtf8("−3")), -3);
        EXPECT_EQ(readNumber("1,234"), 1.234) << "never one thousand and more";
        EXPECT_EQ(readNumber("1.234"), 1.234) << "never one thousand and more";
    };
    readsAll();
    const German german;
    readsAll();
}

TEST(Number, IsNotGuessedFromWhatMayMeanTwoThings) {
    for (const char* typed : {"1.234,5", "1,234.5", "1,234,567", "1 234", "1'234", "1,5;2", "1,5,3", "", ",", "-", "e5",
                              "1e", "x", "0x10", "inf", "nan", "1e999"})
        EXPECT_FALSE(readNumber(typed)) << typed;
}

/// What is shown can be typed again.
TEST(Number, IsReadAsItIsShown) {
    const German german;
    for (const double value : {0.1, -293.15, 1.6918e-11, 2e7, 0.0, std::numbers::pi})
        EXPECT_DOUBLE_EQ(*readNumber(numberText(value, 17)), value);
}

TEST(Number, CountsInGroupsThatNoLanguageReadsAsAFraction) {
    const German german;
    EXPECT_EQ(countText(1234), "1234");
    EXPECT_EQ(countText(1234567), QString::fromUtf8("1\u202f234\u202f567"));
}

}  // namespace
}  // namespace analogon::ui::style
