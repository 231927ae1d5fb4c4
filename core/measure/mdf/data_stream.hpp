#pragma once

#include <cstdint>
#include <vector>

#include "core/measure/byte_view.hpp"

namespace analogon::mdf {

/// One stretch of data as it lies in the file.
struct Fragment {
    enum class Packing { Plain, Deflated, Transposed };
    ByteView stored;
    std::uint64_t bytes{};  // when unpacked
    Packing packing{Packing::Plain};
    std::uint32_t columns{};  // Transposed: bytes of a record
};

/// Data that lies in several blocks, as one sequence of bytes.
class DataStream {
public:
    void append(const Fragment& fragment);
    const std::vector<Fragment>& fragments() const { return fragments_; }
    std::uint64_t size() const { return size_; }

private:
    std::vector<Fragment> fragments_;
    std::uint64_t size_{};
};

/// Reads a stream from its beginning to its end, one unpacked fragment in memory at a time.
class ByteFeed {
public:
    explicit ByteFeed(const DataStream& stream) : stream_(&stream), remaining_(stream.size()) {}

    /// Records one behind the other. count 0: the end, or less than one record is left; first null: the bytes of these
    /// records are lost (a packed block is damaged).
    struct Run {
        const std::uint8_t* first{};
        std::uint64_t count{};
    };
    /// As many records of `stride` bytes as lie together, at most `limit`. Valid until the next call.
    Run takeRun(std::size_t stride, std::uint64_t limit);
    std::uint64_t remaining() const { return remaining_; }

private:
    bool load();
    Run straddling(std::size_t stride);
    void advance(std::uint64_t bytes);

    const DataStream* stream_;
    std::size_t next_{};          // fragment
    const std::uint8_t* here_{};  // null: lost
    std::uint64_t left_{};        // behind here_
    std::uint64_t lostBehind_{};  // what the fragment at hand declares beyond what could be unpacked
    std::uint64_t remaining_;
    std::vector<std::uint8_t> unpacked_, packed_, record_;
};

/// The whole stream in memory; empty where it is larger than `limit`. What is lost is 0.
std::vector<std::uint8_t> gathered(const DataStream& stream, std::uint64_t limit);

}  // namespace analogon::mdf
