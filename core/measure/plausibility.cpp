#include "core/measure/plausibility.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/file_fault.hpp"
#include "core/base/limits.hpp"
#include "core/base/unit.hpp"
#include "core/base/visible.hpp"

namespace analogon {

namespace {

int lineOf(const Table& table, std::size_t row) { return row < table.lines.size() ? table.lines[row] : 0; }

std::string nameOf(const Column& column) { return shortened(column.name, limits::quotedBytes); }

/// "in 3 rows, first in lines 4, 5 and 9"
Text rowsOf(const Table& table, const std::vector<std::size_t>& rows) {
    constexpr std::size_t shown = 3;
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < std::min(shown, rows.size()); ++i)
        lines.push_back(std::to_string(lineOf(table, rows[i])));
    const Text first = listed(lines);
    return rows.size() == 1       ? phrase("in line {}", first)
           : rows.size() <= shown ? phrase("in lines {}", first)
                                  : phrase("in {} rows, first in lines {}", rows.size(), first);
}

Diagnostic remark(const Table& table, std::size_t row, Text message, Text hint) {
    return asWarning(fileError(std::move(message), table.file, lineOf(table, row), 0, std::move(hint)));
}

void belowZero(const Table& table, const Column& column, Diagnostics& told) {
    if (column.unit.empty()) return;
    const Outcome<UnitConversion> kelvin = convertUnit(column.unit, "K");
    if (!kelvin || !std::isfinite(kelvin->factor)) return;
    constexpr double rounding = 1e-6;
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < column.values.size(); ++i)
        if ((*kelvin)(column.values[i]) < -rounding) rows.push_back(i);
    if (rows.empty()) return;
    told.push_back(remark(table, rows.front(),
                          phrase("column '{}' is below absolute zero {}: {:.6g} {}", nameOf(column),
                                 rowsOf(table, rows), column.values[rows.front()], column.unit),
                          phrase("Is the unit right, or does the value stand for a sensor that failed? It is used as "
                                 "it stands.")));
}

/// A full turn in the unit of the column; 0: it holds no angle.
double turnIn(const Column& column) {
    for (const auto& [unit, turn] : {std::pair{"deg", 360.0}, {"°", 360.0}, {"degree", 360.0}, {"rad", 2 * M_PI}})
        if (column.unit == unit) return turn;
    return 0;
}

void wrapped(const Table& table, const Column& column, Diagnostics& told) {
    const double turn = turnIn(column);
    if (!(turn > 0)) return;
    std::vector<std::size_t> rows;
    double largest = 0, low = INFINITY, high = -INFINITY;  // of the other steps; of the values
    for (std::size_t i = 0; i < column.values.size(); ++i) {
        const double value = column.values[i];
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
        const double step = i > 0 ? std::abs(value - column.values[i - 1]) : 0;
        if (step > 0.75 * turn)
            rows.push_back(i);
        else if (step > largest)
            largest = step;
    }
    if (rows.empty() || largest > 0.25 * turn || high - low > 1.02 * turn) return;
    told.push_back(
        remark(table, rows.front(),
               phrase("the angle in column '{}' starts anew after each turn, {}", nameOf(column), rowsOf(table, rows)),
               phrase("The angle of a model runs on: add a turn from each of these rows on, or map the "
                      "speed instead.")));
}

/// Where a column reads exactly the same for long: [begin, end), the longest such stretch.
std::pair<std::size_t, std::size_t> longestStill(const std::vector<double>& values) {
    std::pair<std::size_t, std::size_t> longest{0, 0};
    for (std::size_t begin = 0, end = 0; begin < values.size(); begin = end) {
        for (end = begin + 1; end < values.size() && values[end] == values[begin];) ++end;
        if (end - begin > longest.second - longest.first) longest = {begin, end};
    }
    return longest;
}

/// Share of the steps within [begin, end) at which the value changes.
double moving(const std::vector<double>& values, std::size_t begin, std::size_t end) {
    std::size_t moves = 0;
    for (std::size_t i = begin + 1; i < end; ++i) moves += values[i] != values[i - 1];
    return end > begin + 1 ? static_cast<double>(moves) / static_cast<double>(end - begin - 1) : 0;
}

