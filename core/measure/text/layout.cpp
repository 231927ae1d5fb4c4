#include "core/measure/text/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "core/base/file_fault.hpp"
#include "core/base/limits.hpp"
#include "core/base/unit.hpp"
#include "core/measure/column_header.hpp"
#include "core/measure/text/header_rows.hpp"
#include "core/measure/text/remark.hpp"
#include "core/measure/text/time_format.hpp"
#include "core/measure/time_name.hpp"

namespace analogon {

namespace {

bool namesRemarks(std::string_view name) {
    constexpr std::array<std::string_view, 10> names{"comment", "comments",  "remark",     "remarks",   "note",
                                                     "notes",   "kommentar", "kommentare", "bemerkung", "bemerkungen"};
    return std::find(names.begin(), names.end(), plainKey(name)) != names.end();
}

/// Words in a row of units that say what the cells hold and are no unit.
bool namesNoUnit(std::string_view word) {
    constexpr std::array<std::string_view, 14> words{"value",  "values", "wert",   "werte",  "text",
                                                     "string", "number", "signal", "double", "float64",
                                                     "uint16", "int16",  "bool",   "boolean"};
    return std::find(words.begin(), words.end(), plainKey(word)) != words.end();
}

class LayoutFinder {
public:
    LayoutFinder(TextView text, const std::string& file, const ReadOptions& options, Questions& asked,
                 const UnframedText* unframed)
        : text_(text), file_(file), options_(options), asked_(asked), unframed_(unframed) {}

    Outcome<Layout> find() {
        if (Diagnostics faults = sample(); !faults.empty()) return faults;
        if (areChannelsInRows(rows_))
            return fileError(phrase("the channels of this table stand in rows"), file_, 1, 0,
                             phrase("Turn it round, so that each channel is a column with its name on top."));
        header_ = findHeader(rows_, options_);
        dropKeyOfNames();
        if (Diagnostics faults = checkHeader(); !faults.empty()) return faults;
        layout_.separator = rows_.separator;
        const Outcome<NumberMarks> marks = numberMarks(rows_, options_, file_, asked_);
        if (!marks) return marks.diagnostics();
        layout_.marks = *marks;
        nameColumns();
        readPreamble();
        tellKinds();
        if (std::all_of(layout_.columns.begin(), layout_.columns.end(),
                        [](const LayoutColumn& column) { return column.kind == CellKind::Words; }))
            return noNumbers();
        addUnits();
        addDescriptions();
        findData();
        return std::move(layout_);
    }

private:
    Diagnostics sample() {
        constexpr std::size_t few = 300, many = 20'000, enough = 20;
        TextHead head = headOf(text_, options_, few);
        if (head.lines.empty())
            return {fileError(phrase("the file is empty"), file_, 0, 0,
                              phrase("Check that the recording was exported with its values."))};
        rows_ = sampledRows(head);
        const bool isShort = rows_.isKeyed || (rows_.end - rows_.begin < enough && rows_.end < rows_.rows.size());
        if (!head.isWhole && (rows_.score <= 0 || isShort)) rows_ = sampledRows(headOf(text_, options_, many));
        for (const SampleRow& row : rows_.rows)
            if (Diagnostics faults = tooWide(row, file_); !faults.empty()) return faults;
        if (rows_.otherBegin > 0 && !options_.header) {
            askWhichTable();
            return {
                fileError(phrase("the lines {} to {} are a table of the same shape as the one below: there are two "
                                 "recordings in this file",
                                 rows_.otherBegin, rows_.otherEnd),
                          file_, rows_.otherBegin, 0,
                          phrase("Split the file; or leave the first one out in the study: \"read\": {{\"skip\": {}}}.",
                                 rows_.otherEnd))};
        }
        if (options_.header) {
            rows_.begin = std::min(*options_.header, rows_.rows.size());
            rows_.end = rows_.rows.size();
        } else if (rows_.score <= 0) {
            if (rows_.rows.size() > 1 && rows_.rows[0].cells.size() != rows_.rows[1].cells.size()) return {noNumbers()};
            rows_.begin = std::min<std::size_t>(1, rows_.rows.size());
            rows_.end = rows_.rows.size();
        }
        return {};
    }

