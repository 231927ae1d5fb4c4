#include "core/measure/mat/mat_check.hpp"

#include <zlib.h>

#include <cctype>

namespace analogon::mat {

namespace {

constexpr std::uint64_t headBytes = 128;
constexpr std::uint32_t matrixElement = 14, compressedElement = 15;
constexpr unsigned cellClass = 1, structClass = 2, objectClass = 3, charClass = 4, sparseClass = 5, lastNumeric = 15,
                   functionClass = 16, opaqueClass = 17;
constexpr int deepest = 16;
constexpr std::uint64_t largestUnpacked = std::uint64_t{1} << 31;

std::uint64_t sizeOfElement(std::uint32_t type) {
    static constexpr std::uint8_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 0, 8, 0, 0, 8, 8, 0, 0, 1, 2, 4};
    return type < std::size(sizes) ? sizes[type] : 0;
}

/// One element of level 5: its type and its bytes.
struct Element {
    std::uint32_t type{};
    ByteView bytes;
};

class Level5 {
public:
    Level5(ByteView file, bool isBigEndian) : file_(file), isBigEndian_(isBigEndian) {}

    Check run() {
        std::uint64_t at = headBytes;
        bool hasVariable = false;
        while (at + 8 <= file_.size() && !check_.fault) {
            const auto type = number<std::uint32_t>(file_, at);
            const auto length = number<std::uint32_t>(file_, at + 4);
            if (!file_.has(at + 8, length)) return fail(phrase("the file ends in the middle of a variable"));
            const ByteView bytes = file_.part(at + 8, length);
            if (type == compressedElement)
                compressed(bytes);
            else if (type == matrixElement)
                matrix(bytes, 0);
            hasVariable = true;
            at += 8 + length;
        }
        if (!hasVariable && !check_.fault) return fail(phrase("no variable is in this file"));
        if (at < file_.size() && file_.size() - at >= 1 && at + 8 > file_.size() && !check_.fault)
            return fail(phrase("the file ends in the middle of a variable"));
        return std::move(check_);
    }

private:
    template <class T>
    T number(ByteView bytes, std::uint64_t offset) const {
        return bytes.number<T>(offset, isBigEndian_ == (std::endian::native == std::endian::little));
    }
    Check fail(Text why) {
        check_.fault = std::move(why);
        return std::move(check_);
    }
    void damaged() {
        if (!check_.fault) check_.fault = phrase("the file is damaged: the lengths in it contradict each other");
    }

    void compressed(ByteView packed) {
        z_stream stream{};
        if (inflateInit(&stream) != Z_OK) return damaged();
        stream.next_in = const_cast<Bytef*>(packed.data());
        stream.avail_in = static_cast<uInt>(packed.size());
        std::uint8_t head[8];
        stream.next_out = head;
        stream.avail_out = sizeof head;
        int code = inflate(&stream, Z_SYNC_FLUSH);
        const ByteView tag(head, sizeof head - stream.avail_out);
        const std::uint64_t length = number<std::uint32_t>(tag, 4);
        // deflate cannot do better than 1032 : 1
        const bool isPossible = tag.size() == 8 && length <= packed.size() * 1032 && length <= largestUnpacked;
        std::vector<std::uint8_t> unpacked(isPossible ? length : 0);
        stream.next_out = unpacked.data();
        stream.avail_out = static_cast<uInt>(unpacked.size());
        if (isPossible && code == Z_OK && length > 0) code = inflate(&stream, Z_FINISH);
        const bool isWhole = isPossible && stream.avail_out == 0 && (code >= 0 || code == Z_BUF_ERROR);
        inflateEnd(&stream);
        if (!isWhole) return damaged();
        if (number<std::uint32_t>(tag, 0) == matrixElement) matrix(ByteView(unpacked.data(), unpacked.size()), 0);
    }

