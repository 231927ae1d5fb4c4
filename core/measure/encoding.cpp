#include "core/measure/encoding.hpp"

#include <array>
#include <cstdint>
#include <utility>

#include "core/measure/csv_dialect.hpp"

namespace analogon {

namespace {

void appendUtf8(std::string& out, std::uint32_t codePoint) {
    const auto byte = [&](std::uint32_t value) { out.push_back(static_cast<char>(value)); };
    if (codePoint < 0x80) {
        byte(codePoint);
    } else if (codePoint < 0x800) {
        byte(0xC0 | (codePoint >> 6));
        byte(0x80 | (codePoint & 0x3F));
    } else if (codePoint < 0x10000) {
        byte(0xE0 | (codePoint >> 12));
        byte(0x80 | ((codePoint >> 6) & 0x3F));
        byte(0x80 | (codePoint & 0x3F));
    } else {
        byte(0xF0 | (codePoint >> 18));
        byte(0x80 | ((codePoint >> 12) & 0x3F));
        byte(0x80 | ((codePoint >> 6) & 0x3F));
        byte(0x80 | (codePoint & 0x3F));
    }
}

std::string utf16ToUtf8(std::string_view bytes, bool bigEndian) {
    constexpr std::uint32_t replacement = 0xFFFD;
    const auto unit = [&](std::size_t i) {
        const auto first = static_cast<unsigned char>(bytes[i]);
        const auto second = static_cast<unsigned char>(bytes[i + 1]);
        return bigEndian ? (std::uint32_t{first} << 8) | second : (std::uint32_t{second} << 8) | first;
    };
    std::string out;
    out.reserve(bytes.size() / 2);
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        std::uint32_t code = unit(i);
        if (code >= 0xD800 && code < 0xDC00) {
            const bool paired = i + 3 < bytes.size() && unit(i + 2) >= 0xDC00 && unit(i + 2) < 0xE000;
            if (paired) {
                code = 0x10000 + ((code - 0xD800) << 10) + (unit(i + 2) - 0xDC00);
                i += 2;
            } else {
                code = replacement;
            }
        } else if (code >= 0xDC00 && code < 0xE000) {
            code = replacement;
        }
        appendUtf8(out, code);
    }
    return out;
}

std::string utf32ToUtf8(std::string_view bytes, bool bigEndian) {
    constexpr std::uint32_t replacement = 0xFFFD;
    std::string out;
    out.reserve(bytes.size() / 4);
    for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) {
        std::uint32_t code = 0;
        for (std::size_t k = 0; k < 4; ++k)
            code = code << 8 | static_cast<unsigned char>(bytes[bigEndian ? i + k : i + 3 - k]);
        const bool isLetter = code < 0x110000 && (code < 0xD800 || code >= 0xE000);
        appendUtf8(out, isLetter ? code : replacement);
    }
    return out;
}

constexpr std::array<std::pair<Encoding, std::string_view>, 4> wideMarks{
    {{Encoding::Utf32LittleEndian, {"\xFF\xFE\0\0", 4}},  // before that of UTF-16, which is its front
     {Encoding::Utf32BigEndian, {"\0\0\xFE\xFF", 4}},
     {Encoding::Utf16LittleEndian, {"\xFF\xFE", 2}},
     {Encoding::Utf16BigEndian, {"\xFE\xFF", 2}}}};

/// Of the bytes 0x80 to 0x9F of Windows-1252.
constexpr std::array<std::uint16_t, 32> windowsLetters{0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                                       0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0x8D,   0x017D, 0x8F,
                                                       0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                                       0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};

}  // namespace

/// By its mark; without one by its zeros: every other byte of plain letters is one, or three of four are.
Encoding encodingOf(std::string_view bytes) {
    for (const auto& [encoding, mark] : wideMarks)
        if (bytes.starts_with(mark)) return encoding;
    const std::string_view head = bytes.substr(0, 256);
    if (head.size() < 8) return Encoding::AsIs;
    std::array<std::size_t, 4> zeros{};
    for (std::size_t i = 0; i < head.size(); ++i) zeros[i % 4] += head[i] == '\0';
    const std::size_t all = head.size() / 4, many = all * 4 / 5;
    if (zeros[0] == 0 && zeros[2] >= many && zeros[3] >= all) return Encoding::Utf32LittleEndian;
    if (zeros[3] == 0 && zeros[1] >= many && zeros[0] >= all) return Encoding::Utf32BigEndian;
    const auto [front, back] = std::pair{zeros[0] + zeros[2], zeros[1] + zeros[3]};
    if (front == 0 && back >= 2 * many) return Encoding::Utf16LittleEndian;
    return back == 0 && front >= 2 * many ? Encoding::Utf16BigEndian : Encoding::AsIs;
}

