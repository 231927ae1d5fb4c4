#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/measure/read_options.hpp"

namespace analogon {

/// Where a cell that is not a finite number stands, for the message when the column is used after all.
struct BlankCell {
    std::uint32_t row{};  // index into Column::values
    int position{};       // 1-based byte in the line
};

/// One column of a measurement file, in its own unit.
struct Column {
    std::string name;               // without the unit
    std::string unit;               // as written; empty: none given
    std::vector<double> values;     // NaN: an empty cell
    std::vector<BlankCell> blanks;  // NaN and infinite cells, by row
    std::string header{};           // as written, with the unit
    int line{}, position{};         // where the header stands (1-based); 0: nowhere
};

/// A measurement file as it is.
struct Table {
    std::string file;
    std::vector<Column> columns;
    std::vector<int> lines;  // file line of each row (1-based)

    /// By name, or by the header as written.
    const Column* find(std::string_view name) const;
    std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
    std::vector<std::string> names() const;
    /// Rows first … last-1 alone.
    Table slice(std::size_t first, std::size_t last) const;
};

/// How a text is written; everything not told is found out from the file.
using CsvOptions = ReadOptions;

/// Reads a table that is written as text, by its structure: lines in front of it, up to four rows of header, units in
/// brackets (`T [degC]`, `T (degC)`, `T in degC`), in a row or in the cells, any usual separator, decimal mark,
/// encoding and way to write the time. What can be read in two ways that differ, faulty cells and ragged rows are
/// faults with row and column. Empty cells and NaN are read as NaN (a channel that is mapped decides whether that is a
/// fault); columns of words are left aside; several rasters are put on the stamps of all.
Outcome<Table> readCsv(const std::filesystem::path& file, const CsvOptions& options = {});
Outcome<Table> readCsvText(std::string_view text, const std::string& name, const CsvOptions& options = {});

/// A text of any ending; a tab parts the columns of .tsv and .tab.
Outcome<Table> readTable(const std::filesystem::path& file);

/// Comma-separated text of a table, headers as `name [unit]`; reads back as the same values.
std::string writeCsv(const Table& table);

/// A text as a CSV cell: quoted where needed; one that a spreadsheet would run as a formula (= + - @ and the like in
/// front) is led by an apostrophe.
std::string csvCell(std::string_view text);

}  // namespace analogon
