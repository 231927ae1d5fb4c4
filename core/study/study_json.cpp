#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/json_limits.hpp"
#include "core/base/unit.hpp"
#include "core/base/visible.hpp"
#include "core/measure/read_options.hpp"
#include "core/study/json_fault.hpp"
#include "core/study/json_places.hpp"
#include "core/study/study.hpp"
#include "core/study/study_format.hpp"
#include "core/study/weight.hpp"

namespace analogon {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view formatStem = "analogon-study-";  // and the number of the version

/// A member and where it stands.
struct Node {
    const Json* value{};
    std::string pointer;

    Node member(const std::string& name) const {
        const auto found = value->find(name);
        return {found == value->end() ? nullptr : &*found, pointer + '/' + JsonPlaces::escape(name)};
    }
    Node element(std::size_t index) const { return {&(*value)[index], fmt::format("{}/{}", pointer, index)}; }
    explicit operator bool() const { return value != nullptr; }
};

Text typeOf(const Json& value) {
    if (value.is_object()) return phrase("an object {{…}}");
    if (value.is_array()) return phrase("a list […]");
    if (value.is_string()) return phrase("the text \"{}\"", shortened(value.get<std::string>(), limits::quotedBytes));
    if (value.is_boolean()) return Text(value.get<bool>() ? "true" : "false");
    if (value.is_number()) return phrase("the number {}", value.dump());
    return "null";
}

/// From the tree of study.json to a Study; collects every fault on the way.
class StudyReader {
public:
    StudyReader(const Json& json, const JsonPlaces& places) : json_(json), places_(places) {}

    Outcome<Study> read() {
        const Node root{&json_, ""};
        if (!json_.is_object()) {
            expected(root, phrase("an object {{…}} with the members of a study"));
            return faults_;
        }
        for (const Span& twice : places_.duplicates())
            faults_.push_back(error(phrase("{} is given twice", shortened(twice.text(), limits::quotedBytes)), twice,
                                    phrase("Keep one of them.")));
        if (!readFormat(root)) return faults_;
        refuseNul(root);
        study_.className = requiredText(root, "class");
        readExperiments(root);
        readParameters(root);
        readLibrary(root);
        keepUnknown(root, {"format", "class", "experiments", "parameters", "library", "plots", "report"},
                    phrase("a study"), extra_);
        for (const char* const name : {"plots", "report"})  // known, but of no work: read by those who show or write it
            if (const Node node = root.member(name)) extra_[name] = *node.value;
        study_.extraJson = extra_.empty() ? std::string() : extra_.dump();
        study_.json = places_.source();
        if (!faults_.empty()) return first(std::move(faults_));
        return {std::move(study_), first(std::move(warnings_))};
    }

private:
    /// As many as somebody reads.
    static Diagnostics first(Diagnostics all) {
        if (all.size() > limits::shownFaults) all.resize(limits::shownFaults);
        return all;
    }

    void fault(const Node& node, Text message, Text hint = {}) {
        faults_.push_back(error(std::move(message), places_.value(node.pointer), std::move(hint)));
    }

    /// A NUL ends a text for some of those who are given it: "a.csv\0.csv" would be one file to us and another to them.
    void refuseNul(const Node& node) {
        const auto holdsNul = [](const std::string& text) { return text.find('\0') != std::string::npos; };
        const auto refuse = [&](const Span& place) {
            faults_.push_back(error(phrase("{}: a text holds the character U+0000", path(node)), place,
                                    phrase("Take it out: no name and no path holds it.")));
        };
        if (node.value->is_string() && holdsNul(node.value->get_ref<const std::string&>()))
            refuse(places_.value(node.pointer));
        for (std::size_t i = 0; node.value->is_array() && i < node.value->size(); ++i) refuseNul(node.element(i));
        if (!node.value->is_object()) return;
        for (const auto& [name, value] : node.value->items()) {
            if (holdsNul(name)) refuse(places_.name(node.pointer + '/' + JsonPlaces::escape(name)));
            refuseNul(node.member(name));
        }
    }

