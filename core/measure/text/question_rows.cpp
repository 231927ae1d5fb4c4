#include "core/measure/text/question_rows.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/measure/encoding.hpp"
#include "core/measure/mapped_file.hpp"
#include "core/measure/text/text_file.hpp"
#include "core/measure/text/text_line.hpp"

namespace analogon {

namespace {

constexpr std::size_t headBytes = std::size_t{1} << 16;
constexpr int linesBehind = 30;

/// Whole lines: as many as tell the readings apart, and some behind the one that is asked about.
std::string_view headFor(std::string_view bytes, const Question& question) {
    std::size_t end = 0;
    int line = 0;
    while (end < bytes.size() && (end < headBytes || line < question.line + linesBehind)) {
        end = bytes.find('\n', end);
        end = end == std::string_view::npos ? bytes.size() : end + 1;
        ++line;
    }
    return bytes.substr(0, end);
}

/// Where another question follows, its first reading stands for all of them here.
std::optional<TextFile> readHead(std::string_view head, const std::string& name, ReadOptions options) {
    constexpr int mostQuestions = 4;
    for (int i = 0; i < mostQuestions; ++i) {
        Questions asked;
        if (Outcome<TextFile> file = readTextFile(head, name, options, {}, asked)) return std::move(*file);
        if (asked.empty() || asked.back().readings.empty()) return std::nullopt;
        options = asked.back().readings.front().options;
    }
    return std::nullopt;
}

/// The moment of an ISO 8601 text [ns since 1970]; none: there is none.
std::optional<std::int64_t> momentOf(const std::string& start) {
    constexpr std::int64_t day = 86400'000'000'000;
    const std::optional<Stamp> stamp = readStamp(start);
    const auto date = stamp && stamp->hasDate() ? dayOf(*stamp, DateOrder::YearMonthDay) : std::nullopt;
    return date ? std::optional(*date * day + stamp->nanoseconds) : std::nullopt;
}

using ValuesByLine = std::map<int, Text>;

/// "0.5 A at 0.02 s": readings that differ in the times of the channels alone have the same values.
Text withTime(Text value, const TextGroup& group, std::size_t row) {
    const Column& time = group.table.columns[*group.time];
    return phrase("{} at {:.10g} {}", std::move(value), time.values[row], time.unit.empty() ? "s" : time.unit);
}

ValuesByLine valuesOf(const TextFile& file, const TextGroup& group, std::size_t index, bool isOfTimes) {
    const Column& column = group.table.columns[index];
    const std::optional<std::int64_t> start = group.time == index ? momentOf(file.start) : std::nullopt;
    ValuesByLine values;
    for (std::size_t row = 0; row < column.values.size(); ++row) {
        const double value = column.values[row];
        if (std::isnan(value)) continue;
        Text& text = values[group.table.lines[row]];
        if (start) {
            std::string moment = isoText(*start + std::llround(value * 1e9));
            moment[moment.find('T')] = ' ';
            text = std::move(moment);
        } else {
            const bool isNumber = column.unit.empty() || column.unit == "1";
            text = isNumber ? phrase("{:.10g}", value) : phrase("{:.10g} {}", value, column.unit);
        }
        if (isOfTimes && group.time && group.time != index) text = withTime(std::move(text), group, row);
    }
    return values;
}

/// The values of all columns of numbers, by name.
using Columns = std::vector<std::pair<std::string, ValuesByLine>>;

/// What is a time in one of the readings at least.
std::set<std::string> timesIn(const std::vector<std::optional<TextFile>>& readings) {
    std::set<std::string> times;
    for (const std::optional<TextFile>& file : readings)
        if (file)
            for (const TextGroup& group : file->groups)
                if (group.time) times.insert(group.table.columns[*group.time].name);
    return times;
}

/// `apart`: names of columns that are left out; none: values are shown without their times.
Columns columnsOf(const std::optional<TextFile>& file, const std::set<std::string>& apart) {
    Columns columns;
    if (!file) return columns;
    for (const TextGroup& group : file->groups)
        for (std::size_t i = 0; i < group.kinds.size(); ++i)
            if (group.kinds[i] != CellKind::Words && !apart.contains(group.table.columns[i].name))
                columns.emplace_back(group.table.columns[i].name, valuesOf(*file, group, i, !apart.empty()));
    return columns;
}

const ValuesByLine* find(const Columns& columns, const std::string& name) {
    const auto found = std::find_if(columns.begin(), columns.end(), [&](const auto& c) { return c.first == name; });
    return found == columns.end() ? nullptr : &found->second;
}

Text valueIn(const Columns& columns, const std::string& name, int line) {
    const ValuesByLine* const values = find(columns, name);
    const auto found = values ? values->find(line) : ValuesByLine::const_iterator{};
    return values && found != values->end() ? found->second : Text{};
}

class RowFinder {
public:
    RowFinder(std::string_view head, std::vector<Columns> readings, std::size_t most)
        : head_(head), readings_(std::move(readings)), most_(most) {}

