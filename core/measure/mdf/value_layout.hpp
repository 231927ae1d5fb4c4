#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/measure/byte_view.hpp"

namespace analogon::mdf {

/// How a value lies in a record.
struct ValueLayout {
    enum class Type {
        Unsigned,
        Signed,
        Float,
        Latin1,
        Windows1252,
        Utf8,
        Utf16Little,
        Utf16Big,
        Bytes,
        CanOpenDate,
        CanOpenTime
    };
    Type type{Type::Unsigned};
    bool isBigEndian{};
    std::uint64_t byteOffset{};
    unsigned bitOffset{};
    std::uint32_t bits{};

    bool isNumber() const { return type == Type::Unsigned || type == Type::Signed || type == Type::Float; }
    bool isInteger() const { return type == Type::Unsigned || type == Type::Signed; }
    /// Bytes that the value touches, from byteOffset on.
    std::uint64_t bytes() const { return (std::uint64_t{bitOffset} + bits + 7) / 8; }
    /// Whether there is such a type at all: 1 to 64 bits of an integer; 16, 32 or 64 of a float.
    bool isPossible() const;
};

/// Numbers of `count` records, `stride` bytes apart, whose first begins at `record`. Says whether an integer was too
/// large to be exact as a double.
bool extractNumbers(const ValueLayout& layout, const std::uint8_t* record, std::size_t stride, std::size_t count,
                    double* out);

/// A text (or date, or bytes as hexadecimal digits) as UTF-8. `value` are its bytes.
std::string textOf(ValueLayout::Type type, ByteView value);

/// Windows-1252, the code page of most files of format 3.
std::string windows1252ToUtf8(std::string_view text);

}  // namespace analogon::mdf
