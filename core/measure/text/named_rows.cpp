#include "core/measure/text/named_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/base/file_fault.hpp"
#include "core/measure/column_header.hpp"
#include "core/measure/text/column_meaning.hpp"
#include "core/measure/text/remark.hpp"

namespace analogon {

namespace {

template <std::size_t N>
bool isCalled(const Column& column, const std::array<std::string_view, N>& names) {
    return std::find(names.begin(), names.end(), plainKey(column.name)) != names.end();
}

constexpr std::array<std::string_view, 23> keyNames{
    "name",      "signal",   "signal name", "signalname", "channel", "channel name", "channelname", "variable",
    "varname",   "var name", "tag",         "tag name",   "tagname", "field",        "entity id",   "sensor",
    "parameter", "kanal",    "kanalname",   "messstelle", "topic",   "metric",       "point"};
constexpr std::array<std::string_view, 12> valueNames{"value",   "values",   "wert",      "messwert",
                                                      "reading", "varvalue", "var value", "state",
                                                      "result",  "val",      "data",      "measurement"};

/// What tells to which channel a row belongs: words, or whole numbers.
class Keys {
public:
    Keys(const RawTable& raw, std::size_t column) : raw_(raw), column_(column) {}

    std::string at(std::size_t row) const {
        if (raw_.kinds[column_] != CellKind::Words)
            return fmt::format("{} {}", raw_.table.columns[column_].name, raw_.table.columns[column_].values[row]);
        const std::string* const word = raw_.words[column_].at(row);
        return word ? *word : std::string();
    }

private:
    const RawTable& raw_;
    std::size_t column_;
};

/// Two channels at least, each with some rows.
bool isKey(const RawTable& raw, std::size_t column) {
    constexpr std::size_t fewestRows = 3, most = 4096;
    const std::size_t rows = raw.table.lines.size();
    if (raw.kinds[column] == CellKind::Words) {
        const std::size_t count = raw.words[column].distinct().size();
        return count > 1 && count <= most && fewestRows * count <= rows && !raw.words[column].hasEmptyCells();
    }
    if (raw.kinds[column] != CellKind::Number || !raw.table.columns[column].unit.empty()) return false;
    std::set<double> distinct;
    for (const double value : raw.table.columns[column].values)
        if (value != std::floor(value) || (distinct.insert(value), fewestRows * distinct.size() > rows)) return false;
    return distinct.size() > 1;
}

bool isValues(const RawTable& raw, std::size_t column) {
    return raw.kinds[column] == CellKind::Number && isCalled(raw.table.columns[column], valueNames);
}

std::optional<std::size_t> indexOf(const RawTable& raw, const std::string& name) {
    for (std::size_t i = 0; i < raw.table.columns.size(); ++i)
        if (raw.table.columns[i].name == name) return i;
    return std::nullopt;
}

/// The rows of each channel, in the order of their first ones.
std::vector<std::pair<std::string, std::vector<std::size_t>>> rowsByKey(const RawTable& raw, std::size_t key) {
    const Keys keys(raw, key);
    std::map<std::string, std::size_t> places;
    std::vector<std::pair<std::string, std::vector<std::size_t>>> rows;
    for (std::size_t row = 0; row < raw.table.lines.size(); ++row) {
        const std::string name = keys.at(row);
        const auto [place, isNew] = places.try_emplace(name, rows.size());
        if (isNew) rows.push_back({name, {}});
        rows[place->second].second.push_back(row);
    }
    return rows;
}

Column ownRows(const Column& from, const std::vector<std::size_t>& rows) {
    Column column{from.name, from.unit, {}, {}, from.header, from.line, from.position};
    for (const std::size_t row : rows) column.values.push_back(from.values[row]);
    column.blanks = blanksOf(column.values);
    return column;
}

}  // namespace

std::optional<NamedRows> findNamedRows(const RawTable& raw) {
    std::optional<std::size_t> key, value;
    for (std::size_t i = 0; i < raw.kinds.size(); ++i) {
        if (!key && isCalled(raw.table.columns[i], keyNames) && isKey(raw, i)) key = i;
        if (!isValues(raw, i)) continue;
        if (value) return std::nullopt;  // several channels beside each other
        value = i;
    }
    if (!key || !value || *key == *value) return std::nullopt;
    NamedRows rows{raw.table.columns[*key].name, raw.table.columns[*value].name};
    for (std::size_t i = 0; i < raw.kinds.size(); ++i)
        if (raw.kinds[i] == CellKind::Words && namesUnits(raw.table.columns[i].name))
            rows.units = raw.table.columns[i].name;
    return rows;
}

Outcome<std::vector<TextGroup>> channelsOf(const RawTable& raw, const NamedRows& rows, std::size_t time) {
    const std::optional<std::size_t> key = indexOf(raw, rows.key), value = indexOf(raw, rows.value),
                                     units = rows.units.empty() ? std::nullopt : indexOf(raw, rows.units);
    std::vector<TextGroup> groups;
    for (const auto& [name, own] : rowsByKey(raw, *key)) {
        TextGroup group;
        group.name = name;
        group.table.file = raw.table.file;
        for (const std::size_t row : own) group.table.lines.push_back(raw.table.lines[row]);
        group.table.columns = {ownRows(raw.table.columns[time], own), ownRows(raw.table.columns[*value], own)};
        group.table.columns[1].name = name;
        if (units) {
            const WordSeries told = raw.words[*units].only(own);
            if (told.distinct().size() > 1)
                return fileError(phrase("the unit of channel '{}' changes from row to row: {}", cited(name),
                                        listed(told.distinct())),
                                 raw.table.file, group.table.lines.front(), 0, phrase("Export one quantity a column."));
            if (!told.distinct().empty()) group.table.columns[1].unit = readUnitCell(told.distinct().front());
        }
        group.kinds = {CellKind::Number, CellKind::Number};
        group.words.resize(2);
        group.statuses.resize(2);
        group.time = 0;
        groups.push_back(std::move(group));
    }
    Diagnostics told{remark(phrase("each row has one value and tells in column '{}' which channel it belongs to: "
                                   "there are {} channels",
                                   cited(rows.key), groups.size()),
                            raw.table.file)};
    return {std::move(groups), std::move(told)};
}

Diagnostics tellMixedRows(const RawTable& raw, std::size_t time) {
    constexpr std::size_t fewest = 6;
    const std::vector<double>& stamps = raw.table.columns[time].values;
    for (std::size_t i = 0; i < raw.kinds.size(); ++i) {
        if (raw.kinds[i] != CellKind::Words || !isKey(raw, i)) continue;
        const Keys keys(raw, i);
        std::size_t shared = 0;
        bool isApart = true;
        std::set<std::string> now;
        for (std::size_t row = 0; row < stamps.size() && isApart; ++row) {
            const bool isSame = row > 0 && stamps[row] == stamps[row - 1];
            if (!isSame) now.clear();
            isApart = now.insert(keys.at(row)).second;
            shared += isSame;
        }
        if (!isApart || shared < fewest || 3 * shared < stamps.size()) continue;
        return {
            fileError(phrase("several rows share each stamp, and column '{}' tells them apart: they seem to be rows "
                             "of several channels",
                             cited(raw.table.columns[i].name)),
                      raw.table.file, raw.table.lines.front(), 0,
                      phrase("Export one column a channel, or call the columns \"{}\" and \"{}\".", "name", "value"))};
    }
    return {};
}

}  // namespace analogon
