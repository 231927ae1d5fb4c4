#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <unordered_map>

#include "core/base/file_fault.hpp"
#include "core/base/limits.hpp"
#include "core/base/regular_file.hpp"
#include "core/base/stop.hpp"
#include "core/base/unit.hpp"
#include "core/base/visible.hpp"
#include "core/measure/column_header.hpp"
#include "core/measure/csv_dialect.hpp"
#include "core/measure/encoding.hpp"
#include "core/measure/table.hpp"

namespace analogon {

namespace {

struct Line {
    std::string_view text;
    int number{};  // 1-based
};

/// Takes lines off a text whose lines end with CR, LF or CRLF.
class LineReader {
public:
    explicit LineReader(std::string_view text) : rest_(text) {}

    bool next(Line& line) {
        if (rest_.empty()) return false;
        const char* const begin = rest_.data();
        const char* const end = begin + rest_.size();
        const char* stop = static_cast<const char*>(std::memchr(begin, '\n', rest_.size()));
        if (!stop) stop = end;
        if (const void* const cr = std::memchr(begin, '\r', static_cast<std::size_t>(stop - begin)))
            stop = static_cast<const char*>(cr);
        line = {std::string_view(begin, static_cast<std::size_t>(stop - begin)), ++number_};
        if (stop != end) ++stop;
        if (stop != end && stop[-1] == '\r' && *stop == '\n') ++stop;
        rest_ = std::string_view(stop, static_cast<std::size_t>(end - stop));
        return true;
    }

private:
    std::string_view rest_;
    int number_{};
};

bool isComment(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos) return false;
    line.remove_prefix(first);
    return line.front() == '#' || line.front() == '%' || line.starts_with("//");
}

bool isEmpty(std::string_view line) { return line.find_first_not_of(" \t\"") == std::string_view::npos; }

/// Reads one file. The steps follow the file from top to bottom.
class CsvReader {
    static constexpr std::size_t shownBehind = 1024;  // bytes of a line behind the place of a fault

public:
    CsvReader(std::string_view text, const std::string& name, const CsvOptions& options)
        : text_(text), lines_(text), decimal_(options.decimal), options_(options) {
        table_.file = name;
    }

    Outcome<Table> read() {
        if (text_.substr(0, 4096).find('\0') != std::string_view::npos)
            return fileError(phrase("this is not a text file"), table_.file, 1, 0,
                             phrase("Export the measurement as comma-separated values."));
        findDialect();
        if (!readHeader() || !hasMemory()) return faults_;
        reserve();
        while (hasLine_) {
            if (!isEmpty(line_.text) && !isComment(line_.text) && !readRow()) return faults_;
            advance();
        }
        if (table_.rows() == 0)
            return fileError(phrase("the file has a header and no data rows"), table_.file, headerLine_, 0,
                             phrase("Check that the recording was exported with its values."));
        dropEmptyLastColumn();
        return {std::move(table_), std::move(warnings_)};
    }

private:
    void advance() { hasLine_ = lines_.next(line_); }

    bool fault(Text message, int line, int position, Text hint, std::string_view lineText = {}) {
        Diagnostic diagnostic = fileError(std::move(message), table_.file, line, position, std::move(hint));
        // as much of the line as is shown around the place
        const auto reach = static_cast<std::size_t>(std::max(position, 0)) + shownBehind;
        diagnostic.place.lineText = std::string(lineText.substr(0, reach));
        diagnostic.place.length = 1;
        faults_ = {std::move(diagnostic)};
        return false;
    }

    void findDialect() {
        constexpr std::size_t sampled = 30;
        std::vector<std::string_view> sample;
        LineReader reader(text_);
        for (Line line; sample.size() < sampled && reader.next(line);) {
            if (isEmpty(line.text) || isComment(line.text)) continue;
            if (sample.empty() && line.text.starts_with("sep=") && line.text.size() == 5) {
                if (!options_.separator) options_.separator = line.text[4];  // as spreadsheets write it
                separatorLine_ = line.number;
                continue;
            }
            sample.push_back(line.text);
        }
        separator_ = options_.separator ? *options_.separator : detectSeparator(sample);
    }

