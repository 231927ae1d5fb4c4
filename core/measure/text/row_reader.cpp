#include "core/measure/text/row_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include "core/base/file_fault.hpp"
#include "core/base/limits.hpp"
#include "core/base/stop.hpp"
#include "core/base/unit.hpp"
#include "core/base/visible.hpp"
#include "core/measure/encoding.hpp"
#include "core/measure/plain_number.hpp"
#include "core/measure/text/remark.hpp"
#include "core/measure/text/row_fault.hpp"
#include "core/measure/text/tidy_columns.hpp"
#include "core/measure/text/time_format.hpp"

namespace analogon {

namespace {

/// A cell of a row that is read the fast way: what it holds is told by its column.
struct PlainCell {
    double number{};
    Stamp stamp;
    std::string_view text;
};

/// Reads the rows of one text, from the first row of data to its end.
class RowReader {
    static constexpr std::ptrdiff_t letGoBytes = std::ptrdiff_t{1} << 20;
    static constexpr std::size_t shownBehind = 1024;  // bytes of a line behind the place of a fault

public:
    RowReader(TextView text, const std::string& name, const Layout& layout, const ReadOptions& options,
              const Progress& progress, Questions& asked)
        : text_(text.text.substr(layout.offset)),
          supply_(text.supply),
          lines_(text.from(layout.offset), layout.linesBefore),
          separator_(layout.separator),
          decimal_(layout.marks.decimal),
          thousands_(layout.marks.thousands),
          layout_(layout),
          options_(options),
          progress_(progress),
          asked_(asked) {
        raw_.table.file = name;
        for (const LayoutColumn& column : layout.columns) {
            table().columns.push_back({column.name, column.unit, {}, {}, column.header, column.line, column.position});
            raw_.kinds.push_back(column.kind);
        }
        raw_.stamps.resize(table().columns.size());
        raw_.firstStamps.resize(table().columns.size());
        raw_.words.resize(table().columns.size());
        raw_.beyond.resize(table().columns.size());
        decimalLine_ = layout.linesBefore + 1;
        if (!options.thousands) raw_.thousands = layout.marks.thousands;
    }

    Outcome<RawTable> read() {
        advance();
        if (!hasMemory()) return faults_;
        reserve();
        while (hasLine_ && !isAtEnd_) {
            const bool isEmpty = isEmptyLine(line_.text);
            if (!isEmpty && !isComment(line_.text, separator_) && !readRow()) return faults_;
            isBehindGap_ = isEmpty;
            advance();
        }
        if (table().lines.empty())
            return fileError(phrase("the file has a header and no data rows"), table().file, layout_.headerLine, 0,
                             phrase("Check that the recording was exported with its values."));
        finish();
        return {std::move(raw_), std::move(warnings_)};
    }

private:
    Table& table() { return raw_.table; }
    const Table& table() const { return raw_.table; }
    void advance() { hasLine_ = lines_.next(line_); }

    bool fault(Text message, int line, int position, Text hint, std::string_view lineText = {}) {
        Diagnostic diagnostic = fileError(std::move(message), table().file, line, position, std::move(hint));
        // as much of the line as is shown around the place
        const auto reach = static_cast<std::size_t>(std::max(position, 0)) + shownBehind;
        diagnostic.place.lineText = std::string(lineText.substr(0, reach));
        diagnostic.place.length = 1;
        faults_ = {std::move(diagnostic)};
        return false;
    }

    /// Whether there is memory for the numbers, by the length of the first row; a number takes two bytes at least.
    bool hasMemory() {
        if (!hasLine_) return true;
        const double left = static_cast<double>(text_.data() + text_.size() - line_.text.data());
        const double rows = std::max(1.0, left / static_cast<double>(line_.text.size() + 1));
        const double cells = std::min(rows * static_cast<double>(table().columns.size()), left / 2);
        const Outcome<Done> enough =
            limits::checkTable(rows, table().columns.size(), cells, supply_ ? 0 : static_cast<double>(text_.size()));
        if (enough) return true;
        faults_ = enough.diagnostics();
        faults_.front().place.file = table().file;
        return false;
    }

