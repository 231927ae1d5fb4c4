#include "core/campaign/campaign.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "core/base/json_limits.hpp"
#include "core/base/limits.hpp"
#include "core/base/regular_file.hpp"
#include "core/base/unit.hpp"
#include "core/base/visible.hpp"
#include "core/campaign/units_table.hpp"
#include "core/measure/column_header.hpp"
#include "core/measure/csv_dialect.hpp"
#include "core/study/json_fault.hpp"
#include "core/study/json_places.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uint64_t largestCampaign = 16u << 20, largestTable = 1u << 30;  // [byte]

struct Columns {
    std::string unit;
    std::map<std::string, std::string> files, parameters;
    std::vector<std::string> attributes;
};

/// From the tree of campaign.json; collects every fault on the way.
class CampaignReader {
public:
    CampaignReader(const Json& json, const JsonPlaces& places) : json_(json), places_(places) {}

    bool read(Campaign& campaign, Columns& columns) {
        if (!json_.is_object()) {
            fault("", phrase("a campaign is an object {{…}}"));
            return false;
        }
        for (const Span& twice : places_.duplicates())
            faults_.push_back(error(phrase("{} is given twice", shortened(twice.text(), limits::quotedBytes)), twice,
                                    phrase("Keep one of them.")));
        const std::string format = text(json_, "", "format");
        if (!format.empty() && format != campaignFormat) {  // what else there is to say is of no help
            fault("/format", phrase("this is no campaign: its format is \"{}\"", format),
                  phrase("A campaign has the format \"{}\", and names a study and a table of units.", campaignFormat));
            return false;
        }
        known(json_, "", {"format", "study", "command", "units", "columns"});
        const fs::path folder = campaign.file.parent_path();
        campaign.study = (folder / text(json_, "", "study")).lexically_normal();
        campaign.table = (folder / text(json_, "", "units")).lexically_normal();
        const std::string command = text(json_, "", "command");
        if (!command.empty() && command != "fit" && command != "discover")
            fault("/command", phrase("a campaign has the command \"fit\" or \"discover\", and not \"{}\"", command));
        campaign.command = command == "discover" ? CampaignCommand::Discover : CampaignCommand::Fit;
        readColumns(columns);
        return faults_.empty();
    }
    Diagnostics faults() && { return std::move(faults_); }

private:
    void fault(const std::string& pointer, Text message, Text hint = {}) {
        faults_.push_back(error(std::move(message), places_.value(pointer), std::move(hint)));
    }

    void known(const Json& owner, const std::string& pointer, const std::vector<std::string>& names) {
        for (const auto& [name, value] : owner.items()) {
            if (std::find(names.begin(), names.end(), name) != names.end()) continue;
            const std::string meant = suggestion(name, names);
            faults_.push_back(error(
                phrase("\"{}\" is no member of a campaign", visibleName(name)),
                places_.name(pointer + '/' + JsonPlaces::escape(name)),
                meant.empty() ? phrase("Known here: {}.", listed(names)) : phrase("Did you mean \"{}\"?", meant)));
        }
    }

    std::string word(const Json& value, const std::string& pointer) {
        if (value.is_string() && !value.get_ref<const std::string&>().empty() &&
            value.get_ref<const std::string&>().find('\0') == std::string::npos)
            return value.get<std::string>();
        fault(pointer, phrase("{}: expected a text that is not empty", pointer.substr(1)));
        return {};
    }

    std::string text(const Json& owner, const std::string& pointer, const std::string& name) {
        const auto found = owner.find(name);
        if (found != owner.end()) return word(*found, pointer + '/' + name);
        fault(pointer, phrase("the member \"{}\" is missing", (pointer + '/' + name).substr(1)));
        return {};
    }

    std::map<std::string, std::string> texts(const Json& owner, const std::string& name) {
        std::map<std::string, std::string> all;
        const auto found = owner.find(name);
        if (found == owner.end()) return all;
        const std::string pointer = "/columns/" + name;
        if (!found->is_object()) {
            fault(pointer, phrase("{}: expected an object {{name: column}}", pointer.substr(1)));
            return all;
        }
        for (const auto& [key, value] : found->items()) all[key] = word(value, pointer + '/' + JsonPlaces::escape(key));
        return all;
    }

