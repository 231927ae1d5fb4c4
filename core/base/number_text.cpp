#include "core/base/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace analogon {

namespace {

int decade(double value) { return value == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value)))); }

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
            withoutTrailingZeros(fmt::format("{:.{}f}", value / std::pow(10.0, exponent), digits - 1));
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
    if (!std::isfinite(value)) return "–";
    if (!std::isfinite(standardError) || standardError <= 0) return numberText(value);
    const int exponent = decade(std::max(std::abs(value), standardError));
    const bool isScientific = exponent < -3 || exponent > 5;
    const double scale = isScientific ? std::pow(10.0, exponent) : 1;
    const bool isTold = std::abs(value) >= standardError;
    const int decimals = std::clamp((isTold ? 1 : 0) - decade(standardError / scale), 0, 9);
    const bool vanishes = value != 0 && std::abs(value) / scale < 0.5 * std::pow(10.0, -decimals);
    const std::string digits =
        vanishes ? numberText(value / scale, 1) : fmt::format("{:.{}f}", value / scale, decimals);
    const std::string both = fmt::format("{} ± {:.{}f}", digits, standardError / scale, decimals);
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