    void reserve() {
        if (!hasLine_) return;
        const auto left = static_cast<std::size_t>(text_.data() + text_.size() - line_.text.data());
        const std::size_t rows = std::min<std::size_t>(left / (line_.text.size() + 1) * 11 / 10 + 16, 1u << 24);
        if (rows * table().columns.size() > (1u << 28)) return;
        for (std::size_t i = 0; i < table().columns.size(); ++i) {
            if (raw_.kinds[i] == CellKind::Stamp)
                raw_.stamps[i].reserve(rows);
            else if (raw_.kinds[i] != CellKind::Words)
                table().columns[i].values.reserve(rows);
        }
        table().lines.reserve(rows);
    }

    bool readRow() {
        if (table().lines.size() >= limits::rows)
            return fault(phrase("the file has more than {} rows", limits::rows), line_.number, 0,
                         phrase("Split the recording, or record fewer samples a second."));
        if (table().lines.size() % 65536 == 0) {
            stopPoint();
            progress_.report(
                {"reading",
                 {},
                 static_cast<double>(line_.text.data() - text_.data()) / static_cast<double>(text_.size())});
        }
        if (supply_ && line_.text.data() - letGo_ > letGoBytes) {
            supply_->letGo(letGo_, line_.text.data());
            letGo_ = line_.text.data();
        }
        isLeftOut_ = false;
        if (!readPlainRow() && !readAnyRow()) return false;
        if (!isLeftOut_ && !isAtEnd_) table().lines.push_back(line_.number);
        return true;
    }

    /// The fast way: unquoted finite numbers, stamps and words. False, and nothing kept, for anything else.
    bool readPlainRow() {
        if (separator_ == ' ') return false;
        const char* at = line_.text.data();
        const char* const end = at + line_.text.size();
        const std::size_t count = table().columns.size();
        cells_.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            while (at != end && *at == ' ') ++at;
            at = readPlainCell(i, at, end);
            if (!at) return false;
            while (at != end && *at == ' ') ++at;
            const bool isLast = i + 1 == count;
            while (isLast && at != end && (*at == separator_ || *at == ' ')) ++at;  // empty cells behind the last one
            if (isLast ? at != end : at == end || *at != separator_) return false;
            ++at;
        }
        for (std::size_t i = 0; i < count; ++i) keepPlainCell(i);
        return true;
    }

    /// Where the cell ends; null: it takes a closer look.
    const char* readPlainCell(std::size_t index, const char* at, const char* end) {
        PlainCell& cell = cells_[index];
        const CellKind kind = raw_.kinds[index];
        // the first mark decides what marks mean: by the slow way
        if (kind == CellKind::Number || kind == CellKind::Blank)
            return readPlainNumber(at, end, decimal_.value_or('\0'), cell.number);
        if (kind == CellKind::Quantity || at == end || *at == '"') return nullptr;
        const void* const mark = std::memchr(at, separator_, static_cast<std::size_t>(end - at));
        const char* const stop = mark ? static_cast<const char*>(mark) : end;
        cell.text = withoutBlanks({at, static_cast<std::size_t>(stop - at)});
        if (cell.text.empty()) return nullptr;
        if (kind == CellKind::Stamp) {
            const std::optional<Stamp> stamp = readStampBy(cell.text, options_.timeFormat);
            if (!stamp) return nullptr;
            cell.stamp = *stamp;
        }
        return stop;
    }

    void keepPlainCell(std::size_t index) {
        const CellKind kind = raw_.kinds[index];
        if (kind == CellKind::Stamp)
            keepStamp(index, cells_[index].stamp, cells_[index].text);
        else if (kind == CellKind::Words)
            raw_.words[index].push(inUtf8(cells_[index].text));
        else
            table().columns[index].values.push_back(cells_[index].number);
    }

