#include "core/base/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace analogon {

namespace {

int decade(double value) { return value == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value)))); }

/// value / 10^exponent, where that power is no number, too.
double scaledDown(double value, int exponent) {
    constexpr int most = 300;
    return std::abs(exponent) <= most ? value / std::pow(10.0, exponent)
                                      : value / std::pow(10.0, exponent / 2) / std::pow(10.0, exponent - exponent / 2);
}

/// To so many decimals; negative: to tens, hundreds …
double rounded(double value, int decimals) {
    const double whole = std::round(scaledDown(value, -decimals));
    return scaledDown(whole, decimals);
}

std::string withoutTrailingZeros(std::string text) {
    if (text.find('.') == std::string::npos) return text;
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
}

}  // namespace

std::string numberText(double value, int digits) {
    if (!std::isfinite(value)) return "–";
    if (value == 0) return "0";
    const int exponent = decade(value);
    if (exponent < -3 || exponent > 5) {
        const std::string mantissa =
            withoutTrailingZeros(fmt::format("{:.{}f}", scaledDown(value, exponent), digits - 1));
        return fmt::format("{}e{}", mantissa, exponent);
    }
    return withoutTrailingZeros(fmt::format("{:.{}f}", value, std::max(0, digits - 1 - exponent)));
}

std::string percentText(double value) {
    if (!std::isfinite(value)) return "–";
    const int decimals = std::abs(value) >= 0.1 ? std::clamp(2 - decade(value), 0, 2) : 4;
    return fmt::format("{:.{}f} %", value, value == 0 ? 0 : decimals);
}

std::pair<std::string, std::string> percentTexts(double one, double other) {
    std::pair<std::string, std::string> texts{percentText(one), percentText(other)};
    for (int decimals = 3; texts.first == texts.second && one != other && decimals <= 4; ++decimals)
        texts = {fmt::format("{:.{}f} %", one, decimals), fmt::format("{:.{}f} %", other, decimals)};
    return texts;
}

std::string valueText(double value, double standardError) {
    constexpr double beyondDigits = 1e-9;  // of the value, or of the error: below, each has a notation of its own
    if (!std::isfinite(value)) return "–";
    if (!std::isfinite(standardError) || standardError <= 0) return numberText(value);
    if (standardError < beyondDigits * std::abs(value))
        return fmt::format("{} ± {}", numberText(value, 10), numberText(standardError, 1));
    // two digits of the error, one where it hides the value
    const int digits = std::abs(value) >= standardError ? 2 : 1;
    const double error = rounded(standardError, digits - 1 - decade(standardError));
    const int exponent = decade(std::max(std::abs(rounded(value, digits - 1 - decade(error))), error));
    const bool isScientific = exponent < -3 || exponent > 5;
    const int shared = isScientific ? exponent : 0, places = digits - 1 - decade(error) + shared;
    const double shown = rounded(scaledDown(value, shared), places);
    if (shown == 0) {  // told for what it is, and as nothing only where it is that beside its error
        const bool isNothing = std::abs(value) <= beyondDigits * standardError;
        return fmt::format("{} ± {}", isNothing ? "0" : numberText(value, 1), numberText(error, digits));
    }
    const int decimals = std::max(places, 0);
    const std::string both =
        fmt::format("{0:.{2}f} ± {1:.{2}f}", shown, rounded(scaledDown(error, shared), places), decimals);
    return isScientific ? fmt::format("({})e{}", both, exponent) : both;
}

std::size_t displayWidth(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padRight(std::string_view text, std::size_t width) {
    const std::size_t own = displayWidth(text);
    return std::string(text) + std::string(width > own ? width - own : 0, ' ');
}

std::string padLeft(std::string_view text, std::size_t width) {
    const std::size_t own = displayWidth(text);
    return std::string(width > own ? width - own : 0, ' ') + std::string(text);
}

}  // namespace analogon
