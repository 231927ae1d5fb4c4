#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "core/base/directory_lock.hpp"
#include "core/base/file_fault.hpp"
#include "core/base/file_step.hpp"
#include "core/base/owned_directory.hpp"
#include "core/base/whole_file.hpp"
#include "core/library/package_files.hpp"
#include "core/measure/encoding.hpp"
#include "core/study/pending_save.hpp"
#include "core/study/recorded.hpp"
#include "core/study/report_settings.hpp"
#include "core/study/study.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

bool holdTheSame(const fs::path& a, const fs::path& b) {
    std::error_code code;
    if (!fs::is_regular_file(a, code) || !fs::is_regular_file(b, code)) return false;
    if (fs::file_size(a, code) != fs::file_size(b, code) || code) return false;
    std::ifstream first(a, std::ios::binary), second(b, std::ios::binary);
    using Bytes = std::istreambuf_iterator<char>;
    return std::equal(Bytes(first), Bytes(), Bytes(second), Bytes());
}

/// Writes the files of a study into a directory of its own, then moves them to their place.
class StudyWriter {
public:
    StudyWriter(const Study& study, const fs::path& target, OutsideLibraries outside)
        : study_(study), target_(target), outside_(outside) {}

    /// Notes: what was given another name.
    Outcome<Done> write() {
        if (Outcome<Done> made = prepare(); !made) return made;
        if (Outcome<Done> filled = fill(); !filled) return filled;
        if (Outcome<Done> moved = move(); !moved) return moved;
        return {Done{}, std::move(notes_)};
    }

private:
    /// A directory of its own within the target, or beside it where there is none.
    Outcome<Done> prepare() {
        std::error_code code;
        target_ = fs::absolute(target_, code).lexically_normal();
        if (!target_.has_filename()) target_ = target_.parent_path();
        isThere_ = fs::is_directory(target_, code);
        if (isThere_) {
            target_ = fs::canonical(target_, code);
            lock_ = DirectoryLock(target_, DirectoryLock::Kind::Exclusive, longestSave);
            if (lock_.isBusy()) return isBeingSaved(target_);
        } else if (fs::exists(fs::symlink_status(target_, code))) {
            return cannotWrite(target_, phrase("a file has this name"));
        } else {
            fs::create_directories(target_.parent_path(), code);
            if (code) return cannotWrite(target_, code);
        }
        Outcome<OwnedDirectory> own = OwnedDirectory::make(isThere_ ? target_ : target_.parent_path(), writingPrefix);
        if (!own) return cannotWrite(target_, own.diagnostics().front().message);
        own_ = std::move(*own);
        temporary_ = own_->path() / "new";
        if (isThere_) code = PendingSave::in(target_).finish(own_->path());
        if (!code) fs::create_directory(temporary_, code);
        return code ? Outcome<Done>(cannotWrite(target_, code)) : Outcome<Done>(Done{});
    }

    /// A file must come to lie where its name says, and at the place of nothing but a file.
    Outcome<Done> makeRoom(const std::string& name) {
        std::error_code code;
        if (leadsAway(target_, name))
            return cannotWrite(target_ / name, phrase("a link on its way leads to another directory"));
        if (fs::is_directory(fs::symlink_status(target_ / name, code)))
            return cannotWrite(target_ / name, phrase("a directory has this name"));
        fs::create_directories((temporary_ / name).parent_path(), code);
        return code ? Outcome<Done>(cannotWrite(target_ / name, code)) : Outcome<Done>(Done{});
    }

    Outcome<Done> put(const std::string& name, const std::string& content) {
        if (Outcome<Done> room = makeRoom(name); !room) return room;
        std::ofstream stream(temporary_ / name, std::ios::binary);
        stream << content;
        stream.close();
        syncToDisk(temporary_ / name);
        if (!stream) return cannotWrite(target_ / name, phrase("the disk may be full"));
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
        if (Outcome<Done> done = putLogo(placed); !done) return done;
        for (const auto& [name, text] : study_.models)
            if (Outcome<Done> done = put(name, text); !done) return done;
        if (Outcome<Done> done = putLibraries(placed); !done) return done;
        return put("study.json", studyJson(placed));
    }

    /// The picture of the report's head, where it is there; a missing one is told when the study is read.
    Outcome<Done> putLogo(Study& placed) {
        ReportHead head = reportHeadOf(placed.extraJson);
        if (head.logo.empty()) return Done{};
        const fs::path source = PendingSave::in(study_.directory).place(head.logo);
        std::error_code code;
        if (study_.directory.empty() && source.is_relative()) return Done{};
        if (!fs::is_regular_file(source, code)) return Done{};
        const std::string place = placeOfMeasurement(head.logo);
        if (place != head.logo) {
            head.logo = place;
            placed.extraJson = withReportHead(placed.extraJson, head);
        }
        if (written_.contains(place) || fs::equivalent(source, target_ / place, code)) return Done{};
        return copy(source, place);
    }

    /// A name that study.json can hold.
    static fs::path nameableName(const fs::path& file) { return inUtf8(file.filename().string()); }

    /// Where a measurement lies in the written study; those from elsewhere come to lie beside study.json, at the place
    /// of no other file, and so do those whose names study.json cannot hold.
    std::string placeOfMeasurement(const std::string& file) {
        if (const auto known = places_.find(file); known != places_.end()) return known->second;
        const bool isMoved = leavesDirectory(file) || !isUtf8(file);
        const fs::path path = isMoved ? nameableName(file) : fs::path(file).lexically_normal();
        std::string place = path.generic_string();
        const auto isOfAnother = [&] {
            std::error_code code;
            return isMoved && fs::exists(fs::symlink_status(target_ / place, code)) &&
                   !holdTheSame(study_.directory / file, target_ / place);
        };
        for (int i = 2; taken_.contains(place) || isOfAnother(); ++i)
            place = fmt::format("{}_{}{}", path.stem().string(), i, path.extension().string());
        taken_.insert(place);
        if (isMoved && path != fs::path(file).filename()) {
            Diagnostic note = fileError(
                phrase("the measurement is called \"{}\" in the study, which cannot name it as it is called", place),
                file);
            note.severity = Severity::Note;
            notes_.push_back(std::move(note));
        }
        return places_[file] = place;
    }

