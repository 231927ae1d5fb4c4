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
    if (json.at(3).get<bool>()) return Text::number(textOf(json.at(0)));
    std::vector<Text> arguments;
    for (const Json& argument : json.at(2)) arguments.push_back(textFrom(argument));
    return Text(textOf(json.at(1)), std::move(arguments), textOf(json.at(0)));
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
    VariablePlace place{textOf(json.at(0)), {}, json.at(2), json.at(3), json.at(4), json.at(5), json.at(6)};
    for (const Json& step : json.at(1)) place.steps.push_back({textOf(step.at(0)), step.at(1)});
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
    group.name = textOf(json.at(0));
    group.master = static_cast<MasterKind>(json.at(1).get<int>());
    if (!json.at(2).is_null()) group.masterChannel = json.at(2).get<std::size_t>();
    group.samples = json.at(3);
    for (const Json& c : json.at(4))
        group.channels.push_back({textOf(c.at(0)),
                                  textOf(c.at(1)),
                                  textOf(c.at(2)),
                                  {},
                                  ChannelKind::Number,
                                  c.at(3).get<std::size_t>(),
                                  c.at(4)});
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

namespace {

/// `decode` of the head, where all of it is as it was written: the process that wrote it may have been damaged.
template <class Decode>
auto decoded(const std::string& bytes, const Decode& decode) -> decltype(decode(Json(), std::size_t{})) {
    std::size_t at = 0;
    try {
        const Json head = headOf(bytes, at);
        if (head.is_object()) return decode(head, at);
    } catch (const Json::exception&) {
    }
    return notWhole();
}

bool isSound(const Channels& channels) {
    if (channels.places.size() != channels.groups.size()) return false;
    for (std::size_t g = 0; g < channels.groups.size(); ++g) {
        const RecordedGroup& group = channels.groups[g];
        const bool isKind = group.master >= MasterKind::Time && group.master <= MasterKind::None;
        if (!isKind || channels.places[g].size() != group.channels.size()) return false;
        for (std::size_t c = 0; c < group.channels.size(); ++c)
            if (group.channels[c].samples != channels.places[g][c].count) return false;
        if (group.masterChannel && *group.masterChannel >= group.channels.size()) return false;
    }
    return true;
}

}  // namespace

Outcome<Channels> decodedChannels(const std::string& bytes) {
    return decoded(bytes, [](const Json& head, std::size_t) -> Outcome<Channels> {
        Diagnostics told = diagnosticsFrom(head.at("diagnostics"));
        if (!head.contains("groups")) return hasError(told) ? told : Diagnostics{notWhole()};
        Channels channels;
        for (const Json& group : head.at("groups")) channels.groups.push_back(groupFrom(group));
        for (const Json& note : head.at("notes")) channels.notes.push_back(textFrom(note));
        for (const Json& group : head.at("places")) {
            channels.places.emplace_back();
            for (const Json& place : group) channels.places.back().push_back(placeFrom(place));
        }
        if (!isSound(channels)) return notWhole();
        return {std::move(channels), std::move(told)};
    });
}

Outcome<std::vector<ChannelValues>> decodedValues(const std::string& bytes) {
    return decoded(bytes, [&](const Json& head, std::size_t at) -> Outcome<std::vector<ChannelValues>> {
        Diagnostics told = diagnosticsFrom(head.at("diagnostics"));
        if (!head.contains("counts")) return hasError(told) ? told : Diagnostics{notWhole()};
        std::vector<ChannelValues> values;
        for (const Json& count : head.at("counts")) {
            const auto numbers = count.get<std::size_t>();
            if (numbers > (bytes.size() - at) / sizeof(double)) return notWhole();
            values.push_back({std::vector<double>(numbers), {}});
            std::memcpy(values.back().numbers.data(), bytes.data() + at, numbers * sizeof(double));
            at += numbers * sizeof(double);
        }
        return {std::move(values), std::move(told)};
    });
}

}  // namespace analogon::mat
