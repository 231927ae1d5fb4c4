#include "core/measure/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace analogon {

const Column* Table::find(std::string_view name) const {
    for (const Column& column : columns)
        if (column.name == name) return &column;
    for (const Column& column : columns)
        if (column.header == name && !name.empty()) return &column;
    return nullptr;
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
        Column part{column.name, column.unit, cut(column.values), {}, column.header, column.line, column.position};
        for (const BlankCell& blank : column.blanks)
            if (blank.row >= first && blank.row < last)
                part.blanks.push_back({blank.row - static_cast<std::uint32_t>(first), blank.position});
        out.columns.push_back(std::move(part));
    }
    return out;
}

Outcome<Table> readTable(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (ending == ".tsv" || ending == ".tab") {
        CsvOptions options;
        options.separator = '\t';
        return readCsv(file, options);
    }
    // recorders end the names of their texts in many ways; those of the binary formats are known
    constexpr std::array<std::string_view, 7> binary{".mf4", ".mdf", ".mat", ".tdms", ".xlsx", ".xls", ".zip"};
    if (std::find(binary.begin(), binary.end(), ending) == binary.end()) return readCsv(file);
    return fileError(phrase("files ending in '{}' cannot be read", ending), file.string(), 0, 0,
                     phrase("Measurements are read from .csv, .txt, .tsv and .dat files: export the recording as "
                            "comma-separated values."));
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
