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

/// Value and standard error with two digits of the error and one exponent: "3.096 ± 0.021", "(2.103 ± 0.031)e-11",
/// "12350 ± 680". With one digit where the value is smaller than its error, "3 ± 7", "0.4 ± 7"; "0 ± 7" below 1e-9 of
/// the error. Of an error beyond all digits of the value the size: "293.15 ± 1e-13". Without an error (not finite) the
/// value alone.
std::string valueText(double value, double standardError);

/// Characters as a terminal counts them (code points).
std::size_t displayWidth(std::string_view text);
std::string padRight(std::string_view text, std::size_t width);
std::string padLeft(std::string_view text, std::size_t width);

}  // namespace analogon