    void keepStamp(std::size_t index, const Stamp& stamp, std::string_view text) {
        if (raw_.firstStamps[index].empty()) raw_.firstStamps[index] = text;
        raw_.stamps[index].push_back(stamp);
    }

    bool readAnyRow() {
        CsvRow row = splitCsvRow(line_.text, separator_);
        if (row.openQuote)
            return fault(phrase("a quotation mark is opened and not closed on its line"), line_.number, row.openQuote,
                         phrase("Close it, or double it where the mark itself is meant."), line_.text);
        const std::size_t count = table().columns.size();
        while (row.cells.size() > count && row.cells.back().text.empty()) row.cells.pop_back();
        if (row.cells.size() > count && row.cells.size() <= count + layout_.remarks) row.cells.resize(count);
        if (row.cells.size() < count && layout_.arePadded && !isWordAlone(row))
            row.cells.resize(count, {"", static_cast<int>(line_.text.size()) + 1, false});
        if (row.cells.size() != count) {
            if ((isWordAlone(row) && isEndOfText()) || isFooter(row)) return isAtEnd_ = true;
            return ragged(row);
        }
        if (isEmptyRow(row)) return isLeftOut_ = true;
        if (isFooter(row)) return isAtEnd_ = true;
        for (std::size_t i = 0; i < count; ++i)
            if (!readCellOf(i, row.cells[i])) return false;
        return true;
    }

    static bool isEmptyRow(const CsvRow& row) {
        return row.cells.size() > 1 &&
               std::all_of(row.cells.begin(), row.cells.end(), [](const CsvCell& cell) { return cell.text.empty(); });
    }

    /// "2s" is none in a column of quantities.
    bool beginsWithWord(const CsvRow& row) const {
        const std::string& text = row.cells.front().text;
        const bool isQuantity = raw_.kinds.front() == CellKind::Quantity && readQuantity(text, true);
        return kindOf(text) == CellKind::Words && !isQuantity;
    }

    /// "EOF" below a table.
    bool isWordAlone(const CsvRow& row) const {
        const auto told =
            std::count_if(row.cells.begin(), row.cells.end(), [](const CsvCell& c) { return !c.text.empty(); });
        return table().columns.size() > 1 && told == 1 && beginsWithWord(row);
    }

    bool isEndOfText() {
        constexpr std::size_t most = 20;
        LineReader ahead = lines_;
        std::size_t count = 0;
        for (TextLine line; ahead.next(line);) {
            if (isEmptyLine(line.text)) continue;
            if (++count > most || !isWordAlone(splitCsvRow(line.text, separator_))) return false;
        }
        return true;
    }

    /// Rows of another table ("Min,0.1"): words in front to the end of the text, over numbers; more than one row, or
    /// behind an empty line.
    bool isFooter(const CsvRow& first) {
        constexpr std::size_t most = 20;
        if (table().lines.empty() || raw_.kinds.front() == CellKind::Words || !beginsWithWord(first)) return false;
        LineReader ahead = lines_;
        std::size_t count = 0;
        for (TextLine line; ahead.next(line);)
            if (!isEmptyLine(line.text) && (++count > most || !beginsWithWord(splitCsvRow(line.text, separator_))))
                return false;
        if (!isBehindGap_ && count == 0) return false;  // one row may be one that is damaged
        warnings_.push_back(asWarning(
            fileError(phrase("the lines from here on are no rows of the table and are left out: '{}' stands in front",
                             cited(first.cells.front().text)),
                      table().file, line_.number)));
        return true;
    }

