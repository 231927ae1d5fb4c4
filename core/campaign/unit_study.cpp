#include "core/campaign/unit_study.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cstdint>

#include "core/base/fnv.hpp"
#include "core/measure/open/read_table.hpp"
#include "core/study/json_places.hpp"
#include "core/study/recorded.hpp"
#include "core/study/validate.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

/// FNV-1a over 64 bits (Fowler, Noll, Vo; RFC 9923): tells texts from changed ones, and is no protection against
/// intent.
class Fingerprint {
public:
    void add(std::string_view text) { value_ = fnv1a(std::string_view("\0", 1), fnv1a(text, value_)); }
    /// Path, size and time of the last change; false: there is no such file.
    bool addFile(const fs::path& path) {
        struct stat status {};
        if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return false;
        add(fmt::format("{} {} {}.{}", path.string(), status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec));
        return true;
    }
    std::string text() const { return fmt::format("{:016x}", value_); }

private:
    std::uint64_t value_{fnvOffset};
};

StudyExperiment* experimentNamed(Study& study, const std::string& name) {
    const auto found = std::find_if(study.experiments.begin(), study.experiments.end(),
                                    [&](const StudyExperiment& x) { return x.name == name; });
    return found == study.experiments.end() ? nullptr : &*found;
}

bool isOfUnits(const Campaign& campaign, const StudyExperiment& experiment) {
    return std::find(campaign.experiments.begin(), campaign.experiments.end(), experiment.name) !=
           campaign.experiments.end();
}

}  // namespace

fs::path recordingOf(const Campaign& campaign, const std::string& path) {
    return (campaign.table.parent_path() / path).lexically_normal();
}

Outcome<CampaignTemplate> CampaignTemplate::open(const Campaign& campaign) {
    Outcome<OpenedStudy> opened = openStudy(campaign.study);
    if (!opened) return opened.diagnostics();
    Outcome<ValidStudy> valid = validated(opened->study, Purpose::Check);
    if (!valid) return namedAs(valid.diagnostics(), *opened);
    const JsonPlaces places(campaign.json);
    Diagnostics faults;
    std::vector<std::string> names;
    for (const StudyExperiment& x : opened->study.experiments) names.push_back(x.name);
    for (const std::string& name : campaign.experiments)
        if (!experimentNamed(opened->study, name)) {
            const std::string meant = suggestion(name, names);
            faults.push_back(
                error(phrase("the study has no experiment \"{}\"", name),
                      places.value("/columns/files/" + JsonPlaces::escape(name)),
                      meant.empty() ? phrase("It has {}.", listed(names)) : phrase("Did you mean \"{}\"?", meant)));
        }
    CampaignTemplate made;
    const FlatModel& model = *valid->model.model;
    for (const auto& [parameter, unit] : campaign.valueUnits) {
        const Span place = places.value("/columns/parameters/" + JsonPlaces::escape(parameter));
        const VariableId id = model.find(parameter);
        if (!id.valid() || model[id].variability != FlatVariability::Parameter || model[id].type != FlatType::Real) {
            std::vector<std::string> known;
            for (const FlatVariable& v : model.variables)
                if (v.variability == FlatVariability::Parameter && v.type == FlatType::Real) known.push_back(v.name);
            const std::string meant = suggestion(parameter, known);
            faults.push_back(error(phrase("the model has no parameter \"{}\"", parameter), place,
                                   meant.empty() ? Text() : phrase("Did you mean \"{}\"?", meant)));
            continue;
        }
        if (unit.empty()) continue;
        Outcome<UnitConversion> conversion = convertUnit(unit, model.unitOf(model[id]));
        if (conversion)
            made.conversions_[parameter] = *conversion;
        else
            faults.push_back(error(conversion.diagnostics().front().message, place,
                                   phrase("The table gives \"{}\" in this unit.", parameter)));
    }
    if (!faults.empty()) return faults;
    Fingerprint print;
    print.add(name(campaign.command));
    print.add(studyJson(opened->study));
    for (const auto& [file, text] : opened->study.models) {
        print.add(file);
        print.add(text);
    }
    for (const StudyExperiment& x : opened->study.experiments)
        if (!isOfUnits(campaign, x) && !opened->files) print.addFile(opened->study.directory / x.file);
    made.fingerprint_ = print.text();
    made.opened_ = std::move(*opened);
    return made;
}

Outcome<Study> CampaignTemplate::studyOf(const Campaign& campaign, const CampaignUnit& unit) const {
    Study study = opened_.study;
    study.name = unit.name;
    Diagnostics faults = unit.faults, warnings;
    for (const auto& [experiment, path] : unit.files) {
        StudyExperiment& replaced = *experimentNamed(study, experiment);
        replaced.file = recordingOf(campaign, path).string();
        if (replaced.isTimeOfFile) replaced.timeColumn.clear();
    }
    for (const auto& [experiment, path] : unit.files) {
        StudyExperiment& replaced = *experimentNamed(study, experiment);
        Outcome<Table> table = readTable(replaced.file, replaced.read, namedChannels(study, replaced));
        if (!table) {
            faults.insert(faults.end(), table.diagnostics().begin(), table.diagnostics().end());
            continue;
        }
        warnings.insert(warnings.end(), table.diagnostics().begin(), table.diagnostics().end());
        study.tables[tableKey(replaced)] = std::make_shared<const Table>(std::move(*table));
    }
    if (!faults.empty()) return faults;
    for (StudyExperiment& experiment : study.experiments) findTime(study.tables, experiment);
    for (const auto& [parameter, value] : unit.values) {
        const auto conversion = conversions_.find(parameter);
        StudyParameter& held = study.parameters[parameter];
        held = {};
        held.fit = false;
        held.value = conversion == conversions_.end() ? value : conversion->second(value);
    }
    return {std::move(study), std::move(warnings)};
}

Outcome<std::string> fingerprintOf(const Campaign& campaign, const CampaignTemplate& study, const CampaignUnit& unit) {
    if (!unit.faults.empty()) return unit.faults;
    Fingerprint print;
    print.add(study.fingerprint());
    print.add(unit.name);
    Diagnostics faults;
    for (const auto& [experiment, path] : unit.files) {
        print.add(experiment);
        if (!print.addFile(recordingOf(campaign, path)))
            faults.push_back(fileError(phrase("there is no recording \"{}\"", path), campaign.table.string(), unit.line,
                                       0, phrase("The path is relative to the folder of the table.")));
    }
    for (const auto& [parameter, value] : unit.values)
        print.add(fmt::format("{} {} {}", parameter, value, campaign.valueUnits.at(parameter)));
    if (!faults.empty()) return faults;
    return print.text();
}

}  // namespace analogon
