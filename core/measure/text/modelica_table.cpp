#include "core/measure/text/modelica_table.hpp"

#include <fmt/format.h>

#include "core/base/limits.hpp"
#include "core/measure/cited.hpp"
#include "core/measure/csv_dialect.hpp"
#include "core/measure/text/text_line.hpp"

namespace analogon {

namespace {

/// "double name(rows,cols)" and where it stands.
struct Declaration {
    std::string name;
    std::size_t rows{}, columns{};
};

std::optional<Declaration> declarationOf(std::string_view line) {
    line = withoutBlanks(line);
    for (const std::string_view type : {"double", "float"})
        if (line.starts_with(type) && line.size() > type.size() && line[type.size()] == ' ') {
            const std::string_view rest = withoutBlanks(line.substr(type.size()));
            const std::size_t open = rest.find('('), comma = rest.find(','), close = rest.find(')');
            if (open == 0 || open == std::string_view::npos || comma < open || close < comma ||
                close == std::string_view::npos)
                return std::nullopt;
            const CellValue rows = readCell(rest.substr(open + 1, comma - open - 1), '.');
            const CellValue columns = readCell(rest.substr(comma + 1, close - comma - 1), '.');
            const auto isCount = [](const CellValue& value) {
                return value.kind == CellValue::Kind::Number && value.value >= 1 && value.value < 2e9;
            };
            if (!isCount(rows) || !isCount(columns)) return std::nullopt;
            return Declaration{std::string(withoutBlanks(rest.substr(0, open))), static_cast<std::size_t>(rows.value),
                               static_cast<std::size_t>(columns.value)};
        }
    return std::nullopt;
}

std::string_view withoutComment(std::string_view line) { return line.substr(0, line.find('#')); }

class TableTextReader {
public:
    TableTextReader(TextView text, const std::string& file)
        : supply_(text.supply), letGo_(text.text.data()), lines_(text), file_(file) {}

    Outcome<std::vector<ModelicaTable>> read() {
        std::vector<ModelicaTable> tables;
        TextLine line;
        for (bool hasLine = lines_.next(line); hasLine;) {
            const std::optional<Declaration> declared = declarationOf(withoutComment(line.text));
            if (!declared) {
                if (!withoutBlanks(withoutComment(line.text)).empty())
                    return fault(phrase("this is neither a number of a table nor the head of one"), line.number);
                hasLine = lines_.next(line);
                continue;
            }
            if (declared->columns > limits::columns)
                return fault(phrase("the header has {} columns, more than {}", declared->columns, limits::columns),
                             line.number);
            ModelicaTable table = begin(*declared, line.number);
            if (Diagnostics faults = readValues(*declared, table.table, line, hasLine); !faults.empty()) return faults;
            tables.push_back(std::move(table));
        }
        if (tables.empty()) return fault(phrase("this table file declares no table"), 1);
        return tables;
    }

private:
    Diagnostics fault(Text message, int line) const {
        return {fileError(std::move(message), file_, line, 0,
                          phrase("A table is written as \"double name(rows,columns)\" and its numbers below."))};
    }

    ModelicaTable begin(const Declaration& declared, int line) const {
        ModelicaTable table{declared.name, {file_, {}, {}}};
        for (std::size_t i = 0; i < declared.columns; ++i) {
            Column column{fmt::format("c{}", i + 1), i == 0 ? "s" : "", {}, {}};
            column.line = line;
            table.table.columns.push_back(std::move(column));
        }
        return table;
    }

    /// Numbers may stand in lines of any length.
    Diagnostics readValues(const Declaration& declared, Table& table, TextLine& line, bool& hasLine) {
        std::size_t count = 0;
        const std::size_t wanted = declared.rows * declared.columns;
        while ((hasLine = lines_.next(line)) && count < wanted) {
            letGoBefore(line.text.data());
            std::string_view rest = withoutComment(line.text);
            while (true) {
                const std::size_t begin = rest.find_first_not_of(" \t,;");
                if (begin == std::string_view::npos) break;
                rest.remove_prefix(begin);
                const std::string_view word = rest.substr(0, rest.find_first_of(" \t,;"));
                rest.remove_prefix(word.size());
                const CellValue value = readCell(word, '.');
                if (value.kind != CellValue::Kind::Number) {
                    if (declarationOf(line.text)) return tooFew(declared, count, line.number);
                    return fault(phrase("'{}' is not a number", cited(word)), line.number);
                }
                if (count >= wanted) return tooMany(declared, line.number);
                if (count % declared.columns == 0) table.lines.push_back(line.number);
                table.columns[count++ % declared.columns].values.push_back(value.value);
            }
        }
        if (count < wanted) return tooFew(declared, count, line.number);
        return {};
    }

    Diagnostics tooFew(const Declaration& declared, std::size_t count, int line) const {
        return fault(
            phrase("table '{}' ends after {} of {} numbers", declared.name, count, declared.rows * declared.columns),
            line);
    }
    Diagnostics tooMany(const Declaration& declared, int line) const {
        return fault(phrase("table '{}' has more than {} numbers", declared.name, declared.rows * declared.columns),
                     line);
    }

    void letGoBefore(const char* line) {
        constexpr std::ptrdiff_t many = std::ptrdiff_t{1} << 20;
        if (!supply_ || line - letGo_ < many) return;
        supply_->letGo(letGo_, line);
        letGo_ = line;
    }

    TextSupply* supply_;
    const char* letGo_;  // of the text in front of it
    LineReader lines_;
    const std::string& file_;
};

}  // namespace

bool isModelicaTable(TextView text) {
    LineReader lines(text);
    TextLine line;
    if (!lines.next(line) || withoutBlanks(line.text) != "#1") return false;
    while (lines.next(line)) {
        const std::string_view told = withoutBlanks(withoutComment(line.text));
        if (!told.empty()) return declarationOf(told).has_value();
    }
    return false;
}

Outcome<std::vector<ModelicaTable>> readModelicaTables(TextView text, const std::string& file) {
    return TableTextReader(text, file).read();
}

}  // namespace analogon
