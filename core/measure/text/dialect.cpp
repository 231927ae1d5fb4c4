#include "core/measure/text/dialect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "core/base/limits.hpp"
#include "core/base/stop.hpp"
#include "core/measure/cited.hpp"
#include "core/measure/encoding.hpp"
#include "core/measure/text/preamble.hpp"

namespace analogon {

TextHead headOf(TextView text, const ReadOptions& options, std::size_t most) {
    constexpr std::size_t mostBytes = std::size_t{1} << 20, fewest = 8;
    TextHead head;
    head.separator = options.separator;
    LineReader reader(text);
    std::size_t bytes = 0;
    for (TextLine line; head.lines.size() < most && (bytes < mostBytes || head.lines.size() < fewest);) {
        stopPoint();
        if (!reader.next(line)) {
            head.isWhole = true;
            break;
        }
        joinQuoted(line, reader);
        if (options.skip && line.number <= static_cast<int>(*options.skip)) continue;
        if (line.number == 1 && line.text.starts_with("sep=") && line.text.size() == 5) {
            if (!head.separator) head.separator = line.text[4];  // as spreadsheets write it
            continue;
        }
        if (isEmptyLine(line.text)) continue;
        bytes += line.text.size();
        head.lines.push_back(line);
    }
    return head;
}

namespace {

/// The lines of a cell behind one another.
std::string onOneLine(std::string text) {
    if (text.find_first_of("\r\n") == std::string::npos) return text;
    std::string line;
    for (const char c : text)
        if (c != '\r' && c != '\n')
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    return line;
}

}  // namespace

SampleRow sampleRowOf(const TextLine& line, char separator) {
    SampleRow row;
    row.line = line;
    CsvRow split = splitCsvRow(line.text, separator);
    row.cells = std::move(split.cells);
    row.openQuote = split.openQuote;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
        row.cells[i].text = inUtf8(onOneLine(std::move(row.cells[i].text)));
        row.kinds.push_back(kindOf(row.cells[i].text));
        if (!row.cells[i].text.empty()) row.filled = i + 1;
    }
    return row;
}

Diagnostics tooWide(const SampleRow& row, const std::string& file) {
    if (row.cells.size() <= limits::columns) return {};
    return {fileError(phrase("this line has {} columns, more than {}", row.cells.size(), limits::columns), file,
                      row.line.number, 0, phrase("Export fewer channels, or check the mark between the columns."))};
}

std::size_t widest(const SampledRows& sample) {
    std::size_t most = 0;
    for (std::size_t r = sample.begin; r < sample.end; ++r) most = std::max(most, sample.rows[r].filled);
    return most;
}

bool isValue(CellKind kind) {
    return kind == CellKind::Number || kind == CellKind::Stamp || kind == CellKind::Quantity;
}

namespace {

/// What the columns of a block of rows hold, as far as its rows tell.
class BlockKinds {
public:
    explicit BlockKinds(const SampleRow& row) : size_(row.cells.size()), kinds_(row.kinds) {}

    /// A row of the same length in which most cells are of the kinds of their columns, and one of them a value.
    bool takes(const SampleRow& row) {
        if (row.cells.size() != size_) return false;
        std::size_t alike = 0, told = 0, values = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            if (row.kinds[i] == CellKind::Blank || kinds_[i] == CellKind::Blank) continue;
            ++told;
            const bool isAlike = row.kinds[i] == kinds_[i];
            alike += isAlike;
            values += isAlike && isValue(kinds_[i]);
        }
        // rows of two rasters may have no column in common
        const bool isOther = told == 0 && countValues(row.kinds) > 0 && countValues(kinds_) > 0;
        if (!isOther && (values == 0 || 2 * alike <= told)) return false;
        for (std::size_t i = 0; i < size_; ++i)
            if (kinds_[i] == CellKind::Blank) kinds_[i] = row.kinds[i];
        return true;
    }
    double worth(std::size_t rows) const {
        double sum = 0;
        for (const CellKind kind : kinds_) sum += isValue(kind) ? 1 : kind == CellKind::Words ? -0.6 : 0;
        return static_cast<double>(rows) * std::max(sum, 0.1);
    }
    std::size_t values() const { return countValues(kinds_); }

private:
    static std::size_t countValues(const std::vector<CellKind>& kinds) {
        return static_cast<std::size_t>(std::count_if(kinds.begin(), kinds.end(), isValue));
    }

    std::size_t size_;
    std::vector<CellKind> kinds_;
};

