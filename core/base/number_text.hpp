#pragma once

#include <string>
#include <string_view>
#include <utility>

/// Numbers for people.
namespace analogon {

/// Significant digits without trailing zeros: 0.0312, 12.5, 3.1e-11; "–" when not finite.
std::string numberText(double value, int digits = 4);

/// "8.60 %" with three significant digits; "–" when not finite.
std::string percentText(double value);
/// Two of them with as many digits as tell them apart (up to four decimals).
std::pair<std::string, std::string> percentTexts(double one, double other);

/// Value and standard error with two digits of the error: "3.096 ± 0.021", "(2.10 ± 0.03)e-11". With one where the
/// value is smaller than its error, "3 ± 7", and of a value that these would hide its first digit, "0.03 ± 7". Without
/// an error (not finite) the value alone.
std::string valueText(double value, double standardError);

/// Characters as a terminal counts them (code points).
std::size_t displayWidth(std::string_view text);
std::string padRight(std::string_view text, std::size_t width);
std::string padLeft(std::string_view text, std::size_t width);

}  // namespace analogon
