#include "core/measure/csv_dialect.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace analogon {

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

std::string lowered(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return out;
}

int countOutsideQuotes(std::string_view line, char separator) {
    int count = 0;
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') quoted = !quoted;
        if (c == separator && !quoted) ++count;
    }
    return count;
}

bool isSeparatedByBlanks(const std::vector<std::string_view>& lines) {
    for (std::size_t i = lines.size() > 1 ? 1 : 0; i < lines.size(); ++i) {
        const CsvRow row = splitCsvRow(lines[i], ' ');
        if (row.cells.size() < 2) return false;
        for (const CsvCell& cell : row.cells)
            if (!isNumeric(cell.text)) return false;
    }
    return !lines.empty();
}

}  // namespace

CsvRow splitCsvRow(std::string_view line, char separator) {
    CsvRow row;
    std::size_t i = 0;
    const bool byBlanks = separator == ' ';
    const auto isEdge = [&](char c) { return c == ' ' || (c == '\t' && separator != '\t'); };
    while (true) {
        while (i < line.size() && isEdge(line[i])) ++i;
        if (byBlanks && i >= line.size()) break;
        CsvCell cell;
        cell.position = static_cast<int>(i) + 1;
        if (i < line.size() && line[i] == '"') {
            cell.isQuoted = true;
            for (++i;; ++i) {
                if (i >= line.size()) {
                    row.openQuote = cell.position;
                    break;
                }
                if (line[i] == '"') {
                    if (i + 1 >= line.size() || line[i + 1] != '"') break;
                    ++i;  // a doubled quote stands for one
                }
                cell.text.push_back(line[i]);
            }
            if (i < line.size()) ++i;
        }
        const std::size_t begin = i;
        while (i < line.size() && line[i] != separator && !(byBlanks && isBlank(line[i]))) ++i;
        cell.text += line.substr(begin, i - begin);
        cell.text = std::string(trimmed(cell.text));
        row.cells.push_back(std::move(cell));
        if (i >= line.size()) break;
        ++i;
    }
    return row;
}

char detectSeparator(const std::vector<std::string_view>& lines) {
    constexpr std::array<char, 4> candidates{'\t', ';', '|', ','};
    for (const char candidate : candidates) {
        bool consistent = !lines.empty();
        const int first = lines.empty() ? 0 : countOutsideQuotes(lines.front(), candidate);
        for (const std::string_view line : lines)
            consistent = consistent && countOutsideQuotes(line, candidate) == first;
        if (consistent && first > 0) return candidate;
    }
    for (const char candidate : candidates)
        if (!lines.empty() && countOutsideQuotes(lines.front(), candidate) > 0) return candidate;
    return isSeparatedByBlanks(lines) ? ' ' : ',';
}

CellValue readCell(std::string_view text, char decimal) {
    using Kind = CellValue::Kind;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    text = trimmed(text);
    if (text.empty()) return {Kind::Missing, nan};

    std::string plain(text.front() == '+' ? text.substr(1) : text);
    if (decimal == ',') {
        // The point is no mark of this file: "0.5" here is a mistake, not a number.
        if (plain.find('.') != std::string::npos && plain.find('#') == std::string::npos) return {};
        std::replace(plain.begin(), plain.end(), ',', '.');
    }
    const char* const end = plain.data() + plain.size();
    double value = 0;
    const auto [stop, code] = std::from_chars(plain.data(), end, value);
    if (stop == end && code == std::errc{} && std::isfinite(value)) return {Kind::Number, value};
    if (stop == end && code == std::errc::result_out_of_range) {
        const std::size_t exponent = plain.find_first_of("eE");
        const bool isTiny = exponent != std::string::npos && plain.find('-', exponent) != std::string::npos;
        if (isTiny) return {Kind::Number, 0};
        return {Kind::Infinite, plain.front() == '-' ? -infinity : infinity};
    }

    const std::string word = lowered(plain);
    for (const char* missing : {"nan", "-nan", "na", "n/a", "#n/a", "#nv", "null", "none", "-", "--", "1.#qnan",
                                "-1.#qnan", "1.#ind", "-1.#ind", "nan(ind)", "-nan(ind)"})
        if (word == missing) return {Kind::Missing, nan};
    for (const char* infinite : {"inf", "infinity", "1.#inf"})
        if (word == infinite) return {Kind::Infinite, infinity};
    for (const char* infinite : {"-inf", "-infinity", "-1.#inf"})
        if (word == infinite) return {Kind::Infinite, -infinity};
    return {};
}

bool isNumeric(std::string_view text) {
    return readCell(text, '.').kind != CellValue::Kind::Text || readCell(text, ',').kind != CellValue::Kind::Text;
}

}  // namespace analogon