/// A row in front of the block that belongs to it, though it has another length or a faulty cell: its first cell is of
/// the kind of the first column, and most others are, too.
bool belongsTo(const SampleRow& above, const SampleRow& first) {
    const std::size_t common = std::min(above.cells.size(), first.cells.size());
    if (common == 0) return false;
    std::size_t alike = 0, told = 0;
    for (std::size_t i = 0; i < common; ++i) {
        if (told == 0 && above.kinds[i] == CellKind::Words && first.kinds[i] == CellKind::Blank) return false;
        if (above.kinds[i] == CellKind::Blank || first.kinds[i] == CellKind::Blank) continue;
        if (told == 0 && !(above.kinds[i] == first.kinds[i] && isValue(above.kinds[i]))) return false;
        ++told;
        alike += above.kinds[i] == first.kinds[i];
    }
    return told > 0 && 2 * alike >= told && (alike > 1 || common == 1 || told == 2);
}

/// Words alone, one for each column and no two alike.
bool mayBeHeader(const SampleRow& row, std::size_t width) {
    std::set<std::string_view> distinct;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
        if (isValue(row.kinds[i])) return false;
        if (row.kinds[i] == CellKind::Words) distinct.insert(row.cells[i].text);
    }
    return row.filled > 1 && 2 * distinct.size() > width;
}

/// Rows of the same shape in front of the block. Where a faulty row alone stands between, they belong to it; where a
/// header does, they are another recording.
void lookBefore(SampledRows& sample, const std::vector<std::pair<std::size_t, std::size_t>>& blocks) {
    const std::vector<SampleRow>& rows = sample.rows;
    const std::size_t width = rows[sample.begin].filled;
    for (const auto& [begin, end] : blocks) {
        if (begin >= sample.begin) return;
        const bool isAlike = rows[begin].cells.size() == rows[sample.begin].cells.size() && width > 1 &&
                             belongsTo(rows[begin], rows[sample.begin]);
        if (!isAlike) continue;
        const auto isHeader = [&, w = width](const SampleRow& row) { return mayBeHeader(row, w); };
        const auto from = rows.begin() + static_cast<std::ptrdiff_t>(end);
        if (std::any_of(from, rows.begin() + static_cast<std::ptrdiff_t>(sample.begin), isHeader)) {
            if (end - begin > 1 && sample.otherBegin == 0) {
                sample.otherBegin = rows[begin].line.number;
                sample.otherEnd = rows[end - 1].line.number;
            }
            continue;
        }
        sample.begin = begin;
        return;
    }
}

/// "0s, 1s, 2s": a number with a letter behind it is a quantity where a whole column has that letter and other numbers.
void tellQuantities(std::vector<SampleRow>& rows) {
    constexpr std::size_t fewest = 3;
    struct Found {
        std::set<std::string, std::less<>> units, numbers;
        std::size_t quantities{}, others{};
    };
    std::vector<Found> columns;
    for (const SampleRow& row : rows) {
        if (columns.size() < row.cells.size()) columns.resize(row.cells.size());
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            if (row.kinds[i] != CellKind::Words && row.kinds[i] != CellKind::Quantity) continue;
            const auto quantity = readQuantity(row.cells[i].text, true);
            (quantity ? columns[i].quantities : columns[i].others) += 1;
            if (!quantity) continue;
            columns[i].units.emplace(quantity->unit);
            if (columns[i].numbers.size() < fewest) columns[i].numbers.emplace(quantity->number);
        }
    }
    for (SampleRow& row : rows)
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            const Found& found = columns[i];
            // "200m" may be a part of a unit that is not written
            const bool isOne = found.units.size() == 1 && !found.units.contains("m") && found.numbers.size() >= fewest;
            if (row.kinds[i] == CellKind::Words && isOne && found.quantities > found.others &&
                readQuantity(row.cells[i].text, true))
                row.kinds[i] = CellKind::Quantity;
        }
}

void findBlock(SampledRows& sample) {
    const std::vector<SampleRow>& rows = sample.rows;
    std::vector<std::pair<std::size_t, std::size_t>> blocks;
    for (std::size_t begin = 0; begin < rows.size();) {
        BlockKinds kinds(rows[begin]);
        std::size_t end = begin + 1;
        while (end < rows.size() && kinds.takes(rows[end])) ++end;
        // words in front of each row, each another one, are the keys of a preamble
        const bool isKeyed =
            !rows[begin].kinds.empty() && rows[begin].kinds[0] == CellKind::Words && rows[begin].cells.size() <= 3;
        const double score = (kinds.values() > 0 ? kinds.worth(end - begin) : 0) * (isKeyed ? 0.05 : 1);
        if (score > sample.score) {
            sample.score = score;
            sample.isKeyed = isKeyed;
            sample.begin = begin;
            sample.end = end;
        }
        if (kinds.values() > 0) blocks.emplace_back(begin, end);
        begin = end;
    }
    if (sample.score <= 0) return;
    // the last key of a preamble over rows whose first cell is empty
    if (sample.begin > 0 && sample.end - sample.begin > 1 && rows[sample.begin].kinds[0] == CellKind::Words &&
        rows[sample.begin + 1].kinds[0] == CellKind::Blank && isKeyOfPreamble(rows[sample.begin - 1]))
        ++sample.begin;
    while (sample.begin > 0 && belongsTo(rows[sample.begin - 1], rows[sample.begin])) --sample.begin;
    lookBefore(sample, blocks);
}

