#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace analogon {

/// UTF-8 of a text file's bytes: byte-order marks (UTF-8, UTF-16, UTF-32) are taken off and the wide ones are
/// converted, also where they have no mark. Anything else stays as it is; see latin1ToUtf8 for single lines.
std::string decodeText(std::string_view bytes);

/// Whether decodeText would change the bytes behind a mark of UTF-8.
bool isWideText(std::string_view bytes);

/// By the name of an encoding ("utf-16le", "windows-1252" …); none: it is not known here.
std::optional<std::string> decodeText(std::string_view bytes, std::string_view encoding);

enum class Encoding {
    AsIs,  // UTF-8, or nobody knows
    Utf16LittleEndian,
    Utf16BigEndian,
    Utf32LittleEndian,
    Utf32BigEndian,
    Windows1252,
    Found  // by its bytes
};
std::optional<Encoding> encodingNamed(std::string_view name);
/// By the first bytes of a file.
Encoding encodingOf(std::string_view head);
/// Bytes of one unit of a text that is written so: 4, 2 or 1.
std::size_t unitBytes(Encoding encoding);
/// Bytes of the mark in front of a text that is written so.
std::size_t markLength(std::string_view head, Encoding encoding);
/// A part of a text, without its mark.
std::string decodeText(std::string_view part, Encoding encoding);

bool isUtf8(std::string_view text);

/// Every byte is a character of Windows-1252, which is ISO 8859-1 with marks and letters in place of control characters
/// (older measuring programs write the degree sign so).
std::string latin1ToUtf8(std::string_view text);

/// As it is where it is UTF-8, else by latin1ToUtf8.
std::string inUtf8(std::string_view text);

}  // namespace analogon
