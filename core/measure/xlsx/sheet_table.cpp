#include "core/measure/xlsx/sheet_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/base/unit.hpp"
#include "core/measure/column_header.hpp"
#include "core/measure/counted_time.hpp"
#include "core/measure/time_name.hpp"
#include "core/measure/xlsx/cell_value.hpp"

namespace analogon::xlsx {

namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

const Cell* cellAt(const Row& row, std::uint32_t column) {
    const auto found = std::lower_bound(row.cells.begin(), row.cells.end(), column,
                                        [](const Cell& cell, std::uint32_t c) { return cell.column < c; });
    return found != row.cells.end() && found->column == column ? &*found : nullptr;
}

class SheetReader {
public:
    SheetReader(const Sheet& sheet, std::vector<Text>& notes) : sheet_(sheet), notes_(notes) {}

    std::vector<SheetTable> read() {
        sheetMark_ = marksOfSheet().decimal();
        first_ = firstDataRow();
        if (first_ == sheet_.rows.size()) return {};
        readHeader();
        last_ = endOfData();
        std::map<std::uint32_t, SheetColumn> columns;
        for (std::size_t r = first_; r < last_; ++r)
            for (const Cell& cell : sheet_.rows[r].cells) columns.try_emplace(cell.column);
        nameColumns(columns);
        for (auto& [index, column] : columns) readColumn(index, column);
        joinDateAndClock(columns);
        for (auto& [index, column] : columns) passMidnight(column);
        if (sheet_.isCut)
            notes_.push_back(phrase("sheet \"{}\" has too many cells: the last ones are left out", sheet_.name));
        return tablesOf(columns);
    }

private:
    /// What numbers that were written as text tell of their marks: one that cannot stand between thousands is that of
    /// decimals.
    struct Marks {
        bool isComma{}, isPoint{}, isOpen{};
        void add(const Cell& cell) {
            if (cell.kind != Cell::Kind::Text || cell.text.find_first_of("0123456789") == std::string::npos) return;
            const std::optional<double> withComma = numberOf(cell.text, ','), withPoint = numberOf(cell.text, '.');
            isComma = isComma || (withComma && !withPoint);
            isPoint = isPoint || (withPoint && !withComma);
            isOpen = isOpen || (withComma && withPoint && *withComma != *withPoint);
        }
        /// 0: nothing tells it.
        char decimal() const { return isComma == isPoint ? '\0' : isComma ? ',' : '.'; }
    };

    Marks marksOfSheet() const {
        Marks marks;
        for (const Row& row : sheet_.rows)
            for (const Cell& cell : row.cells) marks.add(cell);
        return marks;
    }

    /// Those of the column, or else of the sheet. False: its numbers can be read in two ways.
    bool findMark(std::uint32_t index) {
        Marks marks;
        for (std::size_t r = first_; r < last_; ++r)
            if (const Cell* cell = cellAt(sheet_.rows[r], index)) marks.add(*cell);
        const char told = marks.decimal() != 0 ? marks.decimal() : sheetMark_;
        decimal_ = told != 0 ? told : '.';
        return told != 0 || !marks.isOpen;
    }

    bool isValue(const Cell& cell) const {
        if (cell.kind != Cell::Kind::Text) return true;
        return numberOf(cell.text, decimal_).has_value() || dateOf(cell.text).has_value();
    }
    bool mayBeValue(const Cell& cell) const { return isValue(cell) || numberOf(cell.text, ',').has_value(); }
    bool isDataLike(const Row& row) const {
        std::size_t values = 0, told = 0;
        for (const Cell& cell : row.cells) {
            if (cell.kind == Cell::Kind::Text && meansNothing(cell.text)) continue;
            ++told;
            values += mayBeValue(cell) ? 1 : 0;
        }
        return values > 0 && 2 * values >= told;
    }
    /// Data are several such rows one below the other; a number in the head of a protocol stands alone.
    std::size_t firstDataRow() const {
        const auto& rows = sheet_.rows;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const bool hasNext = i + 1 < rows.size() && rows[i + 1].number == rows[i].number + 1;
            if (isDataLike(rows[i]) && hasNext && isDataLike(rows[i + 1])) return i;
        }
        return rows.size();
    }

