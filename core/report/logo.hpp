#pragma once

#include <filesystem>
#include <string>

#include "core/base/outcome.hpp"

namespace analogon {

inline constexpr std::size_t largestLogo = 512 * 1024;  // [byte], since each report carries it

/// A PNG, JPEG or SVG file, told by its content, as the data URI that a page embeds. A fault names the file as `shown`.
Outcome<std::string> logoUri(const std::filesystem::path& file, const std::string& shown);

}  // namespace analogon
