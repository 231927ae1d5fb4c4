#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "core/base/outcome.hpp"
#include "core/base/progress.hpp"
#include "core/measure/read_options.hpp"
#include "core/measure/table.hpp"
#include "core/measure/text/text_recording.hpp"

namespace analogon {

/// Values of a file that are kept at most: 256 MB.
inline constexpr std::size_t valuesKept = std::size_t{1} << 25;

/// A measurement file of any kind as tables, a group each, over rasters of their own. Channels of text are left aside.
/// Of a file with more values than that only the masters and what is `wanted` by its name is read; the other columns
/// have no values yet (Table::source has them), which a warning tells.
Outcome<Table> readTable(const std::filesystem::path& file, const ReadOptions& options = {},
                         const std::set<std::string>& wanted = {}, const Progress& progress = {},
                         std::size_t mostValues = valuesKept);

/// A file that is read as text, with what it does not tell.
Outcome<LookedAtText> lookAtTextFile(const std::filesystem::path& file, const ReadOptions& options = {},
                                     const Progress& progress = {});

}  // namespace analogon