    /// "experiments/0/file" as the reader of the file would say it.
    static Text path(const Node& node) {
        return node.pointer.empty() ? phrase("the study") : Text(node.pointer.substr(1));
    }

    void expected(const Node& node, const Text& what, Text hint = {}) {
        fault(node, phrase("{}: expected {}, found {}", path(node), what, typeOf(*node.value)), std::move(hint));
    }

    static Text alike(const std::string& name, const std::vector<std::string>& known) {
        const std::string meant = suggestion(name, known);
        return meant.empty() ? Text() : phrase("Did you mean \"{}\"?", meant);
    }

    void missing(const Node& owner, const std::string& name, const Text& hint = {}) {
        fault(owner, phrase("{}: the member \"{}\" is missing", path(owner), name), hint);
    }

    std::string text(const Node& node) {
        if (node.value->is_string() && !node.value->get_ref<const std::string&>().empty())
            return node.value->get<std::string>();
        expected(node, phrase("a text that is not empty"));
        return {};
    }

    std::string requiredText(const Node& owner, const std::string& name) {
        const Node node = owner.member(name);
        if (node) return text(node);
        missing(owner, name);
        return {};
    }

    std::optional<double> number(const Node& node) {
        if (!node) return std::nullopt;
        if (node.value->is_number()) return node.value->get<double>();
        expected(node, phrase("a number"));
        return std::nullopt;
    }

    bool isObject(const Node& node, const Text& what) {
        if (!node) return false;
        if (!node.value->is_object()) expected(node, what);
        return node.value->is_object();
    }

    void keepUnknown(const Node& owner, const std::vector<std::string>& known, const Text& what, Json& kept) {
        for (const auto& [name, value] : owner.value->items()) {
            if (std::find(known.begin(), known.end(), name) != known.end()) continue;
            kept[name] = value;
            warnings_.push_back(warning(phrase("\"{}\" is no member of {}; it is kept and has no effect", name, what),
                                        places_.name(owner.pointer + '/' + JsonPlaces::escape(name)),
                                        alike(name, known)));
        }
    }

    /// Without one, the first: there has been no other. What a later one means nobody knows, so it is not guessed at:
    /// false, and nothing else of the study is read.
    bool readFormat(const Node& root) {
        const Node node = root.member("format");
        if (!node) {
            warnings_.push_back(warning(phrase("the study does not say its format; it is read as \"{}\"", studyFormat),
                                        {}, phrase("Saving it writes the format down.")));
            return true;
        }
        const std::string format = text(node);
        if (format.empty() || format == studyFormat) return true;
        const std::string number = format.starts_with(formatStem) ? format.substr(formatStem.size()) : std::string();
        const bool isNewer = !number.empty() && number.front() != '0' &&
                             std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
        if (isNewer)
            fault(node, phrase("a newer version of Analogon has written this study: its format is \"{}\"", format),
                  phrase("This version reads \"{}\": open the study with the newer one.", studyFormat));
        else
            fault(node, phrase("the format \"{}\" is not known", format),
                  phrase("This program reads \"{}\".", studyFormat));
        return false;
    }

    void readExperiments(const Node& root) {
        const Node list = root.member("experiments");
        if (!list) return missing(root, "experiments");
        if (!list.value->is_array()) return expected(list, phrase("a list […] of experiments"));
        for (std::size_t i = 0; i < list.value->size(); ++i) {
            const Node node = list.element(i);
            if (!isObject(node, phrase("an experiment {{…}}"))) continue;
            Json kept;
            StudyExperiment experiment = readExperiment(node, kept);
            for (const StudyExperiment& other : study_.experiments)
                if (other.name == experiment.name && !other.name.empty())
                    fault(node.member("name"), phrase("there are two experiments named '{}'", other.name),
                          phrase("Give each experiment its own name."));
            keepUnknown(
                node,
                {"name", "role", "use", "file", "time", "range", "inputs", "outputs", "initial", "read", "raster"},
                phrase("an experiment"), kept);
            if (!kept.empty()) extra_["experiments"][experiment.name] = kept;
            study_.experiments.push_back(std::move(experiment));
        }
    }

