#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// How one CSV file is written: its separator, its cells, its numbers.
namespace analogon {

struct CsvCell {
    std::string text;  // unquoted, without surrounding blanks
    int position{};    // 1-based byte in the line where the cell starts
    bool isQuoted{};
};

struct CsvRow {
    std::vector<CsvCell> cells;
    int openQuote{};  // position of a quote that is not closed; 0: none
};

CsvRow splitCsvRow(std::string_view line, char separator);

/// The separator under which the lines have the same number of cells; tab, ; and | are tried before the comma,
/// which may be a decimal mark. A blank when only blanks separate numbers.
char detectSeparator(const std::vector<std::string_view>& lines);

struct CellValue {
    enum class Kind { Number, Infinite, Missing, Text };
    Kind kind{Kind::Text};
    double value{};
};

/// A cell as a number with this decimal mark. Empty cells and the usual spellings of "not a number" are Missing.
CellValue readCell(std::string_view text, char decimal);

/// Neither decimal mark is meant: the cell is numeric under either.
bool isNumeric(std::string_view text);

}  // namespace analogon
