#include "core/measure/text/row_frame.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "core/measure/text/cell_kind.hpp"
#include "core/measure/text/dialect.hpp"
#include "core/measure/text/preamble.hpp"
#include "core/measure/text/stamp.hpp"
#include "core/measure/text/stamp_parts.hpp"

namespace analogon {

namespace {

/// Changes one line where it is.
using LineChange = std::function<void(char* begin, char* end)>;

constexpr std::size_t fewest = 8;

std::vector<TextLine> headLines(TextView text) {
    constexpr std::size_t most = 200;
    LineReader reader(text);
    std::vector<TextLine> lines;
    for (TextLine line; lines.size() < most && reader.next(line);)
        if (!isEmptyLine(line.text)) lines.push_back(line);
    return lines;
}

/// The first of the columns in which every line has a number; behind two for a key and its value.
std::optional<std::size_t> firstOfNumbers(const std::vector<SampleRow>& rows) {
    const std::size_t width = rows.front().cells.size();
    for (std::size_t i = 2; i < width; ++i) {
        const auto isNumber = [&](const SampleRow& row) { return row.kinds[i] == CellKind::Number; };
        if (std::all_of(rows.begin(), rows.end(), isNumber)) return i;
    }
    return std::nullopt;
}

/// Rows of one length with a key and its value in front of some, numbers behind in all, and nothing between.
std::optional<std::size_t> numbersBesidePairs(const std::vector<SampleRow>& rows) {
    constexpr std::size_t fewestKeys = 3, fewestKnown = 2;
    const std::size_t width = rows.front().cells.size();
    const auto isOther = [&](const SampleRow& row) { return row.cells.size() != width; };
    if (width < 3 || std::any_of(rows.begin(), rows.end(), isOther)) return std::nullopt;
    const std::optional<std::size_t> first = firstOfNumbers(rows);
    if (!first) return std::nullopt;
    std::set<std::string_view> keys;
    std::size_t pairs = 0, known = 0;
    for (const SampleRow& row : rows) {
        for (std::size_t i = 2; i < *first; ++i)
            if (!row.cells[i].text.empty()) return std::nullopt;
        if (row.cells[0].text.empty() && row.cells[1].text.empty()) continue;
        if (row.kinds[0] != CellKind::Words) return std::nullopt;
        ++pairs;
        keys.insert(row.cells[0].text);
        SampleRow pair = row;
        pair.filled = 2;
        known += isKeyOfPreamble(pair);
    }
    const bool arePairs = pairs >= fewestKeys && keys.size() == pairs && known >= fewestKnown;
    return arePairs ? first : std::nullopt;
}

void blankInFrontOf(std::size_t cell, char separator, char* begin, char* end) {
    for (char* at = begin; at != end && cell > 0; ++at) {
        cell -= *at == separator ? 1 : 0;
        *at = ' ';
    }
}

std::optional<LineChange> pairsChange(const std::vector<TextLine>& lines, UnframedText& text) {
    for (const char separator : {',', ';', '\t'}) {
        std::vector<SampleRow> rows;
        for (const TextLine& line : lines) rows.push_back(sampleRowOf(line, separator));
        const std::optional<std::size_t> first = numbersBesidePairs(rows);
        if (!first) continue;
        text.separator = separator;
        for (const SampleRow& row : rows)
            if (!row.cells[0].text.empty()) text.pairs.push_back(row.cells[0].text + separator + row.cells[1].text);
        return [separator, cell = *first](char* begin, char* end) { blankInFrontOf(cell, separator, begin, end); };
    }
    return std::nullopt;
}

/// Quotation marks around each line and none within, though marks that part cells are.
std::optional<LineChange> quotesChange(const std::vector<TextLine>& lines) {
    const auto isQuoted = [](std::string_view line) {
        while (line.ends_with(' ')) line.remove_suffix(1);
        if (line.size() < 4 || line.front() != '"' || line.back() != '"') return false;
        line = line.substr(1, line.size() - 2);
        return line.find('"') == std::string_view::npos && line.find_first_of(",;\t") != std::string_view::npos;
    };
    if (!std::all_of(lines.begin(), lines.end(), [&](const TextLine& line) { return isQuoted(line.text); }))
        return std::nullopt;
    const auto hasSeveral = [](const TextLine& line) {
        return line.text.find_first_of(";\t") != std::string_view::npos;
    };
    const auto commas = [](const TextLine& line) { return std::count(line.text.begin(), line.text.end(), ','); };
    const bool areAlike = std::all_of(lines.begin(), lines.end(),
                                      [&](const TextLine& line) { return commas(line) == commas(lines.front()); });
    // one column of numbers with decimal commas is no row of cells
    if (!std::all_of(lines.begin(), lines.end(), hasSeveral) && !areAlike) return std::nullopt;
    return [](char* begin, char* end) { std::replace(begin, end, '"', ' '); };
}

/// Where the comma in front of the decimals of a stamp is, which the header has no column for; 0: nowhere.
std::size_t commaInStamp(std::string_view line) {
    const std::size_t comma = line.find(',');
    if (comma == std::string_view::npos) return 0;
    const std::optional<Stamp> stamp = readStamp(line.substr(0, comma));
    std::size_t digits = 0;
    while (comma + 1 + digits < line.size() && isDigit(line[comma + 1 + digits])) ++digits;
    const bool isPart =
        (digits == 3 || digits == 6) && comma + 1 + digits < line.size() && line[comma + 1 + digits] == ',';
    return stamp && stamp->hasClock && !stamp->hasFraction && isPart ? comma : 0;
}

std::optional<LineChange> stampsChange(const std::vector<TextLine>& lines) {
    const auto commas = [](std::string_view line) { return std::count(line.begin(), line.end(), ','); };
    std::size_t stamps = 0;
    std::string_view header;
    for (const TextLine& line : lines) {
        if (commaInStamp(line.text) > 0)
            ++stamps;
        else if (stamps > 0)
            return std::nullopt;
        else
            header = line.text;
    }
    if (stamps < fewest || header.empty() || commas(lines.back().text) != commas(header) + 1) return std::nullopt;
    return [](char* begin, char* end) {
        const std::size_t comma = commaInStamp({begin, static_cast<std::size_t>(end - begin)});
        if (comma > 0) begin[comma] = '.';
    };
}

}  // namespace

std::optional<UnframedText> withoutFrames(TextView text, std::string& store) {
    UnframedText result{text};
    const std::vector<TextLine> lines = headLines(text);
    if (lines.size() < fewest) return std::nullopt;
    std::optional<LineChange> one = pairsChange(lines, result);
    if (!one) one = quotesChange(lines);
    if (!one) one = stampsChange(lines);
    if (!one) return std::nullopt;
    const auto changeEach = [change = std::move(*one)](char* begin, char* end) {
        LineReader reader(std::string_view(begin, static_cast<std::size_t>(end - begin)));
        for (TextLine line; reader.next(line);) {
            char* const at = begin + (line.text.data() - begin);
            change(at, at + line.text.size());
        }
    };
    result.text = text.withLines(changeEach, store);
    return result;
}

}  // namespace analogon