    /// `kept`: receives what is not known of it.
    StudyExperiment readExperiment(const Node& node, Json& kept) {
        StudyExperiment experiment;
        experiment.name = requiredText(node, "name");
        experiment.file = requiredText(node, "file");
        readTimeName(node, experiment, kept);
        if (const Node role = node.member("role")) {
            const std::string text = role.value->is_string() ? role.value->get<std::string>() : "";
            if (text != "fit" && text != "validate")
                expected(role, phrase("\"fit\" or \"validate\""), alike(text, {"fit", "validate"}));
            experiment.role = text == "validate" ? Role::Validate : Role::Fit;
        }
        if (const Node use = node.member("use")) {
            if (!use.value->is_boolean()) expected(use, phrase("true or false"));
            experiment.isUsed = !use.value->is_boolean() || use.value->get<bool>();
        }
        if (const Node range = node.member("range")) experiment.range = readRange(range);
        if (const Node read = node.member("read")) experiment.read = readOptions(read, kept);
        if (const Node raster = node.member("raster")) experiment.raster = readRaster(raster, kept);
        experiment.inputs = readMappings(node, "inputs", kept);
        experiment.outputs = readMappings(node, "outputs", kept);
        if (const Node initial = node.member("initial"); isObject(initial, phrase("start values {{parameter: value}}")))
            for (const auto& [name, value] : initial.value->items())
                if (const auto start = readStart(initial.member(name))) experiment.initial[name] = *start;
        return experiment;
    }

    void readTimeName(const Node& owner, StudyExperiment& experiment, Json& kept) {
        const Node time = owner.member("time");
        if (!time) {
            experiment.isTimeOfFile = true;
            return;
        }
        const ChannelName name = readChannelName(time, kept, "time");
        experiment.timeColumn = name.column;
        experiment.timeGroup = name.group;
    }

    /// A name, or one with its group. `kept`: receives under `member` what is not known of it.
    ChannelName readChannelName(const Node& node, Json& kept, const char* member) {
        if (node.value->is_string()) return {text(node)};
        if (!isObject(node, phrase("the name of a column, or {{\"column\": …, \"group\": …}}"))) return {};
        Json unknown;
        keepUnknown(node, {"column", "group", "sheet"}, phrase("the name of a column"), unknown);
        if (!unknown.empty()) kept[member] = unknown;
        return {requiredText(node, "column"), readGroup(node)};
    }

    /// "group" or "sheet" beside a column: a name, or a number from 1.
    GroupName readGroup(const Node& owner) {
        const Node group = owner.member("group"), sheet = owner.member("sheet");
        if (group && sheet)
            fault(sheet, phrase("{}: the group and the sheet of a column are the same thing", path(owner)),
                  phrase("Keep one of them."));
        if (!group && !sheet) return {};
        const Node node = group ? group : sheet;
        const Json& value = *node.value;
        const bool isNumber = value.is_number_integer() && value.get<double>() >= 1;
        if (isNumber) return {{}, value.get<std::size_t>(), !group};
        if (value.is_string() && !value.get_ref<const std::string&>().empty())
            return {value.get<std::string>(), 0, !group};
        expected(node, phrase("the name of a group or its number, the first being 1"));
        return {};
    }

    Raster readRaster(const Node& node, Json& kept) {
        Raster raster;
        if (node.value->is_number()) {
            raster.kind = Raster::Kind::Steps;
            raster.step = node.value->get<double>();
            if (!(raster.step > 0)) fault(node, phrase("{}: the step of a raster must be above 0 s", path(node)));
        } else if (!node.value->is_string() && !node.value->is_object()) {
            expected(node, phrase("\"outputs\", the name of a channel, or a step in seconds"));
        } else if (!(*node.value == "outputs")) {
            raster.kind = Raster::Kind::Channel;
            raster.channel = readChannelName(node, kept, "raster");
        }
        return raster;
    }

