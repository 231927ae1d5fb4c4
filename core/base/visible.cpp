#include "core/base/visible.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

namespace analogon {

namespace {

/// Length of the UTF-8 sequence at `at` and its code point; length 0: none (also overlong ones and halves of pairs).
std::pair<std::size_t, std::uint32_t> codePoint(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) -> std::uint32_t { return static_cast<unsigned char>(text[i]); };
    const std::uint32_t first = byte(at);
    const std::size_t length = first < 0x80         ? 1
                               : (first >> 5) == 6  ? 2
                               : (first >> 4) == 14 ? 3
                               : (first >> 3) == 30 ? 4
                                                    : 0;
    if (length == 0 || at + length > text.size()) return {0, 0};
    std::uint32_t code = length == 1 ? first : first & (0xffu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(at + i) >> 6) != 2) return {0, 0};
        code = code << 6 | (byte(at + i) & 0x3f);
    }
    constexpr std::uint32_t least[]{0, 0, 0x80, 0x800, 0x10000};
    if (code < least[length] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return {0, 0};
    return {length, code};
}

bool isInvisible(std::uint32_t c) {
    static constexpr std::pair<std::uint32_t, std::uint32_t> ranges[]{
        {0x00, 0x1f},     {0x7f, 0x9f},     {0xad, 0xad},     {0x34f, 0x34f},    {0x61c, 0x61c},
        {0x115f, 0x1160}, {0x180b, 0x180e}, {0x200b, 0x200f}, {0x2028, 0x202e},  {0x2060, 0x206f},
        {0x3164, 0x3164}, {0xfeff, 0xfeff}, {0xfff9, 0xfffb}, {0xe0000, 0xe007f}};
    if (c < 0x7f) return c < 0x20;
    return std::any_of(std::begin(ranges), std::end(ranges),
                       [&](const auto& range) { return c >= range.first && c <= range.second; });
}

/// Up to `longest` bytes of what is shown; whether line ends and tabs stay is told by `keepsLines`.
std::string escaped(std::string_view text, bool keepsLines, std::size_t longest) {
    std::string shown;
    shown.reserve(std::min(text.size(), longest));
    for (std::size_t at = 0; at < text.size();) {
        if (shown.size() >= longest) return shown + "…";
        const auto [length, code] = codePoint(text, at);
        const bool stays = keepsLines && (code == '\n' || code == '\t');
        if (length == 0)
            shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[at]));
        else if (isInvisible(code) && !stays)
            shown += fmt::format("\\u{{{:x}}}", code);
        else
            shown += text.substr(at, length);
        at += std::max<std::size_t>(1, length);
    }
    return shown;
}

}  // namespace

std::string visible(std::string_view text) { return escaped(text, true, std::string::npos); }

std::string visibleName(std::string_view text, std::size_t longest) { return escaped(text, false, longest); }

std::string shortened(std::string_view text, std::size_t longest) {
    if (text.size() <= longest) return std::string(text);
    while (longest > 0 && (static_cast<unsigned char>(text[longest]) & 0xc0) == 0x80) --longest;
    return std::string(text.substr(0, longest)) + "…";
}

}  // namespace analogon
