#include "core/measure/text/header_rows.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "core/base/unit.hpp"
#include "core/measure/column_header.hpp"
#include "core/measure/text/preamble.hpp"
#include "core/measure/time_name.hpp"

namespace analogon {

namespace {

constexpr std::size_t mostRows = 4;

bool isBracketed(std::string_view text) {
    return text.size() >= 2 &&
           ((text.front() == '[' && text.back() == ']') || (text.front() == '(' && text.back() == ')'));
}

/// By column, whether the first rows of data hold words or dates there, which have no unit.
std::vector<bool> columnsOfWords(const SampledRows& sample) {
    std::vector<bool> areWords;
    for (std::size_t r = sample.begin; r < std::min(sample.end, sample.begin + 20); ++r) {
        const std::vector<CellKind>& kinds = sample.rows[r].kinds;
        if (areWords.size() < kinds.size()) areWords.resize(kinds.size());
        for (std::size_t i = 0; i < kinds.size(); ++i)
            if (kinds[i] == CellKind::Words || kinds[i] == CellKind::Stamp) areWords[i] = true;
    }
    return areWords;
}

/// No measured value, and units: all in brackets, or half of what stands over numbers, or a time in front. "1" and "-"
/// stand for no dimension.
bool isUnitsRow(const SampleRow& row, const std::vector<bool>& areWords) {
    std::size_t told = 0, overNumbers = 0, known = 0, bracketed = 0;
    bool isTimeFirst = false;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
        const CsvCell& cell = row.cells[i];
        if (cell.text.empty()) continue;
        const std::string unit = readUnitCell(cell.text);
        const bool isBare = unit.empty() || unit == "1" || unit == "-";
        if (!isBare && kindOf(unit) != CellKind::Words) return false;
        ++told;
        bracketed += isBracketed(cell.text);
        const bool isKnown = !isBare && isKnownUnit(unit);
        isTimeFirst = isTimeFirst || (told == 1 && isKnown && areConvertible(unit, "s"));
        if (i < areWords.size() && areWords[i]) continue;
        ++overNumbers;
        known += isKnown;
    }
    if (told > 0 && bracketed == told) return true;
    return isTimeFirst || (known > 0 && 2 * known >= overNumbers);
}

/// The same setting in every cell ("SR=100"), or one moment: no names and no units.
bool isOfSettings(const SampleRow& row, const SampleRow& data) {
    if (row.filled < 2 || row.kinds == data.kinds) return false;
    std::set<std::string_view> distinct;
    for (std::size_t i = 0; i < row.filled; ++i) {
        if (row.cells[i].text.empty()) continue;
        const bool isSetting = row.kinds[i] == CellKind::Stamp || row.cells[i].text.find('=') != std::string::npos;
        if (!isSetting) return false;
        distinct.insert(row.cells[i].text);
    }
    return distinct.size() == 1;
}

std::size_t distinctCells(const SampleRow& row) {
    std::set<std::string_view> distinct;
    for (const CsvCell& cell : row.cells)
        if (!cell.text.empty()) distinct.insert(cell.text);
    return distinct.size();
}

bool namesATime(const SampleRow& row) {
    return std::any_of(row.cells.begin(), row.cells.end(),
                       [](const CsvCell& cell) { return namesTime(readColumnHeader(cell.text).name); });
}

bool holdsValues(const SampleRow& row) { return std::any_of(row.kinds.begin(), row.kinds.end(), isValue); }

void refill(SampleRow& row) {
    row.filled = 0;
    for (std::size_t i = 0; i < row.cells.size(); ++i)
        if (!row.cells[i].text.empty()) row.filled = i + 1;
}

void empty(SampleRow& row, std::size_t cell) {
    row.cells[cell].text.clear();
    row.kinds[cell] = CellKind::Blank;
}

/// Takes the facts out that stand beside the table: a key over its value, or both in one cell.
void takeFacts(std::vector<SampleRow>& rows, std::size_t width, HeaderRows& header) {
    for (std::size_t r = 0; r < rows.size(); ++r)
        for (std::size_t i = width; i < rows[r].cells.size(); ++i) {
            const CsvCell cell = rows[r].cells[i];
            if (cell.text.empty()) continue;
            if (const auto pair = keyAndValue(cell.text); pair && isFactKey(pair->first)) {
                header.facts.push_back({{std::string(pair->first), cell.position, false},
                                        {std::string(pair->second), cell.position, false}});
                empty(rows[r], i);
            } else if (r + 1 < rows.size() && i < rows[r + 1].cells.size() && isFactKey(cell.text) &&
                       rows[r + 1].kinds[i] == CellKind::Number) {
                header.facts.push_back({cell, rows[r + 1].cells[i]});
                empty(rows[r], i);
                empty(rows[r + 1], i);
            }
        }
    for (SampleRow& row : rows) refill(row);
}

/// Of rows of words the one with the names: as many different ones as there are, a time among them, the upper one;
/// above all the one that is called so, where keys stand in front of the rows.
std::size_t rowOfNames(const std::vector<SampleRow>& rows, bool areKeyed) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const auto rank = [&](std::size_t r) {
            const bool isCalledSo = areKeyed && !rows[r].cells.empty() && isKeyOfNames(rows[r].cells[0].text);
            return std::tuple(isCalledSo, distinctCells(rows[r]), namesATime(rows[r]));
        };
        if (rank(i) > rank(best)) best = i;
    }
    return best;
}

