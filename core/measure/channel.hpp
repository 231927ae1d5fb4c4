#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/measure/table.hpp"

namespace analogon {

/// How an input runs between its samples: on straight lines, or held at each until the next. Automatic: as its file
/// says (a status, an integer that is one), and on lines where it says nothing.
enum class Interpolation { Automatic, Linear, Hold };

/// How a model quantity is taken from a column: value = scale * convert(cell) + offset.
struct ChannelMapping {
    std::string column;
    std::string unit;  // overrides the file's unit; empty: the file's
    double scale{1};
    double offset{0};
    double weight{1};  // of an output in the fit
    double clock{0};   // [s] by which the channel's own logger is ahead of the others
    bool fitsClock{};  // that is to be found by the fit (of an output)
    Interpolation interpolation{Interpolation::Automatic};  // of an input
    GroupName group{};                                      // of the file, where the name alone does not tell

    ChannelName channel() const { return {column, group}; }

    friend bool operator==(const ChannelMapping&, const ChannelMapping&) = default;
};

/// What a cell without a number means: a fault (an input drives the model at every moment), or that an output was not
/// measured there (NaN, and a warning that counts them).
enum class EmptyCells { Fault, NotMeasured };

/// A column in the unit of the model. `unit` empty: taken as it is.
/// Faults name file, column and line: unknown column (with a suggestion), unknown or inconvertible unit, infinite
/// cells, cells without a number where these are faults, and a column that has none at all.
Outcome<std::vector<double>> readChannel(const Table& table, const ChannelMapping& mapping, const std::string& unit,
                                         EmptyCells empty = EmptyCells::Fault);

/// The time column in seconds. Faults: falling or repeated time stamps, with line. A gap (a step over 20 times
/// the median step) is a warning with its line.
Outcome<std::vector<double>> readTime(const Table& table, const std::string& column);

}  // namespace analogon
