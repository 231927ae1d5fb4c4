#include "core/measure/text/text_recording.hpp"

#include <algorithm>
#include <cstdint>

#include "core/measure/table.hpp"
#include "core/measure/text/column_meaning.hpp"
#include "core/measure/text/rasters.hpp"
#include "core/measure/text/text_file.hpp"
#include "core/measure/text/time_column.hpp"

namespace analogon {

namespace {

std::vector<std::optional<std::string>> textsOf(const WordSeries& words) {
    std::vector<std::optional<std::string>> texts(words.size());
    for (std::size_t row = 0; row < texts.size(); ++row)
        if (const std::string* const word = words.at(row)) texts[row] = *word;
    return texts;
}

class TextValues final : public RecordingReader {
public:
    explicit TextValues(std::vector<TextGroup> groups) : groups_(std::move(groups)) {}

    Outcome<std::vector<ChannelValues>> read(std::size_t group, std::span<const std::size_t> channels,
                                             const Progress&) const override {
        std::vector<ChannelValues> values;
        const TextGroup& from = groups_[group];
        for (const std::size_t channel : channels) {
            if (from.kinds[channel] == CellKind::Words)
                values.push_back({{}, textsOf(from.words[channel])});
            else
                values.push_back({from.table.columns[channel].values, {}});
        }
        return values;
    }

private:
    std::vector<TextGroup> groups_;
};

RecordedGroup recordedGroup(const TextGroup& group) {
    RecordedGroup recorded;
    recorded.name = group.name;
    recorded.samples = group.table.lines.size();
    recorded.masterChannel = group.time;
    recorded.master = group.time ? MasterKind::Time : MasterKind::None;
    for (std::size_t i = 0; i < group.kinds.size(); ++i) {
        const Column& column = group.table.columns[i];
        RecordedChannel channel{column.name, column.unit, group.comments[i], {}, ChannelKind::Number, recorded.samples};
        if (group.kinds[i] == CellKind::Words) channel.kind = ChannelKind::Text;
        if (!group.statuses[i].empty()) {
            channel.kind = ChannelKind::Status;
            channel.statusTexts = group.statuses[i];
        }
        channel.isInteger = channel.kind == ChannelKind::Status;
        recorded.channels.push_back(std::move(channel));
    }
    return recorded;
}

void tellMissingUnits(const TextGroup& group, std::vector<Text>& notes) {
    constexpr std::size_t shown = 8;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < group.kinds.size(); ++i)
        if (group.kinds[i] != CellKind::Words && group.table.columns[i].unit.empty() && group.statuses[i].empty())
            names.push_back(group.table.columns[i].name);
    if (names.empty()) return;
    const std::size_t count = names.size();
    names.resize(std::min(shown, count));
    notes.push_back(count <= shown ? phrase("no unit is given for {}", listed(names))
                                   : phrase("no unit is given for {} columns, first {}", count, listed(names)));
}

/// The columns that hold numbers, and the names of the others.
Table tableOf(TextGroup group, std::size_t number, bool isAlone) {
    Table table;
    table.file = group.table.file;
    table.lines = std::move(group.table.lines);
    for (std::size_t i = 0; i < group.kinds.size(); ++i) {
        Column& column = group.table.columns[i];
        if (group.kinds[i] == CellKind::Words) {
            table.texts.push_back(column.name);
            continue;
        }
        if (group.time == i) table.time = table.columns.size();
        column.isHeld = !group.statuses[i].empty();
        column.group = isAlone ? std::string() : group.name;
        column.groupNumber = number;
        table.columns.push_back(std::move(column));
    }
    return table;
}

Diagnostics warningsOf(const Diagnostics& all) {
    Diagnostics warnings;
    for (const Diagnostic& diagnostic : all)
        if (diagnostic.severity == Severity::Warning) warnings.push_back(diagnostic);
    return warnings;
}

/// The values of a text that has become a table: columns of words have none there.
class TableValues final : public RecordingReader {
public:
    TableValues(std::shared_ptr<const Table> table, const std::vector<RecordedGroup>& groups)
        : table_(std::move(table)) {
        for (const RecordedGroup& group : groups) {
            std::vector<std::size_t>& columns = columns_.emplace_back();
            std::size_t next = 0;
            for (const RecordedChannel& channel : group.channels)
                columns.push_back(channel.kind == ChannelKind::Text ? none : next++);
        }
    }