    /// The element at `at`, which moves behind it; nothing where it does not lie within.
    std::optional<Element> next(ByteView bytes, std::uint64_t& at) const {
        if (!bytes.has(at, 8)) return std::nullopt;
        const auto first = number<std::uint32_t>(bytes, at);
        if ((first >> 16) != 0) {  // a small one: type and length share four bytes
            const std::uint32_t length = first >> 16;
            if (length > 4) return std::nullopt;
            const Element element{first & 0xFFFF, bytes.part(at + 4, length)};
            at += 8;
            return element;
        }
        const auto length = number<std::uint32_t>(bytes, at + 4);
        if (!bytes.has(at + 8, length)) return std::nullopt;
        const Element element{first, bytes.part(at + 8, length)};
        at += 8 + (first == matrixElement ? length : (std::uint64_t{length} + 7) / 8 * 8);
        return element;
    }

    void matrix(ByteView bytes, int depth) {
        if (bytes.empty()) return;  // an empty field
        std::uint64_t at = 0;
        const std::optional<Element> flags = next(bytes, at);
        if (!flags || flags->bytes.size() < 4 || depth > deepest) return damaged();
        const auto word = number<std::uint32_t>(flags->bytes, 0);
        const unsigned kind = word & 0xFF;
        const bool isComplex = (word & 0x0800) != 0;
        if (kind == opaqueClass) return opaque(bytes, at, depth);
        const std::optional<Element> dimensions = next(bytes, at);
        const std::optional<Element> name = next(bytes, at);
        if (!dimensions || !name || dimensions->bytes.size() < 8) return damaged();
        std::uint64_t values = 1;
        for (std::uint64_t i = 0; i < dimensions->bytes.size() / 4; ++i) {
            const auto size = number<std::int32_t>(dimensions->bytes, 4 * i);
            if (size < 0 || (size > 0 && values > (std::uint64_t{1} << 40) / static_cast<std::uint64_t>(size)))
                return damaged();
            values *= static_cast<std::uint64_t>(size);
        }
        if (kind == cellClass)
            nested(bytes, at, values, depth);
        else if (kind == structClass || kind == objectClass)
            structure(bytes, at, values, kind == objectClass, depth);
        else if (kind == sparseClass)
            sparse(bytes, at, *dimensions, isComplex);
        else if (kind == charClass || (kind > sparseClass && kind <= lastNumeric))
            numeric(bytes, at, values, isComplex, kind == charClass);
        else if (kind != functionClass)
            damaged();
    }

    /// A file has no object of this size without as many bytes: each takes eight at least.
    void nested(ByteView bytes, std::uint64_t at, std::uint64_t count, int depth) {
        if (count > bytes.size() / 8) return damaged();
        for (std::uint64_t i = 0; i < count && !check_.fault; ++i) {
            const std::optional<Element> element = next(bytes, at);
            if (!element || element->type != matrixElement) return damaged();
            matrix(element->bytes, depth + 1);
        }
    }

    void structure(ByteView bytes, std::uint64_t at, std::uint64_t count, bool isObject, int depth) {
        if (isObject && !next(bytes, at)) return damaged();  // name of its class
        const std::optional<Element> length = next(bytes, at);
        const std::optional<Element> names = next(bytes, at);
        const std::uint64_t nameBytes = length ? number<std::uint32_t>(length->bytes, 0) : 0;
        if (!names || nameBytes == 0 || names->bytes.size() % nameBytes != 0) return damaged();
        for (std::uint64_t i = 0; i < names->bytes.size(); i += nameBytes)
            if (names->bytes.part(i, nameBytes).text().find('\0') == std::string_view::npos) return damaged();
        const std::uint64_t fields = names->bytes.size() / nameBytes;
        if (fields > 0 && count > bytes.size() / fields) return damaged();
        nested(bytes, at, count * fields, depth);
    }

    void numeric(ByteView bytes, std::uint64_t at, std::uint64_t values, bool isComplex, bool isText) {
        for (int part = 0; part < (isComplex ? 2 : 1); ++part) {
            const std::optional<Element> data = next(bytes, at);
            if (!data && values == 0 && part == 0) return;
            const std::uint64_t size = data ? sizeOfElement(data->type) : 0;
            if (size == 0) return damaged();
            // characters of UTF-8 may be fewer or more than bytes
            const bool isUtf8 = isText && data->type == 16;
            if (!isUtf8 && data->bytes.size() / size != values) return damaged();
        }
    }

