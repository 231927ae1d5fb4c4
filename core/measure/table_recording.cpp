#include "core/measure/table_recording.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/base/unit.hpp"

namespace analogon {

namespace {

class TableReader final : public RecordingReader {
public:
    explicit TableReader(Table table) : table_(std::move(table)) {}

    Outcome<std::vector<ChannelValues>> read(std::size_t, std::span<const std::size_t> channels,
                                             const Progress&) const override {
        std::vector<ChannelValues> values;
        for (const std::size_t channel : channels) values.push_back({table_.columns[channel].values, {}});
        return values;
    }

private:
    Table table_;
};

bool neverFalls(const std::vector<double>& values) {
    return values.size() > 1 && std::is_sorted(values.begin(), values.end()) && values.front() < values.back();
}

}  // namespace

bool namesTime(std::string_view name) {
    static constexpr std::array<std::string_view, 10> names{"t",    "time",  "zeit",    "timestamp",  "zeitstempel",
                                                            "tijd", "temps", "elapsed", "datum/zeit", "date/time"};
    std::string lower(name);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::find(names.begin(), names.end(), lower) != names.end() || lower.starts_with("time") ||
           lower.starts_with("zeit");
}

MeasurementFile recordingOf(Table table, std::string format) {
    MeasurementFile recording;
    recording.file = table.file;
    recording.format = std::move(format);
    RecordedGroup group;
    group.samples = table.rows();
    for (const Column& column : table.columns)
        group.channels.push_back({column.name, column.unit, {}, {}, ChannelKind::Number, column.values.size()});
    for (std::size_t i = 0; i < table.columns.size() && !group.masterChannel; ++i) {
        const Column& column = table.columns[i];
        const bool isTime = column.unit.empty() ? namesTime(column.name) : areConvertible(column.unit, "s");
        if (isTime && neverFalls(column.values)) group.masterChannel = i;
    }
    if (group.masterChannel)
        group.master = MasterKind::Time;
    else
        recording.notes.push_back(phrase("no column is a time by its unit or its name"));
    recording.groups.push_back(std::move(group));
    recording.reader = std::make_shared<TableReader>(std::move(table));
    return recording;
}

}  // namespace analogon
