#pragma once

#include "core/measure/recording.hpp"
#include "core/measure/xlsx/workbook.hpp"

namespace analogon::xlsx {

struct SheetColumn {
    std::string name, unit;
    bool isText{};
    bool isDate{};
    std::vector<double> numbers;                    // NaN: a gap; of a date days since 1899-12-30
    std::vector<std::optional<std::string>> texts;  // of text
};

/// Columns of one length.
struct SheetTable {
    std::vector<SheetColumn> columns;
    std::optional<std::size_t> time;
};

/// What a sheet says: a header, a row of units, data; each column belongs to the column of time on its left. Empty
/// where it has no numbers.
std::vector<SheetTable> readTables(const Sheet& sheet, std::vector<Text>& notes);

}  // namespace analogon::xlsx
