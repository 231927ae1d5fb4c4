#include "app/analogon-cli/channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <ostream>

#include "core/base/number_text.hpp"
#include "core/base/stop.hpp"
#include "core/measure/open/open_recording.hpp"

namespace analogon::cli {

namespace {

using Json = nlohmann::ordered_json;

/// Values that are held at once while a file is read: 256 MB of numbers.
constexpr std::size_t valuesAtOnce = std::size_t{1} << 25;

const char* name(MasterKind kind) {
    switch (kind) {
        case MasterKind::Time:
            return "time";
        case MasterKind::Angle:
            return "angle";
        case MasterKind::Distance:
            return "distance";
        case MasterKind::Index:
            return "index";
        case MasterKind::None:
            break;
    }
    return "none";
}

const char* name(ChannelKind kind) {
    switch (kind) {
        case ChannelKind::Status:
            return "status";
        case ChannelKind::Text:
            return "text";
        case ChannelKind::Number:
            break;
    }
    return "number";
}

/// By group and channel; empty where values were not asked for.
using Summaries = std::vector<std::vector<ValueSummary>>;

/// What it says and what to do about it.
Text noteOf(const Diagnostic& remark) {
    return remark.hint.empty() ? remark.message : phrase("{} ({})", remark.message, remark.hint);
}

/// As many channels of a group in one pass as fit into memory.
Outcome<Summaries> summarise(MeasurementFile& recording, const Progress& progress) {
    Summaries summaries;
    for (std::size_t g = 0; g < recording.groups.size(); ++g) {
        const RecordedGroup& group = recording.groups[g];
        std::vector<ValueSummary>& list = summaries.emplace_back();
        const std::size_t together = std::max<std::size_t>(1, valuesAtOnce / std::max<std::size_t>(1, group.samples));
        for (std::size_t first = 0; first < group.channels.size(); first += together) {
            std::vector<std::size_t> indices(std::min(together, group.channels.size() - first));
            std::iota(indices.begin(), indices.end(), first);
            const Outcome<std::vector<ChannelValues>> read = recording.reader->read(g, indices, progress);
            if (!read) return read.diagnostics();
            for (const Diagnostic& remark : read.diagnostics()) recording.notes.push_back(remark.message);
            for (std::size_t i = 0; i < indices.size(); ++i) {
                if (group.masterChannel == indices[i])
                    for (Text& note : masterNotes(groupLabel(group, g), (*read)[i].numbers))
                        recording.notes.push_back(std::move(note));
                list.push_back(summaryOf((*read)[i]));
            }
        }
    }
    return summaries;
}

void put(Json& json, const char* key, const std::optional<double>& value) {
    json[key] = value ? Json(*value) : Json(nullptr);
}

Json jsonOf(const RecordedChannel& channel, const ValueSummary* summary) {
    Json json{{"name", channel.name},
              {"unit", channel.unit},
              {"comment", channel.comment},
              {"kind", name(channel.kind)},
              {"samples", channel.samples}};
    if (!summary) return json;
    json["gaps"] = summary->gaps;
    if (channel.kind == ChannelKind::Text) {
        json["first"] = summary->firstText ? Json(*summary->firstText) : Json(nullptr);
        json["last"] = summary->lastText ? Json(*summary->lastText) : Json(nullptr);
        return json;
    }
    put(json, "first", summary->first);
    put(json, "last", summary->last);
    put(json, "min", summary->min);
    put(json, "max", summary->max);
    put(json, "mean", summary->mean);
    return json;
}

Json jsonOf(const MeasurementFile& recording, const Summaries& summaries) {
    Json json{{"file", recording.file}, {"format", recording.format}};
    if (!recording.start.empty()) json["start"] = recording.start;
    json["notes"] = Json::array();
    for (const Text& note : recording.notes) json["notes"].push_back(note.english());
    json["groups"] = Json::array();
    for (std::size_t g = 0; g < recording.groups.size(); ++g) {
        const RecordedGroup& group = recording.groups[g];
        Json channels = Json::array();
        for (std::size_t c = 0; c < group.channels.size(); ++c)
            channels.push_back(jsonOf(group.channels[c], summaries.empty() ? nullptr : &summaries[g][c]));
        json["groups"].push_back({{"name", group.name},
                                  {"master", name(group.master)},
                                  {"samples", group.samples},
                                  {"channels", std::move(channels)}});
    }
    return json;
}

std::string cell(const std::optional<double>& value) { return value ? numberText(*value, 6) : "-"; }

/// Columns of a channel's line.
std::vector<std::string> cellsOf(const RecordedGroup& group, std::size_t index, const ValueSummary* summary) {
    const RecordedChannel& channel = group.channels[index];
    std::vector<std::string> cells{group.masterChannel == index ? "* " + channel.name : "  " + channel.name,
                                   channel.unit, name(channel.kind)};
    if (summary && channel.kind == ChannelKind::Text) {
        cells.insert(cells.end(), {std::to_string(summary->gaps), summary->firstText.value_or("-"),
                                   summary->lastText.value_or("-"), "", "", ""});
    } else if (summary) {
        cells.insert(cells.end(), {std::to_string(summary->gaps), cell(summary->first), cell(summary->last),
                                   cell(summary->min), cell(summary->max), cell(summary->mean)});
    }
    cells.push_back(channel.comment);
    return cells;
}

void print(std::ostream& out, const std::vector<std::vector<std::string>>& lines) {
    std::vector<std::size_t> widths;
    for (const auto& line : lines) {
        widths.resize(std::max(widths.size(), line.size()));
        for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], displayWidth(line[i]));
    }
    for (const auto& line : lines) {
        std::string text;
        for (std::size_t i = 0; i < line.size(); ++i) text += padRight(line[i], widths[i]) + "  ";
        text.erase(text.find_last_not_of(' ') + 1);
        out << text << '\n';
    }
}