    void readHeader() {
        constexpr std::size_t most = 3;
        std::size_t row = first_;
        const auto hasAbove = [&] { return row > 0 && sheet_.rows[row - 1].number + 1 == sheet_.rows[row].number; };
        if (!hasAbove()) return;
        const Row& above = sheet_.rows[--row];
        if (hasAbove() && isUnitsRow(above))
            units_ = &above;
        else
            headers_.push_back(&above);
        while (hasAbove() && headers_.size() < most && areWords(sheet_.rows[row - 1]))
            headers_.push_back(&sheet_.rows[--row]);
    }

    static bool areWords(const Row& row) {
        return std::all_of(row.cells.begin(), row.cells.end(),
                           [](const Cell& cell) { return cell.kind == Cell::Kind::Text; });
    }

    static std::string textAt(const Row& row, std::uint32_t column) {
        const Cell* const cell = cellAt(row, column);
        return cell && cell->kind == Cell::Kind::Text ? cell->text : std::string();
    }

    /// One row has the names where it stands over every column, the upper of those that have the most different ones.
    /// Else a cell that stands over several columns names those below which nothing stands, and tells apart what has
    /// one name.
    void nameColumns(std::map<std::uint32_t, SheetColumn>& columns) const {
        const Row* whole = nullptr;
        std::size_t most = 0;
        for (const Row* const row : headers_) {  // the lowest first
            std::set<std::string> names;
            for (const auto& [index, column] : columns) names.insert(textAt(*row, index));
            if (names.contains({}) || names.size() < most) continue;
            most = names.size();
            whole = row;
        }
        std::map<std::string, int> counts;
        for (auto& [index, column] : columns) {
            std::string text = whole ? textAt(*whole, index) : std::string();
            for (std::size_t i = 0; text.empty() && i < headers_.size(); ++i) text = textAt(*headers_[i], index);
            ColumnHeader header = readColumnHeader(text);
            column.name = header.name.empty() ? columnLetters(index) : header.name;
            column.unit = header.unit;
            ++counts[column.name];
        }
        if (whole || headers_.size() < 2) return;
        std::string over;
        for (auto& [index, column] : columns) {
            if (std::string text = textAt(*headers_[1], index); !text.empty()) over = std::move(text);
            if (counts[column.name] > 1 && !over.empty() && over != column.name) column.name = over + ' ' + column.name;
        }
    }

    static bool isUnitsRow(const Row& row) {
        std::size_t units = 0;
        for (const Cell& cell : row.cells) {
            if (cell.kind != Cell::Kind::Text) return false;
            const std::string unit = readUnitCell(cell.text);
            units += unit == "-" || isKnownUnit(unit) ? 1 : 0;
        }
        return 2 * units > row.cells.size();
    }

    /// An empty row ends the data where no rows of the same shape follow it.
    std::size_t endOfData() {
        const auto& rows = sheet_.rows;
        std::size_t end = first_ + 1;
        while (end < rows.size()) {
            const bool isBehindGap = rows[end].number != rows[end - 1].number + 1;
            const bool isAlike = isDataLike(rows[end]) &&
                                 rows[end].cells.front().column == rows[first_].cells.front().column &&
                                 mayBeValue(rows[end].cells.front()) == mayBeValue(rows[first_].cells.front());
            if (isBehindGap && !isAlike) break;
            ++end;
        }
        const auto isData = [this](const Row& row) { return isDataLike(row); };
        if (std::any_of(rows.begin() + static_cast<std::ptrdiff_t>(end), rows.end(), isData))
            notes_.push_back(phrase("sheet \"{}\": what stands below the table, from row {} on, is left out",
                                    sheet_.name, rows[end].number));
        return end;
    }