    void askWhichTable() {
        Reading last{phrase("the one below line {}", rows_.otherEnd), options_};
        last.options.skip = static_cast<std::size_t>(rows_.otherEnd);
        asked_.push_back({Question::Kind::Choice,
                          phrase("There are two recordings in this file. Which one is meant?"),
                          rows_.otherEnd + 1,
                          {std::move(last)}});
    }

    Diagnostic noNumbers() const {
        return fileError(phrase("no rows of numbers are found in this text"), file_, 0, 0,
                         phrase("Is it a measurement? If it is, tell the study how it is written: \"read\": "
                                "{{\"separator\": …, \"decimal\": …, \"skip\": lines before the header}}."));
    }

    Diagnostics checkHeader() const {
        if (!header_.names) return {};
        const SampleRow& names = *header_.names;
        if (names.openQuote)
            return {fileError(phrase("a quotation mark is opened and not closed on its line"), file_, names.line.number,
                              names.openQuote, phrase("Close it, or double it where the mark itself is meant."))};
        if (Diagnostics faults = tooWide(names, file_); !faults.empty()) return faults;
        for (const CsvCell& cell : names.cells)
            if (cell.text.size() > limits::columnName)
                return {fileError(phrase("a column has a name of {} bytes, more than {}: '{}'", cell.text.size(),
                                         limits::columnName, cited(cell.text)),
                                  file_, names.line.number, cell.position,
                                  phrase("Check the mark between the columns."))};
        return {};
    }

    /// "TraceName,CH1,CH2" over rows of two numbers with a mark behind the last one: the word in front is a key, as
    /// those of the rows beside it are.
    void dropKeyOfNames() {
        const auto isLonger = [this](const SampleRow& row) { return row.filled == width() + 1; };
        if (!header_.names || !isLonger(*header_.names) || !isKeyOfNames(header_.names->cells.front().text) ||
            std::none_of(header_.keys.begin(), header_.keys.end(), isLonger))
            return;
        const auto drop = [](SampleRow& row) {
            row.cells.erase(row.cells.begin());
            row.kinds.erase(row.kinds.begin());
            --row.filled;
        };
        drop(*header_.names);
        if (header_.units && isLonger(*header_.units)) drop(*header_.units);
        for (SampleRow& row : header_.descriptions)
            if (isLonger(row)) drop(row);
    }

    std::size_t width() const { return std::max<std::size_t>(widest(rows_), 1); }

    void nameColumns() {
        if (!header_.names) {
            for (std::size_t i = 0; i < width(); ++i) layout_.columns.push_back({fmt::format("c{}", i + 1)});
            return;
        }
        const SampleRow& names = *header_.names;
        layout_.headerLine = names.line.number;
        std::size_t count = std::max(names.filled, std::min(width(), names.cells.size()));
        // a column of remarks in which nothing stands may have no cells in the rows
        for (; count > width() && rows_.begin < rows_.end && namesRemarks(names.cells[count - 1].text); --count)
            ++layout_.remarks;
        for (std::size_t i = 0; i < count; ++i) {
            const CsvCell& cell = names.cells[i];
            ColumnHeader header = readColumnHeader(cell.text);
            if (header.name.empty()) header.name = fmt::format("c{}", i + 1);
            layout_.columns.push_back({std::move(header.name),
                                       std::move(header.unit),
                                       {},
                                       cell.text,
                                       names.line.number,
                                       cell.position,
                                       CellKind::Blank});
        }
        keepPaths();
        makeNamesDiffer();
    }

    /// "T/degC" without brackets or blanks, which may be a place and a name as well ("Motor/T").
    static bool isSplitAtSlash(const LayoutColumn& column) {
        return !column.unit.empty() && column.header.size() == column.name.size() + 1 + column.unit.size() &&
               column.header[column.name.size()] == '/' && column.header.starts_with(column.name) &&
               column.header.ends_with(column.unit);
    }

    static void joinAtSlash(LayoutColumn& column) {
        column.name = column.header;
        column.unit.clear();
    }