void printTable(const MeasurementFile& recording, const Summaries& summaries, std::ostream& out) {
    out << recording.file << ": " << recording.format;
    if (!recording.start.empty()) out << ", start " << recording.start;
    out << '\n';
    for (const Text& note : recording.notes) out << "note: " << note << '\n';
    for (std::size_t g = 0; g < recording.groups.size(); ++g) {
        const RecordedGroup& group = recording.groups[g];
        out << fmt::format("\ngroup {}{}: {} samples over {}\n", g + 1,
                           group.name.empty() ? "" : " \"" + group.name + "\"", group.samples, name(group.master));
        std::vector<std::vector<std::string>> lines{{"  channel", "unit", "kind"}};
        if (!summaries.empty())
            lines.front().insert(lines.front().end(), {"gaps", "first", "last", "min", "max", "mean"});
        lines.front().push_back("comment");
        for (std::size_t c = 0; c < group.channels.size(); ++c)
            lines.push_back(cellsOf(group, c, summaries.empty() ? nullptr : &summaries[g][c]));
        print(out, lines);
    }
    out.flush();
}

}  // namespace

int channels(const Options& options, std::ostream& out, std::ostream& err) {
    Outcome<MeasurementFile> opened = openRecording(options.input);
    if (!opened) {
        err << format(opened.diagnostics()) << std::endl;
        return inputAtFault;
    }
    MeasurementFile& recording = *opened;
    for (const Diagnostic& remark : opened.diagnostics()) recording.notes.push_back(noteOf(remark));
    Summaries summaries;
    if (options.withValues) {
        Outcome<Summaries> read = summarise(recording, Progress(stopInForce(), {}));
        if (!read) {
            err << format(read.diagnostics()) << std::endl;
            return isStopped() ? interrupted : inputAtFault;
        }
        summaries = std::move(*read);
    }
    if (options.asJson)
        out << jsonOf(recording, summaries).dump(2, ' ', false, Json::error_handler_t::replace) << std::endl;
    else
        printTable(recording, summaries, out);
    return done;
}

}  // namespace analogon::cli