    /// The header, commented or not, and the units row. Leaves line_ at the first data row.
    bool readHeader() {
        Line comment;
        for (advance(); hasLine_; advance()) {
            stopPoint();
            if (isComment(line_.text)) comment = line_;
            const bool skipped = isEmpty(line_.text) || isComment(line_.text) || line_.number == separatorLine_;
            if (!skipped) break;
        }
        if (!hasLine_)
            return fault(phrase("the file is empty"), 0, 0,
                         phrase("Check that the recording was exported with its values."));
        CsvRow row = split(line_);
        if (row.openQuote) return openQuote(row);
        headerLine_ = line_.number;
        const auto isText = [](const CsvCell& cell) { return !isNumeric(cell.text); };
        if (!isWithinLimits(row)) return false;
        if (std::any_of(row.cells.begin(), row.cells.end(), isText)) {
            nameColumns(row);
            advance();
            return readUnitsRow();
        }
        if (comment.number > 0) {
            // Some programs write the header as the last comment: "# t, u".
            const std::size_t first = comment.text.find_first_not_of(" \t#%/");
            const CsvRow commented = split({comment.text.substr(std::min(first, comment.text.size())), comment.number});
            if (commented.cells.size() == row.cells.size() &&
                std::all_of(commented.cells.begin(), commented.cells.end(), isText)) {
                headerLine_ = comment.number;
                nameColumns(commented);
                return true;
            }
        }
        for (std::size_t i = 0; i < row.cells.size(); ++i)
            table_.columns.push_back({fmt::format("c{}", i + 1), "", {}, {}});
        warnings_.push_back(asWarning(fileError(
            phrase("the file has no header"), table_.file, line_.number, 0,
            phrase("Its columns are called {} to {}.", table_.columns.front().name, table_.columns.back().name))));
        return true;
    }

    /// What a header of these cells would make of the file.
    bool isWithinLimits(const CsvRow& header) {
        if (header.cells.size() > limits::columns)
            return fault(phrase("the header has {} columns, more than {}", header.cells.size(), limits::columns),
                         line_.number, 0, phrase("Export fewer channels, or check the mark between the columns."));
        for (const CsvCell& cell : header.cells)
            if (cell.text.size() > limits::columnName)
                return fault(phrase("a column has a name of {} bytes, more than {}: '{}'", cell.text.size(),
                                    limits::columnName, quoted(cell.text)),
                             line_.number, cell.position, phrase("Check the mark between the columns."));
        return true;
    }

    static std::string quoted(std::string_view text) { return shortened(text, limits::quotedBytes); }

    CsvRow split(const Line& line) const {
        CsvRow row = splitCsvRow(line.text, separator_);
        for (CsvCell& cell : row.cells)
            if (!isUtf8(cell.text)) cell.text = latin1ToUtf8(cell.text);
        return row;
    }

    bool openQuote(const CsvRow& row) {
        return fault(phrase("a quotation mark is opened and not closed on its line"), line_.number, row.openQuote,
                     phrase("Close it, or double it where the mark itself is meant."), line_.text);
    }

    void nameColumns(const CsvRow& row) {
        constexpr std::size_t shownRenamed = 5;
        std::size_t renamed = 0;
        std::unordered_map<std::string, int> taken;
        for (const CsvCell& cell : row.cells) {
            ColumnHeader header = readColumnHeader(cell.text);
            if (header.name.empty()) header.name = fmt::format("c{}", table_.columns.size() + 1);
            const std::string wanted = header.name;
            for (int count = ++taken[wanted]; count > 1; ++count) {
                header.name = fmt::format("{}_{}", wanted, count);
                if (!taken.contains(header.name)) break;
            }
            if (header.name != wanted) {
                ++taken[header.name];
                if (++renamed <= shownRenamed) tellRenamed(wanted, header.name, cell.position);
            }
            table_.columns.push_back(
                {std::move(header.name), std::move(header.unit), {}, {}, cell.text, headerLine_, cell.position});
        }
        if (renamed > shownRenamed)
            warnings_.push_back(asWarning(fileError(
                phrase("{} further columns have the name of another one", renamed - shownRenamed), table_.file,
                headerLine_, 0, phrase("They are called by that name and a number behind it."))));
    }