    ReadOptions readOptions(const Node& node, Json& kept) {
        ReadOptions options;
        if (!isObject(node, phrase("how the text is written, as {{\"separator\": \";\", \"decimal\": \",\"}}")))
            return options;
        options.separator = readMark(node.member("separator"), knownSeparators, phrase(", ; | a tab (\\t) or a blank"));
        options.decimal = readMark(node.member("decimal"), knownDecimals, phrase(". or ,"));
        options.thousands = readMark(node.member("thousands"), knownThousands, phrase(". , ' or a blank"));
        options.skip = readCount(node.member("skip"));
        options.header = readCount(node.member("header"));
        if (const Node units = node.member("units")) {
            if (!units.value->is_boolean()) expected(units, phrase("true or false"));
            options.hasUnitsRow = units.value->is_boolean() && units.value->get<bool>();
        }
        if (const Node format = node.member("time_format")) options.timeFormat = text(format);
        if (const Node zone = node.member("time_zone")) options.timeZone = text(zone);
        if (const Node times = node.member("times")) options.times = readTimes(times);
        if (const Node encoding = node.member("encoding")) options.encoding = text(encoding);
        if (const Node names = node.member("unit_names")) readUnitNames(names, options);
        if (options.decimal && (options.decimal == options.separator || options.decimal == options.thousands))
            fault(node.member("decimal"),
                  phrase("{}: one mark cannot be that of the decimals and another one too", path(node)));
        Json unknown;
        keepUnknown(node,
                    {"separator", "decimal", "thousands", "skip", "header", "units", "time_format", "time_zone",
                     "times", "encoding", "unit_names"},
                    phrase("\"read\""), unknown);
        if (!unknown.empty()) kept["read"] = unknown;
        return options;
    }

    TimeColumns readTimes(const Node& node) {
        const std::string told = node.value->is_string() ? node.value->get<std::string>() : "";
        if (told == "one") return TimeColumns::One;
        if (told == "left") return TimeColumns::Left;
        if (told == "right") return TimeColumns::Right;
        expected(node, phrase("one, left or right"));
        return TimeColumns::Found;
    }

    void readUnitNames(const Node& node, ReadOptions& options) {
        if (!isObject(node, phrase("an object {{unit of the file: unit}}, as {{\"kpa\": \"kPa\"}}"))) return;
        for (const auto& [name, value] : node.value->items()) {
            const Node unit = node.member(name);
            const std::string meant = text(unit);
            if (value.is_string() && (meant.empty() || !isKnownUnit(meant)))
                fault(unit, phrase("the unit \"{}\" is not known", meant), phrase("\"1\" is a number without a unit."));
            options.unitNames[name] = meant;
        }
    }

    std::optional<char> readMark(const Node& node, std::string_view known, const Text& what) {
        if (!node) return std::nullopt;
        const std::string mark = node.value->is_string() ? node.value->get<std::string>() : "";
        if (mark.size() == 1 && known.find(mark.front()) != std::string_view::npos) return mark.front();
        expected(node, what);
        return std::nullopt;
    }

    std::optional<std::size_t> readCount(const Node& node) {
        if (!node) return std::nullopt;
        if (node.value->is_number_unsigned()) return node.value->get<std::size_t>();
        expected(node, phrase("a number of lines, 0 or more"));
        return std::nullopt;
    }

    std::optional<std::pair<double, double>> readRange(const Node& node) {
        const Json& list = *node.value;
        if (!list.is_array() || list.size() != 2 || !list[0].is_number() || !list[1].is_number()) {
            expected(node, phrase("two times [from, to] in seconds"));
            return std::nullopt;
        }
        const auto range = std::make_pair(list[0].get<double>(), list[1].get<double>());
        if (range.first < range.second) return range;
        fault(node, phrase("{}: the range ends at {} before it begins at {}", path(node), range.second, range.first));
        return std::nullopt;
    }

    std::map<std::string, ChannelMapping> readMappings(const Node& owner, const std::string& name, Json& kept) {
        std::map<std::string, ChannelMapping> mappings;
        const Node node = owner.member(name);
        if (!isObject(node, phrase("an object {{model signal: column}}"))) return mappings;
        for (const auto& [signal, value] : node.value->items()) {
            Json unknown;
            mappings[signal] = readMapping(node.member(signal), name == "inputs", unknown);
            if (!unknown.empty()) kept[name][signal] = unknown;
        }
        return mappings;
    }