    /// A head as DIN 1313 has it, "t/s | u/mV | i/A": a quantity by its unit in every column, the time among them.
    /// "t/s" alone would be tonnes by seconds.
    bool readQuotients() {
        bool hasTime = false;
        for (const LayoutColumn& column : layout_.columns) {
            const std::size_t slash = column.header.find('/');
            if (slash == std::string::npos || slash == 0 || column.header.find('/', slash + 1) != std::string::npos)
                return false;
            const std::string unit = column.header.substr(slash + 1);
            if (!isKnownUnit(unit)) return false;
            hasTime = hasTime || (namesTime(column.header.substr(0, slash)) && areConvertible(unit, "s"));
        }
        if (!hasTime) return false;
        for (LayoutColumn& column : layout_.columns) {
            column.name = column.header.substr(0, column.header.find('/'));
            column.unit = column.header.substr(column.name.size() + 1);
        }
        return true;
    }

    /// Where one place has several names, or a name behind a slash is no unit, none of them is one.
    void keepPaths() {
        if (readQuotients()) return;
        std::unordered_map<std::string, int> places;
        bool arePaths = false;
        for (const LayoutColumn& column : layout_.columns) {
            if (isSplitAtSlash(column))
                arePaths = ++places[column.name] > 1 || arePaths;
            else if (column.unit.empty() && column.name == column.header && !isKnownUnit(column.name))
                arePaths = column.name.find('/') != std::string::npos || arePaths;
        }
        for (LayoutColumn& column : layout_.columns)
            if (arePaths && isSplitAtSlash(column)) joinAtSlash(column);
    }

    void makeNamesDiffer() {
        constexpr std::size_t shownRenamed = 5;
        std::size_t renamed = 0;
        std::unordered_map<std::string, int> taken;
        for (LayoutColumn& column : layout_.columns) {
            const std::string wanted = column.name;
            for (int count = ++taken[wanted]; count > 1; ++count) {
                column.name = fmt::format("{}_{}", wanted, count);
                if (!taken.contains(column.name)) break;
            }
            if (column.name == wanted) continue;
            ++taken[column.name];
            if (++renamed <= shownRenamed)
                warn(phrase("there are several columns named '{}'", cited(wanted)), column.position,
                     phrase("This one is called '{}' here.", cited(column.name)));
        }
        if (renamed > shownRenamed)
            warn(phrase("{} further columns have the name of another one", renamed - shownRenamed), 0,
                 phrase("They are called by that name and a number behind it."));
    }

    void warn(Text message, int position, Text hint) {
        layout_.warnings.push_back(
            asWarning(fileError(std::move(message), file_, layout_.headerLine, position, std::move(hint))));
    }

    void readPreamble() {
        PreambleReader reader(layout_.columns.size(), layout_.marks.decimal.value_or('.'));
        for (std::size_t i = 0; i < header_.first && i < rows_.rows.size(); ++i) {
            reader.add(rows_.rows[i]);
            if (rows_.separator == ' ') reader.addComment(rows_.rows[i].line.text);  // "Rate: 10 Hz" is parted as well
        }
        // those above the header are among the lines in front of it
        const bool hasHeader = header_.first < rows_.rows.size();
        for (auto row = header_.keys.rbegin(); row != header_.keys.rend(); ++row)  // from top to bottom
            if (hasHeader && row->line.number > rows_.rows[header_.first].line.number) reader.add(*row);
        const int data = rows_.begin < rows_.rows.size() ? rows_.rows[rows_.begin].line.number : 0;
        for (const TextLine& comment : rows_.comments)
            if (comment.number < data) reader.addComment(comment.text);
        if (unframed_)
            for (const std::string& pair : unframed_->pairs) reader.add(sampleRowOf({pair, 0}, unframed_->separator));
        for (const auto& [key, value] : header_.facts) reader.addPair(key.text, value.text);
        layout_.facts = reader.facts();
        if (!header_.names) takeNamesOfPreamble();
    }

    /// Where nothing stands above the data, a line of names in the preamble is the header.
    void takeNamesOfPreamble() {
        const std::vector<std::string>& names = layout_.facts.comments;
        for (std::size_t i = 0; i < std::min(names.size(), layout_.columns.size()); ++i)
            if (!names[i].empty()) layout_.columns[i].name = names[i];
        makeNamesDiffer();
    }

