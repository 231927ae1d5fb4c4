#include "core/measure/mdf/value_layout.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "core/measure/encoding.hpp"

namespace analogon::mdf {

namespace {

constexpr double exactLimit = 9007199254740992.0;  // 2^53

template <class Value>
bool isInexact(Value value) {
    if constexpr (sizeof(Value) < 8) return false;
    if constexpr (std::is_signed_v<Value>)
        return value > (Value{1} << 53) || value < -(Value{1} << 53);
    else
        return value > (Value{1} << 53);
}

template <class Value, bool swaps>
Value load(const std::uint8_t* bytes) {
    Value value;
    if constexpr (swaps && sizeof(Value) > 1) {
        std::uint8_t turned[sizeof(Value)];
        for (std::size_t i = 0; i < sizeof(Value); ++i) turned[i] = bytes[sizeof(Value) - 1 - i];
        std::memcpy(&value, turned, sizeof(Value));
    } else {
        std::memcpy(&value, bytes, sizeof(Value));
    }
    return value;
}

template <class Value, bool swaps>
bool extractPlain(const std::uint8_t* from, std::size_t stride, std::size_t count, double* out) {
    bool inexact = false;
    for (std::size_t i = 0; i < count; ++i, from += stride) {
        const Value value = load<Value, swaps>(from);
        if constexpr (std::is_integral_v<Value> && sizeof(Value) == 8) inexact = inexact || isInexact(value);
        out[i] = static_cast<double>(value);
    }
    return inexact;
}

double halfToDouble(std::uint16_t half) {
    const int exponent = (half >> 10) & 0x1F;
    const int mantissa = half & 0x3FF;
    double value = 0;
    if (exponent == 31)
        value = mantissa == 0 ? INFINITY : NAN;
    else if (exponent == 0)
        value = std::ldexp(mantissa, -24);
    else
        value = std::ldexp(1024 + mantissa, exponent - 25);
    return (half & 0x8000) ? -value : value;
}

template <bool swaps>
bool extractHalf(const std::uint8_t* from, std::size_t stride, std::size_t count, double* out) {
    for (std::size_t i = 0; i < count; ++i, from += stride) out[i] = halfToDouble(load<std::uint16_t, swaps>(from));
    return false;
}

/// The 64 bits or less of an integer that may begin within a byte: up to nine bytes take part.
std::uint64_t loadBits(const ValueLayout& layout, const std::uint8_t* from) {
    const auto bytes = static_cast<int>(layout.bytes());
    std::uint64_t low = 0;
    std::uint64_t ninth = 0;
    for (int i = 0; i < bytes; ++i) {
        const std::uint64_t byte = from[layout.isBigEndian ? bytes - 1 - i : i];
        if (i < 8)
            low |= byte << (8 * i);
        else
            ninth = byte;
    }
    std::uint64_t value = low >> layout.bitOffset;
    if (bytes == 9) value |= ninth << (64 - layout.bitOffset);
    return layout.bits == 64 ? value : value & ((std::uint64_t{1} << layout.bits) - 1);
}

bool extractBits(const ValueLayout& layout, const std::uint8_t* from, std::size_t stride, std::size_t count,
                 double* out) {
    bool inexact = false;
    const std::uint64_t sign = std::uint64_t{1} << (layout.bits - 1);
    for (std::size_t i = 0; i < count; ++i, from += stride) {
        const std::uint64_t value = loadBits(layout, from);
        out[i] = layout.type == ValueLayout::Type::Signed
                     ? static_cast<double>(static_cast<std::int64_t>((value ^ sign) - sign))
                     : static_cast<double>(value);
        inexact = inexact || std::abs(out[i]) > exactLimit;
    }
    return inexact;
}

template <bool swaps>
bool extractWhole(const ValueLayout& layout, const std::uint8_t* from, std::size_t stride, std::size_t count,
                  double* out) {
    const bool isSigned = layout.type == ValueLayout::Type::Signed;
    const bool isFloat = layout.type == ValueLayout::Type::Float;
    switch (layout.bits) {
        case 8:
            return isSigned ? extractPlain<std::int8_t, false>(from, stride, count, out)
                            : extractPlain<std::uint8_t, false>(from, stride, count, out);
        case 16:
            return isFloat    ? extractHalf<swaps>(from, stride, count, out)
                   : isSigned ? extractPlain<std::int16_t, swaps>(from, stride, count, out)
                              : extractPlain<std::uint16_t, swaps>(from, stride, count, out);
        case 32:
            return isFloat    ? extractPlain<float, swaps>(from, stride, count, out)
                   : isSigned ? extractPlain<std::int32_t, swaps>(from, stride, count, out)
                              : extractPlain<std::uint32_t, swaps>(from, stride, count, out);
        default:
            return isFloat    ? extractPlain<double, swaps>(from, stride, count, out)
                   : isSigned ? extractPlain<std::int64_t, swaps>(from, stride, count, out)
                              : extractPlain<std::uint64_t, swaps>(from, stride, count, out);
    }
}

std::string hexadecimal(ByteView value) {
    std::string out;
    for (std::size_t i = 0; i < value.size(); ++i) out += fmt::format("{:02x}", value.data()[i]);
    return out;
}

std::string terminated16(ByteView value, Encoding encoding) {
    std::size_t length = 0;
    while (length + 1 < value.size() && (value.data()[length] != 0 || value.data()[length + 1] != 0)) length += 2;
    return decodeText(value.part(0, length).text(), encoding);
}

/// Milliseconds of the minute, minute, hour, day, month, year of the century.
std::string canOpenDate(ByteView value) {
    const unsigned milliseconds = value.little<std::uint16_t>(0);
    const unsigned year = value.little<std::uint8_t>(6) & 0x7Fu;
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}", year + (year < 84 ? 2000 : 1900),
                       value.little<std::uint8_t>(5) & 0x3Fu, value.little<std::uint8_t>(4) & 0x1Fu,
                       value.little<std::uint8_t>(3) & 0x1Fu, value.little<std::uint8_t>(2) & 0x3Fu,
                       milliseconds / 1000, milliseconds % 1000);
}

