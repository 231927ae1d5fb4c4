#include "core/measure/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace analogon {

std::vector<BlankCell> blanksOf(const std::vector<double>& values) {
    std::vector<BlankCell> blanks;
    for (std::size_t row = 0; row < values.size(); ++row)
        if (!std::isfinite(values[row])) blanks.push_back({static_cast<std::uint32_t>(row), 0});
    return blanks;
}

bool Column::isOf(const GroupName& wanted) const {
    if (!wanted.name.empty()) return group == wanted.name;
    return wanted.number == 0 || groupNumber == wanted.number;
}

GroupName Column::groupName() const { return {group, group.empty() ? groupNumber : 0, false}; }

const Column* Table::find(std::string_view name, const GroupName& group) const {
    for (const Column& column : columns)
        if (column.name == name && column.isOf(group)) return &column;
    for (const Column& column : columns)
        if (column.header == name && !name.empty() && column.isOf(group)) return &column;
    return nullptr;
}

bool Table::hasUnread() const {
    return rows() > 0 &&
           std::any_of(columns.begin(), columns.end(), [](const Column& column) { return column.values.empty(); });
}

std::vector<std::string> Table::names() const {
    std::vector<std::string> out;
    for (const Column& column : columns) out.push_back(column.name);
    return out;
}

Table Table::slice(std::size_t first, std::size_t last) const {
    const auto cut = [&](const auto& values) {
        using Values = std::decay_t<decltype(values)>;
        return Values(values.begin() + static_cast<std::ptrdiff_t>(first),
                      values.begin() + static_cast<std::ptrdiff_t>(last));
    };
    Table out;
    out.file = file;
    out.lines = cut(lines);
    for (const Column& column : columns) {
        Column part{
            column.name,     column.unit,   cut(column.values),     {},           column.header,     column.line,
            column.position, column.isHeld, column.isOnOtherRaster, column.group, column.groupNumber};
        for (const BlankCell& blank : column.blanks)
            if (blank.row >= first && blank.row < last)
                part.blanks.push_back({blank.row - static_cast<std::uint32_t>(first), blank.position});
        out.columns.push_back(std::move(part));
    }
    return out;
}

std::string csvCell(std::string_view text) {
    const bool isFormula = !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
    const bool isQuoted = isFormula || text.find_first_of(",;\"\n\r\t|") != std::string_view::npos ||
                          (!text.empty() && (text.front() == ' ' || text.back() == ' '));
    std::string out = isFormula ? "'" : "";
    if (!isQuoted) return std::string(text);
    for (const char c : text) {
        if (c == '"') out.push_back('"');
        out.push_back(c);
    }
    return '"' + out + '"';
}

std::string writeCsv(const Table& table) {
    std::string out;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const Column& column = table.columns[i];
        if (i > 0) out += ',';
        out += csvCell(column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit));
    }
    out += '\n';
    for (std::size_t row = 0; row < table.rows(); ++row) {
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            if (i > 0) out += ',';
            const double value = table.columns[i].values[row];
            if (!std::isnan(value)) fmt::format_to(std::back_inserter(out), "{}", value);
        }
        out += '\n';
    }
    return out;
}

}  // namespace analogon