/// Nothing stands in the first column: keys of the rows above do.
bool isFirstEmpty(const SampledRows& sample) {
    for (std::size_t r = sample.begin; r < sample.end; ++r)
        if (sample.rows[r].kinds.empty() || sample.rows[r].kinds[0] != CellKind::Blank) return false;
    return sample.begin < sample.end;
}

/// A word and numbers: names only where the numbers count channels ("x-axis,1,2"), else a key and its values.
bool isKeyWithNumbers(const SampleRow& row) {
    if (row.filled < 2 || row.kinds[0] != CellKind::Words) return false;
    std::set<double> channels;
    for (std::size_t i = 1; i < row.filled; ++i) {
        if (row.kinds[i] != CellKind::Number) return false;
        const double value = readCell(row.cells[i].text, '.').value;
        if (!(value >= 0 && value <= 256 && value == std::floor(value)) || !channels.insert(value).second) return true;
    }
    return false;
}

/// Where blanks part the columns, a unit in brackets belongs to the name in front of it, and names of several words
/// are parted by more than one blank.
SampleRow rejoined(const SampleRow& row, std::size_t width) {
    SampleRow joined = row;
    joined.cells.clear();
    for (const CsvCell& cell : row.cells) {
        if (isBracketed(cell.text) && !joined.cells.empty())
            joined.cells.back().text += ' ' + cell.text;
        else
            joined.cells.push_back(cell);
    }
    if (joined.cells.size() != width) {
        joined.cells.clear();
        std::string_view rest = row.line.text;
        while (!rest.empty()) {
            const std::size_t begin = std::min(rest.find_first_not_of(" \t"), rest.size());
            rest.remove_prefix(begin);
            const std::size_t end = std::min({rest.find("  "), rest.find('\t'), rest.size()});
            const auto position = static_cast<int>(rest.data() - row.line.text.data()) + 1;
            if (end > 0) joined.cells.push_back({std::string(withoutBlanks(rest.substr(0, end))), position, false});
            rest.remove_prefix(end);
        }
    }
    if (joined.cells.size() != width) return row;
    joined.kinds.assign(width, CellKind::Words);
    joined.filled = width;
    return joined;
}

/// Units alone: their names were left out ("second,Volt").
bool isUnitsAlone(const SampleRow& row) {
    const std::string first = row.cells.empty() ? std::string() : readUnitCell(row.cells[0].text);
    // names of counters that can be read as units
    if (first.size() < 2 || first == "millis" || first == "micros" || !areConvertible(first, "s")) return false;
    return row.filled > 1 && std::all_of(row.cells.begin(), row.cells.end(), [](const CsvCell& cell) {
               return cell.text.empty() || isKnownUnit(readUnitCell(cell.text));
           });
}

