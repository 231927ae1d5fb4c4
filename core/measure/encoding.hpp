#pragma once

#include <string>
#include <string_view>

namespace analogon {

/// UTF-8 of a text file's bytes: byte-order marks (UTF-8, UTF-16) are taken off and UTF-16 is converted. Anything
/// else stays as it is; see latin1ToUtf8 for single lines.
std::string decodeText(std::string_view bytes);

bool isUtf8(std::string_view text);

/// Every byte is a character of ISO 8859-1 (older measuring programs write the degree sign so).
std::string latin1ToUtf8(std::string_view text);

}  // namespace analogon