bool isWideText(std::string_view bytes) { return encodingOf(bytes) != Encoding::AsIs; }

std::size_t unitBytes(Encoding encoding) {
    if (encoding == Encoding::Utf32LittleEndian || encoding == Encoding::Utf32BigEndian) return 4;
    return encoding == Encoding::Utf16LittleEndian || encoding == Encoding::Utf16BigEndian ? 2 : 1;
}

std::optional<Encoding> encodingNamed(std::string_view encoding) {
    std::string name;
    for (const char c : inLowerCase(encoding))
        if (c != '-' && c != '_' && c != ' ') name.push_back(c);
    if (name == "utf16le") return Encoding::Utf16LittleEndian;
    if (name == "utf16be") return Encoding::Utf16BigEndian;
    if (name == "utf32le") return Encoding::Utf32LittleEndian;
    if (name == "utf32be") return Encoding::Utf32BigEndian;
    if (name == "utf16" || name == "utf32") return Encoding::Found;
    if (name == "utf8") return Encoding::AsIs;
    if (name == "windows1252" || name == "cp1252" || name == "latin1" || name == "iso88591" || name == "ascii")
        return Encoding::Windows1252;
    return std::nullopt;
}

std::size_t markLength(std::string_view head, Encoding encoding) {
    const auto lengthOf = [&](std::string_view mark) { return head.starts_with(mark) ? mark.size() : 0; };
    if (encoding == Encoding::AsIs) return lengthOf("\xEF\xBB\xBF");
    for (const auto& [wide, mark] : wideMarks)
        if (encoding == wide) return lengthOf(mark);
    return 0;
}

std::string decodeText(std::string_view part, Encoding encoding) {
    if (encoding == Encoding::Found) encoding = encodingOf(part);
    if (encoding == Encoding::AsIs) return std::string(part);
    if (encoding == Encoding::Windows1252) return latin1ToUtf8(part);
    if (unitBytes(encoding) == 4) return utf32ToUtf8(part, encoding == Encoding::Utf32BigEndian);
    return utf16ToUtf8(part, encoding == Encoding::Utf16BigEndian);
}

std::optional<std::string> decodeText(std::string_view bytes, std::string_view name) {
    std::optional<Encoding> encoding = encodingNamed(name);
    if (encoding == Encoding::Found) encoding = encodingOf(bytes);
    if (!encoding) return std::nullopt;
    return decodeText(bytes.substr(markLength(bytes, *encoding)), *encoding);
}

std::string decodeText(std::string_view bytes) {
    const Encoding encoding = encodingOf(bytes);
    return decodeText(bytes.substr(markLength(bytes, encoding)), encoding);
}

bool isUtf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        std::size_t tail = 0;
        if (lead >= 0xC2 && lead < 0xE0) {
            tail = 1;
        } else if (lead >= 0xE0 && lead < 0xF0) {
            tail = 2;
        } else if (lead >= 0xF0 && lead < 0xF5) {
            tail = 3;
        } else if (lead >= 0x80) {
            return false;
        }
        if (i + tail >= text.size()) return false;
        for (std::size_t k = 1; k <= tail; ++k)
            if ((static_cast<unsigned char>(text[i + k]) & 0xC0) != 0x80) return false;
        i += tail + 1;
    }
    return true;
}

std::string latin1ToUtf8(std::string_view text) {
    std::string out;
    out.reserve(text.size() + 4);
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        appendUtf8(out, byte >= 0x80 && byte < 0xA0 ? windowsLetters[byte - 0x80] : byte);
    }
    return out;
}

std::string inUtf8(std::string_view text) { return isUtf8(text) ? std::string(text) : latin1ToUtf8(text); }

}  // namespace analogon