    void tellRenamed(const std::string& wanted, const std::string& name, int position) {
        warnings_.push_back(
            asWarning(fileError(phrase("there are several columns named '{}'", quoted(wanted)), table_.file,
                                headerLine_, position, phrase("This one is called '{}' here.", quoted(name)))));
    }

    bool readUnitsRow() {
        if (options_.hasUnitsRow && !*options_.hasUnitsRow) return true;
        while (hasLine_ && (isEmpty(line_.text) || isComment(line_.text))) advance();
        if (!hasLine_) return true;
        const CsvRow row = split(line_);
        if (row.openQuote) return openQuote(row);
        if (!(options_.hasUnitsRow && *options_.hasUnitsRow) && !isUnitsRow(row)) return true;
        if (row.cells.size() > table_.columns.size()) return ragged(row);
        for (std::size_t i = 0; i < row.cells.size(); ++i)
            if (const std::string unit = readUnitCell(row.cells[i].text); !unit.empty()) table_.columns[i].unit = unit;
        advance();
        return true;
    }

    /// No measured value, and at least one unit that is known; "1" and "-" stand for no dimension.
    static bool isUnitsRow(const CsvRow& row) {
        bool oneKnown = false;
        for (const CsvCell& cell : row.cells) {
            const std::string unit = readUnitCell(cell.text);
            const bool isBare = unit.empty() || unit == "1" || unit == "-";
            if (!isBare && isNumeric(unit)) return false;
            oneKnown = oneKnown || (!isBare && isKnownUnit(unit));
        }
        return oneKnown;
    }

    /// Whether there is memory for the numbers, by the length of the first row; a number takes two bytes at least.
    bool hasMemory() {
        if (!hasLine_) return true;
        const double left = static_cast<double>(text_.data() + text_.size() - line_.text.data());
        const double rows = std::max(1.0, left / static_cast<double>(line_.text.size() + 1));
        const double cells = std::min(rows * static_cast<double>(table_.columns.size()), left / 2);
        const Outcome<Done> enough =
            limits::checkMemory(phrase("the table of {:.3g} rows and {} columns", rows, table_.columns.size()),
                                8 * cells + static_cast<double>(text_.size()));
        if (enough) return true;
        faults_ = enough.diagnostics();
        faults_.front().place.file = table_.file;
        return false;
    }

    void reserve() {
        if (!hasLine_) return;
        const auto left = static_cast<std::size_t>(text_.data() + text_.size() - line_.text.data());
        const std::size_t rows = std::min<std::size_t>(left / (line_.text.size() + 1) * 11 / 10 + 16, 1u << 24);
        if (rows * table_.columns.size() > (1u << 28)) return;
        for (Column& column : table_.columns) column.values.reserve(rows);
        table_.lines.reserve(rows);
    }

    bool readRow() {
        if (table_.lines.size() >= limits::rows)
            return fault(phrase("the file has more than {} rows", limits::rows), line_.number, 0,
                         phrase("Split the recording, or record fewer samples a second."));
        if (!readPlainRow() && !readAnyRow()) return false;
        table_.lines.push_back(line_.number);
        return true;
    }

    /// The fast way: unquoted finite numbers with a decimal point. False, and nothing kept, for anything else.
    bool readPlainRow() {
        if (decimal_ == ',' || separator_ == ' ') return false;
        const char* at = line_.text.data();
        const char* const end = at + line_.text.size();
        const std::size_t count = table_.columns.size();
        numbers_.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            while (at != end && *at == ' ') ++at;
            const auto [stop, code] = std::from_chars(at, end, numbers_[i]);
            if (code != std::errc{} || !std::isfinite(numbers_[i])) return false;
            if (!decimal_ && std::memchr(at, '.', static_cast<std::size_t>(stop - at))) setDecimal('.');
            at = stop;
            while (at != end && *at == ' ') ++at;
            const bool isLast = i + 1 == count;
            if (isLast ? at != end : at == end || *at != separator_) return false;
            ++at;
        }
        for (std::size_t i = 0; i < count; ++i) table_.columns[i].values.push_back(numbers_[i]);
        return true;
    }

    void setDecimal(char mark) {
        decimal_ = mark;
        decimalLine_ = line_.number;
    }

