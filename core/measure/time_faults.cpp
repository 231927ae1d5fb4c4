#include "core/measure/time_faults.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/median.hpp"
#include "core/measure/cited.hpp"

namespace analogon {

namespace {

constexpr std::size_t shownRows = 3;

int lineOf(const Table& table, std::size_t row) { return row < table.lines.size() ? table.lines[row] : 0; }

/// "300 after 300 (line 6), 1.2 after 1.2 (line 9)"
Text shown(const Table& table, const Column& column, const std::vector<std::size_t>& rows) {
    Text text;
    for (std::size_t i = 0; i < std::min(shownRows, rows.size()); ++i) {
        if (i > 0) text += ", ";
        text +=
            phrase("{} after {} (line {})", column.values[rows[i]], column.values[rows[i] - 1], lineOf(table, rows[i]));
    }
    return rows.size() > shownRows ? text + ", …" : text;
}

/// The usual step of the stamps that rise; 0: none does.
double usualStep(const std::vector<double>& time) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < time.size(); ++i)
        if (time[i] > time[i - 1]) steps.push_back(time[i] - time[i - 1]);
    return steps.empty() ? 0 : median(std::move(steps));
}

bool isSameRow(const Table& table, std::size_t a, std::size_t b) {
    return std::all_of(table.columns.begin(), table.columns.end(), [&](const Column& c) {
        return c.values[a] == c.values[b] || (std::isnan(c.values[a]) && std::isnan(c.values[b]));
    });
}

/// Another column that counts the rows, by the same step from each to the next; null: there is none.
const Column* counterBeside(const Table& table, const Column& time) {
    for (const Column& c : table.columns) {
        if (&c == &time || c.values.size() < 3 || !c.blanks.empty()) continue;
        const double step = c.values[1] - c.values[0];
        bool counts = step > 0 && step == std::round(step);
        for (std::size_t i = 1; counts && i < c.values.size(); ++i) counts = c.values[i] - c.values[i - 1] == step;
        if (counts) return &c;
    }
    return nullptr;
}

Text meaningOfRepeats(const Table& table, const Column& column, const std::vector<double>& seconds,
                      const std::vector<std::size_t>& rows) {
    const auto isCopy = [&](std::size_t row) { return isSameRow(table, row, row - 1); };
    if (std::all_of(rows.begin(), rows.end(), isCopy))
        return phrase("These rows are copies of those before them: the logger wrote them twice; keep one of each.");
    Text meaning;
    if (const Column* counter = counterBeside(table, column))
        meaning = phrase("'{}' counts on there, so no row was written twice; it counts rows and is no time. ",
                         cited(counter->name));
    meaning += phrase(
        "If a quantity jumps there (two rows for one moment), write the second a little later, by {:.2g} s. If "
        "the time has too few digits, export it with more; stamps of equal steps can be written anew. If a "
        "row was written twice, keep the right one.",
        1e-3 * usualStep(seconds));
    return meaning;
}

Text meaningOfReturns(const Table& table, const std::vector<double>& seconds, const std::vector<std::size_t>& rows) {
    const std::size_t first = rows.front();
    const double back = seconds[first - 1] - seconds[first];
    if (back < 3 * usualStep(seconds))
        return phrase(
            "By less than three samples: stamps of two loggers may be mixed, or written late. Correct the "
            "stamps of these rows; sorting them would mix what was measured at different moments.");
    return phrase(
        "The recording may have been started anew there: split the file before line {}, or use its first "
        "part alone (\"range\": [{:.6g}, {:.6g}]). If the clock was set back, add {:.4g} s from there on. "
        "Sorting the rows would mix two recordings.",
        lineOf(table, first), seconds.front(), seconds[first - 1], back + usualStep(seconds));
}

}  // namespace

std::optional<Diagnostic> timeFault(const Table& table, const Column& column, const std::vector<double>& seconds) {
    std::vector<std::size_t> repeats, returns;
    for (std::size_t i = 1; i < seconds.size(); ++i) {
        if (seconds[i] == seconds[i - 1]) repeats.push_back(i);
        if (seconds[i] < seconds[i - 1]) returns.push_back(i);
    }
    if (repeats.empty() && returns.empty()) return std::nullopt;
    const std::string name = cited(column.name);
    Text message, hint;
    if (!repeats.empty()) {
        message = phrase("the time in column '{}' repeats in {} of {} rows: {}", name, repeats.size(), seconds.size(),
                         shown(table, column, repeats));
        hint = meaningOfRepeats(table, column, seconds, repeats);
    }
    if (!returns.empty()) {
        if (!message.empty()) {
            message += "; ";
            hint += " ";
        }
        message += phrase("the time in column '{}' goes back in {} of {} rows: {}", name, returns.size(),
                          seconds.size(), shown(table, column, returns));
        hint += meaningOfReturns(table, seconds, returns);
    }
    const std::size_t first = std::min(repeats.empty() ? returns.front() : repeats.front(),
                                       returns.empty() ? repeats.front() : returns.front());
    return fileError(std::move(message), table.file, lineOf(table, first), 0, std::move(hint));
}

}  // namespace analogon