    void addUnits() {
        const auto& facts = layout_.facts;
        if (header_.units) layout_.unitsLine = header_.units->line.number;
        for (std::size_t i = 0; i < layout_.columns.size(); ++i) {
            LayoutColumn& column = layout_.columns[i];
            const bool isTold = (header_.units && i < header_.units->cells.size() &&
                                 !readUnitCell(header_.units->cells[i].text).empty()) ||
                                (i < facts.units.size() && !readUnitCell(facts.units[i]).empty());
            if (isTold && isSplitAtSlash(column)) joinAtSlash(column);
            if (header_.units && i < header_.units->cells.size()) addUnitCell(header_.units->cells[i].text, column, i);
            if (column.unit.empty() && i < facts.units.size()) column.unit = readUnitCell(facts.units[i]);
        }
        if (!layout_.columns.empty() && layout_.columns[0].unit.empty() && !facts.timeUnit.empty() && !countsRows(0))
            layout_.columns[0].unit = facts.timeUnit;
        for (LayoutColumn& column : layout_.columns) takeForCelsius(column);
    }

    /// Words in a row of units over a column that counts its rows ("Sequence") are no unit.
    void addUnitCell(std::string_view text, LayoutColumn& column, std::size_t index) const {
        const std::string unit = readUnitCell(text);
        if (unit.empty()) return;
        const bool holdsNumbers = column.kind == CellKind::Number || column.kind == CellKind::Quantity;
        if (!isKnownUnit(unit) && (countsRows(index) || !holdsNumbers || namesNoUnit(unit)))
            column.comment = unit;
        else
            column.unit = unit;
    }

    bool countsRows(std::size_t column) const {
        double last = 0;
        for (std::size_t r = rows_.begin; r < rows_.end; ++r) {
            const auto& cells = rows_.rows[r].cells;
            const CellValue value = column < cells.size() ? readCell(cells[column].text, '.') : CellValue{};
            if (value.kind != CellValue::Kind::Number) return false;
            if (r > rows_.begin && value.value != last + 1) return false;
            last = value.value;
        }
        return rows_.end > rows_.begin + 1 && (last == std::floor(last));
    }

    /// A bench measures temperatures, not charges, unless it says so.
    void takeForCelsius(LayoutColumn& column) {
        if (column.unit != "C") return;
        const std::string name = inLowerCase(column.name);
        for (const char* charge : {"charge", "ladung", "coulomb", "q"})
            if (name == charge ||
                (name.size() > 3 && name.find(charge) != std::string::npos && std::string_view(charge).size() > 1))
                return;
        column.unit = "degC";
        warn(phrase("the unit 'C' of column '{}' is taken for degC, not for coulomb", cited(column.name)),
             column.position,
             phrase("Where it is a charge, give the unit in the study as {{\"column\": …, \"unit\": \"A.s\"}}."));
    }

    void addDescriptions() {
        const auto add = [&](std::size_t i, const std::string& text) {
            LayoutColumn& column = layout_.columns[i];
            if (text.empty() || text == column.name || text == column.header) return;
            if (kindOf(text) == CellKind::Number) return;
            if (column.comment.find(text) == std::string::npos)
                column.comment += (column.comment.empty() ? "" : "; ") + text;
        };
        for (const SampleRow& row : header_.descriptions)
            for (std::size_t i = 0; i < std::min(row.cells.size(), layout_.columns.size()); ++i)
                add(i, row.cells[i].text);
        const auto& comments = layout_.facts.comments;
        for (std::size_t i = 0; i < std::min(comments.size(), layout_.columns.size()); ++i) add(i, comments[i]);
    }

    /// What most cells of a column are. A column of numbers with a word in it stays one of numbers: the word is a
    /// fault.
    void tellKinds() {
        for (std::size_t i = 0; i < layout_.columns.size(); ++i) {
            std::array<std::size_t, 5> counts{};
            for (std::size_t r = rows_.begin; r < rows_.end; ++r)
                if (i < rows_.rows[r].kinds.size()) ++counts[static_cast<std::size_t>(rows_.rows[r].kinds[i])];
            counts[static_cast<std::size_t>(CellKind::Blank)] = 0;
            const auto most = std::max_element(counts.begin(), counts.end());
            if (*most > 0) layout_.columns[i].kind = static_cast<CellKind>(most - counts.begin());
            const auto numbers = counts[static_cast<std::size_t>(CellKind::Number)];
            if (layout_.columns[i].kind == CellKind::Words && numbers > 0 && 3 * numbers >= *most)
                layout_.columns[i].kind = CellKind::Number;
            if (!options_.timeFormat.empty() && isOfFormat(i)) takeForStamps(i);
        }
        std::size_t times = 0;
        for (const LayoutColumn& column : layout_.columns) times += namesTime(column.name);
        layout_.arePadded = (times > 1 && layout_.columns.size() > 2) || mostEndEarly();
    }

