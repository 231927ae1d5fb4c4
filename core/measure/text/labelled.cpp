#include "core/measure/text/labelled.hpp"

#include <algorithm>

#include "core/measure/csv_dialect.hpp"
#include "core/measure/text/stamp.hpp"
#include "core/measure/text/stamp_parts.hpp"

namespace analogon {

namespace {

bool isOfName(char c) { return isLetter(c) || isDigit(c) || c == '_' || c == '.'; }
bool isGap(char c) { return c == ' ' || c == '\t' || c == ',' || c == ';'; }

struct Found {
    std::string_view name;
    std::size_t begin{}, number{};  // in the line
};

/// "name:" or "name=" in front of a number, at the beginning of a cell.
std::optional<Found> labelAt(std::string_view line, std::size_t begin) {
    std::size_t end = begin;
    while (end < line.size() && isOfName(line[end])) ++end;
    const std::size_t mark = std::min(line.find_first_not_of(' ', end), line.size());
    const bool isMarked = mark < line.size() && (line[mark] == '=' || (line[mark] == ':' && mark == end));
    if (end == begin || !isLetter(line[begin]) || !isMarked) return std::nullopt;
    std::size_t number = mark + 1;
    while (number < line.size() && line[number] == ' ') ++number;
    const std::size_t digit = number + (number < line.size() && (line[number] == '-' || line[number] == '+'));
    if (digit >= line.size() || !(isDigit(line[digit]) || line[digit] == '.')) return std::nullopt;
    return Found{line.substr(begin, end - begin), begin, number};
}

std::vector<Found> labelsIn(std::string_view line) {
    std::vector<Found> labels;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (i > 0 && !isGap(line[i - 1])) continue;
        if (const auto label = labelAt(line, i)) {
            labels.push_back(*label);
            i = label->number;
        }
    }
    return labels;
}

/// A stamp in front of a line with a mark around or behind it.
struct StampFrame {
    bool hasBrackets{};
    std::size_t end{};  // of the closing bracket or of the arrow
};

std::optional<StampFrame> frameOf(std::string_view line) {
    if (line.starts_with('[')) {
        const std::size_t close = line.find(']');
        if (close == std::string_view::npos || !readStamp(withoutBlanks(line.substr(1, close - 1))))
            return std::nullopt;
        return StampFrame{true, close + 1};
    }
    const std::size_t arrow = line.find(" -> ");
    if (arrow == std::string_view::npos || !readStamp(withoutBlanks(line.substr(0, arrow)))) return std::nullopt;
    return StampFrame{false, arrow + 3};
}

/// What parts the cells behind the stamp; the stamp is parted from them by the same.
char separatorBehind(std::string_view rest) {
    for (const char c : {'\t', ';', ','})
        if (rest.find(c) != std::string_view::npos) return c;
    return ' ';
}

void blankFrame(std::string& line, const StampFrame& frame) {
    const char separator = separatorBehind(std::string_view(line).substr(frame.end));
    if (frame.hasBrackets) line.front() = ' ';
    for (std::size_t i = frame.hasBrackets ? frame.end - 1 : frame.end - 2; i < frame.end; ++i) line[i] = ' ';
    line[frame.end - 1] = separator;
}

/// What the first lines have in common.
struct Pattern {
    std::vector<std::string> names;
    bool hasFrames{};
};

Pattern patternOf(TextView text) {
    constexpr int most = 50, fewest = 3;
    constexpr double nearlyAll = 0.9;  // a serial line may begin in mid row
    LineReader reader(text);
    std::vector<std::vector<std::string>> lists;
    int framed = 0, lines = 0;
    for (TextLine line; lines < most && reader.next(line);) {
        if (isEmptyLine(line.text)) continue;
        ++lines;
        framed += frameOf(line.text).has_value();
        lists.emplace_back();
        for (const Found& label : labelsIn(line.text)) lists.back().emplace_back(label.name);
    }
    if (lines < fewest) return {};
    const std::vector<std::string>& usual = lists[lists.size() / 2];
    const auto alike = std::count(lists.begin(), lists.end(), usual);
    Pattern pattern;
    if (static_cast<double>(alike) >= nearlyAll * lines) pattern.names = usual;
    pattern.hasFrames = framed >= nearlyAll * lines;
    return pattern;
}

/// In each line of a text that has some, its own place.
void blankLabels(char* begin, char* end, bool hasFrames) {
    LineReader reader(std::string_view(begin, static_cast<std::size_t>(end - begin)));
    for (TextLine line; reader.next(line);) {
        std::string plain(line.text);
        for (const Found& label : labelsIn(line.text))
            std::fill(plain.begin() + static_cast<std::ptrdiff_t>(label.begin),
                      plain.begin() + static_cast<std::ptrdiff_t>(label.number), ' ');
        const std::optional<StampFrame> frame = hasFrames ? frameOf(line.text) : std::nullopt;
        if (frame) blankFrame(plain, *frame);
        std::copy(plain.begin(), plain.end(), begin + (line.text.data() - begin));
    }
}

/// The first lines, as they are.
std::string firstLines(TextView text) {
    constexpr int lines = 200;
    LineReader reader(text);
    const char* end = text.text.data();
    TextLine line;
    for (int i = 0; i < lines && reader.next(line); ++i) end = line.text.data() + line.text.size();
    return std::string(text.text.data(), end);
}

}  // namespace

std::optional<LabelledText> withoutLabels(TextView text, std::string& store) {
    const Pattern pattern = patternOf(text);
    if (pattern.names.empty() && !pattern.hasFrames) return std::nullopt;
    LabelledText result{text, firstLines(text), pattern.names};
    result.text = text.withLines(
        [hasFrames = pattern.hasFrames](char* begin, char* end) { blankLabels(begin, end, hasFrames); }, store);
    return result;
}

void nameByLabels(Layout& layout, const LabelledText& labelled) {
    if (labelled.names.empty() || layout.headerLine > 0 || layout.offset > labelled.head.size()) return;
    LineReader reader(std::string_view(labelled.head).substr(layout.offset));
    for (TextLine line; reader.next(line);) {
        const std::vector<Found> labels = labelsIn(line.text);
        if (labels.size() != labelled.names.size()) continue;
        const auto at = static_cast<std::size_t>(line.text.data() - labelled.head.data());
        const std::string_view plain = labelled.text.from(at).front(line.text.size());
        const CsvRow row = splitCsvRow(plain, layout.separator);
        for (std::size_t i = 0; i < std::min(row.cells.size(), layout.columns.size()); ++i)
            for (const Found& label : labels)
                if (static_cast<std::size_t>(row.cells[i].position) == label.number + 1)
                    layout.columns[i].name = label.name;
        break;
    }
    // of a missing header and the names that stand for one
    std::erase_if(layout.warnings, [](const Diagnostic& d) { return d.message == "the file has no header"; });
}

}  // namespace analogon
