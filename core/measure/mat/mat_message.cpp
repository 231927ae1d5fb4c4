#include "core/measure/mat/mat_message.hpp"

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

namespace analogon::mat {

namespace {

using Json = nlohmann::json;

/// Names in a file may be in any encoding: bytes, not text.
Json bytesOf(const std::string& text) { return Json::binary({text.begin(), text.end()}); }
std::string textOf(const Json& json) {
    const auto& bytes = json.get_binary();
    return {bytes.begin(), bytes.end()};
}

Json toJson(const Text& text) {
    Json arguments = Json::array();
    for (const Text& argument : text.arguments()) arguments.push_back(toJson(argument));
    return {bytesOf(text.english()), bytesOf(text.pattern()), std::move(arguments), text.isNumber()};
}

Text textFrom(const Json& json) {
    if (json[3].get<bool>()) return Text::number(textOf(json[0]));
    std::vector<Text> arguments;
    for (const Json& argument : json[2]) arguments.push_back(textFrom(argument));
    return Text(textOf(json[1]), std::move(arguments), textOf(json[0]));
}

Json toJson(const Diagnostics& diagnostics) {
    Json list = Json::array();
    for (const Diagnostic& d : diagnostics)
        list.push_back({toJson(d.message), bytesOf(d.place.file), toJson(d.hint), static_cast<int>(d.severity)});
    return list;
}

Diagnostics diagnosticsFrom(const Json& json) {
    Diagnostics list;
    for (const Json& each : json) {
        list.push_back(fileError(textFrom(each[0]), textOf(each[1]), 0, 0, textFrom(each[2])));
        list.back().severity = static_cast<Severity>(each[3].get<int>());
    }
    return list;
}

Json toJson(const VariablePlace& place) {
    Json steps = Json::array();
    for (const FieldStep& step : place.steps) steps.push_back({bytesOf(step.field), step.index});
    return {
        bytesOf(place.variable), std::move(steps), place.first, place.stride, place.count, place.scale, place.offset};
}

VariablePlace placeFrom(const Json& json) {
    VariablePlace place{textOf(json[0]), {}, json[2], json[3], json[4], json[5], json[6]};
    for (const Json& step : json[1]) place.steps.push_back({textOf(step[0]), step[1]});
    return place;
}

/// Only what the finder of channels sets.
Json toJson(const RecordedGroup& group) {
    Json channels = Json::array();
    for (const RecordedChannel& c : group.channels)
        channels.push_back({bytesOf(c.name), bytesOf(c.unit), bytesOf(c.comment), c.samples, c.isInteger});
    return {bytesOf(group.name), static_cast<int>(group.master),
            group.masterChannel ? Json(*group.masterChannel) : Json(), group.samples, std::move(channels)};
}

RecordedGroup groupFrom(const Json& json) {
    RecordedGroup group;
    group.name = textOf(json[0]);
    group.master = static_cast<MasterKind>(json[1].get<int>());
    if (!json[2].is_null()) group.masterChannel = json[2].get<std::size_t>();
    group.samples = json[3];
    for (const Json& c : json[4])
        group.channels.push_back(
            {textOf(c[0]), textOf(c[1]), textOf(c[2]), {}, ChannelKind::Number, c[3].get<std::size_t>(), c[4]});
    return group;
}

std::string message(const Json& head) {
    const std::vector<std::uint8_t> cbor = Json::to_cbor(head);
    const std::uint64_t length = cbor.size();
    std::string bytes(sizeof length, '\0');
    std::memcpy(bytes.data(), &length, sizeof length);
    bytes.append(cbor.begin(), cbor.end());
    return bytes;
}

/// The head; `at`: where the values begin. Null: the message is not whole.
Json headOf(const std::string& bytes, std::size_t& at) {
    std::uint64_t length = 0;
    if (bytes.size() < sizeof length) return {};
    std::memcpy(&length, bytes.data(), sizeof length);
    if (length > bytes.size() - sizeof length) return {};
    at = sizeof length + length;
    return Json::from_cbor(bytes.begin() + sizeof length, bytes.begin() + static_cast<std::ptrdiff_t>(at), true, false);
}

Diagnostic notWhole() { return fileError(phrase("the file is damaged: it cannot be read as MATLAB 7.3"), {}); }

}  // namespace

std::string encoded(const Outcome<Channels>& channels) {
    Json head{{"diagnostics", toJson(channels.diagnostics())}};
    if (channels) {
        head["groups"] = head["notes"] = head["places"] = Json::array();
        for (const RecordedGroup& group : channels->groups) head["groups"].push_back(toJson(group));
        for (const Text& note : channels->notes) head["notes"].push_back(toJson(note));
        for (const auto& group : channels->places) {
            Json places = Json::array();
            for (const VariablePlace& place : group) places.push_back(toJson(place));
            head["places"].push_back(std::move(places));
        }
    }
    return message(head);
}

std::string encoded(const Outcome<std::vector<ChannelValues>>& values) {
    Json head{{"diagnostics", toJson(values.diagnostics())}};
    if (values) {
        head["counts"] = Json::array();
        for (const ChannelValues& each : *values) head["counts"].push_back(each.numbers.size());
    }
    std::string bytes = message(head);
    if (values)
        for (const ChannelValues& each : *values)
            bytes.append(reinterpret_cast<const char*>(each.numbers.data()), each.numbers.size() * sizeof(double));
    return bytes;
}

Outcome<Channels> decodedChannels(const std::string& bytes) {
    std::size_t at = 0;
    const Json head = headOf(bytes, at);
    if (!head.is_object()) return notWhole();
    if (!head.contains("groups")) return diagnosticsFrom(head["diagnostics"]);
    Channels channels;
    for (const Json& group : head["groups"]) channels.groups.push_back(groupFrom(group));
    for (const Json& note : head["notes"]) channels.notes.push_back(textFrom(note));
    for (const Json& group : head["places"]) {
        channels.places.emplace_back();
        for (const Json& place : group) channels.places.back().push_back(placeFrom(place));
    }
    return {std::move(channels), diagnosticsFrom(head["diagnostics"])};
}

Outcome<std::vector<ChannelValues>> decodedValues(const std::string& bytes) {
    std::size_t at = 0;
    const Json head = headOf(bytes, at);
    if (!head.is_object()) return notWhole();
    if (!head.contains("counts")) return diagnosticsFrom(head["diagnostics"]);
    std::vector<ChannelValues> values;
    for (const Json& count : head["counts"]) {
        const auto numbers = count.get<std::size_t>();
        if (numbers > (bytes.size() - at) / sizeof(double)) return notWhole();
        values.push_back({std::vector<double>(numbers), {}});
        std::memcpy(values.back().numbers.data(), bytes.data() + at, numbers * sizeof(double));
        at += numbers * sizeof(double);
    }
    return {std::move(values), diagnosticsFrom(head["diagnostics"])};
}

}  // namespace analogon::mat
