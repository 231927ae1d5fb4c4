#pragma once

#include <filesystem>

#include "core/measure/read_options.hpp"
#include "core/measure/recording.hpp"
#include "core/measure/table.hpp"

namespace analogon {

/// A text file as a recording.
Outcome<MeasurementFile> openText(const std::filesystem::path& file, const ReadOptions& options = {});
Outcome<MeasurementFile> openTextOf(std::string_view bytes, const std::string& name, const ReadOptions& options = {});

/// The same as tables, each group over its own raster.
Outcome<Table> readTextTables(const std::filesystem::path& file, const ReadOptions& options);

}  // namespace analogon
