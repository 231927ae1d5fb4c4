#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/measure/question.hpp"
#include "core/measure/read_options.hpp"
#include "core/measure/recording.hpp"
#include "core/measure/text/row_reader.hpp"

/// A text file from its bytes to groups of channels: encoding, lines, dialect, layout, rows, time.
namespace analogon {

/// Columns over one time.
struct TextGroup {
    std::string name;  // empty: the file gives none
    Table table;       // columns of words have no values
    std::vector<CellKind> kinds;
    std::vector<WordSeries> words;
    std::vector<std::vector<StatusText>> statuses;
    std::vector<std::string> comments;
    std::optional<std::size_t> time;
};

struct TextFile {
    std::string format;  // "text", "Modelica table"
    std::string start;   // ISO 8601; empty: the file does not tell
    Text found;          // how it was read, in one line
    std::vector<TextGroup> groups;
};

/// What is doubtful comes along as warnings, what was found out as notes. What can be answered by "read" is asked, too:
/// where it is a fault, and where the file is read nevertheless.
Outcome<TextFile> readTextFile(std::string_view bytes, const std::string& name, const ReadOptions& options,
                               const Progress& progress, Questions& asked);
Outcome<TextFile> readTextFile(std::string_view bytes, const std::string& name, const ReadOptions& options,
                               const Progress& progress = {});
/// Of a file, which need not fit into memory beside its values.
Outcome<TextFile> readTextFile(const std::filesystem::path& file, const ReadOptions& options, const Progress& progress,
                               Questions& asked);

}  // namespace analogon
