#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "core/base/text.hpp"
#include "core/measure/byte_view.hpp"

/// The structure of a TDMS file: objects with properties, and where their raw values lie.
namespace analogon::tdms {

enum DataType : std::uint32_t {
    Int8 = 1,
    Int16 = 2,
    Int32 = 3,
    Int64 = 4,
    Uint8 = 5,
    Uint16 = 6,
    Uint32 = 7,
    Uint64 = 8,
    Float32 = 9,
    Float64 = 10,
    Float32WithUnit = 0x19,
    Float64WithUnit = 0x1A,
    String = 0x20,
    Boolean = 0x21,
    Timestamp = 0x44,
    DaqMx = 0xFFFFFFFF
};

/// Bytes of a value; 0: none that can be read (or a text, whose length varies).
std::size_t sizeOf(std::uint32_t type);

struct TimePoint {
    std::int64_t seconds{};    // since 1904-01-01 UTC
    std::uint64_t fraction{};  // of a second, in 2^-64
};
TimePoint timePointAt(ByteView bytes, std::uint64_t offset, bool isBigEndian);
/// ISO 8601 with three decimals, in UTC.
std::string isoText(const TimePoint& time);

using Property = std::variant<double, std::string, TimePoint>;

/// Values of a channel in one segment: `count` of them `stride` bytes apart, again in each of `repeats` chunks.
struct Piece {
    ByteView bytes;  // from the first value on
    std::size_t stride{};
    std::uint64_t count{};
    std::uint64_t repeats{1};
    std::uint64_t repeatStride{};
    std::uint32_t type{};
    bool isBigEndian{};
    std::uint64_t textBytes{};  // of String: what one chunk takes

    std::uint64_t values() const { return count * repeats; }
};

struct Object {
    std::string group, channel;  // both empty: the file; channel empty: a group
    std::map<std::string, Property> properties;
    std::vector<Piece> pieces;
    std::uint32_t type{};
    std::uint32_t scaleId{};  // of the raw values of DAQmx
    bool isDaqMx{};
    bool isSkipped{};  // its values are of a kind that cannot be read

    std::uint64_t values() const;
};

struct File {
    std::vector<Object> objects;  // in the order in which they appear
    bool isIncomplete{};          // the recorder did not close it, or it was cut
    bool isDamaged{};
};

File readSegments(ByteView bytes);

}  // namespace analogon::tdms