    void readColumn(std::uint32_t index, SheetColumn& column) {
        const Cell* unit = units_ ? cellAt(*units_, index) : nullptr;
        if (unit) column.unit = readUnitCell(unit->text);
        const bool isOneReading = findMark(index);
        std::size_t texts = 0, values = 0, dates = 0, percents = 0, written = 0;
        for (std::size_t r = first_; r < last_; ++r) {
            const Cell* cell = cellAt(sheet_.rows[r], index);
            if (!cell || (cell->kind == Cell::Kind::Text && meansNothing(cell->text))) continue;
            const bool isDate =
                cell->kind == Cell::Kind::Date || (cell->kind == Cell::Kind::Text && dateOf(cell->text));
            (isValue(*cell) ? values : texts) += 1;
            dates += isDate ? 1 : 0;
            percents += cell->kind == Cell::Kind::Percent ? 1 : 0;
            written += cell->kind == Cell::Kind::Text && !isDate && isValue(*cell) ? 1 : 0;
        }
        column.isText = texts > values || !isOneReading;
        if (!isOneReading)
            notes_.push_back(
                phrase("sheet \"{}\", column \"{}\": its numbers are written as text, and their mark may "
                       "stand for decimals or between thousands: write them as numbers",
                       sheet_.name, column.name));
        column.isDate = !column.isText && 2 * dates > values;
        const bool isPercent = column.unit == "%" && 2 * percents > values;
        if (written > 0 && !column.isText)
            notes_.push_back(phrase(
                "sheet \"{}\", column \"{}\": numbers that were written as text are read, \"{}\" as decimal mark",
                sheet_.name, column.name, std::string(1, decimal_)));
        if (isPercent)
            notes_.push_back(
                phrase("sheet \"{}\", column \"{}\": fractions that are shown as percent are read as percent",
                       sheet_.name, column.name));
        std::size_t lost = 0, uncalculated = 0;
        for (std::size_t r = first_; r < last_; ++r) {
            const Cell* cell = cellAt(sheet_.rows[r], index);
            if (column.isText) {
                column.texts.push_back(cell && cell->kind == Cell::Kind::Text ? std::optional(cell->text)
                                                                              : std::nullopt);
                continue;
            }
            const double value = cell ? valueOf(*cell, column.isDate) : gap;
            uncalculated += cell && cell->kind == Cell::Kind::Uncalculated ? 1 : 0;
            column.numbers.push_back(isPercent && cell && cell->kind == Cell::Kind::Percent ? 100 * value : value);
            lost += cell && cell->kind == Cell::Kind::Text && !meansNothing(cell->text) && std::isnan(value) ? 1 : 0;
        }
        if (uncalculated > 0)
            notes_.push_back(
                phrase("sheet \"{}\", column \"{}\": {} formulas have no result in the file and are gaps; open it in a "
                       "spreadsheet program and save it",
                       sheet_.name, column.name, uncalculated));
        if (lost > 0)
            notes_.push_back(
                phrase("sheet \"{}\", column \"{}\": {} cells with words are gaps", sheet_.name, column.name, lost));
    }

    double valueOf(const Cell& cell, bool isDate) const {
        if (cell.kind == Cell::Kind::Error || cell.kind == Cell::Kind::Uncalculated) return gap;
        if (cell.kind != Cell::Kind::Text) return cell.number;
        if (isDate) return dateOf(cell.text).value_or(gap);
        return numberOf(cell.text, decimal_).value_or(gap);
    }

    /// A date in one column and the clock in the next are one stamp, which is called as the clock is.
    void joinDateAndClock(std::map<std::uint32_t, SheetColumn>& columns) {
        const auto all = [](const SheetColumn& column, auto isSo) {
            return column.isDate && std::all_of(column.numbers.begin(), column.numbers.end(),
                                                [&](double v) { return std::isnan(v) || isSo(v); });
        };
        for (auto date = columns.begin(); date != columns.end(); ++date) {
            const auto clock = std::next(date);
            if (clock == columns.end()) return;
            const bool isPair = all(date->second, [](double v) { return v >= 1 && v == std::floor(v); }) &&
                                all(clock->second, [](double v) { return v >= 0 && v < 1; });
            if (!isPair) continue;
            for (std::size_t i = 0; i < clock->second.numbers.size(); ++i)
                clock->second.numbers[i] += date->second.numbers[i];
            notes_.push_back(
                phrase("the time is that of columns '{}' and '{}' together", date->second.name, clock->second.name));
            columns.erase(date);
            return;
        }
    }

