#include "core/measure/text/row_fault.hpp"

#include <algorithm>

#include "core/measure/text/cell_kind.hpp"

namespace analogon {

namespace {

/// Whether the names of the columns stand again below, as where a program began a second recording in one file.
bool namesStandAgain(const Layout& layout, LineReader& behind) {
    constexpr int most = 100;
    if (layout.headerLine == 0) return false;
    TextLine line;
    for (int i = 0; i < most && behind.next(line); ++i) {
        const CsvRow row = splitCsvRow(line.text, layout.separator);
        const auto isName = [&](std::size_t k) { return row.cells[k].text == layout.columns[k].header; };
        const std::size_t count = std::min(row.cells.size(), layout.columns.size());
        std::size_t named = 0;
        while (named < count && isName(named)) ++named;
        if (named > 1 && named + 1 >= count) return true;
    }
    return false;
}

Text standsAgain() {
    return phrase("The header stands here again: split the file in front of this line, it holds two recordings.");
}

}  // namespace

Text hintOfLength(std::size_t found, std::size_t expected, const Layout& layout, LineReader behind) {
    if (namesStandAgain(layout, behind)) return standsAgain();
    const char separator = layout.separator;
    const bool hasHeader = layout.headerLine > 0;
    Text hint = phrase("Every row needs one cell for each column of the header.");
    if (found < expected && separator == ',' && hasHeader)
        hint += phrase(" A name with a comma needs quotation marks.");
    if (separator == ',' && found == 2 * expected)
        hint = phrase(
            "There are exactly twice as many: the commas seem to be decimal marks as well. Export with "
            "decimal points, or with ; or a tab between the columns.");
    else if (separator == ',' && found > expected)
        hint += phrase(" If the commas are decimal marks, the columns must be separated by ; or a tab.");
    return hint;
}

Text hintOfWord(const std::string& text, const Layout& layout, bool isBehindGap, LineReader behind) {
    const auto& columns = layout.columns;
    const bool isHeader = std::any_of(columns.begin(), columns.end(), [&](const LayoutColumn& named) {
        return named.header == text && !named.header.empty();
    });
    Text hint = phrase("Only numbers can be read; leave the cell of an output empty where it was not measured.");
    if (isHeader || namesStandAgain(layout, behind))
        hint = standsAgain();
    else if (isBehindGap && kindOf(text) == CellKind::Words)
        hint = phrase(
            "Another table seems to begin here: keep one in the file, or export each recording to a file of its "
            "own.");
    else if (readQuantity(text))
        hint = phrase("A unit stands in the cell: write it in the header and numbers in the cells.");
    else if (text.find(',') != std::string::npos && text.find('.') != std::string::npos)
        hint = phrase("Marks between thousands cannot be read: write 1234.5.");
    return hint;
}

}  // namespace analogon