    Outcome<Done> putMeasurement(const std::string& from, const std::string& place) {
        if (written_.contains(place)) return Done{};
        std::error_code code;
        const bool isHere = isThere_ && fs::equivalent(target_, study_.directory, code);
        DirectoryLock lock;
        if (!isHere && !study_.directory.empty())
            lock = DirectoryLock(study_.directory, DirectoryLock::Kind::Shared, longestSave);
        if (lock.isBusy()) return isBeingSaved(study_.directory);
        const fs::path source = PendingSave::in(study_.directory).place(from);
        if ((!study_.directory.empty() || source.is_absolute()) && fs::exists(source, code)) {
            if (fs::equivalent(source, target_ / place, code)) return Done{};  // it is there already
            return copy(source, place);
        }
        const auto table = std::find_if(study_.tables.begin(), study_.tables.end(),
                                        [&](const auto& known) { return fileOfKey(known.first) == from; });
        const bool isUnread = std::any_of(study_.unread.begin(), study_.unread.end(),
                                          [&](const auto& known) { return fileOfKey(known.first) == from; });
        if (table == study_.tables.end() && isUnread) return Done{};  // there was none to be written
        if (table == study_.tables.end() || !table->second || !table->second->others.empty())
            return fileError(phrase("the measurement is neither on disk nor in the study"), source.string());
        return put(place, writeCsv(*table->second));
    }

    Outcome<Done> copy(const fs::path& source, const std::string& place) {
        if (written_.contains(place)) return Done{};
        if (Outcome<Done> room = makeRoom(place); !room) return room;
        std::error_code code = copyToNew(source, temporary_ / place);
        if (code) return cannotWrite(target_ / place, code);
        // A measurement kept read-only at its origin shall not make the copy so.
        fs::permissions(temporary_ / place, fs::perms::owner_write, fs::perm_options::add, code);
        syncToDisk(temporary_ / place);
        written_.insert(place);
        return Done{};
    }

    /// Whether a place is that of another file, or lies below one, or around one.
    bool isTaken(const std::string& place) const {
        return std::any_of(taken_.begin(), taken_.end(), [&](const std::string& other) {
            return other == place || other.starts_with(place + '/') || place.starts_with(other + '/');
        });
    }

    /// Libraries of a study that is written elsewhere: what is relative to the one directory is not to the other.
    Outcome<Done> putLibraries(Study& placed) {
        std::error_code code;
        if (isThere_ && fs::equivalent(target_, study_.directory, code)) return Done{};
        for (std::string& path : placed.libraryPaths) {
            const fs::path from = fs::weakly_canonical(study_.directory / path, code);
            const bool isOutside = leavesDirectory(path);
            if (isOutside && outside_ == OutsideLibraries::Named && isUtf8(from.string())) {
                path = from.string();
                continue;
            }
            std::string place = fs::path(path).lexically_normal().generic_string();
            if (isOutside) place = freePlaceOf(from);
            for (const fs::path& file : packageFiles(from)) {
                const fs::path name = file == from ? fs::path(place) : place / file.lexically_relative(from);
                if (Outcome<Done> done = copy(file, name.lexically_normal().generic_string()); !done) return done;
            }
            path = place;
        }
        return Done{};
    }

    /// "library/Workshop": a package may be kept under any name.
    std::string freePlaceOf(const fs::path& library) {
        const fs::path name = inUtf8(library.filename().string());
        std::string place = (libraryFolder / name).generic_string();
        for (int i = 2; isTaken(place); ++i) place = fmt::format("{}_{}/{}", libraryFolder.string(), i, name.string());
        taken_.insert(place);
        return place;
    }

    /// Blocks of another study that lay here before would become part of this one.
    std::set<std::string> removedModels() const {
        std::set<std::string> removed;
        std::error_code code;
        if (!fs::exists(target_ / "study.json", code) || fs::equivalent(target_, study_.directory, code))
            return removed;
        for (fs::directory_iterator entry(target_, code), end; !code && entry != end; entry.increment(code)) {
            const std::string name = entry->path().filename().string();
            if (entry->path().extension() == ".mo" && !study_.models.contains(name)) removed.insert(name);
        }
        return removed;
    }

    Outcome<Done> move() {
        std::error_code code;
        if (isThere_) {
            code = commitSave(temporary_, target_, written_, removedModels());
            if (!code) code = PendingSave::in(target_).finish(own_->path());
        } else {
            syncToDisk(temporary_);
            code = renameToNew(temporary_, target_);
            if (!code) syncToDisk(target_.parent_path());
        }
        return code ? Outcome<Done>(cannotWrite(target_, code)) : Outcome<Done>(Done{});
    }

    inline static const fs::path libraryFolder = "library";

    const Study& study_;
    fs::path target_, temporary_;
    OutsideLibraries outside_;
    bool isThere_{};
    DirectoryLock lock_;
    std::optional<OwnedDirectory> own_;
    std::map<std::string, std::string> places_;
    std::set<std::string> taken_, written_;
    Diagnostics notes_;
};

}  // namespace

Outcome<Done> writeStudy(const Study& study, const std::filesystem::path& directory, OutsideLibraries outside) {
    return StudyWriter(study, directory, outside).write();
}

}  // namespace analogon
