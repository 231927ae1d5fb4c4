#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>

/// The usual number of a table, read in one pass over its characters.
namespace analogon {

namespace plain_number {

/// 10^0 … 10^22, which a double holds exactly.
inline constexpr std::array<double, 23> powers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                               1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// The digits of a number, gathered to one whole number and a power of ten.
struct Digits {
    std::uint64_t whole{};
    int count{};  // that are significant
    int scale{};  // times 10^scale
    bool isAny{};

    const char* take(const char* at, const char* end, int step) {
        for (; at != end; ++at) {
            const auto digit = static_cast<unsigned>(*at - '0');
            if (digit > 9) break;
            isAny = true;
            if (count > 0 || digit > 0) ++count;
            if (count <= 19) whole = 10 * whole + digit;
            scale += step;
        }
        return at;
    }
};

inline const char* takeExponent(const char* at, const char* end, int& exponent) {
    if (at == end || (*at != 'e' && *at != 'E')) return at;
    const char* behind = at + 1;
    const bool isNegative = behind != end && *behind == '-';
    if (behind != end && (*behind == '-' || *behind == '+')) ++behind;
    int value = 0;
    const char* const first = behind;
    for (; behind != end && static_cast<unsigned>(*behind - '0') <= 9; ++behind)
        if (value < 10'000) value = 10 * value + (*behind - '0');
    if (behind == first) return at;
    exponent += isNegative ? -value : value;
    return behind;
}

/// The general way, for many digits and large exponents: correctly rounded, too.
inline bool readAny(const char* begin, const char* end, char decimal, double& value) {
    std::array<char, 64> copy;
    const auto size = static_cast<std::size_t>(end - begin);
    if (size > copy.size()) return false;
    for (std::size_t i = 0; i < size; ++i) copy[i] = begin[i] == decimal ? '.' : begin[i];
    const char* const first = copy.data() + (size > 0 && copy[0] == '+' ? 1 : 0);
    const auto [stop, code] = std::from_chars(first, copy.data() + size, value);
    return code == std::errc{} && stop == copy.data() + size && std::isfinite(value);
}

}  // namespace plain_number

/// A finite number at the front of [at, end) with this decimal mark (0: none may stand in it), correctly rounded; where
/// it ends. Null: what stands there takes a closer look.
inline const char* readPlainNumber(const char* at, const char* end, char decimal, double& value) {
    const char* const begin = at;
    const bool isNegative = at != end && *at == '-';
    if (at != end && (*at == '-' || *at == '+')) ++at;
    plain_number::Digits digits;
    at = digits.take(at, end, 0);
    if (at != end && decimal != 0 && *at == decimal) at = digits.take(at + 1, end, -1);
    if (!digits.isAny) return nullptr;
    at = plain_number::takeExponent(at, end, digits.scale);
    constexpr std::uint64_t exact = std::uint64_t{1} << 53;
    if (digits.count > 19 || digits.whole > exact || digits.scale > 22 || digits.scale < -22)
        return plain_number::readAny(begin, at, decimal, value) ? at : nullptr;
    // both are exact, and so is the rounding of one operation (Clinger, "How to read floating point numbers
    // accurately")
    const auto whole = static_cast<double>(digits.whole);
    const double size = digits.scale < 0 ? whole / plain_number::powers[static_cast<std::size_t>(-digits.scale)]
                                         : whole * plain_number::powers[static_cast<std::size_t>(digits.scale)];
    value = isNegative ? -size : size;
    return at;
}

}  // namespace analogon
