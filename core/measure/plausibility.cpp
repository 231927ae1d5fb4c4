#include "core/measure/plausibility.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/base/file_fault.hpp"
#include "core/base/median.hpp"
#include "core/base/range.hpp"
#include "core/base/unit.hpp"
#include "core/base/visible.hpp"
#include "core/measure/cited.hpp"

namespace analogon {

namespace {

int lineOf(const Table& table, std::size_t row) { return row < table.lines.size() ? table.lines[row] : 0; }

std::string nameOf(const Column& column) { return cited(column.name); }

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

/// Where a column reads exactly the same for long, within [from, to): [begin, end), the longest such stretch.
std::pair<std::size_t, std::size_t> longestStill(const std::vector<double>& values, std::size_t from, std::size_t to) {
    std::pair<std::size_t, std::size_t> longest{from, from};
    for (std::size_t begin = from, end = from; begin < to; begin = end) {
        for (end = begin + 1; end < to && values[end] == values[begin];) ++end;
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

/// A stretch in which a column reads exactly the same, and what the column does beside it.
struct Still {
    std::size_t begin{}, end{};
    std::size_t next{};  // rows of the longest other one
    double moves{};      // at how many of the steps beside it the value changes
    Range range;

    std::size_t count() const { return end - begin; }
};

Still stillIn(const std::vector<double>& values) {
    Still still;
    std::tie(still.begin, still.end) = longestStill(values, 0, values.size());
    for (const auto& [from, to] : {std::pair{std::size_t{0}, still.begin}, {still.end, values.size()}}) {
        const auto [begin, end] = longestStill(values, from, to);
        still.next = std::max(still.next, end - begin);
    }
    still.moves = moving(values, 0, values.size()) * static_cast<double>(values.size() - 1);
    still.range = rangeOf(values);
    return still;
}

/// Whether a column has noise beside a stretch that no two readings of a sensor agree in for long: third differences
/// (a smooth course leaves next to nothing of them) that turn from one to the next, larger than what rounding leaves,
/// and small beside the range (what drives a component at random may well rest).
bool isNoisyBeside(const std::vector<double>& values, const Still& still) {
    constexpr double ofStep = 0.6, ofRange = 0.1, mostlyTurning = 0.6;  // rounding alone: 0.29 of a step
    double step = still.range.width(), before = 0;
    std::vector<double> sizes;
    std::size_t turns = 0, pairs = 0;
    for (std::size_t i = 0; i + 3 < values.size(); ++i) {
        const double move = std::abs(values[i + 1] - values[i]);
        if (move > 1e-9 * std::max(std::abs(values[i]), std::abs(values[i + 1]))) step = std::min(step, move);
        const double third = values[i + 3] - 3 * values[i + 2] + 3 * values[i + 1] - values[i];
        const bool isBeside = std::isfinite(third) && (i + 3 < still.begin || i >= still.end);
        if (isBeside) sizes.push_back(std::abs(third));
        if (isBeside && third != 0 && before != 0) {
            ++pairs;
            turns += third * before < 0;
        }
        before = isBeside ? third : 0;
    }
    if (sizes.empty() || static_cast<double>(turns) < mostlyTurning * static_cast<double>(pairs)) return false;
    const double noise = median(std::move(sizes)) / 0.6745 / std::sqrt(20.0);
    return noise >= ofStep * step && noise <= ofRange * still.range.width();
}

/// Whether a sensor or a logger has stuck there: what always scatters does so no more, in the midst of its range (at
/// its ends it may be limited, and what rests reads 0); or what is never the same twice goes on with a jump.
bool hasStuck(const std::vector<double>& values, const Still& still) {
    constexpr double hardlyEver = 0.95, often = 0.3;
    constexpr std::size_t longer = 10;  // times than any other
    const double beside = static_cast<double>(values.size() - still.count());
    if (still.begin > 0 && still.end < values.size() && still.moves >= hardlyEver * (beside - 1) &&
        catchesUp(values, still.begin, still.end))
        return true;
    const double value = values[still.begin];
    return still.count() >= longer * still.next && still.moves >= often * beside && value != 0 &&
           value > still.range.low && value < still.range.high && isNoisyBeside(values, still);
}

/// A column that stands still for long while the others go on.
void stuck(const Table& table, const Column& column, const std::vector<const Column*>& used, Diagnostics& told) {
    constexpr std::size_t fewest = 20;
    constexpr double mostly = 0.8, share = 0.02;
    const std::vector<double>& values = column.values;
    if (values.size() < 2 * fewest) return;
    const Still still = stillIn(values);
    if (still.count() < fewest || static_cast<double>(still.count()) < share * static_cast<double>(values.size()) ||
        values.size() - still.count() < fewest || !hasStuck(values, still))
        return;
    const auto goesOn = [&](const Column* other) {
        return other != &column && moving(other->values, still.begin, still.end) > mostly &&
               moving(other->values, 0, values.size()) > mostly;
    };
    const auto other = std::find_if(used.begin(), used.end(), goesOn);
    if (other == used.end()) return;
    told.push_back(
        remark(table, still.begin,
               phrase("column '{}' stands at {:.6g} from line {} to line {} while '{}' moves; elsewhere it reads the "
                      "same in no more than {} rows on end",
                      nameOf(column), values[still.begin], lineOf(table, still.begin), lineOf(table, still.end - 1),
                      nameOf(**other), still.next),
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
