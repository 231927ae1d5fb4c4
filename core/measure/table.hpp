#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/outcome.hpp"

namespace analogon {

/// One column of a measurement file, in its own unit.
struct Column {
    std::string name;  // without the unit
    std::string unit;  // as written; empty: none given
    std::vector<double> values;  // NaN: an empty cell
};

/// A measurement file as it is.
struct Table {
    std::string file;
    std::vector<Column> columns;
    std::vector<int> lines;  // file line of each row (1-based)

    const Column* find(std::string_view name) const;
    std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
};

/// How a CSV file is written; everything not given is found out from the file.
struct CsvOptions {
    std::optional<char> separator;  // , ; tab space |
    std::optional<char> decimal;    // . or ,
    std::optional<bool> hasUnitsRow;
};

/// Reads comma-separated values: header with units in brackets (`T [degC]`, `T (degC)`, `T in degC`) or a units
/// row, separators , ; tab, decimal comma, # comments, byte-order mark, quoted cells, CR, LF or CRLF. Non-numeric
/// cells and ragged rows are faults with row and column. Empty cells and NaN are read as NaN (a channel that is
/// mapped decides whether that is a fault).
Outcome<Table> readCsv(const std::filesystem::path& file, const CsvOptions& options = {});
Outcome<Table> readCsvText(std::string_view text, const std::string& name, const CsvOptions& options = {});

/// By file ending (csv, txt, tsv, dat).
Outcome<Table> readTable(const std::filesystem::path& file);

}  // namespace analogon
