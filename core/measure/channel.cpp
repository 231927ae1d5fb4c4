#include "core/measure/channel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/base/median.hpp"
#include "core/base/unit.hpp"
#include "core/measure/cited.hpp"
#include "core/measure/column_header.hpp"
#include "core/measure/time_faults.hpp"

namespace analogon {

namespace {

Diagnostic unknownColumn(const Table& table, const std::string& name) {
    const std::vector<std::string> names = table.names();
    const std::string alike = suggestion(name, names);
    constexpr std::size_t shown = 30;
    std::vector<std::string> first;
    for (std::size_t i = 0; i < std::min(shown, names.size()); ++i) first.push_back(cited(names[i]));
    const std::string columns = fmt::format("{}{}", fmt::join(first, ", "), names.size() > shown ? ", …" : "");
    Text hint = alike.empty() ? phrase("The columns are {}.", columns)
                              : phrase("Did you mean '{}'? The columns are {}.", alike, columns);
    return fileError(phrase("there is no column '{}'", cited(name)), table.file, 0, 0, std::move(hint));
}

/// The first cell that is not a finite number, and how many more there are.
Diagnostic blankCell(const Table& table, const Column& column, EmptyCells empty) {
    const BlankCell& first = column.blanks.front();
    const bool isMissing = std::isnan(column.values[first.row]);
    const int last = table.lines[column.blanks.back().row];
    const std::size_t count = column.blanks.size();
    const Text what = isMissing ? phrase("no number") : phrase("an infinite value");
    Text message = count > 1 ? phrase("column '{}' has {} here (data row {}; {} cells in all, the last in line {})",
                                      cited(column.name), what, first.row + 1, count, last)
                             : phrase("column '{}' has {} here (data row {})", cited(column.name), what, first.row + 1);
    Text hint = phrase("Remove these rows, fill the cells, or leave them out with \"range\": [from, to] in the study.");
    if (empty == EmptyCells::Fault)
        hint = phrase("Only outputs may have empty cells.") + " " + hint + " " +
               phrase(
                   "An input that is written only now and then is told how it runs between: \"interpolation\": "
                   "\"hold\" or \"linear\".");
    return fileError(std::move(message), table.file, table.lines[first.row], first.position, std::move(hint));
}

/// The cells in which an output was not measured.
Diagnostic unmeasured(const Table& table, const Column& column) {
    const BlankCell& first = column.blanks.front();
    Diagnostic note = fileError(phrase("column '{}' was not measured in {} of {} rows, first in data row {}",
                                       cited(column.name), column.blanks.size(), column.values.size(), first.row + 1),
                                table.file, table.lines[first.row], first.position,
                                phrase("What the model says there is compared with nothing."));
    note.severity = Severity::Warning;
    return note;
}

/// A table made in memory may hold such values without their places.
Column withBlanks(const Column& column) {
    Column out = column;
    if (!out.blanks.empty() || out.isOnOtherRaster) return out;
    out.blanks = blanksOf(out.values);
    return out;
}

/// Whether every cell can be taken as it is.
bool isReadable(const std::vector<double>& values, EmptyCells empty) {
    const auto isNumber = [](double value) { return std::isfinite(value); };
    if (empty == EmptyCells::Fault) return std::all_of(values.begin(), values.end(), isNumber);
    const auto isInfinite = [](double value) { return std::isinf(value); };
    return std::any_of(values.begin(), values.end(), isNumber) &&
           std::none_of(values.begin(), values.end(), isInfinite);
}

/// Never with the unit of the model as what to write: that the numbers are in it is what nobody knows.
Diagnostic unknownUnit(const Table& table, const Column& column, const std::string& unit) {
    const std::string alike = unitAlike(unit);
    Text hint = phrase(
        "Give the unit that its numbers are in, in the header or in the study as {{\"column\": \"{}\", \"unit\": …}}.",
        column.name);
    if (!alike.empty()) hint = phrase("Did you mean '{}'?", alike) + " " + hint;
    return fileError(phrase("the unit '{}' of column '{}' is not known", unit, column.name), table.file, column.line,
                     column.position, std::move(hint));
}

/// What stands in round brackets behind the name of a column, where it is no number; empty: nothing does.
std::string inBrackets(const std::string& name) {
    const std::size_t open = name.rfind('(');
    if (open == std::string::npos || open == 0 || name.back() != ')') return {};
    const std::string text = name.substr(open + 1, name.size() - open - 2);
    const bool hasLetter =
        std::any_of(text.begin(), text.end(), [](unsigned char c) { return std::isalpha(c) || c >= 0x80; });
    return hasLetter ? text : std::string();
}

/// A column without a unit of which the name ends with another one than the model's ("i_mA" for amperes): its numbers
/// may be in either.
Diagnostics otherUnitAtEnd(const Table& table, const Column& column, const std::string& unit) {
    const std::string end = unitAtEnd(column.name);
    if (end.empty() || unit.empty() || unit == "1") return {};
    const auto convert = convertUnit(end, unit);
    if (!convert || !std::isfinite(convert->factor) || (convert->factor == 1 && convert->offset == 0)) return {};
    Diagnostic note = fileError(
        phrase("column '{}' has no unit and its name ends in '{}': its numbers are taken to be in '{}', as the model "
               "wants them",
               cited(column.name), end, unit),
        table.file, column.line, column.position,
        phrase("Say which it is in the study: {{\"column\": \"{}\", \"unit\": \"{}\"}} or {{\"column\": \"{}\", "
               "\"unit\": \"{}\"}}.",
               column.name, end, column.name, unit));
    note.severity = Severity::Warning;
    return {note};
}

/// A column without a unit of which the name ends with one that nobody knows. What begins with a unit of the model's
/// kind was meant as one: a fault. Else a remark: the numbers are taken as they are.
Diagnostics doubtfulUnit(const Table& table, const Column& column, const std::string& unit) {
    const std::string text = inBrackets(column.name);
    if (text.empty()) return otherUnitAtEnd(table, column, unit);
    if (unit.empty() || unit == "1") return {};
    if (beginsWithUnitOf(text, unit)) return {unknownUnit(table, column, text)};
    Diagnostic note =
        fileError(phrase("'({})' behind the name of column '{}' is no unit that is known: its numbers are taken to be "
                         "in '{}', as the model wants them",
                         text, column.name, unit),
                  table.file, column.line, column.position,
                  phrase("Where they are in another unit, give it in the study as {{\"column\": \"{}\", \"unit\": …}}.",
                         column.name));
    note.severity = Severity::Warning;
    return {note};
}

Outcome<UnitConversion> conversion(const Table& table, const Column& column, const std::string& from,
                                   const std::string& to) {
    if (from.empty() || to.empty()) return UnitConversion{};
    const std::string source = from == "-" ? "1" : from;
    Outcome<UnitConversion> result = convertUnit(source, to);
    // A unit and its inverse (rpm and s) are related, but by no line.
    if (result && std::isfinite(result->factor) && std::isfinite(result->offset)) return result;
    if (!isKnownUnit(source)) return unknownUnit(table, column, from);
    return fileError(phrase("column '{}' is in '{}', which cannot be converted to the '{}' of the model",
                            cited(column.name), cited(from), to),
                     table.file, column.line, column.position,
                     phrase("Map another column, or give the unit in the study as {{\"column\": \"{}\", "
                            "\"unit\": …}}.",
                            column.name));
}

double medianStep(const std::vector<double>& time) {
    std::vector<double> steps(time.size() - 1);
    for (std::size_t i = 0; i + 1 < time.size(); ++i) steps[i] = time[i + 1] - time[i];
    return median(std::move(steps));
}

/// One warning for all gaps, at the first.
Diagnostics gaps(const Table& table, const Column& column, const std::vector<double>& time) {
    constexpr double gapFactor = 20;
    const double usual = medianStep(time);
    std::vector<std::size_t> found;
    for (std::size_t i = 1; i < time.size(); ++i)
        if (time[i] - time[i - 1] > gapFactor * usual) found.push_back(i);
    if (found.empty()) return {};
    const std::size_t at = found.front();
    Text message = phrase("the recording pauses for {:.4g} s before this row; its usual step is {:.4g} s",
                          time[at] - time[at - 1], usual);
    if (found.size() > 1) message += phrase(" ({} such gaps in all)", found.size());
    Diagnostic gap = fileError(message, table.file, table.lines[at], 0,
                               phrase("Between rows, inputs run linearly in '{}'. Use \"range\" in the study to "
                                      "leave a part out.",
                                      column.name));
    gap.severity = Severity::Warning;
    return {gap};
}

}  // namespace

Outcome<std::vector<double>> readChannel(const Table& table, const ChannelMapping& mapping, const std::string& unit,
                                         EmptyCells empty) {
    const Column* const column = table.find(mapping.column, mapping.group);
    if (!column) return unknownColumn(table, mapping.column);
    const Outcome<UnitConversion> convert =
        conversion(table, *column, mapping.unit.empty() ? column->unit : mapping.unit, unit);
    if (!convert) return convert.diagnostics();
    Diagnostics remarks;
    if (mapping.unit.empty() && column->unit.empty() && mapping.scale == 1 && mapping.offset == 0)
        remarks = doubtfulUnit(table, *column, unit);
    if (hasError(remarks)) return remarks;
    Column known = withBlanks(*column);
    if (!isReadable(known.values, empty)) {
        const auto isInfiniteCell = [&](const BlankCell& cell) { return std::isinf(known.values[cell.row]); };
        const bool isInfinite = std::any_of(known.blanks.begin(), known.blanks.end(), isInfiniteCell);
        if (known.blanks.empty())
            return fileError(phrase("column '{}' was not measured at any stamp of the raster", cited(known.name)),
                             table.file, 0, 0, phrase("Choose another \"raster\", or leave the channel out."));
        if (empty == EmptyCells::NotMeasured && isInfinite)  // those without a number are none
            std::erase_if(known.blanks, [&](const BlankCell& cell) { return !isInfiniteCell(cell); });
        return blankCell(table, known, empty);
    }
    std::vector<double> values(column->values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = mapping.scale * (*convert)(column->values[i]) + mapping.offset;
    if (!known.blanks.empty()) remarks.push_back(unmeasured(table, known));
    return {std::move(values), std::move(remarks)};
}

Outcome<std::vector<double>> readTime(const Table& table, const std::string& column) {
    const Outcome<std::vector<double>> channel = readChannel(table, ChannelMapping{column, {}, 1, 0, 1}, "s");
    if (!channel) return channel.diagnostics();
    const Column& source = *table.find(column);
    const std::vector<double>& time = *channel;
    if (time.size() < 2)
        return fileError(phrase("the recording has only one row"), table.file,
                         table.lines.empty() ? 0 : table.lines.front(), 0, phrase("At least two samples are needed."));
    if (std::all_of(time.begin(), time.end(), [&](double t) { return t == time.front(); }))
        return fileError(phrase("the time in column '{}' stands still at {}", column, source.values.front()),
                         table.file, table.lines.front(), 0, phrase("Name the column that holds the time in seconds."));
    if (std::optional<Diagnostic> fault = timeFault(table, source, time)) return std::move(*fault);
    Diagnostics remarks = channel.diagnostics();
    if (source.isOnOtherRaster) return {time, std::move(remarks)};  // each raster was looked at alone
    for (Diagnostic& gap : gaps(table, source, time)) remarks.push_back(std::move(gap));
    return {time, std::move(remarks)};
}

}  // namespace analogon
