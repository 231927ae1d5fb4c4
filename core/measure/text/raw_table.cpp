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

void RawTable::insertFront(Column column) {
    table.columns.insert(table.columns.begin(), std::move(column));
    kinds.insert(kinds.begin(), CellKind::Number);
    stamps.insert(stamps.begin(), std::vector<Stamp>{});
    firstStamps.insert(firstStamps.begin(), std::string());
    words.insert(words.begin(), std::vector<std::optional<std::string>>{});
    beyond.insert(beyond.begin(), std::vector<int>{});
}

}  // namespace analogon
