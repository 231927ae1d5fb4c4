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

struct CellValue {
    /// Beyond: the instrument says that the quantity was out of its range.
    enum class Kind { Number, Infinite, Missing, Beyond, Text };
    Kind kind{Kind::Text};
    double value{};
};

/// A cell as a number with this decimal mark, and with this mark between thousands (0: none). Empty cells and the usual
/// spellings of "not a number" are Missing.
CellValue readCell(std::string_view text, char decimal, char thousands = 0);

/// Neither decimal mark is meant: the cell is numeric under either.
bool isNumeric(std::string_view text);

/// Without blanks around it, those that break no line included.
std::string_view withoutBlanks(std::string_view text);

/// A to Z in small letters.
std::string inLowerCase(std::string_view text);

/// How the digits of a number are parted. Open: one mark with three digits behind it, which may stand for decimals or
/// between thousands ("1.234").
struct NumberShape {
    enum class Mark { None, Point, Comma, OpenPoint, OpenComma };
    bool isNumber{};
    Mark decimal{Mark::None};
    char thousands{};      // the mark that stands between thousands; 0: none
    bool isLongWithout{};  // four digits or more in front of the decimals and no mark between them
};
NumberShape shapeOf(std::string_view text);

}  // namespace analogon
