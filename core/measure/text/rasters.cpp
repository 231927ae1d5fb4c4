#include "core/measure/text/rasters.hpp"

#include <algorithm>
#include <cmath>

#include "core/measure/text/channel_times.hpp"
#include "core/measure/text/column_meaning.hpp"
#include "core/measure/text/remark.hpp"
#include "core/measure/text/time_column.hpp"

namespace analogon {

namespace {

template <class Value>
std::vector<Value> kept(const std::vector<Value>& values, const std::vector<std::size_t>& rows) {
    std::vector<Value> out;
    if (values.empty()) return out;
    out.reserve(rows.size());
    for (const std::size_t row : rows) out.push_back(values[row]);
    return out;
}

/// The columns of one time in the rows in which it has a stamp.
TextGroup cutGroup(const RawTable& raw, const std::vector<std::vector<StatusText>>& statuses, const ChannelTime& over) {
    TextGroup group;
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < raw.table.lines.size(); ++i)
        if (!std::isnan(raw.table.columns[over.time].values[i])) rows.push_back(i);
    group.table.file = raw.table.file;
    group.table.lines = kept(raw.table.lines, rows);
    for (const std::size_t i : over.columns) {
        const Column& from = raw.table.columns[i];
        Column column{from.name, from.unit, kept(from.values, rows), {}, from.header, from.line, from.position};
        column.blanks = blanksOf(column.values);
        if (i == over.time) group.time = group.table.columns.size();
        group.table.columns.push_back(std::move(column));
        group.kinds.push_back(raw.kinds[i]);
        group.words.push_back(raw.words[i].size() == 0 ? WordSeries{} : raw.words[i].only(rows));
        group.statuses.push_back(statuses[i]);
    }
    return group;
}

TextGroup wholeGroup(RawTable raw, std::vector<std::vector<StatusText>> statuses, std::optional<std::size_t> time) {
    TextGroup group;
    group.table = std::move(raw.table);
    group.kinds = std::move(raw.kinds);
    group.words = std::move(raw.words);
    group.statuses = std::move(statuses);
    group.time = time;
    return group;
}

/// Rows that are written only when something switches must not be joined by straight lines.
void tellSwitches(const TextGroup& group, Diagnostics& told) {
    const std::vector<double>& stamps = group.table.columns[*group.time].values;
    double least = INFINITY, most = 0;
    for (std::size_t i = 1; i < stamps.size(); ++i) {
        const double step = stamps[i] - stamps[i - 1];
        if (step > 0) least = std::min(least, step);
        most = std::max(most, step);
    }
    if (!(most > 3 * least)) return;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < group.kinds.size(); ++i)
        if (i != *group.time && isSwitch(group.table.columns[i])) names.push_back(group.table.columns[i].name);
    if (names.empty() || names.size() > 20) return;
    told.push_back(doubt(
        phrase("{} switch between 0 and 1 and the rows come at uneven times: they seem to be written when "
               "something changes",
               listed(names)),
        group.table.file, 0, phrase("As inputs they are held from row to row with \"interpolation\": \"hold\".")));
}

/// Words in a column whose header has a unit, or whose cells begin as numbers do, were meant as numbers.
void tellTexts(const TextGroup& group, Diagnostics& told) {
    constexpr std::size_t most = 5;
    std::size_t count = 0;
    for (std::size_t i = 0; i < group.kinds.size() && count < most; ++i) {
        const WordSeries& words = group.words[i];
        if (group.kinds[i] != CellKind::Words || words.distinct().empty()) continue;
        const std::string& first = words.distinct().front();
        const std::size_t digit = first.find_first_not_of("+-(");
        const bool beginsAsNumber = digit != std::string::npos && first[digit] >= '0' && first[digit] <= '9';
        if (!beginsAsNumber && group.table.columns[i].unit.empty()) continue;
        told.push_back(doubt(
            phrase("column '{}' is read as text: '{}' is no number", cited(group.table.columns[i].name), cited(first)),
            group.table.file, group.table.lines.front()));
        ++count;
    }
}

}  // namespace

namespace {

void tellAll(Diagnostics& told, Diagnostics more) {
    for (Diagnostic& each : more) told.push_back(std::move(each));
}

std::vector<TextGroup> cutGroups(RawTable raw, const std::optional<NamedRows>& named, const ReadOptions& options,
                                 Diagnostics& told, Questions& asked) {
    std::vector<std::vector<StatusText>> statuses = readSwitches(raw);
    for (std::size_t i = 0; i < statuses.size(); ++i)
        if (!statuses[i].empty())
            told.push_back(doubt(phrase("the words '{}' and '{}' in column '{}' are read as 0 and 1",
                                        statuses[i][0].text, statuses[i][1].text, cited(raw.table.columns[i].name)),
                                 raw.table.file));
    const std::optional<std::size_t> time = timeColumn(raw.table, raw.kinds);
    std::vector<TextGroup> groups;
    if (named && time) {
        Outcome<std::vector<TextGroup>> channels = channelsOf(raw, *named, *time);
        tellAll(told, channels.diagnostics());
        return channels ? std::move(*channels) : std::vector<TextGroup>{};
    }
    if (time) tellAll(told, tellMixedRows(raw, *time));
    const std::vector<ChannelTime> times =
        time ? timesOfChannels(raw, *time, options, told, asked) : std::vector<ChannelTime>{};
    if (times.size() < 2)
        groups.push_back(wholeGroup(std::move(raw), std::move(statuses), time));
    else
        for (const ChannelTime& over : times) groups.push_back(cutGroup(raw, statuses, over));
    return groups;
}

}  // namespace

std::vector<TextGroup> groupsOf(RawTable raw, const std::optional<NamedRows>& named,
                                const std::map<std::string, std::string>& comments, const ReadOptions& options,
                                Diagnostics& told, Questions& asked) {
    std::vector<TextGroup> groups = cutGroups(std::move(raw), named, options, told, asked);
    for (TextGroup& group : groups) {
        for (const Column& column : group.table.columns) {
            const auto comment = comments.find(column.name);
            group.comments.push_back(comment == comments.end() ? std::string() : comment->second);
        }
        tellTexts(group, told);
        if (!group.time) continue;
        tellAll(told, nameCountedUnit(group.table, *group.time, options, asked));
        tellAll(told, mendRepeatedStamps(group.table, *group.time));
        tellSwitches(group, told);
    }
    return groups;
}

}  // namespace analogon
