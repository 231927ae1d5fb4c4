#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.hpp"
#include "core/measure/read_options.hpp"
#include "core/measure/table.hpp"
#include "core/measure/text/layout.hpp"
#include "core/measure/text/stamp_series.hpp"
#include "core/measure/text/word_series.hpp"

namespace analogon {

/// The rows of a text as they stand. A column of stamps or words has no values in the table.
struct RawTable {
    Table table;
    std::vector<CellKind> kinds;      // by column
    std::vector<StampSeries> stamps;  // without date and clock: an empty cell
    std::vector<WordSeries> words;
    std::vector<std::vector<int>> beyond;  // lines in which the instrument was out of its range
    std::vector<std::string> firstStamps;  // the first one of each column, as it stands
    char thousands{};                      // a mark between thousands that came up among the rows

    void erase(std::size_t column);
    /// The last row first; of a table without stamps.
    void reverseRows();
    /// Of numbers.
    void insertFront(Column column);
};

/// Faulty cells and rows of another length are faults with line and column. Empty cells and NaN are read as NaN (a
/// channel that is mapped decides whether that is a fault). Rows that are read are let go of.
Outcome<RawTable> readRows(TextView text, const std::string& name, const Layout& layout, const ReadOptions& options,
                           const Progress& progress, Questions& asked);

}  // namespace analogon