    /// A clock without a date falls at midnight.
    void passMidnight(SheetColumn& column) {
        const auto isClock = [](double value) { return std::isnan(value) || (value >= 0 && value < 1); };
        if (!column.isDate || !std::all_of(column.numbers.begin(), column.numbers.end(), isClock)) return;
        std::size_t days = 0;
        double last = gap;
        for (double& value : column.numbers) {
            if (std::isnan(value)) continue;
            value += static_cast<double>(days);
            if (value < last - 0.5) {
                value += 1;
                ++days;
            }
            last = value;
        }
        if (days > 0)
            notes_.push_back(
                phrase("sheet \"{}\", column \"{}\": the clock passes midnight {} times: a day is added "
                       "there",
                       sheet_.name, column.name, days));
    }

    /// The first one by its name or its unit; others are durations unless they are called a time.
    static bool isTime(const SheetColumn& column, bool isFirst) {
        if (column.isText) return false;
        const bool hasUnit = !column.unit.empty() && areConvertible(column.unit, "s");
        const bool isNamed = namesTime(column.name) && (column.unit.empty() || hasUnit);
        if (!column.isDate && !isNamed && !(isFirst && hasUnit)) return false;
        double last = -INFINITY, first = NAN;
        for (const double value : column.numbers) {
            if (std::isnan(value)) continue;
            if (value < last) return false;
            if (std::isnan(first)) first = value;
            last = value;
        }
        return last > first;
    }

    std::vector<SheetTable> tablesOf(std::map<std::uint32_t, SheetColumn>& columns) {
        std::vector<SheetTable> tables(1);
        std::size_t times = 0;
        for (auto& [index, column] : columns) {
            // a second column of time is one only where the first has another length or other stamps
            if (isTime(column, times == 0) &&
                (!tables.back().time || !isSameTime(tables.back().columns[*tables.back().time], column))) {
                if (times++ > 0) tables.emplace_back();
                tables.back().time = tables.back().columns.size();
            }
            tables.back().columns.push_back(std::move(column));
        }
        if (times > 1)
            notes_.push_back(phrase("sheet \"{}\" has {} columns of time: each column belongs to the one on its left",
                                    sheet_.name, times));
        for (SheetTable& table : tables) {
            cut(table);
            if (table.time && !table.columns[*table.time].isDate && table.columns[*table.time].unit.empty()) {
                SheetColumn& time = table.columns[*table.time];
                time.unit = takenTimeUnit(time.name, time.numbers, notes_);
            }
        }
        std::erase_if(tables, [](const SheetTable& table) { return table.columns.empty(); });
        return tables;
    }

    static bool isSameTime(const SheetColumn& a, const SheetColumn& b) {
        return a.isDate == b.isDate && a.numbers == b.numbers;
    }

    /// Rows behind the last time (an average, a remark) are no data; without a time, rows behind the last value.
    void cut(SheetTable& table) {
        std::size_t rows = 0;
        const auto lengthOf = [](const SheetColumn& column) {
            std::size_t length = column.isText ? column.texts.size() : column.numbers.size();
            while (length > 0 && (column.isText ? !column.texts[length - 1] : std::isnan(column.numbers[length - 1])))
                --length;
            return length;
        };
        std::size_t longest = 0;
        for (const SheetColumn& column : table.columns) longest = std::max(longest, lengthOf(column));
        rows = table.time ? lengthOf(table.columns[*table.time]) : longest;
        if (rows < longest)
            notes_.push_back(
                phrase("sheet \"{}\": {} rows without a time at the end are left out", sheet_.name, longest - rows));
        for (SheetColumn& column : table.columns)
            (column.isText ? column.texts.resize(rows) : column.numbers.resize(rows));
    }

    const Sheet& sheet_;
    std::vector<Text>& notes_;
    char sheetMark_{}, decimal_{'.'};  // of the whole sheet, 0: not told; of the column that is read
    std::size_t first_{}, last_{};
    std::vector<const Row*> headers_;  // rows of words above the units and the data, the lowest first
    const Row* units_{};
};

}  // namespace

std::vector<SheetTable> readTables(const Sheet& sheet, std::vector<Text>& notes) {
    return SheetReader(sheet, notes).read();
}

}  // namespace analogon::xlsx