    Outcome<std::vector<ChannelValues>> read(std::size_t group, std::span<const std::size_t> channels,
                                             const Progress&) const override {
        const Table& table = group == 0 ? *table_ : *table_->others[group - 1];
        std::vector<ChannelValues> values;
        for (const std::size_t channel : channels) {
            const std::size_t column = columns_[group][channel];
            values.push_back({column == none ? std::vector<double>() : table.columns[column].values, {}});
        }
        return values;
    }

private:
    static constexpr std::size_t none = SIZE_MAX;
    std::shared_ptr<const Table> table_;
    std::vector<std::vector<std::size_t>> columns_;  // by group and channel
};

Table tablesOf(std::vector<TextGroup> groups) {
    const bool isAlone = groups.size() == 1;
    Table first = tableOf(std::move(groups.front()), 1, isAlone);
    for (std::size_t i = 1; i < groups.size(); ++i)
        first.others.push_back(std::make_shared<const Table>(tableOf(std::move(groups[i]), i + 1, isAlone)));
    return first;
}

MeasurementFile recordingOf(const TextFile& file, const std::string& name) {
    MeasurementFile recording;
    recording.file = name;
    recording.format = file.format;
    recording.start = file.start;
    recording.notes.push_back(file.found);
    for (const TextGroup& group : file.groups) {
        recording.groups.push_back(recordedGroup(group));
        tellMissingUnits(group, recording.notes);
        if (group.time)
            for (const Diagnostic& odd : oddStamps(group.table, *group.time)) recording.notes.push_back(odd.message);
    }
    return recording;
}

LookedAtText lookedAt(Outcome<TextFile> read, const std::string& name, Questions asked) {
    if (!read) return {read.diagnostics(), nullptr, std::move(asked)};
    MeasurementFile recording = recordingOf(*read, name);
    auto table = std::make_shared<const Table>(tablesOf(std::move(read->groups)));
    recording.reader = std::make_shared<TableValues>(table, recording.groups);
    return {{std::move(table), warningsOf(read.diagnostics())},
            std::make_shared<const MeasurementFile>(std::move(recording)),
            std::move(asked)};
}

Outcome<Table> tablesOf(Outcome<TextFile> read) {
    if (!read) return read.diagnostics();
    return {tablesOf(std::move(read->groups)), warningsOf(read.diagnostics())};
}

Outcome<MeasurementFile> opened(Outcome<TextFile> read, const std::string& name) {
    if (!read) return read.diagnostics();
    MeasurementFile recording = recordingOf(*read, name);
    recording.reader = std::make_shared<TextValues>(std::move(read->groups));
    return {std::move(recording), read.diagnostics()};
}

}  // namespace

LookedAtText lookAtText(std::string_view bytes, const std::string& name, const ReadOptions& options,
                        const Progress& progress) {
    Questions asked;
    Outcome<TextFile> read = readTextFile(bytes, name, options, progress, asked);
    return lookedAt(std::move(read), name, std::move(asked));
}

LookedAtText lookAtText(const std::filesystem::path& file, const ReadOptions& options, const Progress& progress) {
    Questions asked;
    Outcome<TextFile> read = readTextFile(file, options, progress, asked);
    return lookedAt(std::move(read), file.string(), std::move(asked));
}

Outcome<Table> textTables(std::string_view bytes, const std::string& name, const ReadOptions& options,
                          const Progress& progress) {
    return tablesOf(readTextFile(bytes, name, options, progress));
}

Outcome<Table> readTextTables(const std::filesystem::path& file, const ReadOptions& options, const Progress& progress) {
    Questions asked;
    return tablesOf(readTextFile(file, options, progress, asked));
}

Outcome<MeasurementFile> openTextOf(std::string_view bytes, const std::string& name, const ReadOptions& options) {
    return opened(readTextFile(bytes, name, options), name);
}

Outcome<MeasurementFile> openText(const std::filesystem::path& file, const ReadOptions& options) {
    Questions asked;
    return opened(readTextFile(file, options, {}, asked), file.string());
}

}  // namespace analogon
