#include "core/measure/text/row_fault.hpp"

#include <algorithm>

#include "core/measure/text/cell_kind.hpp"

namespace analogon {

Text hintOfLength(std::size_t found, std::size_t expected, char separator, bool hasHeader) {
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

Text hintOfWord(const std::string& text, const Layout& layout, bool isBehindGap) {
    const auto& columns = layout.columns;
    const bool isHeader = std::any_of(columns.begin(), columns.end(), [&](const LayoutColumn& named) {
        return named.header == text && !named.header.empty();
    });
    Text hint = phrase("Only numbers can be read; leave the cell of an output empty where it was not measured.");
    if (isHeader)
        hint = phrase("The header stands here again: split the file in front of this line, it holds two recordings.");
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