/// The rows above the data that may be header, from top to bottom.
std::vector<SampleRow> rowsAbove(const SampledRows& sample, HeaderRows& header) {
    const std::size_t width = widest(sample);
    const std::vector<bool> areWords = columnsOfWords(sample);
    std::vector<SampleRow> rows;
    bool hasNames = false;
    int below = 0;  // the line of the row that was looked at before
    header.first = sample.begin;
    for (std::size_t i = sample.begin; i-- > 0 && rows.size() < mostRows;) {
        const SampleRow& row = sample.rows[i];
        if (row.filled == 0) {
            if (!rows.empty()) break;
            continue;
        }
        const bool isApart = row.line.number + 1 < below;
        below = row.line.number;
        const bool isSettings = sample.begin < sample.end && isOfSettings(row, sample.rows[sample.begin]);
        const bool isWhole = row.filled == 1 || sample.separator == ' ';
        const auto pair = isWhole ? keyAndValue(row.line.text) : std::nullopt;
        if (pair && isFactKey(pair->first)) break;  // "Rate: 10 Hz" above one column
        if (isKeyOfPreamble(row) || isSettings || (rows.empty() && isKeyWithNumbers(row))) {
            header.keys.push_back(row);
            continue;
        }
        if (rows.empty()) {
            if (row.filled == 1 && width > 1) break;  // a title
        } else {
            const bool fits = row.filled > 1 && row.filled <= std::max(rows.back().cells.size(), width) + 2 &&
                              row.filled + 1 >= width;
            const bool isPair = row.filled == 2 && width > 2 && row.kinds[0] == CellKind::Words;  // a key and its value
            const bool mayHoldValues = !hasNames && !isKeyWithNumbers(row);  // numbers of channels over their units
            if (!fits || isPair || (holdsValues(row) && !mayHoldValues) || (isApart && hasNames)) break;
        }
        hasNames = hasNames || !isUnitsRow(row, areWords);
        const bool isOfBlanks = sample.separator == ' ' && row.filled != width;
        rows.push_back(isOfBlanks ? rejoined(row, width) : row);
        header.first = i;
    }
    std::reverse(rows.begin(), rows.end());
    return rows;
}

/// Some programs write the header as the last comments: "# t, u".
std::vector<SampleRow> commentedRows(const SampledRows& sample) {
    const std::size_t width = widest(sample);
    if (sample.begin >= sample.rows.size()) return {};
    const int data = sample.rows[sample.begin].line.number;
    std::vector<SampleRow> rows;
    for (std::size_t i = sample.comments.size(); i-- > 0 && rows.size() < mostRows;) {
        const TextLine& comment = sample.comments[i];
        if (comment.number > data) continue;
        if (comment.number + static_cast<int>(rows.size()) + 3 < data) break;
        const std::size_t first = std::min(comment.text.find_first_not_of(" \t#%/;"), comment.text.size());
        SampleRow row = sampleRowOf({comment.text.substr(first), comment.number}, sample.separator);
        if (row.filled != width || holdsValues(row)) break;
        rows.push_back(std::move(row));
    }
    std::reverse(rows.begin(), rows.end());
    return rows;
}

}  // namespace

HeaderRows findHeader(const SampledRows& sample, const ReadOptions& options) {
    HeaderRows header;
    std::vector<SampleRow> rows;
    if (options.header) {
        header.first = 0;
        rows.assign(sample.rows.begin(), sample.rows.begin() + static_cast<std::ptrdiff_t>(sample.begin));
    } else {
        rows = rowsAbove(sample, header);
        if (rows.empty()) rows = commentedRows(sample);
    }
    takeFacts(rows, widest(sample), header);
    std::erase_if(rows, [](const SampleRow& row) { return row.filled == 0; });
    if (rows.empty()) return header;
    if (rows.size() == 1 && !options.header && !options.hasUnitsRow && isUnitsAlone(rows[0])) {
        header.units = rows[0];
        return header;
    }
    const std::vector<bool> areWords = columnsOfWords(sample);
    const bool mayHaveUnits = options.hasUnitsRow.value_or(rows.size() > 1) && rows.size() > 1;
    for (std::size_t i = rows.size(); mayHaveUnits && i-- > 0;) {
        if (!isUnitsRow(rows[i], areWords) && !(options.hasUnitsRow && i + 1 == rows.size())) continue;
        header.units = rows[i];
        rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(i));
        break;
    }
    const std::size_t names = options.header ? 0 : rowOfNames(rows, isFirstEmpty(sample));
    header.names = rows[names];
    rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(names));
    header.descriptions = std::move(rows);
    return header;
}

bool areChannelsInRows(const SampledRows& sample) {
    constexpr std::size_t most = 64;
    const std::size_t rows = sample.end - sample.begin;
    if (sample.begin != 0 || rows < 2 || rows > most || sample.end != sample.rows.size()) return false;
    bool hasTime = false;
    for (const SampleRow& row : sample.rows) {
        const ColumnHeader name = row.cells.empty() ? ColumnHeader{} : readColumnHeader(row.cells[0].text);
        const auto isNumber = [](CellKind kind) { return kind == CellKind::Number; };
        const bool isLong = row.cells.size() > rows + 1 && row.kinds[0] == CellKind::Words;
        if (!isLong || !std::all_of(row.kinds.begin() + 1, row.kinds.end(), isNumber)) return false;
        hasTime = hasTime || (namesTime(name.name) && (name.unit.empty() || areConvertible(name.unit, "s")));
    }
    return hasTime;
}

}  // namespace analogon