SampledRows sampleBy(const TextHead& head, char separator) {
    SampledRows sample;
    sample.separator = separator;
    for (const TextLine& line : head.lines) {
        if (isComment(line.text, separator))
            sample.comments.push_back(line);
        else
            sample.rows.push_back(sampleRowOf(line, separator));
    }
    tellQuantities(sample.rows);
    findBlock(sample);
    return sample;
}

/// The header of a table that is parted otherwise.
bool isOneWordAbove(const SampledRows& sample) {
    return sample.begin > 0 && sample.rows[sample.begin - 1].filled == 1 && widest(sample) > 1;
}

/// Numbers alone, and as many names above them.
bool isWholeTable(const SampledRows& sample) {
    if (sample.score <= 0 || sample.begin == 0 || sample.end < sample.begin + 2) return false;
    const std::size_t width = sample.rows[sample.begin].cells.size();
    const auto holds = [&](const SampleRow& row, CellKind kind) {
        return row.cells.size() == width &&
               std::all_of(row.kinds.begin(), row.kinds.end(), [&](CellKind found) { return found == kind; });
    };
    for (std::size_t r = sample.begin; r < sample.end; ++r)
        if (!holds(sample.rows[r], CellKind::Number)) return false;
    return width > 1 && holds(sample.rows[sample.begin - 1], CellKind::Words);
}

/// Whether the first of the sampled rows has more than one cell; a text may have no row at all.
bool isParted(const SampledRows& sample) {
    return sample.begin < sample.rows.size() && sample.rows[sample.begin].cells.size() > 1;
}

}  // namespace

SampledRows sampledRows(const TextHead& head) {
    if (head.separator) return sampleBy(head, *head.separator);
    SampledRows best;
    best.score = -1;
    constexpr std::array<char, 4> candidates{'\t', ';', '|', ','};
    for (const char candidate : candidates) {
        const auto holds = [&](const TextLine& line) { return line.text.find(candidate) != std::string_view::npos; };
        if (std::none_of(head.lines.begin(), head.lines.end(), holds)) continue;
        SampledRows sample = sampleBy(head, candidate);
        if (sample.score > best.score) best = std::move(sample);
    }
    if (best.score > 0 && best.separator == ',' && isOneWordAbove(best)) {
        SampledRows sample = sampleBy(head, ' ');
        if (isWholeTable(sample)) return sample;
    }
    if (!(best.score > 0 && isParted(best))) {
        SampledRows sample = sampleBy(head, ' ');
        const bool isBetter = sample.score > best.score && isParted(sample);
        if (isBetter || (best.score < 0 && sample.score > 0)) best = std::move(sample);
    }
    if (best.score < 0) best = sampleBy(head, ',');
    return best;
}

namespace {

/// The mark in a cell of which nobody can tell what it stands for.
char openMarkIn(const CsvCell& cell) { return cell.text.find(',') != std::string::npos ? ',' : '.'; }

}  // namespace

Diagnostic openMark(const CsvCell& cell, int line, const ReadOptions& options, const std::string& file,
                    Questions& asked) {
    const char mark = openMarkIn(cell);
    const std::string text = cited(withoutBlanks(cell.text));
    const double decimals = readCell(text, mark).value;
    Reading ofDecimals{phrase("'{}' is {:.10g}", text, decimals), options}, ofThousands = ofDecimals;
    ofDecimals.options.decimal = mark;
    ofThousands.label = phrase("'{}' is {:.10g}", text, 1000 * decimals);
    ofThousands.options.thousands = mark;
    if (options.decimal == mark) ofThousands.options.decimal.reset();
    asked.push_back({Question::Kind::Choice,
                     phrase("Does the mark in '{}' stand for decimals or between thousands?", text),
                     line,
                     {std::move(ofDecimals), std::move(ofThousands)}});
    return fileError(
        phrase("'{}' may be {:.10g} or {:.10g}: nothing in the file tells whether its mark stands for decimals or "
               "between thousands",
               text, decimals, 1000 * decimals),
        file, line, cell.position,
        phrase("Say it in the study: \"read\": {{\"decimal\": \"{}\"}} for {:.10g}, \"read\": {{\"thousands\": "
               "\"{}\"}} for {:.10g}.",
               std::string(1, mark), decimals, std::string(1, mark), 1000 * decimals));
}

