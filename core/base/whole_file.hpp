#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/outcome.hpp"

namespace analogon {

/// Of the owned directories in which files are written before they take their places.
inline constexpr const char* writingPrefix = ".analogon-writing-";

/// A file that is written whole: whenever the program is ended, the path has the old file or the new one. `write`
/// fills a file in a directory of our own beside it, which then takes its place. A link is followed to the file it
/// names. Refused: a directory, a pipe, a device; such a path keeps what it is.
Outcome<Done> writeWhole(const std::filesystem::path& file,
                         const std::function<Outcome<Done>(const std::filesystem::path& beside)>& write);
Outcome<Done> writeWhole(const std::filesystem::path& file, const std::string& content);

}  // namespace analogon