    void readColumns(Columns& columns) {
        const auto found = json_.find("columns");
        if (found == json_.end()) return fault("", phrase("the member \"{}\" is missing", "columns"));
        if (!found->is_object()) return fault("/columns", phrase("{}: expected an object {{name: column}}", "columns"));
        known(*found, "/columns", {"unit", "files", "parameters", "attributes"});
        columns.unit = text(*found, "/columns", "unit");
        columns.files = texts(*found, "files");
        if (columns.files.empty() && faults_.empty())
            fault("/columns", phrase("no recording is of a unit"),
                  phrase("\"files\" names the column with the path of a recording, for each experiment."));
        columns.parameters = texts(*found, "parameters");
        const auto attributes = found->find("attributes");
        if (attributes == found->end()) return;
        if (!attributes->is_array()) return fault("/columns/attributes", phrase("expected a list […] of columns"));
        for (std::size_t i = 0; i < attributes->size(); ++i)
            columns.attributes.push_back(word((*attributes)[i], fmt::format("/columns/attributes/{}", i)));
    }

    const Json& json_;
    const JsonPlaces& places_;
    Diagnostics faults_;
};

/// Why a text is no name of a folder of results; empty: it is one.
Text whyNoFolder(const std::string& name) {
    constexpr std::size_t longest = 200;  // of the 255 bytes of a file system, what is written beside it takes some
    if (name.empty()) return phrase("the unit has no name");
    if (name.size() > longest) return phrase("the name of the unit is longer than {} bytes", longest);
    if (name.front() == '.') return phrase("the name of the unit begins with a point");
    if (name.find_first_of("/\\\t") != std::string::npos || visibleName(name, longest + 1) != name)
        return phrase("the name of the unit holds a character that no folder's name may have");
    return {};
}

/// From the table to units.
class UnitsReader {
public:
    UnitsReader(const UnitsTable& table, const JsonPlaces& places) : table_(table), places_(places) {}

    bool read(const Columns& columns, Campaign& campaign) {
        const std::size_t unit = column(columns.unit, "/columns/unit");
        std::map<std::string, std::size_t> files, values, labels;
        for (const auto& [experiment, name] : columns.files) {
            files[experiment] = column(name, "/columns/files/" + JsonPlaces::escape(experiment));
            campaign.experiments.push_back(experiment);
        }
        for (const auto& [parameter, name] : columns.parameters) {
            const std::string pointer = "/columns/parameters/" + JsonPlaces::escape(parameter);
            const std::size_t at = values[parameter] = column(name, pointer);
            if (faults_.empty()) campaign.valueUnits[parameter] = unitOf(name, table_.header[at], pointer);
        }
        for (std::size_t i = 0; i < columns.attributes.size(); ++i)
            labels[columns.attributes[i]] = column(columns.attributes[i], fmt::format("/columns/attributes/{}", i));
        campaign.attributes = columns.attributes;
        if (!faults_.empty()) return false;
        std::unordered_map<std::string, int> lines;
        for (const UnitsRow& row : table_.rows) {
            CampaignUnit read = readUnit(row, unit, files, values);
            for (const auto& [label, at] : labels) read.labels[label] = row.cells[at];
            const auto [first, isNew] = lines.emplace(read.name, row.line);
            if (!isNew && !read.name.empty() && faults_.size() < limits::shownFaults)
                faults_.push_back(fileError(
                    phrase("the unit \"{}\" stands in line {} already", visibleName(read.name), first->second),
                    table_.file, row.line, row.positions[unit], phrase("Give each unit a name of its own.")));
            campaign.units.push_back(std::move(read));
        }
        if (table_.rows.empty()) faults_.push_back(fileError(phrase("the table has no unit"), table_.file));
        return faults_.empty();
    }
    Diagnostics faults() && { return std::move(faults_); }

private:
    std::size_t column(const std::string& name, const std::string& pointer) {
        const std::vector<std::size_t> found = table_.find(name);
        if (found.size() == 1) return found.front();
        if (found.size() > 1) {
            faults_.push_back(error(phrase("the table of units has {} columns \"{}\"", found.size(), name),
                                    places_.value(pointer), phrase("Write the whole header, with its unit.")));
            return 0;
        }
        const std::string meant = suggestion(name, table_.header);
        faults_.push_back(
            error(phrase("the table of units has no column \"{}\"", name), places_.value(pointer),
                  meant.empty() ? phrase("It has {}.", listed(table_.header)) : phrase("Did you mean \"{}\"?", meant)));
        return 0;
    }