    QuestionRows find() {
        for (const Columns& columns : readings_)
            for (const auto& [name, values] : columns) {
                QuestionRows found{name, {}};
                for (const auto& [line, value] : values)  // from the first that differs on
                    if (found.rows.size() < most_ && (!found.rows.empty() || differs(name, line)))
                        found.rows.push_back({line, {}, at(name, line)});
                if (!found.rows.empty()) return withTexts(std::move(found));
            }
        return withTexts(firstRows());
    }

private:
    std::vector<Text> at(const std::string& name, int line) const {
        std::vector<Text> values;
        for (const Columns& columns : readings_) values.push_back(valueIn(columns, name, line));
        return values;
    }

    bool differs(const std::string& name, int line) const {
        const std::vector<Text> values = at(name, line);
        return std::any_of(values.begin(), values.end(), [&](const Text& text) { return !(text == values.front()); });
    }

    /// Of readings that do not differ, or of a single one.
    QuestionRows firstRows() const {
        constexpr std::size_t shown = 3;
        QuestionRows rows;
        if (readings_.empty() || readings_.front().empty()) return rows;
        const Columns& columns = readings_.front();
        for (const auto& [line, value] : columns.front().second) {
            if (rows.rows.size() == most_) break;
            Text text = value;
            for (std::size_t i = 1; i < std::min(shown, columns.size()); ++i)
                (text += "   ") += valueIn(columns, columns[i].first, line);
            rows.rows.push_back({line, {}, std::vector<Text>(readings_.size(), text)});
        }
        return rows;
    }

    QuestionRows withTexts(QuestionRows rows) const {
        LineReader reader(head_);
        auto row = rows.rows.begin();
        for (TextLine line; row != rows.rows.end() && reader.next(line);)
            if (line.number == row->line) (row++)->text = inUtf8(line.text);
        return rows;
    }

    std::string_view head_;
    std::vector<Columns> readings_;
    std::size_t most_;
};

}  // namespace

QuestionRows rowsUnder(std::string_view bytes, const std::string& name, const Question& question, std::size_t most) {
    std::string decoded;
    if (isWideText(bytes)) bytes = decoded = decodeText(bytes);
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    const std::string_view head = headFor(bytes, question);
    std::vector<std::optional<TextFile>> files;
    for (const Reading& reading : question.readings) {
        ReadOptions options = reading.options;
        if (!decoded.empty()) options.encoding.clear();
        files.push_back(readHead(head, name, options));
    }
    const bool isOfTimes = std::any_of(question.readings.begin(), question.readings.end(), [&](const Reading& reading) {
        return reading.options.times != question.readings.front().options.times;
    });
    const std::set<std::string> apart = isOfTimes ? timesIn(files) : std::set<std::string>{};
    std::vector<Columns> readings;
    for (const std::optional<TextFile>& file : files) readings.push_back(columnsOf(file, apart));
    return RowFinder(head, std::move(readings), most).find();
}

QuestionRows rowsUnder(const std::filesystem::path& file, const Question& question, std::size_t most) {
    const Outcome<std::shared_ptr<const MappedFile>> mapped = MappedFile::open(file);
    if (!mapped) return {};
    return rowsUnder((*mapped)->bytes().text(), file.string(), question, most);
}

}  // namespace analogon