    ChannelMapping readMapping(const Node& node, bool isInput, Json& kept) {
        ChannelMapping mapping;
        if (!node.value->is_object()) {
            if (node.value->is_string()) {
                mapping.column = text(node);
            } else {
                expected(node, phrase("the name of a column, or {{\"column\": …, \"unit\": …}}"));
            }
            return mapping;
        }
        mapping.column = requiredText(node, "column");
        mapping.group = readGroup(node);
        if (const Node unit = node.member("unit")) mapping.unit = text(unit);
        mapping.scale = number(node.member("scale")).value_or(1);
        mapping.offset = number(node.member("offset")).value_or(0);
        mapping.weight = number(node.member("weight")).value_or(1);
        if (mapping.scale == 0)
            fault(node.member("scale"), phrase("{}: a scale of 0 wipes the column out", path(node)));
        checkWeight(node, mapping.weight);
        if (const Node clock = node.member("clock")) {
            mapping.fitsClock = clock.value->is_string() && clock.value->get_ref<const std::string&>() == "fit";
            if (clock.value->is_number()) mapping.clock = clock.value->get<double>();
            if (!mapping.fitsClock && !clock.value->is_number())
                expected(clock, phrase("a number of seconds, or \"fit\""));
        }
        if (const Node interpolation = node.member("interpolation"))
            mapping.interpolation = readInterpolation(interpolation, isInput);
        keepUnknown(node, {"column", "group", "sheet", "unit", "scale", "offset", "weight", "clock", "interpolation"},
                    phrase("a mapped column"), kept);
        return mapping;
    }

    void checkWeight(const Node& node, double weight) {
        if (weight < 0)
            fault(node.member("weight"), phrase("{}: a weight cannot be negative", path(node)));
        else if (!isWeight(weight))
            fault(node.member("weight"),
                  phrase("{}: a weight of {:.3g} is beyond what can be weighed ({:g} … {:g})", path(node), weight,
                         leastWeight, mostWeight),
                  phrase("A weight says how much an output counts beside the others, each in units of its range or "
                         "its noise: 1 is the common one, 0 leaves it out."));
    }

    Interpolation readInterpolation(const Node& node, bool isInput) {
        const std::string word = node.value->is_string() ? node.value->get<std::string>() : "";
        if (!isInput)
            fault(node,
                  phrase("{}: an output is compared where it was measured, never between its samples", path(node)),
                  phrase("Remove \"interpolation\" here; it belongs to an input."));
        else if (word == "linear" || word == "hold")
            return word == "hold" ? Interpolation::Hold : Interpolation::Linear;
        else if (!node.value->is_string())
            expected(node, phrase("\"linear\" or \"hold\""));
        else
            fault(node, phrase("{}: expected \"linear\" or \"hold\", found \"{}\"", path(node), word),
                  meantInterpolation(word));
        return Interpolation::Automatic;
    }

    static Text meantInterpolation(const std::string& word) {
        // what other programs call them
        for (const char* const held : {"held", "zoh", "zero-order", "zero-order-hold", "zero_order_hold", "previous",
                                       "step", "steps", "stairs", "constant", "none"})
            if (suggestion(word, {held}) == held) return phrase("Did you mean \"{}\"?", "hold");
        for (const char* const line : {"line", "lines", "straight", "foh", "first-order", "first-order-hold", "ramp"})
            if (suggestion(word, {line}) == line) return phrase("Did you mean \"{}\"?", "linear");
        const std::string alike = suggestion(word, {"linear", "hold"});
        if (!alike.empty()) return phrase("Did you mean \"{}\"?", alike);
        return phrase("\"linear\": on straight lines between the samples; \"hold\": each value until the next sample.");
    }

    std::optional<StudyStart> readStart(const Node& node) {
        if (node.value->is_number()) return node.value->get<double>();
        if (node.value->is_object() && node.member("column"))
            return ColumnStart{requiredText(node, "column"), readGroup(node)};
        if (!node.value->is_string() || node.value->get_ref<const std::string&>().empty()) {
            expected(node, phrase("a number, \"fit\" or the name of a column"));
            return std::nullopt;
        }
        const std::string text = node.value->get<std::string>();
        if (text == "fit") return FittedStart{};
        return ColumnStart{text, {}};
    }