    bool readAnyRow() {
        CsvRow row = splitCsvRow(line_.text, separator_);
        if (row.openQuote) return openQuote(row);
        while (row.cells.size() > table_.columns.size() && row.cells.back().text.empty()) row.cells.pop_back();
        if (row.cells.size() != table_.columns.size()) return ragged(row);
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            const CsvCell& cell = row.cells[i];
            if (!decimal_ && isNumeric(cell.text)) {
                if (cell.text.find('.') != std::string::npos && cell.text.find('#') == std::string::npos) {
                    setDecimal('.');
                } else if (cell.text.find(',') != std::string::npos) {
                    setDecimal(',');
                }
            }
            const CellValue value = readCell(cell.text, decimal_.value_or('.'));
            if (value.kind == CellValue::Kind::Text) return notANumber(cell, table_.columns[i].name);
            Column& column = table_.columns[i];
            if (value.kind != CellValue::Kind::Number)
                column.blanks.push_back({static_cast<std::uint32_t>(column.values.size()), cell.position});
            column.values.push_back(value.value);
        }
        return true;
    }

    bool ragged(const CsvRow& row) {
        const std::size_t expected = table_.columns.size();
        const std::size_t found = row.cells.size();
        const int position = found > expected ? row.cells[expected].position : static_cast<int>(line_.text.size()) + 1;
        Text hint = phrase("Every row needs one cell for each column of the header.");
        if (separator_ == ',' && found > expected)
            hint += phrase(" If the commas are decimal marks, the columns must be separated by ; or a tab.");
        return fault(found == 1 ? phrase("this row has one cell, the header has {}", expected)
                                : phrase("this row has {} cells, the header has {}", found, expected),
                     line_.number, position, std::move(hint), line_.text);
    }

    bool notANumber(const CsvCell& cell, const std::string& column) {
        const char other = decimal_ == ',' ? '.' : ',';
        if (decimal_ && isNumeric(cell.text) && readCell(cell.text, other).kind != CellValue::Kind::Text)
            return fault(other == ',' ? phrase("'{}' in column '{}' has a decimal comma, line {} has a decimal point",
                                               quoted(cell.text), quoted(column), decimalLine_)
                                      : phrase("'{}' in column '{}' has a decimal point, line {} has a decimal comma",
                                               quoted(cell.text), quoted(column), decimalLine_),
                         line_.number, cell.position, phrase("Write the whole file with one decimal mark."),
                         line_.text);
        Text hint = phrase("Only numbers can be read; leave the cell of an output empty where it was not measured.");
        if (cell.text.find(',') != std::string::npos && cell.text.find('.') != std::string::npos)
            hint = phrase("Marks between thousands cannot be read: write 1234.5.");
        return fault(phrase("'{}' in column '{}' is not a number", shortened(cell.text, 60), quoted(column)),
                     line_.number, cell.position, std::move(hint), line_.text);
    }

    /// Rows that all end with a separator have one column too many, without a name.
    void dropEmptyLastColumn() {
        const Column& last = table_.columns.back();
        const bool isUnnamed = last.name == fmt::format("c{}", table_.columns.size()) && last.unit.empty();
        if (table_.columns.size() > 1 && isUnnamed && last.blanks.size() == last.values.size())
            table_.columns.pop_back();
    }

    std::string_view text_;
    LineReader lines_;
    Line line_;
    bool hasLine_{};
    char separator_{','};
    int separatorLine_{};
    std::optional<char> decimal_;
    int decimalLine_{};
    int headerLine_{};
    CsvOptions options_;
    Table table_;
    std::vector<double> numbers_;
    Diagnostics faults_, warnings_;
};

}  // namespace

Outcome<Table> readCsvText(std::string_view text, const std::string& name, const CsvOptions& options) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        const std::string decoded = decodeText(text);
        return CsvReader(decoded, name, options).read();
    }
    return CsvReader(text, name, options).read();
}

Outcome<Table> readCsv(const std::filesystem::path& file, const CsvOptions& options) {
    const Outcome<std::string> bytes = readRegularFile(file);
    if (!bytes) return bytes.diagnostics();
    return readCsvText(*bytes, file.string(), options);
}

}  // namespace analogon