    /// Rows in which the last cells are not written, but in a few.
    bool mostEndEarly() const {
        const std::size_t all = layout_.columns.size();
        std::size_t whole = 0, early = 0, cells = 0;
        for (std::size_t r = rows_.begin; r < rows_.end; ++r) {
            const std::size_t count = rows_.rows[r].cells.size();
            whole += count == all;
            if (count >= all) continue;
            if (early++ > 0 && count != cells) return false;
            cells = count;
        }
        return whole > 0 && early >= 3 && early > 4 * whole && cells > 1;
    }

    /// Numbers are stamps of a format without marks ("%H%M%S") only where they are called a time, or in one column.
    void takeForStamps(std::size_t column) {
        const std::string& format = options_.timeFormat;
        const bool isBare = format.find_first_of(":/.-, T") == std::string::npos;
        const auto isTime = [](const LayoutColumn& c) { return namesTime(c.name); };
        const auto first = std::find_if(layout_.columns.begin(), layout_.columns.end(), isTime);
        LayoutColumn& told = layout_.columns[column];
        const bool isOther = isBare && told.kind == CellKind::Number && first != layout_.columns.end() &&
                             first != layout_.columns.begin() + static_cast<std::ptrdiff_t>(column);
        if (!isOther) told.kind = CellKind::Stamp;
    }

    bool isOfFormat(std::size_t column) const {
        if (rows_.begin >= rows_.end) return false;
        const auto& cells = rows_.rows[rows_.begin].cells;
        return column < cells.size() && isOfTimeFormat(cells[column].text, options_.timeFormat);
    }

    void findData() {
        if (rows_.begin >= rows_.rows.size()) {
            layout_.offset = text_.text.size();
            return;
        }
        const TextLine& line = rows_.rows[rows_.begin].line;
        layout_.offset = static_cast<std::size_t>(line.text.data() - text_.text.data());
        layout_.linesBefore = line.number - 1;
        if (!header_.names && rows_.score > 0 && !options_.header) {
            const LayoutColumn& first = layout_.columns.front();
            layout_.warnings.push_back(asWarning(
                fileError(phrase("the file has no header"), file_, line.number, 0,
                          phrase("Its columns are called {} to {}.", first.name, layout_.columns.back().name))));
        }
    }

    TextView text_;
    const std::string& file_;
    const ReadOptions& options_;
    Questions& asked_;
    const UnframedText* unframed_;
    SampledRows rows_;
    HeaderRows header_;
    Layout layout_;
};

Text nameOfMark(char mark) {
    if (mark == '\t') return phrase("tabs");
    if (mark == ' ') return phrase("blanks");
    return fmt::format("'{}'", mark);
}

}  // namespace

Outcome<Layout> findLayout(TextView text, const std::string& file, const ReadOptions& options, Questions& asked,
                           const UnframedText* unframed) {
    return LayoutFinder(text, file, options, asked, unframed).find();
}

Text described(const Layout& layout) {
    Text told = layout.headerLine > 0 ? phrase("names in line {}", layout.headerLine) : phrase("no header");
    if (layout.unitsLine > 0) told += phrase(", units in line {}", layout.unitsLine);
    told += phrase(", data from line {}", layout.linesBefore + 1);
    if (layout.columns.size() > 1) told += phrase(", {} between the columns", nameOfMark(layout.separator));
    if (layout.marks.decimal) told += phrase(", decimal mark '{}'", std::string(1, *layout.marks.decimal));
    if (layout.marks.thousands != 0) told += phrase(", '{}' between thousands", std::string(1, layout.marks.thousands));
    return told;
}

}  // namespace analogon