    void readParameters(const Node& root) {
        const Node parameters = root.member("parameters");
        if (!isObject(parameters, phrase("an object {{parameter: {{…}}}}"))) return;
        for (const auto& [name, value] : parameters.value->items()) {
            const Node node = parameters.member(name);
            if (!isObject(node, phrase("an object, as {{\"fit\": true, \"min\": 0}}"))) continue;
            Json kept;
            study_.parameters[name] = readParameter(node, kept);
            keepUnknown(node, {"fit", "value", "min", "max", "scale", "prior"}, phrase("a parameter"), kept);
            if (!kept.empty()) extra_["parameters"][name] = kept;
        }
    }

    StudyParameter readParameter(const Node& node, Json& kept) {
        StudyParameter parameter;
        if (const Node fit = node.member("fit")) {
            if (!fit.value->is_boolean()) expected(fit, phrase("true or false"));
            parameter.fit = fit.value->is_boolean() && fit.value->get<bool>();
        }
        parameter.value = number(node.member("value"));
        parameter.min = number(node.member("min"));
        parameter.max = number(node.member("max"));
        if (const Node scale = node.member("scale")) {
            const std::string text = scale.value->is_string() ? scale.value->get<std::string>() : "";
            if (text != "lin" && text != "log")
                expected(scale, phrase("\"lin\" or \"log\""), alike(text, {"lin", "log"}));
            parameter.scale = text == "log" ? ParameterScale::Logarithmic : ParameterScale::Linear;
        }
        if (const Node prior = node.member("prior")) parameter.prior = readPrior(prior, kept);
        if (parameter.min && parameter.max && *parameter.min >= *parameter.max)
            fault(node.member("min"), phrase("{}: the lower bound {} is not below the upper bound {}", path(node),
                                             *parameter.min, *parameter.max));
        if (parameter.scale == ParameterScale::Logarithmic && parameter.min && *parameter.min <= 0)
            fault(node.member("min"), phrase("{}: a logarithmic scale needs a lower bound above 0", path(node)),
                  phrase("Raise \"min\", or use \"scale\": \"lin\"."));
        return parameter;
    }

    std::optional<NormalPrior> readPrior(const Node& node, Json& kept) {
        if (!isObject(node, phrase("what is known, as {{\"mean\": 3.2, \"std\": 0.1}}"))) return std::nullopt;
        for (const char* const name : {"mean", "std"})
            if (!node.member(name)) missing(node, name, phrase("A prior is {{\"mean\": …, \"std\": …}}."));
        const std::optional<double> mean = number(node.member("mean")), deviation = number(node.member("std"));
        Json unknown;
        keepUnknown(node, {"mean", "std"}, phrase("a prior"), unknown);
        if (!unknown.empty()) kept["prior"] = unknown;
        if (!mean || !deviation) return std::nullopt;
        if (*deviation > 0) return NormalPrior{*mean, *deviation};
        fault(node.member("std"), phrase("{}: a standard deviation must be above 0", path(node)),
              phrase("A parameter that is known for sure is not fitted: \"fit\": false."));
        return std::nullopt;
    }

    void readLibrary(const Node& root) {
        const Node library = root.member("library");
        if (!library) return;
        if (!library.value->is_array()) return expected(library, phrase("a list […] of paths"));
        for (std::size_t i = 0; i < library.value->size(); ++i) study_.libraryPaths.push_back(text(library.element(i)));
    }

    const Json& json_;
    const JsonPlaces& places_;
    Study study_;
    Json extra_;
    Diagnostics faults_, warnings_;
};

}  // namespace

Outcome<Study> parseStudyJson(const SourcePtr& json) {
    if (const Outcome<Done> limited = checkJsonLimits(*json); !limited) return limited.diagnostics();
    Json tree;
    try {
        tree = Json::parse(json->text());
    } catch (const Json::exception& failure) {
        return jsonFault(json, failure);
    }
    const JsonPlaces places(json);
    return StudyReader(tree, places).read();
}

}  // namespace analogon