    bool readCellOf(std::size_t index, const CsvCell& cell) {
        CellKind& kind = raw_.kinds[index];
        if (kind == CellKind::Blank && !cell.text.empty()) {
            const CellKind found = kindOf(cell.text);
            if (found == CellKind::Words || found == CellKind::Stamp) begin(index, found);
        }
        switch (kind) {
            case CellKind::Stamp:
                return readStampCell(index, cell);
            case CellKind::Words:
                if (cell.text.empty())
                    raw_.words[index].pushEmpty();
                else
                    raw_.words[index].push(inUtf8(cell.text));
                return true;
            case CellKind::Quantity:
                return readQuantityCell(index, cell);
            default:
                return readNumberCell(index, cell);
        }
    }

    /// A column that was empty so far holds something else than numbers.
    void begin(std::size_t index, CellKind kind) {
        Column& column = table().columns[index];
        if (column.values.size() > column.blanks.size()) return;
        raw_.kinds[index] = kind;
        for (std::size_t row = 0; row < column.values.size(); ++row)
            if (kind == CellKind::Words)
                raw_.words[index].pushEmpty();
            else
                raw_.stamps[index].push_back({});
        column.values.clear();
        column.blanks.clear();
    }

    bool readStampCell(std::size_t index, const CsvCell& cell) {
        StampSeries& stamps = raw_.stamps[index];
        const std::optional<Stamp> stamp = readStampBy(cell.text, options_.timeFormat);
        if (!stamp && kindOf(cell.text) == CellKind::Blank) {
            stamps.push_back({});
            return true;
        }
        if (!stamp)
            return fault(
                phrase("'{}' in column '{}' is no date or clock", cited(cell.text), cited(table().columns[index].name)),
                line_.number, cell.position,
                phrase("Say how they are written in the study: \"read\": {{\"time_format\": \"%d.%m.%Y "
                       "%H:%M:%S\"}}."),
                line_.text);
        keepStamp(index, *stamp, cell.text);
        return true;
    }

    bool readQuantityCell(std::size_t index, const CsvCell& cell) {
        const std::optional<QuantityText> quantity = readQuantity(cell.text, true);
        Column& column = table().columns[index];
        if (!quantity) {
            if (kindOf(cell.text) == CellKind::Blank) return readNumberCell(index, cell);
            return fault(phrase("'{}' in column '{}' is no number with a unit, as the cells above it", cited(cell.text),
                                cited(column.name)),
                         line_.number, cell.position, phrase("Write the unit in the header and numbers in the cells."),
                         line_.text);
        }
        const std::string unit = inUtf8(quantity->unit);
        if (column.unit.empty()) column.unit = unit;
        CsvCell number = cell;
        number.text = std::string(quantity->number);
        if (!readNumberCell(index, number)) return false;
        if (unit == column.unit) return true;
        const Outcome<UnitConversion> convert = convertUnit(unit, column.unit);
        if (!convert)
            return fault(phrase("the cells of column '{}' are in '{}' and in '{}'", cited(column.name),
                                cited(column.unit), cited(unit)),
                         line_.number, cell.position, phrase("Export the column in one unit."), line_.text);
        column.values.back() = (*convert)(column.values.back());
        return true;
    }

    bool readNumberCell(std::size_t index, const CsvCell& cell) {
        if (!decimal_ && !decideMark(cell)) return false;
        CellValue value = readCell(cell.text, decimal_.value_or('.'), thousands_);
        if (value.kind == CellValue::Kind::Text && thousands_ == 0) value = withThousands(cell);
        Column& column = table().columns[index];
        if (value.kind == CellValue::Kind::Text) return notANumber(cell, column.name);
        if (value.kind != CellValue::Kind::Number)
            column.blanks.push_back({static_cast<std::uint32_t>(column.values.size()), cell.position});
        if (value.kind == CellValue::Kind::Beyond) raw_.beyond[index].push_back(line_.number);
        column.values.push_back(value.value);
        return true;
    }

