#include "core/measure/plain_number.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <optional>
#include <random>
#include <string>

namespace analogon {
namespace {

/// The text behind the number; none: it takes a closer look.
std::optional<std::string> restOf(const std::string& text, char decimal, double& value) {
    const char* const end = text.data() + text.size();
    const char* const stop = readPlainNumber(text.data(), end, decimal, value);
    return stop ? std::optional(std::string(stop, end)) : std::nullopt;
}

TEST(PlainNumber, EndsWhereTheNumberDoes) {
    double value = 0;
    EXPECT_EQ(restOf("-12,5;3", ',', value), ";3");
    EXPECT_EQ(value, -12.5);
    EXPECT_EQ(restOf("1.5", ',', value), ".5");
    EXPECT_EQ(restOf("+.5E+02 V", '.', value), " V");
    EXPECT_EQ(value, 50);
    EXPECT_EQ(restOf("2e", '.', value), "e");
    EXPECT_EQ(restOf("7.", '.', value), "");
    for (const char* text : {"", "-", ".", "e5", "nan", "inf", "1e999", "\"1\""})
        EXPECT_FALSE(restOf(text, '.', value)) << text;
    EXPECT_EQ(restOf("-0", '.', value), "");
    EXPECT_TRUE(std::signbit(value));
}

TEST(PlainNumber, IsTheNearestToWhatIsWritten) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 200'000; ++i) {
        const std::uint64_t bits = random();
        double written = 0, value = 0;
        std::memcpy(&written, &bits, sizeof written);
        if (!std::isfinite(written)) continue;
        const int digits = 1 + i % 22;
        if (i % 3 != 0) written = std::ldexp(static_cast<double>(bits >> 11), -60 + i % 40);
        const std::string text =
            i % 2 == 0 ? fmt::format("{:.{}g}", written, digits) : fmt::format("{:.{}e}", written, digits);
        double expected = 0;
        const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), expected);
        if (code != std::errc{} || stop != text.data() + text.size()) continue;
        ASSERT_EQ(restOf(text, '.', value), "") << text;
        ASSERT_EQ(std::memcmp(&value, &expected, sizeof value), 0) << text;
    }
}

}  // namespace
}  // namespace analogon
