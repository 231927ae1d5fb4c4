#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/base/directory_lock.hpp"
#include "core/base/regular_file.hpp"
#include "core/measure/open/read_table.hpp"
#include "core/study/json_places.hpp"
#include "core/study/pending_save.hpp"
#include "core/study/recorded.hpp"
#include "core/study/report_settings.hpp"
#include "core/study/study.hpp"
#include "core/syntax/parser.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largestText = 64u << 20;  // [byte] study.json, and each model

std::set<std::string> filesEndingIn(const fs::path& directory, std::string_view ending) {
    std::set<std::string> files;
    std::error_code code;
    for (fs::directory_iterator entry(directory, code), end; !code && entry != end; entry.increment(code))
        if (std::error_code lost; entry->path().extension() == ending && entry->is_regular_file(lost))
            files.insert(entry->path().filename().string());
    return files;
}

/// A study's directory as its last save left it.
class StudyFolder {
public:
    explicit StudyFolder(const fs::path& directory) : directory_(directory), pending_(PendingSave::in(directory)) {}

    fs::path place(const fs::path& name) const { return pending_.place(name); }
    bool holds(const fs::path& name) const {
        std::error_code code;
        return fs::exists(place(name), code);
    }
    std::set<std::string> filesEndingIn(std::string_view ending) const {
        std::set<std::string> names = analogon::filesEndingIn(directory_, ending);
        std::erase_if(names, [&](const std::string& name) { return pending_.removes(name); });
        for (const std::string& name : pending_.files())
            if (const fs::path path(name); path.extension() == ending && path.filename() == path) names.insert(name);
        return names;
    }

private:
    fs::path directory_;
    PendingSave pending_;
};

/// The study.json that a path means.
Outcome<fs::path> studyFile(const fs::path& path, const StudyFolder& folder) {
    std::error_code code;
    if (!fs::exists(path, code) && !folder.holds(path.filename()))
        return fileError(phrase("there is no such file or directory"), path.string(), 0, 0,
                         phrase("Give the directory of a study, or its study.json."));
    if (fs::is_directory(path, code)) {
        if (folder.holds("study.json")) return path / "study.json";
        return fileError(phrase("this directory holds no study.json"), path.string(), 0, 0,
                         phrase("A study is a directory with study.json, a model (.mo) and its measurements."));
    }
    if (path.extension() == ".analogon")
        return fileError(phrase("packed studies cannot be read here"), path.string(), 0, 0,
                         phrase("Unpack it (it is a zip archive) and give the directory."));
    if (path.extension() == ".json") return path;
    return fileError(phrase("this is not a study"), path.string(), 0, 0,
                     phrase("Give the directory of a study, or its study.json."));
}

/// The file that declares the class; "model.mo" when none does, so that its text can still be shown and mended.
std::string fileOfClass(const std::map<std::string, std::string>& models, const std::string& className) {
    for (const auto& [name, text] : models) {
        const auto parsed = syntax::parse(std::make_shared<const Source>(name, text));
        const std::string within = parsed.definition.within ? parsed.definition.within->text() : "";
        for (const syntax::ClassPtr& definition : parsed.definition.classes) {
            const std::string qualified = within.empty() ? definition->name : within + '.' + definition->name;
            if (className == qualified || className.starts_with(qualified + '.')) return name;
        }
    }
    if (models.contains("model.mo") || models.empty()) return "model.mo";
    return models.begin()->first;
}

Outcome<std::shared_ptr<const Table>> readMeasurement(const Study& study, const StudyFolder& folder, std::size_t index,
                                                      Diagnostics& warnings) {
    const StudyExperiment& experiment = study.experiments[index];
    if (!folder.holds(experiment.file)) {
        std::set<std::string> present;
        for (const char* const ending : {".csv", ".txt", ".mf4", ".mdf", ".dat", ".mat", ".tdms", ".xlsx"})
            present.merge(folder.filesEndingIn(ending));
        const std::string alike = suggestion(experiment.file, {present.begin(), present.end()});
        Text hint = phrase("The path is relative to the study's directory.");
        if (!alike.empty()) hint = phrase("Did you mean '{}'?", alike);
        return error(phrase("experiment '{}': there is no file '{}'", experiment.name, experiment.file),
                     JsonPlaces(study.json).value(fmt::format("/experiments/{}/file", index)), hint);
    }
    Outcome<Table> table =
        readTable(folder.place(experiment.file).lexically_normal(), experiment.read, namedChannels(study, experiment));
    if (!table) return table.diagnostics();
    warnings.insert(warnings.end(), table.diagnostics().begin(), table.diagnostics().end());
    const std::string file = (study.directory / experiment.file).lexically_normal().string();
    if (table->file == file) return std::make_shared<const Table>(std::move(*table));
    return calledAs(*table, file);
}

/// The tables of the experiments; why there is none of others is a fault, or kept with the study.
Diagnostics readMeasurements(Study& study, const StudyFolder& folder, UnreadMeasurement unread, Diagnostics& warnings) {
    Diagnostics faults;
    for (std::size_t i = 0; i < study.experiments.size(); ++i) {
        const std::string name = tableKey(study.experiments[i]);
        const bool isRefused = unread == UnreadMeasurement::Refused && study.experiments[i].isUsed;
        if (study.tables.contains(name) || (study.unread.contains(name) && !isRefused)) continue;
        auto table = readMeasurement(study, folder, i, warnings);
        if (table)
            study.tables[name] = *table;
        else if (isRefused)
            faults.insert(faults.end(), table.diagnostics().begin(), table.diagnostics().end());
        else
            study.unread[name] = table.diagnostics();
    }
    return faults;
}

Outcome<Study> readFolder(const fs::path& file, const StudyFolder& folder, UnreadMeasurement unread) {
    Outcome<std::string> json = readRegularFile(folder.place(file.filename()), largestText);
    if (!json) return json.diagnostics();
    Outcome<Study> parsed = parseStudyJson(std::make_shared<const Source>(file.string(), std::move(*json)));
    if (!parsed) return parsed;

    Study study = std::move(*parsed);
    Diagnostics warnings = parsed.diagnostics();
    study.directory = file.parent_path();
    study.name = fs::absolute(file).lexically_normal().parent_path().filename().string();
    for (const std::string& name : folder.filesEndingIn(".mo")) {
        Outcome<std::string> text = readRegularFile(folder.place(name), largestText);
        if (!text) return text.diagnostics();
        study.models[name] = std::move(*text);
    }
    study.modelFile = fileOfClass(study.models, study.className);
    if (Diagnostics faults = readMeasurements(study, folder, unread, warnings); !faults.empty()) return faults;
    for (StudyExperiment& experiment : study.experiments) findTime(study.tables, experiment);
    const Diagnostics ofReport = reportHeadFaults(study);
    warnings.insert(warnings.end(), ofReport.begin(), ofReport.end());
    return {std::move(study), std::move(warnings)};
}

}  // namespace

Outcome<Study> readStudy(const std::filesystem::path& path, UnreadMeasurement unread) {
    std::error_code code;
    fs::path directory = fs::is_directory(path, code) ? path : path.parent_path();
    if (directory.empty()) directory = ".";
    const DirectoryLock lock(directory, DirectoryLock::Kind::Shared, longestSave);
    if (lock.isBusy()) return isBeingSaved(path);
    const StudyFolder folder(directory);
    const Outcome<fs::path> file = studyFile(path, folder);
    if (!file) return file.diagnostics();
    return readFolder(*file, folder, unread);
}

}  // namespace analogon
