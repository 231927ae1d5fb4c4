#include "core/campaign/units_table.hpp"

#include <algorithm>
#include <string_view>

#include "core/base/limits.hpp"
#include "core/measure/column_header.hpp"
#include "core/measure/csv_dialect.hpp"
#include "core/measure/encoding.hpp"

namespace analogon {

namespace {

char separatorOf(std::string_view header) {
    char best = ',';
    for (const char mark : {';', '\t'})
        if (std::count(header.begin(), header.end(), mark) > std::count(header.begin(), header.end(), best))
            best = mark;
    return best;
}

}  // namespace

std::vector<std::size_t> UnitsTable::find(const std::string& name) const {
    std::vector<std::size_t> exact, alike;
    for (std::size_t i = 0; i < header.size(); ++i) {
        if (header[i] == name) exact.push_back(i);
        if (readColumnHeader(header[i]).name == readColumnHeader(name).name) alike.push_back(i);
    }
    return exact.empty() ? alike : exact;
}

Outcome<UnitsTable> parseUnitsTable(const std::string& text, const std::string& file) {
    std::string_view rest = text;
    if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
    if (!isUtf8(std::string(rest)))
        return fileError(phrase("the table of units is no text in UTF-8"), file, 0, 0, phrase("Save it as UTF-8."));
    UnitsTable table;
    table.file = file;
    Diagnostics faults;
    for (int line = 1; !rest.empty() && faults.size() < limits::shownFaults; ++line) {
        const std::size_t end = rest.find('\n');
        std::string_view one = rest.substr(0, end);
        rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
        if (one.ends_with('\r')) one.remove_suffix(1);
        if (withoutBlanks(one).empty()) continue;
        if (table.header.empty()) table.separator = separatorOf(one);
        CsvRow row = splitCsvRow(one, table.separator);
        if (row.openQuote > 0) {
            faults.push_back(fileError(phrase("a quote is not closed in this line"), file, line, row.openQuote,
                                       phrase("Close it; a cell of this table ends with its line.")));
        } else if (table.header.empty()) {
            for (CsvCell& cell : row.cells) table.header.push_back(std::move(cell.text));
        } else if (row.cells.size() != table.header.size()) {
            faults.push_back(fileError(
                phrase("the row has {} cells and the header {}", row.cells.size(), table.header.size()), file, line));
        } else {
            UnitsRow& added = table.rows.emplace_back();
            added.line = line;
            for (CsvCell& cell : row.cells) {
                added.cells.push_back(std::move(cell.text));
                added.positions.push_back(cell.position);
            }
        }
    }
    if (!faults.empty()) return faults;
    return table;
}

}  // namespace analogon