/// Milliseconds since midnight and days since 1984-01-01.
std::string canOpenTime(ByteView value) {
    const unsigned milliseconds = value.little<std::uint32_t>(0) & 0x0FFFFFFFu;
    const std::chrono::year_month_day date{std::chrono::sys_days{std::chrono::year{1984} / 1 / 1} +
                                           std::chrono::days{value.little<std::uint16_t>(4)}};
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), milliseconds / 3600000,
                       milliseconds / 60000 % 60, milliseconds / 1000 % 60, milliseconds % 1000);
}

}  // namespace

bool ValueLayout::isPossible() const {
    if (bitOffset > 7) return false;
    if (type == Type::Float) return bitOffset == 0 && (bits == 16 || bits == 32 || bits == 64);
    if (isInteger()) return bits >= 1 && bits <= 64;
    return bitOffset == 0 && bits % 8 == 0;
}

bool extractNumbers(const ValueLayout& layout, const std::uint8_t* record, std::size_t stride, std::size_t count,
                    double* out) {
    const std::uint8_t* from = record + layout.byteOffset;
    const bool isWhole =
        layout.bitOffset == 0 && (layout.bits == 8 || layout.bits == 16 || layout.bits == 32 || layout.bits == 64);
    if (!isWhole) return extractBits(layout, from, stride, count, out);
    const bool swaps = layout.isBigEndian == (std::endian::native == std::endian::little);
    return swaps ? extractWhole<true>(layout, from, stride, count, out)
                 : extractWhole<false>(layout, from, stride, count, out);
}

std::string windows1252ToUtf8(std::string_view text) {
    // 0x80 … 0x9F; the rest is as in ISO 8859-1
    static constexpr const char* special[32] = {"€", "",  "‚", "ƒ", "„", "…", "†", "‡", "ˆ", "‰", "Š",
                                                "‹", "Œ", "",  "Ž", "",  "",  "‘", "’", "“", "”", "•",
                                                "–", "—", "˜", "™", "š", "›", "œ", "",  "ž", "Ÿ"};
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x80 && byte < 0xA0)
            out += special[byte - 0x80];
        else
            out += latin1ToUtf8(std::string_view(&c, 1));
    }
    return out;
}

std::string textOf(ValueLayout::Type type, ByteView value) {
    switch (type) {
        case ValueLayout::Type::Latin1:
            return latin1ToUtf8(value.terminatedText());
        case ValueLayout::Type::Windows1252:
            return windows1252ToUtf8(value.terminatedText());
        case ValueLayout::Type::Utf16Little:
            return terminated16(value, Encoding::Utf16LittleEndian);
        case ValueLayout::Type::Utf16Big:
            return terminated16(value, Encoding::Utf16BigEndian);
        case ValueLayout::Type::CanOpenDate:
            return canOpenDate(value);
        case ValueLayout::Type::CanOpenTime:
            return canOpenTime(value);
        case ValueLayout::Type::Bytes:
            return hexadecimal(value);
        default:
            break;
    }
    return inUtf8(value.terminatedText());
}

}  // namespace analogon::mdf
