#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/outcome.hpp"

/// An XLSX workbook as cells, before anything is made of them.
namespace analogon::xlsx {

struct Cell {
    /// Uncalculated: a formula whose result the file does not hold.
    enum class Kind : std::uint8_t { Number, Date, Percent, Text, Error, Uncalculated };
    std::uint32_t column{};  // from 0
    Kind kind{Kind::Number};
    double number{};  // Date: days since 1899-12-30
    std::string text{};
};

struct Row {
    std::uint32_t number{};   // as the program shows it, from 1
    std::vector<Cell> cells;  // not empty ones, by column
};

struct Sheet {
    std::string name;
    std::vector<Row> rows;  // not empty ones, from the top
    bool isCut{};           // it has more cells than are read
};

Outcome<std::vector<Sheet>> readWorkbook(const std::string& file);

/// "AB"
std::string columnLetters(std::uint32_t column);

}  // namespace analogon::xlsx
