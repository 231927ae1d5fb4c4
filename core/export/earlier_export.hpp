#pragma once

#include <filesystem>
#include <string>

#include "core/base/outcome.hpp"
#include "core/export/export.hpp"

namespace analogon {

/// Whether a file may be written there: nothing has that name, or an empty file, or what was exported in this format
/// before, as far as it tells unchanged. Told by what it holds.
Outcome<Done> checkExportPlace(ExportFormat format, const std::filesystem::path& file);

/// A Modelica text with a line before it that tells whether somebody has changed it since.
std::string sealed(const std::string& text);
bool isSealed(const std::string& text);

}  // namespace analogon