    /// The first number with a mark says what marks mean; where it says nothing it is asked.
    bool decideMark(const CsvCell& cell) {
        using Mark = NumberShape::Mark;
        if (cell.text.find_first_of(".,") == std::string::npos) return true;
        const NumberShape shape = shapeOf(cell.text);
        if (!shape.isNumber) return true;
        const bool isOpen = shape.decimal == Mark::OpenPoint || shape.decimal == Mark::OpenComma;
        if (isOpen && separator_ != ',') {
            faults_ = {openMark(cell, line_.number, options_, table().file, asked_)};
            return false;
        }
        if (shape.decimal != Mark::None)
            setDecimal(shape.decimal == Mark::Point || shape.decimal == Mark::OpenPoint ? '.' : ',');
        return true;
    }

    void setDecimal(char mark) {
        decimal_ = mark;
        decimalLine_ = line_.number;
    }

    /// A mark between thousands that comes up only here, and can mean nothing else.
    CellValue withThousands(const CsvCell& cell) {
        const NumberShape shape = shapeOf(cell.text);
        if (!shape.isNumber || shape.thousands == 0 || shape.thousands == decimal_) return {};
        const CellValue value = readCell(cell.text, decimal_.value_or('.'), shape.thousands);
        if (value.kind == CellValue::Kind::Number) thousands_ = raw_.thousands = shape.thousands;
        return value;
    }

    bool ragged(const CsvRow& row) {
        const std::size_t expected = table().columns.size();
        const std::size_t found = row.cells.size();
        const int position = found > expected ? row.cells[expected].position : static_cast<int>(line_.text.size()) + 1;
        return fault(found == 1 ? phrase("this row has one cell, the header has {}", expected)
                                : phrase("this row has {} cells, the header has {}", found, expected),
                     line_.number, position, hintOfLength(found, expected, layout_, lines_), line_.text);
    }

    bool notANumber(const CsvCell& cell, const std::string& column) {
        const char other = decimal_ == ',' ? '.' : ',';
        if (decimal_ && isNumeric(cell.text) && readCell(cell.text, other).kind != CellValue::Kind::Text)
            return fault(other == ',' ? phrase("'{}' in column '{}' has a decimal comma, line {} has a decimal point",
                                               cited(cell.text), cited(column), decimalLine_)
                                      : phrase("'{}' in column '{}' has a decimal point, line {} has a decimal comma",
                                               cited(cell.text), cited(column), decimalLine_),
                         line_.number, cell.position, phrase("Write the whole file with one decimal mark."),
                         line_.text);
        return fault(phrase("'{}' in column '{}' is not a number", shortened(cell.text, 60), cited(column)),
                     line_.number, cell.position, hintOfWord(cell.text, layout_, isBehindGap_, lines_), line_.text);
    }

    void finish() {
        Diagnostics told = tidyColumns(raw_);
        warnings_.insert(warnings_.end(), told.begin(), told.end());
        if (raw_.thousands != 0)
            warnings_.push_back(asWarning(fileError(
                phrase("'{}' is read as a mark between thousands", std::string(1, raw_.thousands)), table().file)));
    }

    std::string_view text_;
    TextSupply* supply_;
    const char* letGo_{text_.data()};  // of the text in front of it
    LineReader lines_;
    TextLine line_;
    bool hasLine_{}, isAtEnd_{}, isLeftOut_{}, isBehindGap_{};
    char separator_{','};
    std::optional<char> decimal_;
    char thousands_{};
    int decimalLine_{};
    const Layout& layout_;
    const ReadOptions& options_;
    const Progress& progress_;
    Questions& asked_;
    RawTable raw_;
    std::vector<PlainCell> cells_;
    Diagnostics faults_, warnings_;
};

}  // namespace

Outcome<RawTable> readRows(TextView text, const std::string& name, const Layout& layout, const ReadOptions& options,
                           const Progress& progress, Questions& asked) {
    return RowReader(text, name, layout, options, progress, asked).read();
}

}  // namespace analogon
