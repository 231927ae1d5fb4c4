#include "core/measure/mdf/data_stream.hpp"

#include <zlib.h>

namespace analogon::mdf {

namespace {

/// Unpacks into `out`, which has the size that is declared; how many bytes it became.
std::uint64_t inflateInto(ByteView packed, std::vector<std::uint8_t>& out) {
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) return 0;
    stream.next_in = const_cast<Bytef*>(packed.data());
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = out.data();
    stream.avail_out = static_cast<uInt>(out.size());
    inflate(&stream, Z_FINISH);
    const std::uint64_t written = out.size() - stream.avail_out;
    inflateEnd(&stream);
    return written;
}

/// Columns one behind the other become records again; what is behind the last whole record was not transposed.
void transposeBack(const std::vector<std::uint8_t>& from, std::size_t columns, std::vector<std::uint8_t>& to) {
    const std::size_t rows = from.size() / columns;
    to.resize(from.size());
    for (std::size_t column = 0; column < columns; ++column)
        for (std::size_t row = 0; row < rows; ++row) to[row * columns + column] = from[column * rows + row];
    std::copy(from.begin() + static_cast<std::ptrdiff_t>(rows * columns), from.end(),
              to.begin() + static_cast<std::ptrdiff_t>(rows * columns));
}

}  // namespace

void DataStream::append(const Fragment& fragment) {
    if (fragment.bytes == 0) return;
    fragments_.push_back(fragment);
    size_ += fragment.bytes;
}

bool ByteFeed::load() {
    if (lostBehind_ > 0) {
        here_ = nullptr;
        left_ = lostBehind_;
        lostBehind_ = 0;
        return true;
    }
    if (next_ == stream_->fragments().size()) return false;
    const Fragment& fragment = stream_->fragments()[next_++];
    left_ = fragment.bytes;
    if (fragment.packing == Fragment::Packing::Plain) {
        here_ = fragment.stored.data();
        return true;
    }
    unpacked_.resize(fragment.bytes);
    const std::uint64_t written = inflateInto(fragment.stored, unpacked_);
    if (fragment.packing == Fragment::Packing::Transposed && fragment.columns > 1) {
        packed_.swap(unpacked_);
        transposeBack(packed_, fragment.columns, unpacked_);
    }
    // a part of columns is no part of records
    const bool isUsable = written == fragment.bytes || fragment.packing == Fragment::Packing::Deflated;
    here_ = isUsable && written > 0 ? unpacked_.data() : nullptr;
    if (here_) {
        left_ = written;
        lostBehind_ = fragment.bytes - written;
    }
    return true;
}

void ByteFeed::advance(std::uint64_t bytes) {
    if (here_) here_ += bytes;
    left_ -= bytes;
    remaining_ -= bytes;
}

ByteFeed::Run ByteFeed::takeRun(std::size_t stride, std::uint64_t limit) {
    if (stride == 0 || limit == 0 || remaining_ < stride) return {};
    while (left_ == 0)
        if (!load()) return {};
    if (left_ < stride) return straddling(stride);
    const Run run{here_, std::min<std::uint64_t>(left_ / stride, limit)};
    advance(run.count * stride);
    return run;
}

ByteFeed::Run ByteFeed::straddling(std::size_t stride) {
    record_.resize(stride);
    bool isWhole = true;
    for (std::size_t have = 0; have < stride;) {
        while (left_ == 0)
            if (!load()) return {};
        const auto piece = static_cast<std::size_t>(std::min<std::uint64_t>(left_, stride - have));
        if (here_)
            std::memcpy(record_.data() + have, here_, piece);
        else
            isWhole = false;
        advance(piece);
        have += piece;
    }
    return {isWhole ? record_.data() : nullptr, 1};
}

std::vector<std::uint8_t> gathered(const DataStream& stream, std::uint64_t limit) {
    std::vector<std::uint8_t> out;
    if (stream.size() > limit) return out;
    out.reserve(stream.size());
    ByteFeed feed(stream);
    for (ByteFeed::Run run = feed.takeRun(1, UINT64_MAX); run.count > 0; run = feed.takeRun(1, UINT64_MAX)) {
        if (run.first)
            out.insert(out.end(), run.first, run.first + run.count);
        else
            out.resize(out.size() + run.count);
    }
    return out;
}

}  // namespace analogon::mdf