namespace {

/// What the numbers of the sample say about the marks.
struct Evidence {
    bool isPoint{}, isComma{};
    char thousands{};
    const SampleRow* openRow{};  // the first cell with an open mark
    std::size_t openCell{};
    bool hasOpenPoint{}, hasOpenComma{};
    std::vector<bool> longWithout{}, shortWithout{}, openIn{};  // by column: 1234, 234, 1.234
};

Evidence evidenceOf(const SampledRows& sample) {
    using Mark = NumberShape::Mark;
    Evidence found;
    found.longWithout.resize(sample.begin < sample.rows.size() ? sample.rows[sample.begin].cells.size() : 0);
    found.openIn.resize(found.longWithout.size());
    found.shortWithout.resize(found.longWithout.size());
    for (std::size_t r = sample.begin; r < sample.end; ++r)
        for (std::size_t i = 0; i < sample.rows[r].cells.size() && i < found.openIn.size(); ++i) {
            const CellKind kind = sample.rows[r].kinds[i];
            if (kind != CellKind::Number && kind != CellKind::Quantity) continue;
            std::string_view text = sample.rows[r].cells[i].text;
            if (const auto quantity = readQuantity(text); kind == CellKind::Quantity && quantity)
                text = quantity->number;
            const NumberShape shape = shapeOf(text);
            if (!shape.isNumber) continue;
            found.isPoint = found.isPoint || shape.decimal == Mark::Point;
            found.isComma = found.isComma || shape.decimal == Mark::Comma;
            if (shape.thousands != 0 && found.thousands == 0) found.thousands = shape.thousands;
            if (shape.isLongWithout) found.longWithout[i] = true;
            if (!shape.isLongWithout && shape.decimal == Mark::None) found.shortWithout[i] = true;
            if (shape.decimal == Mark::OpenPoint || shape.decimal == Mark::OpenComma) {
                found.openIn[i] = true;
                found.hasOpenPoint = found.hasOpenPoint || shape.decimal == Mark::OpenPoint;
                found.hasOpenComma = found.hasOpenComma || shape.decimal == Mark::OpenComma;
                if (!found.openRow) {
                    found.openRow = &sample.rows[r];
                    found.openCell = i;
                }
            }
        }
    return found;
}

}  // namespace

Outcome<NumberMarks> numberMarks(const SampledRows& sample, const ReadOptions& options, const std::string& file,
                                 Questions& asked) {
    NumberMarks marks{options.decimal, options.thousands.value_or('\0')};
    if (marks.thousands != 0 && marks.decimal == marks.thousands)
        return fileError(phrase("\"decimal\" and \"thousands\" are the same mark"), file);
    if (!marks.decimal && (marks.thousands == '.' || marks.thousands == ','))
        marks.decimal = marks.thousands == '.' ? ',' : '.';
    const Evidence found = evidenceOf(sample);
    if (!options.thousands) marks.thousands = found.thousands;
    if (options.decimal && !options.thousands && marks.thousands == 0) {
        // beside decimals that are told, the other mark parts thousands
        const bool isComma = *options.decimal == ',';
        const bool isOpen = isComma ? found.hasOpenPoint : found.hasOpenComma;
        const bool isDecimalToo = isComma ? found.isPoint : found.isComma;
        if (isOpen && !isDecimalToo) marks.thousands = isComma ? '.' : ',';
    }
    if (!marks.decimal) {
        if (found.isPoint != found.isComma) {
            marks.decimal = found.isPoint ? '.' : ',';
        } else if (found.isPoint) {
            return NumberMarks{std::nullopt, found.thousands};  // both: the reader names the lines
        } else if (found.openRow) {
            const CsvCell& cell = found.openRow->cells[found.openCell];
            const char mark = openMarkIn(cell);
            // thousands are parted everywhere or nowhere
            bool isDecimal = sample.separator == ',' && mark == '.';
            for (std::size_t i = 0; i < found.openIn.size(); ++i)
                isDecimal = isDecimal || (found.openIn[i] && found.longWithout[i]);
            if (!isDecimal) return openMark(cell, found.openRow->line.number, options, file, asked);
            marks.decimal = mark;
        }
    }
    if (marks.decimal && !options.thousands && marks.thousands == 0 && found.openRow) {
        const CsvCell& cell = found.openRow->cells[found.openCell];
        const char mark = openMarkIn(cell);
        if (mark != *marks.decimal && !found.longWithout[found.openCell]) {
            // a column of thousands has smaller numbers, too, which have no mark
            if (!found.shortWithout[found.openCell])
                return openMark(cell, found.openRow->line.number, options, file, asked);
            marks.thousands = mark;
        }
    }
    if (marks.decimal && marks.thousands == marks.decimal) marks.thousands = 0;
    return marks;
}

}  // namespace analogon
