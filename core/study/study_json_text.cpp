#include <array>
#include <nlohmann/json.hpp>

#include "core/study/study.hpp"
#include "core/study/study_format.hpp"

namespace analogon {

namespace {

using Json = nlohmann::ordered_json;

void putGroup(const GroupName& group, Json& json) {
    if (!group.isTold()) return;
    Json& member = json[group.isSheet ? "sheet" : "group"];
    if (group.name.empty())
        member = group.number;
    else
        member = group.name;
}

Json channelJson(const ChannelName& name) {
    if (!name.group.isTold()) return name.column;
    Json json{{"column", name.column}};
    putGroup(name.group, json);
    return json;
}

Json rasterJson(const Raster& raster) {
    return raster.kind == Raster::Kind::Steps ? Json(raster.step) : channelJson(raster.channel);
}

Json readJson(const ReadOptions& read) {
    Json json = Json::object();
    const auto putMark = [&](const char* key, std::optional<char> mark) {
        if (mark) json[key] = std::string(1, *mark);
    };
    putMark("separator", read.separator);
    putMark("decimal", read.decimal);
    putMark("thousands", read.thousands);
    if (read.skip) json["skip"] = *read.skip;
    if (read.header) json["header"] = *read.header;
    if (read.hasUnitsRow) json["units"] = *read.hasUnitsRow;
    if (!read.timeFormat.empty()) json["time_format"] = read.timeFormat;
    if (!read.timeZone.empty()) json["time_zone"] = read.timeZone;
    constexpr std::array<const char*, 4> times{"", "one", "left", "right"};
    if (read.times != TimeColumns::Found) json["times"] = times[static_cast<std::size_t>(read.times)];
    if (!read.encoding.empty()) json["encoding"] = read.encoding;
    for (const auto& [name, unit] : read.unitNames) json["unit_names"][name] = unit;
    return json;
}

Json mappingJson(const ChannelMapping& mapping) {
    ChannelMapping plain;
    plain.column = mapping.column;
    if (mapping == plain) return mapping.column;
    Json json{{"column", mapping.column}};
    putGroup(mapping.group, json);
    if (!mapping.unit.empty()) json["unit"] = mapping.unit;
    if (mapping.scale != plain.scale) json["scale"] = mapping.scale;
    if (mapping.offset != plain.offset) json["offset"] = mapping.offset;
    if (mapping.weight != plain.weight) json["weight"] = mapping.weight;
    if (mapping.fitsClock)
        json["clock"] = "fit";
    else if (mapping.clock != plain.clock)
        json["clock"] = mapping.clock;
    if (mapping.interpolation != plain.interpolation)
        json["interpolation"] = mapping.interpolation == Interpolation::Hold ? "hold" : "linear";
    return json;
}

Json mappingsJson(const std::map<std::string, ChannelMapping>& mappings) {
    Json json = Json::object();
    for (const auto& [name, mapping] : mappings) json[name] = mappingJson(mapping);
    return json;
}

Json startJson(const StudyStart& start) {
    if (const double* number = std::get_if<double>(&start)) return *number;
    if (const ColumnStart* column = std::get_if<ColumnStart>(&start))
        return channelJson({column->column, column->group});
    return "fit";
}

Json experimentJson(const StudyExperiment& experiment) {
    Json json{{"name", experiment.name},
              {"role", experiment.role == Role::Fit ? "fit" : "validate"},
              {"file", experiment.file}};
    if (!experiment.isUsed) json["use"] = false;
    if (!experiment.isTimeOfFile) json["time"] = channelJson({experiment.timeColumn, experiment.timeGroup});
    if (experiment.read != ReadOptions{}) json["read"] = readJson(experiment.read);
    if (experiment.raster.kind != Raster::Kind::Outputs) json["raster"] = rasterJson(experiment.raster);
    if (experiment.range) json["range"] = Json::array({experiment.range->first, experiment.range->second});
    json["inputs"] = mappingsJson(experiment.inputs);
    json["outputs"] = mappingsJson(experiment.outputs);
    for (const auto& [name, start] : experiment.initial) json["initial"][name] = startJson(start);
    return json;
}

Json parameterJson(const StudyParameter& parameter) {
    Json json{{"fit", parameter.fit}};
    if (parameter.value) json["value"] = *parameter.value;
    if (parameter.min) json["min"] = *parameter.min;
    if (parameter.max) json["max"] = *parameter.max;
    if (parameter.prior) json["prior"] = {{"mean", parameter.prior->mean}, {"std", parameter.prior->deviation}};
    if (parameter.scale == ParameterScale::Linear) json["scale"] = "lin";
    if (parameter.scale == ParameterScale::Logarithmic) json["scale"] = "log";
    return json;
}

/// Members of mapped columns go where the column is still mapped; one that is its name alone becomes an object for
/// them.
void addToMappings(Json& mappings, const Json& kept) {
    for (const auto& [signal, members] : kept.items()) {
        const auto mapping = mappings.find(signal);
        if (mapping == mappings.end()) continue;
        if (mapping->is_string()) *mapping = Json{{"column", *mapping}};
        mapping->update(members);
    }
}

/// Where what they belonged to is told in another way now they are left out.
void addToMember(Json& experiment, const std::string& name, const Json& kept) {
    if (!experiment.contains(name) && name != "read") return;
    Json& own = experiment[name];
    if (own.is_null()) own = Json::object();
    if (own.is_string() && own != "outputs") own = Json{{"column", own}};
    if (own.is_object()) own.update(kept);
}

void addToExperiment(Json& experiment, const Json& kept) {
    for (const auto& [name, value] : kept.items())
        if (name == "inputs" || name == "outputs")
            addToMappings(experiment[name], value);
        else if (name == "time" || name == "raster" || name == "read")
            addToMember(experiment, name, value);
        else
            experiment[name] = value;
}

void addToParameter(Json& parameter, const Json& kept) {
    for (const auto& [name, value] : kept.items())
        if (name != "prior")
            parameter[name] = value;
        else if (const auto prior = parameter.find(name); prior != parameter.end())
            prior->update(value);
}

/// Adds the members that we do not know where they stood.
void addExtra(Json& json, const std::string& extraJson) {
    const Json extra = Json::parse(extraJson, nullptr, false);
    if (!extra.is_object()) return;
    for (const auto& [name, value] : extra.items()) {
        if (name == "experiments") {
            for (Json& experiment : json["experiments"])
                if (const auto kept = value.find(experiment["name"].get<std::string>()); kept != value.end())
                    addToExperiment(experiment, *kept);
        } else if (name == "parameters") {
            for (const auto& [parameter, kept] : value.items())
                if (json["parameters"].contains(parameter)) addToParameter(json["parameters"][parameter], kept);
        } else {
            json[name] = value;
        }
    }
}

std::string onOneLine(const Json& json) {
    std::string text;
    for (const char c : json.dump(0, ' ', false, Json::error_handler_t::replace))
        if (c != '\n')
            text += c;
        else if (text.back() == ',')
            text += ' ';
    return text;
}

}  // namespace

std::string readText(const ReadOptions& read) { return onOneLine(readJson(read)); }

std::string mappingText(const ChannelMapping& mapping) { return onOneLine(mappingJson(mapping)); }

std::string studyJson(const Study& study) {
    Json json{{"format", studyFormat}, {"class", study.className}};
    json["experiments"] = Json::array();
    for (const StudyExperiment& experiment : study.experiments)
        json["experiments"].push_back(experimentJson(experiment));
    json["parameters"] = Json::object();
    for (const auto& [name, parameter] : study.parameters) json["parameters"][name] = parameterJson(parameter);
    if (!study.libraryPaths.empty()) json["library"] = study.libraryPaths;
    if (!study.extraJson.empty()) addExtra(json, study.extraJson);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace analogon