/// Whether a column goes on with a jump, as a reading does that has missed what went on meanwhile. A command that is
/// held between two ramps goes on as it was.
bool catchesUp(const std::vector<double>& values, std::size_t begin, std::size_t end) {
    constexpr double clearly = 5;  // times the mean step
    double sum = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
        if (i != end && std::isfinite(values[i] - values[i - 1])) sum += std::abs(values[i] - values[i - 1]);
    const double steps = static_cast<double>(values.size() - (end - begin));
    return std::abs(values[end] - values[end - 1]) > clearly * sum / std::max(1.0, steps);
}

/// A column that hardly ever reads the same twice, and then does for long while the others go on.
void stuck(const Table& table, const Column& column, const std::vector<const Column*>& used, Diagnostics& told) {
    constexpr std::size_t fewest = 20;
    constexpr double hardlyEver = 0.95, mostly = 0.8, share = 0.02;
    const std::vector<double>& values = column.values;
    const auto [begin, end] = longestStill(values);
    const std::size_t count = end - begin;
    if (begin == 0 || end >= values.size() || !catchesUp(values, begin, end)) return;
    if (count < fewest || static_cast<double>(count) < share * static_cast<double>(values.size())) return;
    const double outside = static_cast<double>(values.size() - count);
    if (outside < static_cast<double>(fewest)) return;
    const double moves = moving(values, 0, values.size()) * static_cast<double>(values.size() - 1);
    if (moves < hardlyEver * (outside - 1)) return;
    const auto goesOn = [&, b = begin, e = end](const Column* other) {
        return other != &column && moving(other->values, b, e) > mostly &&
               moving(other->values, 0, values.size()) > mostly;
    };
    const auto other = std::find_if(used.begin(), used.end(), goesOn);
    if (other == used.end()) return;
    told.push_back(
        remark(table, begin,
               phrase("column '{}' stands at {:.6g} from line {} to line {} while '{}' moves, and hardly "
                      "ever reads the same twice elsewhere",
                      nameOf(column), values[begin], lineOf(table, begin), lineOf(table, end - 1), nameOf(**other)),
               phrase("Did the sensor or the logger stick? It is used as it stands; leave the part out with "
                      "\"range\", or empty the cells of an output.")));
}

/// Single values that are farther from the rest than this many times all that the rest spans.
void spikes(const Table& table, const Column& column, Diagnostics& told) {
    constexpr double beyond = 1e3;
    constexpr std::size_t fewest = 10, mostSpikes = 5;
    std::vector<double> sorted;
    for (const double value : column.values)
        if (std::isfinite(value)) sorted.push_back(value);
    if (sorted.size() < fewest) return;
    const auto at = [&](double share) {
        const auto place = sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
        std::nth_element(sorted.begin(), place, sorted.end());
        return *place;
    };
    const double low = at(0.05), middle = at(0.5), high = at(0.95);
    const double span = std::max(high - low, 1e-3 * std::abs(middle));
    if (!(span > 0)) return;
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < column.values.size(); ++i)
        if (std::abs(column.values[i] - middle) > beyond * span) rows.push_back(i);
    if (rows.empty() || rows.size() > mostSpikes) return;  // many are no spikes
    told.push_back(remark(table, rows.front(),
                          phrase("column '{}' holds {:.4g} {}, far beyond the {:.4g} … {:.4g} of nearly all its rows",
                                 nameOf(column), column.values[rows.front()], rowsOf(table, rows), low, high),
                          phrase("A value like this outweighs all others in a fit: empty the cell of an output, or "
                                 "correct it.")));
}

}  // namespace

Diagnostics implausibilities(const Table& table, const std::vector<const Column*>& used) {
    Diagnostics told;
    for (const Column* column : used) {
        belowZero(table, *column, told);
        wrapped(table, *column, told);
        stuck(table, *column, used, told);
        spikes(table, *column, told);
    }
    return told;
}

}  // namespace analogon
