#pragma once

#include <filesystem>

#include "core/measure/question.hpp"
#include "core/measure/read_options.hpp"
#include "core/measure/recording.hpp"
#include "core/measure/table.hpp"

namespace analogon {

/// A text file as a recording.
Outcome<MeasurementFile> openText(const std::filesystem::path& file, const ReadOptions& options = {});
Outcome<MeasurementFile> openTextOf(std::string_view bytes, const std::string& name, const ReadOptions& options = {});

/// Reads a table that is written as text, by its structure: lines in front of it, up to four rows of header, units in
/// brackets (`T [degC]`, `T (degC)`, `T in degC`), in a row or in the cells, any usual separator, decimal mark,
/// encoding and way to write the time. What can be read in two ways that differ, faulty cells and ragged rows are
/// faults with row and column. Empty cells and NaN are read as NaN (a channel that is mapped decides whether that is a
/// fault); columns of words are left aside; of several groups each is a table over its own raster.
Outcome<Table> textTables(std::string_view bytes, const std::string& name, const ReadOptions& options = {},
                          const Progress& progress = {});
Outcome<Table> readTextTables(const std::filesystem::path& file, const ReadOptions& options,
                              const Progress& progress = {});

/// A text that is looked at before it is taken in.
struct LookedAtText {
    Outcome<std::shared_ptr<const Table>> table;
    std::shared_ptr<const MeasurementFile> recording{};  // what it holds, with the table's values; null: it is faulty
    Questions asked{};
};
LookedAtText lookAtText(std::string_view bytes, const std::string& name, const ReadOptions& options = {},
                        const Progress& progress = {});
LookedAtText lookAtText(const std::filesystem::path& file, const ReadOptions& options, const Progress& progress);

}  // namespace analogon
