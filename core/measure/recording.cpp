#include "core/measure/recording.hpp"

#include <algorithm>
#include <cmath>

namespace analogon {

std::string statusTextOf(const RecordedChannel& channel, double value) {
    for (const StatusText& status : channel.statusTexts)
        if (value >= status.lower && value <= status.upper) return status.text;
    return std::isnan(value) ? std::string() : channel.otherStatus;
}

Outcome<ChannelValues> readValues(const MeasurementFile& recording, std::size_t group, std::size_t channel,
                                  const Progress& progress) {
    Outcome<std::vector<ChannelValues>> read = recording.reader->read(group, std::span(&channel, 1), progress);
    if (!read) return read.diagnostics();
    return {std::move(read->front()), read.diagnostics()};
}

namespace {

ValueSummary summaryOfTexts(const std::vector<std::optional<std::string>>& texts) {
    ValueSummary summary;
    summary.gaps = static_cast<std::size_t>(std::count(texts.begin(), texts.end(), std::nullopt));
    summary.firstText = texts.front();
    summary.lastText = texts.back();
    return summary;
}

std::optional<double> finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

}  // namespace

ValueSummary summaryOf(const ChannelValues& values) {
    if (!values.texts.empty()) return summaryOfTexts(values.texts);
    ValueSummary summary;
    const std::vector<double>& numbers = values.numbers;
    if (numbers.empty()) return summary;
    double least = INFINITY, most = -INFINITY;
    long double sum = 0;  // the sum of values near the largest double would overflow in one
    std::size_t count = 0;
    for (const double value : numbers) {
        if (!std::isfinite(value)) continue;
        ++count;
        least = std::min(least, value);
        most = std::max(most, value);
        sum += value;
    }
    summary.gaps = numbers.size() - count;
    summary.first = finite(numbers.front());
    summary.last = finite(numbers.back());
    if (count == 0) return summary;
    summary.min = least;
    summary.max = most;
    summary.mean = static_cast<double>(sum / static_cast<long double>(count));
    return summary;
}

std::vector<Text> masterNotes(const std::string& group, std::span<const double> values) {
    std::size_t back = 0, firstBack = 0, repeated = 0, firstRepeated = 0, blank = 0;
    double last = -INFINITY;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) {
            ++blank;
            continue;
        }
        if (values[i] < last && back++ == 0) firstBack = i;
        if (values[i] == last && repeated++ == 0) firstRepeated = i;
        last = values[i];
    }
    std::vector<Text> notes;
    if (back > 0)
        notes.push_back(
            phrase("group \"{}\": its master jumps back {} times, first at sample {}", group, back, firstBack + 1));
    if (repeated > 0)
        notes.push_back(phrase("group \"{}\": {} stamps of its master repeat the one before, first at sample {}", group,
                               repeated, firstRepeated + 1));
    if (blank > 0) notes.push_back(phrase("group \"{}\": {} stamps of its master are no finite numbers", group, blank));
    return notes;
}

std::string groupLabel(const RecordedGroup& group, std::size_t index) {
    return group.name.empty() ? std::to_string(index + 1) : group.name;
}

}  // namespace analogon
