#include "core/measure/text/tidy_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/file_fault.hpp"
#include "core/base/visible.hpp"
#include "core/measure/text/preamble.hpp"
#include "core/measure/text/remark.hpp"

namespace analogon {

namespace {

/// Instruments write 9.9E37 where a value is beyond their range or there is none (SCPI).
void takeOverflowsOut(RawTable& raw) {
    constexpr double overflow = 9.9e37, none = 9.91e37;
    for (std::size_t i = 0; i < raw.table.columns.size(); ++i) {
        std::vector<double>& values = raw.table.columns[i].values;
        bool isAny = false;
        for (const double value : values) isAny = isAny || std::abs(value) == overflow || std::abs(value) == none;
        if (!isAny) continue;
        std::vector<BlankCell>& blanks = raw.table.columns[i].blanks;
        for (std::size_t row = 0; row < values.size(); ++row) {
            if (std::abs(values[row]) != overflow && std::abs(values[row]) != none) continue;
            values[row] = std::numeric_limits<double>::quiet_NaN();
            blanks.push_back({static_cast<std::uint32_t>(row), 0});
            raw.beyond[i].push_back(raw.table.lines[row]);
        }
        std::sort(blanks.begin(), blanks.end(), [](const BlankCell& a, const BlankCell& b) { return a.row < b.row; });
        std::sort(raw.beyond[i].begin(), raw.beyond[i].end());
    }
}

Diagnostics tellBeyond(const RawTable& raw) {
    constexpr std::size_t shown = 3;
    Diagnostics told;
    for (std::size_t i = 0; i < raw.table.columns.size(); ++i) {
        const std::vector<int>& lines = raw.beyond[i];
        if (lines.empty()) continue;
        std::vector<std::string> first;
        for (std::size_t k = 0; k < std::min(shown, lines.size()); ++k) first.push_back(std::to_string(lines[k]));
        const std::string name = cited(raw.table.columns[i].name);
        Text message =
            lines.size() <= shown
                ? phrase("column '{}' was beyond the range of its instrument in line {}", name, listed(first))
                : phrase("column '{}' was beyond the range of its instrument in {} rows, first in lines {}", name,
                         lines.size(), listed(first));
        told.push_back(asWarning(fileError(std::move(message), raw.table.file, lines.front(), 0,
                                           phrase("These cells are taken for not measured."))));
    }
    return told;
}

bool isEmpty(const RawTable& raw, std::size_t index) {
    const Column& column = raw.table.columns[index];
    return raw.kinds[index] != CellKind::Words && raw.kinds[index] != CellKind::Stamp &&
           column.blanks.size() == column.values.size();
}

/// Columns without a name in which nothing stands are what a mark at the end of each row makes; one in front is what
/// keys before the rows of the header make ("Kanal"), or a time that was not written ("X_Value").
void dropEmptyColumns(RawTable& raw) {
    while (raw.table.columns.size() > 1) {
        const Column& last = raw.table.columns.back();
        const bool isUnnamed = last.name == fmt::format("c{}", raw.table.columns.size()) && last.unit.empty();
        if (!isUnnamed || !isEmpty(raw, raw.table.columns.size() - 1)) break;
        raw.erase(raw.table.columns.size() - 1);
    }
    const std::string& first = raw.table.columns.front().header;
    const bool isKey = isKeyOfNames(first) || plainKey(first) == "x value";
    if (raw.table.columns.size() > 1 && isKey && isEmpty(raw, 0)) raw.erase(0);
}

}  // namespace

Diagnostics tidyColumns(RawTable& raw) {
    takeOverflowsOut(raw);
    Diagnostics told = tellBeyond(raw);
    dropEmptyColumns(raw);
    return told;
}

}  // namespace analogon
