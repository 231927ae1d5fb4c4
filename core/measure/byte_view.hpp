#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace analogon {

/// Bytes of a file that may be damaged: nothing outside them is ever touched.
class ByteView {
public:
    ByteView() = default;
    ByteView(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

    const std::uint8_t* data() const { return data_; }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    bool has(std::uint64_t offset, std::uint64_t bytes) const { return offset <= size_ && bytes <= size_ - offset; }

    /// What there is of these bytes: cut at the end of the view.
    ByteView part(std::uint64_t offset, std::uint64_t bytes = UINT64_MAX) const {
        if (offset >= size_) return {};
        return {data_ + offset, static_cast<std::size_t>(std::min<std::uint64_t>(bytes, size_ - offset))};
    }

    /// A number at an offset; 0 where it does not lie wholly within.
    template <class T>
    T little(std::uint64_t offset) const {
        return number<T>(offset, std::endian::native == std::endian::big);
    }
    template <class T>
    T big(std::uint64_t offset) const {
        return number<T>(offset, std::endian::native == std::endian::little);
    }
    template <class T>
    T number(std::uint64_t offset, bool swapped) const {
        static_assert(std::is_trivially_copyable_v<T>);
        T value{};
        if (!has(offset, sizeof(T))) return value;
        std::uint8_t bytes[sizeof(T)];
        std::memcpy(bytes, data_ + offset, sizeof(T));
        if (swapped) std::reverse(bytes, bytes + sizeof(T));
        std::memcpy(&value, bytes, sizeof(T));
        return value;
    }

    std::string_view text() const { return {reinterpret_cast<const char*>(data_), size_}; }
    /// Up to the first 0.
    std::string_view terminatedText() const {
        const std::string_view whole = text();
        return whole.substr(0, whole.find('\0'));
    }

private:
    const std::uint8_t* data_{};
    std::size_t size_{};
};

}  // namespace analogon
