#include "core/measure/text/time_column.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/file_fault.hpp"
#include "core/base/median.hpp"
#include "core/base/unit.hpp"
#include "core/measure/column_header.hpp"
#include "core/measure/counted_time.hpp"
#include "core/measure/text/channel_times.hpp"
#include "core/measure/text/remark.hpp"
#include "core/measure/text/time_format.hpp"
#include "core/measure/text/written_clock.hpp"
#include "core/measure/time_name.hpp"

namespace analogon {

namespace {

bool repeats(const std::vector<double>& values) {
    for (std::size_t i = 1; i < values.size(); ++i)
        if (values[i] == values[i - 1]) return true;
    return false;
}

/// The unit that a name counts ("millis"), with blanks around it; null: none.
const char* countedIn(std::string_view key) {
    constexpr std::array<std::string_view, 4> milli{" millis ", " milliseconds ", " millisekunden ", " msec "};
    constexpr std::array<std::string_view, 3> micro{" micros ", " microseconds ", " mikrosekunden "};
    if (std::find(milli.begin(), milli.end(), key) != milli.end()) return "ms";
    return std::find(micro.begin(), micro.end(), key) != micro.end() ? "us" : nullptr;
}

/// "Total Time", "Rel. Zeit": the word stands within the name; or what a clock counts is all of it.
bool holdsTime(const std::string& name) {
    const std::string key = ' ' + plainKey(name) + ' ';
    constexpr std::array<std::string_view, 3> within{" time ", " zeit ", " x value "};
    constexpr std::array<std::string_view, 9> whole{" ts ",     " date ", " datum ",   " epoch ",   " unix ",
                                                    " uptime ", " sec ",  " seconds ", " sekunden "};
    return std::any_of(within.begin(), within.end(),
                       [&](std::string_view word) { return key.find(word) != std::string::npos; }) ||
           std::find(whole.begin(), whole.end(), key) != whole.end() || countedIn(key) != nullptr;
}

bool countsByOne(const Column& column) {
    const std::vector<double>& values = column.values;
    if (values.size() < 2 || values.front() != std::floor(values.front())) return false;
    for (std::size_t i = 1; i < values.size(); ++i)
        if (values[i] != values[i - 1] + 1) return false;
    return true;
}

/// The row in which a column that is a time by its unit and its name goes back; 0: none.
std::size_t firstFall(const Column& column) {
    if (!namesTime(column.name) || !areConvertible(column.unit, "s")) return 0;
    for (std::size_t i = 1; i < column.values.size(); ++i)
        if (column.values[i] < column.values[i - 1]) return i;
    return 0;
}

/// In seconds: the unit beside it, that of the time axis, or seconds.
double seconds(const ToldNumber& told, const std::string& timeUnit) {
    for (const std::string& unit : {told.unit, timeUnit})
        if (const auto convert = convertUnit(unit, "s")) return (*convert)(told.value);
    return told.value;
}

std::optional<double> toldInterval(const PreambleFacts& facts) {
    if (facts.hasSeveralIntervals) return std::nullopt;
    if (facts.interval) return seconds(*facts.interval, facts.timeUnit);
    if (!facts.rate) return std::nullopt;
    const auto hertz = convertUnit(facts.rate->unit.empty() ? "Hz" : facts.rate->unit, "Hz");
    return hertz ? std::optional(1 / (*hertz)(facts.rate->value)) : std::nullopt;
}

void insertTime(RawTable& raw, std::vector<double> values) {
    std::string name = "time";
    while (raw.table.find(name)) name += '_';
    raw.insertFront(Column{name, "s", std::move(values), {}});
}

}  // namespace

bool rises(const std::vector<double>& values) {
    double first = NAN, last = -INFINITY;
    for (const double value : values) {
        if (std::isnan(value)) continue;
        if (value < last) return false;
        if (std::isnan(first)) first = value;
        last = value;
    }
    return last > first;
}

std::optional<std::size_t> timeColumn(const Table& table, const std::vector<CellKind>& kinds) {
    std::optional<std::size_t> best;
    int bestRank = 0;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const Column& column = table.columns[i];
        if (!kinds.empty() && kinds[i] == CellKind::Words) continue;
        const bool hasUnit = areConvertible(column.unit, "s");
        if (!hasUnit && !column.unit.empty()) continue;
        // a capital T is a temperature rather
        const int name = column.name == "T" ? 1 : namesTime(column.name) ? 4 : holdsTime(column.name) ? 3 : 0;
        int rank = 2 * (name + (hasUnit ? 2 : 0));
        if (rank == 0 || !rises(column.values)) continue;
        if (repeats(column.values)) rank -= 3;
        if (rank > bestRank) {
            best = i;
            bestRank = rank;
        }
    }
    return best ? best : firstOfPairedTimes(table, kinds);
}

