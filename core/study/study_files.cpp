#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "core/base/file_fault.hpp"
#include "core/study/json_places.hpp"
#include "core/study/study.hpp"
#include "core/syntax/parser.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

Outcome<std::string> readText(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        return fileError(phrase("the file cannot be opened"), file.string(), 0, 0,
                         phrase("Check its name and its access rights."));
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::vector<fs::path> filesEndingIn(const fs::path& directory, std::string_view ending) {
    std::vector<fs::path> files;
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(directory, code))
        if (entry.path().extension() == ending && entry.is_regular_file(code)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// The study.json that a path means.
Outcome<fs::path> studyFile(const fs::path& path) {
    std::error_code code;
    if (!fs::exists(path, code))
        return fileError(phrase("there is no such file or directory"), path.string(), 0, 0,
                         phrase("Give the directory of a study, or its study.json."));
    if (fs::is_directory(path, code)) {
        if (fs::exists(path / "study.json", code)) return path / "study.json";
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

Outcome<std::shared_ptr<const Table>> readMeasurement(const Study& study, std::size_t index, Diagnostics& warnings) {
    const StudyExperiment& experiment = study.experiments[index];
    const fs::path file = (study.directory / experiment.file).lexically_normal();
    std::error_code code;
    if (!fs::exists(file, code)) {
        std::vector<std::string> present;
        for (const fs::path& other : filesEndingIn(study.directory, ".csv"))
            present.push_back(other.filename().string());
        const std::string alike = suggestion(experiment.file, present);
        Text hint = phrase("The path is relative to the study's directory.");
        if (!alike.empty()) hint = phrase("Did you mean '{}'?", alike);
        return error(phrase("experiment '{}': there is no file '{}'", experiment.name, experiment.file),
                     JsonPlaces(study.json).value(fmt::format("/experiments/{}/file", index)), hint);
    }
    Outcome<Table> table = readTable(file);
    if (!table) return table.diagnostics();
    warnings.insert(warnings.end(), table.diagnostics().begin(), table.diagnostics().end());
    return std::make_shared<const Table>(std::move(*table));
}

bool leavesDirectory(const fs::path& path) {
    return path.is_absolute() || path.has_root_name() || path.lexically_normal().begin()->string() == "..";
}

/// What has come to the disk survives a loss of power, too.
void sync(const fs::path& path) {
    const int handle = open(path.c_str(), O_RDONLY);
    if (handle < 0) return;
    fsync(handle);
    close(handle);
}

/// A save into a directory that exists cannot be one step of the file system. Its files are written into
/// `writingFolder` first. The save is done once that folder is renamed to `savedFolder`; moving the files to their
/// places is finished by whoever reads or writes the study next, should the program be ended meanwhile.
constexpr const char* writingFolder = ".analogon-writing";
constexpr const char* savedFolder = ".analogon-saved";
constexpr const char* removedList = ".removed";  // in it: names of models that the new study has no more

/// Moves the files of a save that was done to their places.
std::error_code finishSave(const fs::path& directory) {
    std::error_code code;
    const fs::path saved = directory / savedFolder;
    if (!fs::is_directory(saved, code)) return {};
    std::ifstream list(saved / removedList);
    for (std::string name; std::getline(list, name);)
        if (const fs::path model = fs::path(name).filename(); model.extension() == ".mo")
            fs::remove(directory / model, code);
    list.close();
    fs::remove(saved / removedList, code);
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(saved, code))
        if (entry.is_regular_file(code)) files.push_back(entry.path());
    code.clear();
    for (const fs::path& file : files) {
        const fs::path place = directory / file.lexically_relative(saved);
        fs::create_directories(place.parent_path(), code);
        fs::rename(file, place, code);
        if (code && code != std::errc::no_such_file_or_directory) return code;  // another program may finish it, too
        code.clear();
    }
    fs::remove_all(saved, code);
    sync(directory);
    return code;
}

/// Writes the files of a study into a directory of its own, then moves them to their place.
class StudyWriter {
public:
    StudyWriter(const Study& study, const fs::path& target) : study_(study), target_(target) {}

    Outcome<Done> write() {
        std::error_code code;
        if (!makeTemporary(code)) return cannotWrite(target_, code);
        Outcome<Done> result = fill();
        if (result) result = move();
        fs::remove_all(temporary_, code);
        return result;
    }

private:
    bool makeTemporary(std::error_code& code) {
        fs::path plain = fs::absolute(target_, code).lexically_normal();
        if (!plain.has_filename()) plain = plain.parent_path();
        target_ = plain;
        if (fs::is_directory(target_, code)) {
            if (code = finishSave(target_); code) return false;
            temporary_ = target_ / writingFolder;
            fs::remove_all(temporary_, code);  // of a save that was ended
            return fs::create_directory(temporary_, code);
        }
        code.clear();
        fs::create_directories(target_.parent_path(), code);
        for (int i = 0; i < 1000 && !code; ++i) {
            temporary_ = target_.parent_path() / fmt::format(".{}.writing{}", target_.filename().string(), i);
            if (fs::create_directory(temporary_, code)) return true;
        }
        return false;
    }

    Outcome<Done> put(const std::string& name, const std::string& content) {
        std::error_code code;
        fs::create_directories((temporary_ / name).parent_path(), code);
        std::ofstream stream(temporary_ / name, std::ios::binary);
        stream << content;
        stream.close();
        sync(temporary_ / name);
        if (!stream) return cannotWrite(target_ / name, std::make_error_code(std::errc::io_error));
        written_.insert(name);
        return Done{};
    }

    Outcome<Done> fill() {
        Study placed = study_;
        for (StudyExperiment& experiment : placed.experiments) {
            const std::string from = experiment.file;
            experiment.file = placeOfMeasurement(from);
            if (Outcome<Done> done = putMeasurement(from, experiment.file); !done) return done;
        }
        for (const auto& [name, text] : study_.models)
            if (Outcome<Done> done = put(name, text); !done) return done;
        return put("study.json", studyJson(placed));
    }

    /// Where a measurement lies in the written study; those from elsewhere come to lie beside study.json.
    std::string placeOfMeasurement(const std::string& file) {
        if (const auto known = places_.find(file); known != places_.end()) return known->second;
        const fs::path path(file);
        std::string place = leavesDirectory(path) ? path.filename().string() : path.lexically_normal().generic_string();
        for (int i = 2; taken_.contains(place); ++i)
            place = fmt::format("{}_{}{}", path.stem().string(), i, path.extension().string());
        taken_.insert(place);
        return places_[file] = place;
    }

    Outcome<Done> putMeasurement(const std::string& from, const std::string& place) {
        if (written_.contains(place)) return Done{};
        std::error_code code;
        const fs::path source = study_.directory / from;
        if ((!study_.directory.empty() || source.is_absolute()) && fs::exists(source, code)) {
            if (fs::equivalent(source, target_ / place, code)) return Done{};  // it is there already
            fs::create_directories((temporary_ / place).parent_path(), code);
            fs::copy_file(source, temporary_ / place, code);
            if (code) return cannotWrite(target_ / place, code);
            // A measurement kept read-only at its origin shall not make the copy so.
            fs::permissions(temporary_ / place, fs::perms::owner_write, fs::perm_options::add, code);
            sync(temporary_ / place);
            written_.insert(place);
            return Done{};
        }
        const auto table = study_.tables.find(from);
        if (table == study_.tables.end() || !table->second)
            return fileError(phrase("the measurement is neither on disk nor in the study"), source.string());
        return put(place, writeCsv(*table->second));
    }

    Outcome<Done> move() {
        std::error_code code;
        sync(temporary_);
        if (!fs::exists(target_, code)) {
            fs::rename(temporary_, target_, code);
            if (code) return cannotWrite(target_, code);
            sync(target_.parent_path());
            return Done{};
        }
        // Blocks of the study that lay here before would become part of this one.
        if (fs::exists(target_ / "study.json", code) && !fs::equivalent(target_, study_.directory, code)) {
            std::string removed;
            for (const fs::path& model : filesEndingIn(target_, ".mo"))
                if (!study_.models.contains(model.filename().string())) removed += model.filename().string() + "\n";
            if (Outcome<Done> done = put(removedList, removed); !done) return done;
        }
        code.clear();
        fs::rename(temporary_, target_ / savedFolder, code);
        if (code) return cannotWrite(target_, code);
        sync(target_);
        code = finishSave(target_);
        return code ? Outcome<Done>(cannotWrite(target_, code)) : Outcome<Done>(Done{});
    }

    const Study& study_;
    fs::path target_, temporary_;
    std::map<std::string, std::string> places_;
    std::set<std::string> taken_, written_;
};

}  // namespace

Outcome<Study> readStudy(const std::filesystem::path& path) {
    std::error_code code;
    if (const std::error_code stuck = finishSave(fs::is_directory(path, code) ? path : path.parent_path()); stuck)
        return cannotWrite(path, stuck);
    const Outcome<fs::path> file = studyFile(path);
    if (!file) return file.diagnostics();
    const Outcome<std::string> json = readText(*file);
    if (!json) return json.diagnostics();
    Outcome<Study> parsed = parseStudyJson(std::make_shared<const Source>(file->string(), *json));
    if (!parsed) return parsed;

    Study study = std::move(*parsed);
    Diagnostics warnings = parsed.diagnostics(), faults;
    study.directory = file->parent_path();
    study.name = fs::absolute(*file).lexically_normal().parent_path().filename().string();
    for (const fs::path& model : filesEndingIn(study.directory, ".mo")) {
        Outcome<std::string> text = readText(model);
        if (!text) return text.diagnostics();
        study.models[model.filename().string()] = std::move(*text);
    }
    study.modelFile = fileOfClass(study.models, study.className);
    for (std::size_t i = 0; i < study.experiments.size(); ++i) {
        const std::string& name = study.experiments[i].file;
        if (study.tables.contains(name)) continue;
        auto table = readMeasurement(study, i, warnings);
        if (table) {
            study.tables[name] = *table;
        } else {
            faults.insert(faults.end(), table.diagnostics().begin(), table.diagnostics().end());
        }
    }
    if (!faults.empty()) return faults;
    return {std::move(study), std::move(warnings)};
}

Outcome<Done> writeStudy(const Study& study, const std::filesystem::path& directory) {
    return StudyWriter(study, directory).write();
}

}  // namespace analogon