    std::string unitOf(const std::string& asked, const std::string& header, const std::string& pointer) {
        const std::string wanted = readColumnHeader(asked).unit, written = readColumnHeader(header).unit;
        if (!wanted.empty() && !written.empty() && wanted != written)
            faults_.push_back(error(phrase("the campaign names the unit {} and the table {}", wanted, written),
                                    places_.value(pointer), phrase("Name the column as the table does.")));
        std::string unit = written.empty() ? wanted : written;
        if (!unit.empty() && !isKnownUnit(unit))
            faults_.push_back(error(phrase("the unit \"{}\" is not known", unit), places_.value(pointer)));
        return unit;
    }

    CampaignUnit readUnit(const UnitsRow& row, std::size_t name, const std::map<std::string, std::size_t>& files,
                          const std::map<std::string, std::size_t>& values) const {
        CampaignUnit unit;
        unit.name = row.cells[name];
        unit.line = row.line;
        const auto fault = [&](std::size_t at, Text message, Text hint = {}) {
            unit.faults.push_back(
                fileError(std::move(message), table_.file, row.line, row.positions[at], std::move(hint)));
        };
        if (Text why = whyNoFolder(unit.name); !why.empty()) {
            unit.hasFolderName = false;
            fault(name, std::move(why), phrase("Its results lie in a folder of that name."));
        }
        for (const auto& [experiment, at] : files) {
            unit.files[experiment] = row.cells[at];
            if (row.cells[at].empty()) fault(at, phrase("the unit has no recording for \"{}\"", experiment));
        }
        for (const auto& [parameter, at] : values) {
            const std::string& cell = row.cells[at];
            if (cell.empty()) continue;
            CellValue value = readCell(cell, '.');
            if (value.kind != CellValue::Kind::Number && table_.separator != ',') value = readCell(cell, ',');
            if (value.kind == CellValue::Kind::Number)
                unit.values[parameter] = value.value;
            else
                fault(at, phrase("{}: expected a number, found \"{}\"", parameter, visibleName(cell)),
                      phrase("Leave the cell empty where it is not known."));
        }
        return unit;
    }

    const UnitsTable& table_;
    const JsonPlaces& places_;
    Diagnostics faults_;
};

Diagnostics first(Diagnostics faults) {
    if (faults.size() > limits::shownFaults) faults.resize(limits::shownFaults);
    return faults;
}

}  // namespace

const char* name(CampaignCommand command) { return command == CampaignCommand::Fit ? "fit" : "discover"; }

Outcome<Campaign> readCampaign(const fs::path& file) {
    std::error_code code;
    if (fs::is_directory(file, code))
        return fileError(phrase("this is a directory; name a file"), file.string(), 0, 0,
                         phrase("A campaign is a file, campaign.json, that names a study and a table of units."));
    Outcome<std::string> text = readRegularFile(file, largestCampaign);
    if (!text) return text.diagnostics();
    const auto source = std::make_shared<const Source>(file.string(), std::move(*text));
    if (Outcome<Done> fits = checkJsonLimits(*source); !fits) return fits.diagnostics();
    Json json;
    try {
        json = Json::parse(source->text());
    } catch (const Json::exception& failure) {
        return jsonFault(source, failure);
    }
    const JsonPlaces places(source);
    Campaign campaign;
    campaign.json = source;
    campaign.file = fs::absolute(file).lexically_normal();
    Columns columns;
    CampaignReader reader(json, places);
    if (!reader.read(campaign, columns)) return first(std::move(reader).faults());
    if (!fs::exists(campaign.study, code))
        return error(phrase("there is no study \"{}\"", campaign.study.string()), places.value("/study"),
                     phrase("The path is relative to the campaign's folder."));
    if (!fs::exists(campaign.table, code))
        return error(phrase("there is no table \"{}\"", campaign.table.string()), places.value("/units"),
                     phrase("The path is relative to the campaign's folder."));
    Outcome<std::string> words = readRegularFile(campaign.table, largestTable);
    if (!words) return words.diagnostics();
    Outcome<UnitsTable> table = parseUnitsTable(*words, campaign.table.string());
    if (!table) return table.diagnostics();
    UnitsReader units(*table, places);
    if (!units.read(columns, campaign)) return first(std::move(units).faults());
    return campaign;
}

}  // namespace analogon
