#include "core/measure/text/column_meaning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/unit.hpp"
#include "core/measure/column_header.hpp"
#include "core/measure/text/remark.hpp"

namespace analogon {

namespace {

/// The column to the left that has no unit of its own.
std::optional<std::size_t> columnOf(const RawTable& raw, std::size_t units) {
    for (std::size_t i = units; i-- > 0;) {
        if (raw.kinds[i] != CellKind::Number) continue;
        return raw.table.columns[i].unit.empty() ? std::optional(i) : std::nullopt;
    }
    return std::nullopt;
}

/// The unit of which one is most, so that a value in volts and one in millivolts are both in volts; empty: not all can
/// be converted.
std::string largestOf(const std::vector<std::string>& units) {
    std::string largest = units.front();
    for (const std::string& unit : units) {
        const auto convert = convertUnit(unit, largest);
        if (!convert) return {};
        if (convert->factor > 1) largest = unit;
    }
    return largest;
}

Diagnostics applyUnits(RawTable& raw, std::size_t from, std::size_t to) {
    const WordSeries& words = raw.words[from];
    if (words.hasEmptyCells()) return {};
    std::vector<std::string> units;
    for (const std::string& word : words.distinct()) {
        const std::string unit = readUnitCell(word);
        if (std::find(units.begin(), units.end(), unit) != units.end()) continue;
        if (unit.empty() || !isKnownUnit(unit)) return {};
        units.push_back(unit);
    }
    if (units.empty()) return {};
    Column& column = raw.table.columns[to];
    const std::string common = largestOf(units);
    if (common.empty())
        return {fileError(phrase("column '{}' tells units for '{}' that cannot be converted into each other: {}",
                                 cited(raw.table.columns[from].name), cited(column.name), listed(units)),
                          raw.table.file, raw.table.lines.front(), 0, phrase("Export one quantity a column."))};
    column.unit = common;
    if (units.size() == 1) return {};
    std::map<std::string, UnitConversion> conversions;
    for (const std::string& unit : units) conversions[unit] = *convertUnit(unit, common);
    for (std::size_t row = 0; row < words.size(); ++row)
        column.values[row] = conversions[readUnitCell(*words.at(row))](column.values[row]);
    return {doubt(phrase("the unit of column '{}' changes from row to row ({}): all its numbers are in {} now",
                         cited(column.name), listed(units), common),
                  raw.table.file, raw.table.lines.front())};
}

struct Switch {
    std::string_view off, on;
};
constexpr std::array<Switch, 10> switches{Switch{"off", "on"},    {"false", "true"}, {"no", "yes"},   {"aus", "ein"},
                                          {"falsch", "wahr"},     {"nein", "ja"},    {"low", "high"}, {"aus", "an"},
                                          {"inactive", "active"}, {"closed", "open"}};

/// Both words must stand there: one alone switches nothing.
const Switch* switchOf(const WordSeries& words) {
    for (const Switch& pair : switches) {
        bool hasOff = false, hasOn = false, hasOther = false;
        for (const std::string& word : words.distinct()) {
            const std::string lower = inLowerCase(word);
            hasOff = hasOff || lower == pair.off;
            hasOn = hasOn || lower == pair.on;
            hasOther = hasOther || (lower != pair.off && lower != pair.on);
            if (hasOther) break;
        }
        if (hasOff && hasOn && !hasOther) return &pair;
    }
    return nullptr;
}

}  // namespace

bool namesUnits(const std::string& name) {
    const std::string key = plainKey(name);
    for (const std::string_view word : {"unit", "units", "einheit", "einheiten"})
        if (key == word || key.ends_with(' ' + std::string(word))) return true;
    return false;
}

Diagnostics applyUnitColumns(RawTable& raw) {
    Diagnostics told;
    for (std::size_t i = 0; i < raw.kinds.size(); ++i) {
        if (raw.kinds[i] != CellKind::Words || !namesUnits(raw.table.columns[i].name)) continue;
        const std::optional<std::size_t> column = columnOf(raw, i);
        if (!column) continue;
        Diagnostics found = applyUnits(raw, i, *column);
        told.insert(told.end(), found.begin(), found.end());
    }
    return told;
}

std::vector<std::vector<StatusText>> readSwitches(RawTable& raw) {
    std::vector<std::vector<StatusText>> statuses(raw.kinds.size());
    for (std::size_t i = 0; i < raw.kinds.size(); ++i) {
        if (raw.kinds[i] != CellKind::Words) continue;
        const Switch* const pair = switchOf(raw.words[i]);
        if (!pair) continue;
        Column& column = raw.table.columns[i];
        for (std::size_t row = 0; row < raw.words[i].size(); ++row) {
            const std::string* const word = raw.words[i].at(row);
            if (!word) column.blanks.push_back({static_cast<std::uint32_t>(row), 0});
            column.values.push_back(word ? (inLowerCase(*word) == pair->on ? 1.0 : 0.0) : NAN);
        }
        raw.words[i].clear();
        raw.kinds[i] = CellKind::Number;
        statuses[i] = {{0, 0, std::string(pair->off)}, {1, 1, std::string(pair->on)}};
    }
    return statuses;
}

bool isSwitch(const Column& column) {
    bool hasOff = false, hasOn = false;
    for (const double value : column.values) {
        if (value != 0 && value != 1) return false;
        (value == 0 ? hasOff : hasOn) = true;
    }
    return hasOff && hasOn;
}

}  // namespace analogon