Diagnostics putOldestFirst(RawTable& raw) {
    if (timeColumn(raw.table, raw.kinds)) return {};
    const auto isNewestFirst = [&](std::size_t index) {
        const Column& column = raw.table.columns[index];
        const bool isTime = raw.kinds[index] == CellKind::Number && namesTime(column.name) &&
                            (column.unit.empty() || areConvertible(column.unit, "s"));
        return isTime && column.values.size() > 2 && column.values.front() > column.values.back() &&
               std::is_sorted(column.values.rbegin(), column.values.rend()) &&
               std::none_of(column.values.begin(), column.values.end(), [](double v) { return std::isnan(v); });
    };
    for (std::size_t i = 0; i < raw.table.columns.size(); ++i) {
        if (!isNewestFirst(i)) continue;
        raw.reverseRows();
        return {doubt(phrase("the time in column '{}' falls from row to row: the newest stands first, and the rows are "
                             "taken from the last one on",
                             cited(raw.table.columns[i].name)),
                      raw.table.file, raw.table.lines.back())};
    }
    return {};
}

Diagnostics addCountedTime(RawTable& raw, const PreambleFacts& facts, const ReadOptions& options, Questions& asked) {
    const std::string& file = raw.table.file;
    const std::optional<double> told = intervalOf(options.timeFormat);
    const std::optional<double> interval = told ? told : toldInterval(facts);
    const std::optional<std::size_t> time = timeColumn(raw.table, raw.kinds);
    if (time && !told) {
        // what the preamble tells is held against it
        const Column& column = raw.table.columns[*time];
        const auto convert = convertUnit(column.unit.empty() ? "s" : column.unit, "s");
        if (!interval || !convert || column.values.size() < 3 || column.unit.empty()) return {};
        const double step = convert->factor * (column.values[2] - column.values[0]) / 2;
        if (!(step > 0) || std::abs(step - *interval) < 0.05 * step) return {};
        return {
            doubt(phrase("the lines in front of the table tell {:.6g} s between two rows, the column '{}' has {:.6g} s",
                         *interval, cited(column.name), step),
                  file)};
    }
    const std::size_t rows = raw.table.lines.size();
    if (!interval) {
        Text what = phrase("no column is a time by its unit or its name");
        for (const Column& column : raw.table.columns)
            if (const std::size_t row = firstFall(column); row > 0) {
                what = phrase("the time in column '{}' goes back in line {}: the rows are not in their order",
                              cited(column.name), raw.table.lines[row]);
                break;
            } else if (countsByOne(column)) {
                what = phrase("no column is a time; '{}' counts the rows", cited(column.name));
                break;
            }
        asked.push_back({Question::Kind::Interval, phrase("Which time lies between two rows?")});
        if (facts.hasSeveralIntervals) what += phrase("; the channels have several sample intervals");
        return {remark(
            what, file, 0,
            phrase("Tell the time between two rows in the study: \"read\": {{\"time_format\": \"0.001 s\"}}, or as "
                   "a rate: \"1 kHz\"."))};
    }
    const double start = facts.start && !told ? seconds(*facts.start, facts.timeUnit) : 0;
    std::vector<double> values(rows);
    const Column& counter = raw.table.columns.front();
    // rows that were lost count, where the first column counts them
    const bool isCounted =
        !told && raw.kinds.front() == CellKind::Number && counter.unit.empty() && rises(counter.values) &&
        std::all_of(counter.values.begin(), counter.values.end(), [](double v) { return v == std::floor(v); }) &&
        counter.values.size() > 1 && counter.values[1] == counter.values[0] + 1;
    for (std::size_t i = 0; i < rows; ++i)
        values[i] = start + *interval * (isCounted ? counter.values[i] - counter.values[0] : static_cast<double>(i));
    insertTime(raw, std::move(values));
    Text made =
        told ? phrase("the time is made of {:.6g} s from one row to the next, as it was told", *interval)
             : phrase(
                   "the time is made of {:.6g} s from one row to the next and a start at {:.6g} s, as the lines in "
                   "front of the table tell",
                   *interval, start);
    return {remark(std::move(made), file)};
}

void applyToldUnit(RawTable& raw, const ReadOptions& options) {
    const std::optional<std::string> unit = timeUnitOf(options.timeFormat);
    const std::optional<std::size_t> time = unit ? timeColumn(raw.table, raw.kinds) : std::nullopt;
    if (time && raw.table.columns[*time].unit.empty()) raw.table.columns[*time].unit = *unit;
}