    void sparse(ByteView bytes, std::uint64_t at, const Element& dimensions, bool isComplex) {
        const std::optional<Element> rows = next(bytes, at);
        const std::optional<Element> columns = next(bytes, at);
        const auto height = number<std::uint32_t>(dimensions.bytes, 0),
                   width = number<std::uint32_t>(dimensions.bytes, 4);
        if (!rows || !columns || columns->bytes.size() / 4 != std::uint64_t{width} + 1) return damaged();
        const std::uint64_t there = rows->bytes.size() / 4;
        std::uint32_t last = 0;
        for (std::uint64_t i = 0; i <= width; ++i) {
            const auto begin = number<std::uint32_t>(columns->bytes, 4 * i);
            if (begin < last || begin > there) return damaged();
            last = begin;
        }
        for (std::uint64_t i = 0; i < last; ++i)
            if (number<std::uint32_t>(rows->bytes, 4 * i) >= height) return damaged();
        for (int part = 0; part < (isComplex ? 2 : 1); ++part) {
            const std::optional<Element> data = next(bytes, at);
            const std::uint64_t size = data ? sizeOfElement(data->type) : 0;
            if (size == 0 || data->bytes.size() / size < last) return damaged();
        }
    }

    void opaque(ByteView bytes, std::uint64_t at, int depth) {
        const std::optional<Element> name = next(bytes, at);
        const std::optional<Element> system = next(bytes, at);
        const std::optional<Element> kind = next(bytes, at);
        if (!name || !system || !kind) return damaged();
        if (depth == 0 && !name->bytes.empty())
            check_.opaque.push_back(
                {std::string(name->bytes.terminatedText()), std::string(kind->bytes.terminatedText())});
    }

    ByteView file_;
    bool isBigEndian_;
    Check check_;
};

/// A variable of level 4 at `at`, which moves behind it; false: damaged.
bool nextOfLevel4(ByteView file, std::uint64_t& at) {
    const bool isBig = file.little<std::uint32_t>(at) >= 5000;
    const auto field = [&](std::uint64_t i) {
        return file.number<std::uint32_t>(at + 4 * i, isBig == (std::endian::native == std::endian::little));
    };
    if (!file.has(at, 20)) return false;
    const std::uint32_t type = field(0), rows = field(1), columns = field(2), complex = field(3), name = field(4);
    static constexpr std::uint64_t sizes[] = {8, 4, 4, 2, 2, 1};
    const std::uint32_t precision = type / 10 % 10;
    const bool isKnown =
        type < 5000 && type / 100 % 10 == 0 && precision < std::size(sizes) && type % 10 <= 2 && complex <= 1;
    if (!isKnown || name == 0 || name > 4096) return false;
    if (columns != 0 && rows > (std::uint64_t{1} << 40) / columns) return false;
    const std::uint64_t bytes = std::uint64_t{rows} * columns * sizes[precision] * (complex + 1);
    if (!file.has(at + 20, name + bytes) || file.data()[at + 20 + name - 1] != 0) return false;
    at += 20 + name + bytes;
    return true;
}

}  // namespace

Check checkLevel5(ByteView file) { return Level5(file, file.part(126, 2).text() == "MI").run(); }

Check checkLevel4(ByteView file) {
    Check check;
    for (std::uint64_t at = 0; at < file.size() && !check.fault;)
        if (!nextOfLevel4(file, at)) check.fault = phrase("the file ends in the middle of a variable");
    return check;
}

bool looksLikeLevel4(ByteView file) {
    std::uint64_t at = 0;
    if (!file.has(0, 20) || !nextOfLevel4(file, at)) return false;
    const std::string_view name = file.part(20, at - 20).terminatedText();
    return !name.empty() && (std::isalpha(static_cast<unsigned char>(name[0])) != 0);
}

}  // namespace analogon::mat
