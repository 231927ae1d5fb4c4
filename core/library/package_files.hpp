#pragma once

#include <filesystem>
#include <vector>

namespace analogon {

/// The files that are read of a package directory or of a single .mo file, with their whole paths: what a copy of it
/// must hold. Where nothing can be read, none.
std::vector<std::filesystem::path> packageFiles(const std::filesystem::path& path);

}  // namespace analogon
