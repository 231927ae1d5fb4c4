#include <algorithm>

#include "core/measure/text/row_reader.hpp"

namespace analogon {

void RawTable::erase(std::size_t column) {
    const auto eraseIn = [at = static_cast<std::ptrdiff_t>(column)](auto& of) { of.erase(of.begin() + at); };
    eraseIn(table.columns);
    eraseIn(kinds);
    eraseIn(stamps);
    eraseIn(firstStamps);
    eraseIn(words);
    eraseIn(beyond);
}

void RawTable::reverseRows() {
    const auto last = static_cast<std::uint32_t>(table.lines.size() - 1);
    std::reverse(table.lines.begin(), table.lines.end());
    for (Column& column : table.columns) {
        std::reverse(column.values.begin(), column.values.end());
        std::reverse(column.blanks.begin(), column.blanks.end());
        for (BlankCell& blank : column.blanks) blank.row = last - blank.row;
    }
    for (WordSeries& series : words) series.reverse();
}

void RawTable::insertFront(Column column) {
    table.columns.insert(table.columns.begin(), std::move(column));
    kinds.insert(kinds.begin(), CellKind::Number);
    stamps.insert(stamps.begin(), StampSeries{});
    firstStamps.insert(firstStamps.begin(), std::string());
    words.insert(words.begin(), WordSeries{});
    beyond.insert(beyond.begin(), std::vector<int>{});
}

}  // namespace analogon
