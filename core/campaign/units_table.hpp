#pragma once

#include <string>
#include <vector>

#include "core/base/outcome.hpp"

namespace analogon {

struct UnitsRow {
    int line{};                      // from 1
    std::vector<std::string> cells;  // as many as the header has
    std::vector<int> positions;      // 1-based byte in the line, of each cell
};

/// A table of words: a row for each unit under one row of names.
struct UnitsTable {
    std::string file;
    char separator{','};
    std::vector<std::string> header;  // as written, with units
    std::vector<UnitsRow> rows;

    /// Columns of this header or, without its unit, of this name.
    std::vector<std::size_t> find(const std::string& name) const;
};

/// Separated by the mark that the header has most of: a comma, a semicolon or a tab. Empty lines are passed over.
/// Faults: rows of another length than the header, a quote that is not closed, bytes that are no UTF-8.
Outcome<UnitsTable> parseUnitsTable(const std::string& text, const std::string& file);

}  // namespace analogon