namespace {

/// Which unit a time without one has: by its names for people, and as "time_format" tells it.
void askUnit(const Column& column, int line, std::vector<std::pair<Text, std::string>> units,
             const ReadOptions& options, Questions& asked) {
    Question question{Question::Kind::Choice,
                      phrase("In which unit is the time in column '{}', which begins at {:.9g}?", cited(column.name),
                             column.values.front()),
                      line};
    for (auto& [label, unit] : units) {
        question.readings.push_back({std::move(label), options});
        question.readings.back().options.timeFormat = unit;
    }
    asked.push_back(std::move(question));
}

/// "t_ms", "millis"; empty: the name tells no unit.
std::string unitOfName(const std::string& name) {
    if (const char* const counted = countedIn(' ' + plainKey(name) + ' ')) return counted;
    const std::string end = unitAtEnd(name);
    return areConvertible(end, "s") ? end : std::string();
}

Text nameOfUnit(std::string_view unit) {
    if (unit == "min") return phrase("minutes");
    return unit == "ms" ? phrase("milliseconds") : unit == "us" ? phrase("microseconds") : phrase("nanoseconds");
}

}  // namespace

Diagnostics nameCountedUnit(Table& table, std::size_t time, const ReadOptions& options, Questions& asked) {
    Column& column = table.columns[time];
    if (!column.unit.empty() || column.values.size() < 2) return {};
    if (const std::string unit = unitOfName(column.name); !unit.empty()) {
        column.unit = unit;
        if (unit == "s") return {};
        askUnit(column, table.lines.front(), {{nameOfUnit(unit), unit}, {phrase("seconds"), "s"}}, options, asked);
        return {doubt(phrase("the time in column '{}' is taken in {}, as its name says", cited(column.name), unit),
                      table.file, table.lines.front())};
    }
    if (const std::string format = writtenFormat(column.values); !format.empty()) {
        Text label = format == "%H%M%S" ? phrase("hours, minutes and seconds in one number")
                                        : phrase("date and clock in one number");
        Text message = phrase("the time in column '{}' begins at {:.14g} and has no unit: these may be seconds, or {}",
                              cited(column.name), column.values.front(), label);
        askUnit(column, table.lines.front(), {{std::move(label), format}, {phrase("seconds"), "s"}}, options, asked);
        return {fileError(std::move(message), table.file, table.lines.front(), 0,
                          phrase("Say it in the study: \"read\": {{\"time_format\": \"{}\"}} or "
                                 "{{\"time_format\": \"s\"}}.",
                                 format))};
    }
    const CountedTime counted = countedTime(column.values);
    if (!counted.unit.empty()) {
        column.unit = counted.unit;
        askUnit(column, table.lines.front(), {{nameOfUnit(counted.unit), counted.unit}, {phrase("seconds"), "s"}},
                options, asked);
        return {doubt(toldSince1970(column.name, counted.unit), table.file, table.lines.front())};
    }
    if (counted.mayBeDays) {
        askUnit(column, table.lines.front(), {{phrase("seconds"), "s"}, {phrase("days"), "d"}}, options, asked);
        return {fileError(
            phrase("the time in column '{}' begins at {:.9g} and has no unit: these may be seconds or days",
                   cited(column.name), column.values.front()),
            table.file, table.lines.front(), 0,
            phrase("Say it in the study: \"read\": {{\"time_format\": \"s\"}} or {{\"time_format\": \"d\"}}."))};
    }
    return {};
}

Diagnostics oddStamps(const Table& table, std::size_t time) {
    constexpr double factor = 20;
    const Column& column = table.columns[time];
    double least = INFINITY, longest = 0;
    std::size_t row = 0;
    for (std::size_t i = 1; i < column.values.size(); ++i) {
        const double step = column.values[i] - column.values[i - 1];
        if (step > 0 && step < least) least = step;
        if (step > longest) {
            longest = step;
            row = i;
        }
    }
    if (column.values.size() < 4 || !(longest > factor * least)) return {};
    std::vector<double> steps;
    for (std::size_t i = 1; i < column.values.size(); ++i) steps.push_back(column.values[i] - column.values[i - 1]);
    const double usual = median(steps);
    if (!(usual > 0) || !(longest > factor * usual)) return {};
    const auto count = std::count_if(steps.begin(), steps.end(), [&](double step) { return step > factor * usual; });
    const std::string unit = column.unit.empty() ? "s" : column.unit;
    return {doubt(
        phrase("the recording pauses for {:.6g} {} before line {}; its usual step is {:.6g} {} ({} such pauses in all)",
               longest, unit, table.lines[row], usual, unit, count),
        table.file, table.lines[row])};
}

}  // namespace analogon
