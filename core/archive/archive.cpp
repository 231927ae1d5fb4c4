#include "core/archive/archive.hpp"

#include <fcntl.h>
#include <quazip/quazip.h>
#include <quazip/quazipfile.h>
#include <quazip/quazipnewinfo.h>
#include <unistd.h>

#include <QBuffer>
#include <QCryptographicHash>
#include <QFile>
#include <QSysInfo>
#include <algorithm>
#include <cerrno>
#include <fstream>

#include "core/archive/archive_limits.hpp"
#include "core/archive/zip_directory.hpp"
#include "core/archive/zip_look.hpp"
#include "core/base/file_fault.hpp"
#include "core/base/file_step.hpp"
#include "core/base/owned_directory.hpp"
#include "core/base/regular_file.hpp"
#include "core/base/stop.hpp"
#include "core/base/visible.hpp"
#include "core/base/whole_file.hpp"
#include "core/study/json_places.hpp"
#include "core/study/named_path.hpp"
#include "core/study/pending_save.hpp"
#include "core/study/recorded.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

constexpr qint64 chunk = 1 << 20;  // [byte]

bool openNew(QFile& file, const fs::path& path) {
    const int handle = open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    return handle >= 0 && file.open(handle, QIODevice::ReadWrite, QFileDevice::AutoCloseHandle);
}

Diagnostic damaged(const fs::path& archive, const std::string& entry, const char* what) {
    return fileError(phrase("the entry \"{}\" {}", visibleName(entry), Text(what, {}, what)), archive.string(), 0, 0,
                     phrase("Get the file again from where it came from."));
}

/// Told of the entry and of where there must be room, not of the directory of ours that it is unpacked into.
struct Unpacking {
    fs::path archive, directory, place;  // of the user's, where the directory lies

    Diagnostic fails(const ZipEntry& entry, const Text& why) const {
        return fileError(phrase("the entry \"{}\" cannot be unpacked: {}", visibleName(entry.name), why),
                         archive.string(), 0, 0,
                         phrase("Check that {} may be written and has room.", visibleName(place.string())));
    }
    Diagnostic fails(const ZipEntry& entry, const std::error_code& code) const { return fails(entry, code.message()); }
};

/// Why a file is not written. One that took a part only has no fault of the system: the text of any file then.
Text reasonOf(const QFile& file) {
    const QString reason = file.errorString();
    return reason == QFile().errorString() ? phrase("the disk may be full") : Text(reason.toStdString());
}

/// Unpacks one entry; never more than the archive said it holds.
Outcome<Done> unpackEntry(QuaZip& zip, const Unpacking& unpacking, const ZipEntry& entry, const Progress& progress) {
    const fs::path &archive = unpacking.archive, target = unpacking.directory / entry.name;
    if (!zip.setCurrentFile(QString::fromStdString(entry.name), QuaZip::csSensitive))
        return damaged(archive, entry.name, "cannot be found");
    QuaZipFile from(&zip);
    if (!from.open(QIODevice::ReadOnly)) return damaged(archive, entry.name, "cannot be read: its header is damaged");
    std::error_code code;
    fs::create_directories(target.parent_path(), code);
    QFile to;
    if (code) return unpacking.fails(entry, code);
    if (!openNew(to, target)) return unpacking.fails(entry, lastFault());
    std::uint64_t left = entry.size;
    QByteArray bytes(chunk, Qt::Uninitialized);
    for (;;) {
        if (progress.stopRequested()) return fileError(phrase("interrupted"), archive.string());
        stopPoint();
        const qint64 count = from.read(bytes.data(), chunk);
        if (count < 0) return damaged(archive, entry.name, "is damaged: its compressed data cannot be read");
        if (count == 0) break;
        if (static_cast<std::uint64_t>(count) > left)
            return damaged(archive, entry.name, "is larger than the archive says");
        left -= static_cast<std::uint64_t>(count);
        if (to.write(bytes.constData(), count) != count) return unpacking.fails(entry, reasonOf(to));
    }
    if (left > 0) return damaged(archive, entry.name, "is shorter than the archive says");
    from.close();  // compares the checksum
    if (from.getZipError() != UNZ_OK) return damaged(archive, entry.name, "is damaged: its checksum does not fit");
    to.close();
    if (to.error() != QFile::NoError) return unpacking.fails(entry, reasonOf(to));
    return Done{};
}

/// All entries below a directory; returns the warnings.
Outcome<Done> unpackInto(const Unpacking& unpacking, const Progress& progress = {}) {
    const auto& [archive, directory, place] = unpacking;
    const Outcome<std::vector<ZipEntry>> entries = readZipDirectory(archive);
    if (!entries) return entries.diagnostics();
    if (Outcome<Done> isBounded = checkLimits(archive, *entries); !isBounded) return isBounded;
    QFile file;
    QuaZip zip(&file);
    if (!openForReading(file, archive) || !zip.open(QuaZip::mdUnzip))
        return fileError(phrase("this is no zip archive"), archive.string());
    Diagnostics warnings = entries.diagnostics();
    for (const ZipEntry& entry : *entries) {
        Outcome<Done> done = unpackEntry(zip, unpacking, entry, progress);
        if (done) continue;
        if (progress.stopRequested() || !entry.name.starts_with(historyFolder + std::string("/"))) return done;
        std::error_code code;
        fs::remove(directory / entry.name, code);  // a damaged history costs the history, not the study
        std::transform(done.diagnostics().begin(), done.diagnostics().end(), std::back_inserter(warnings), asWarning);
    }
    const auto isStudy = [](const ZipEntry& e) { return e.name == "study.json"; };
    if (std::none_of(entries->begin(), entries->end(), isStudy))
        return fileError(phrase("this archive holds no study.json"), archive.string(), 0, 0,
                         phrase("A study archive holds study.json, a model (.mo) and its measurements at its top."));
    if (entries->front().name == "mimetype") {
        std::ifstream stream(directory / "mimetype");
        const std::string type((std::istreambuf_iterator<char>(stream)), {});
        if (type != archiveType)
            return fileError(phrase("this archive is of another kind: \"{}\"", visibleName(type)), archive.string());
        std::error_code code;
        fs::remove(directory / "mimetype", code);
    }
    return {Done{}, std::move(warnings)};
}

/// The runs in a study's directory; what cannot be read of them is a warning.
std::vector<PastRun> historyIn(const fs::path& directory, const Study& study, Diagnostics& warnings) {
    Outcome<std::vector<PastRun>> history = readHistory(directory / historyFolder, study);
    warnings.insert(warnings.end(), history.diagnostics().begin(), history.diagnostics().end());
    return history ? std::move(*history) : std::vector<PastRun>();
}

/// A recording that a run saw at another place, and that is not here: named without the way there.
void keepWithin(Study& study) {
    for (StudyExperiment& e : study.experiments)
        if (leavesDirectory(e.file)) e.file = fs::path(e.file).filename().string();
}

bool leadsOut(const Study& study) {
    return std::any_of(study.experiments.begin(), study.experiments.end(),
                       [](const StudyExperiment& e) { return leavesDirectory(e.file); });
}

void keepWithin(PastRun& run) {
    if (leadsOut(*run.ranOn)) {
        auto ranOn = std::make_shared<Study>(*run.ranOn);
        keepWithin(*ranOn);
        run.ranOn = std::move(ranOn);
    }
    if (!leadsOut(run.result->completed) && !(run.result->proposed && leadsOut(*run.result->proposed))) return;
    auto result = std::make_shared<RunResult>(*run.result);
    keepWithin(result->completed);
    if (result->proposed) keepWithin(*result->proposed);
    run.result = std::move(result);
}

/// Paths below the temporary directory as entries of the archive.
Diagnostics renamed(Diagnostics diagnostics, const std::string& from, const std::string& to) {
    for (Diagnostic& d : diagnostics) {
        Text file = d.place.file;
        for (Text* const text : {&d.message, &file, &d.hint}) text->replaceAll(from, to);
        d.place.file = file;
    }
    return diagnostics;
}

Diagnostic isNotInside(const NamedPath& named, const Span& place) {
    switch (named.key) {
        case NamedPath::Key::Measurement:
            return error(phrase("experiment '{}': the file '{}' is not in the archive", named.experiment, named.path),
                         place, phrase("An archive reads itself alone: put the measurement into it."));
        case NamedPath::Key::Logo:
            return error(phrase("the logo '{}' is not in the archive", named.path), place,
                         phrase("An archive reads itself alone: put the logo into it."));
        case NamedPath::Key::Library:
            break;
    }
    return error(phrase("the library '{}' is not in the archive", named.path), place,
                 phrase("An archive reads itself alone: pack the directory of the study, which puts the library into "
                        "it."));
}

/// An archive reads itself alone: what it names elsewhere would be a file of whoever opens it.
Outcome<Done> checkReach(const fs::path& directory, const fs::path& archive) {
    const fs::path place = directory / "study.json";
    Outcome<std::string> text = readRegularFile(place);
    if (!text) return Done{};  // told when it is read
    const auto json = std::make_shared<const Source>((archive / "study.json").string(), std::move(*text));
    const Outcome<Study> study = parseStudyJson(json);
    if (!study) return Done{};
    Diagnostics faults;
    const JsonPlaces places(json);
    for (const NamedPath& named : namedPaths(*study))
        if (!staysWithin(directory, named.path)) faults.push_back(isNotInside(named, places.value(named.pointer)));
    return faults.empty() ? Outcome<Done>(Done{}) : Outcome<Done>(faults);
}

/// Tells by what an archive was packed from what: the machine and the place of the study, which nobody can read from
/// it.
std::string packComment(const OpenedStudy& opened) {
    std::error_code code;
    const fs::path place = opened.files ? opened.origin : fs::absolute(opened.study.directory, code);
    const std::string path = fs::weakly_canonical(place, code).string();
    const QByteArray origin = QSysInfo::machineUniqueId() + '\0' + QByteArray::fromStdString(path);
    return "analogon-pack-1 " + QCryptographicHash::hash(origin, QCryptographicHash::Sha256).toHex().toStdString();
}

Outcome<OpenedStudy> openArchive(const fs::path& archive, UnreadMeasurement unread) {
    Outcome<std::shared_ptr<const TemporaryDirectory>> files = TemporaryDirectory::make();
    if (!files) return files.diagnostics();
    const fs::path directory = (*files)->path();
    const Outcome<Done> unpacked = unpackInto({archive, directory, (*files)->place()});
    if (!unpacked) return unpacked.diagnostics();
    if (const Outcome<Done> isWithin = checkReach(directory, archive); !isWithin) return isWithin.diagnostics();
    Outcome<Study> study = readStudy(directory, unread);
    Diagnostics messages = renamed(study.diagnostics(), directory.string(), archive.string());
    if (!study) return messages;
    messages.insert(messages.begin(), unpacked.diagnostics().begin(), unpacked.diagnostics().end());
    study->name = archive.stem().string();
    if (study->json)
        study->json = std::make_shared<const Source>((archive / "study.json").string(), study->json->text());
    for (auto& [name, table] : study->tables) {
        table = calledAs(*table, (archive / fileOfKey(name)).string());
    }
    Diagnostics lost;
    std::vector<PastRun> history = historyIn(directory, *study, lost);
    for (PastRun& run : history) keepWithin(run);
    for (Diagnostic& d : renamed(std::move(lost), directory.string(), archive.string()))
        messages.push_back(std::move(d));
    return {OpenedStudy{std::move(*study), *files, archive, std::move(history)}, std::move(messages)};
}

std::vector<std::string> filesBelow(const fs::path& directory) {
    std::vector<std::string> names;
    std::error_code code;
    for (const auto& entry : fs::recursive_directory_iterator(directory, code))
        if (entry.is_regular_file(code)) names.push_back(entry.path().lexically_relative(directory).generic_string());
    std::sort(names.begin(), names.end());
    return names;
}

bool putEntry(QuaZip& zip, const std::string& name, QIODevice& from, bool isStored, const Progress& progress) {
    QuaZipNewInfo info(QString::fromStdString(name));
    info.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup | QFile::ReadOther);
    QuaZipFile to(&zip);
    const bool isOpen =
        isStored ? to.open(QIODevice::WriteOnly, info, nullptr, 0, 0, 0) : to.open(QIODevice::WriteOnly, info);
    if (!isOpen) return false;
    QByteArray bytes;
    while (!(bytes = from.read(chunk)).isEmpty())
        if (progress.stopRequested() || to.write(bytes) != bytes.size()) return false;
    to.close();
    return to.getZipError() == ZIP_OK;
}

/// What a zip file is told of itself.
struct ZipHead {
    const char* mimetype{};  // stands first; null: none
    std::string comment{};
};

/// The files of a directory as a zip file, on the disk when this returns.
Outcome<Done> writeZip(const fs::path& directory, const fs::path& target, const fs::path& shown, const ZipHead& head,
                       const Progress& progress) {
    QFile file;
    if (!openNew(file, target)) return cannotWrite(shown, lastFault());
    QuaZip zip(&file);
    zip.setAutoClose(false);
    zip.setUtf8Enabled(true);
    zip.setDataDescriptorWritingEnabled(false);  // sizes stand before the data, so the type is at a fixed place
    bool isWritten = zip.open(QuaZip::mdCreate);
    if (!head.comment.empty()) zip.setComment(QString::fromStdString(head.comment));
    if (isWritten && head.mimetype) {
        QByteArray type(head.mimetype);
        QBuffer buffer(&type);
        isWritten = buffer.open(QIODevice::ReadOnly) && putEntry(zip, "mimetype", buffer, true, progress);
    }
    for (const std::string& name : filesBelow(directory)) {
        if (!isWritten) break;
        QFile from;
        isWritten = openForReading(from, directory / name) &&
                    // digits of doubles: nothing to compress
                    putEntry(zip, name, from, name.ends_with(traceEnding), progress) && from.error() == QFile::NoError;
    }
    zip.close();
    if (progress.stopRequested()) return fileError(phrase("interrupted"), shown.string());
    isWritten = isWritten && zip.getZipError() == ZIP_OK && file.flush() && fsync(file.handle()) == 0;
    return isWritten ? Outcome<Done>(Done{}) : Outcome<Done>(cannotWrite(shown, reasonOf(file)));
}

Outcome<Done> zipWhole(const fs::path& directory, const fs::path& path, const ZipHead& head, const Progress& progress) {
    return writeWhole(path, [&](const fs::path& beside) { return writeZip(directory, beside, path, head, progress); });
}

Outcome<Done> saveArchive(const Study& study, const fs::path& path, const std::vector<PastRun>& history,
                          const std::string& comment = {}, const Progress& progress = {}) {
    Outcome<std::shared_ptr<const TemporaryDirectory>> files = TemporaryDirectory::make();
    if (!files) return files.diagnostics();
    const fs::path directory = (*files)->path() / "study";
    const Outcome<Done> written = writeStudy(study, directory, OutsideLibraries::Included);
    if (!written) return written;
    if (!history.empty())
        if (Outcome<Done> done = writeHistory(history, directory / historyFolder); !done) return done;
    if (Outcome<Done> zipped = zipWhole(directory, path, {archiveType, comment}, progress); !zipped) return zipped;
    return written;
}

}  // namespace

Diagnostics namedAs(Diagnostics diagnostics, const OpenedStudy& opened) {
    if (!opened.files) return diagnostics;
    return renamed(std::move(diagnostics), opened.files->path().string(), opened.origin.string());
}

bool isArchive(const fs::path& path) {
    std::error_code code;
    if (fs::is_directory(path, code)) return false;
    return path.extension() == archiveEnding || path.extension() == ".zip";
}

Outcome<OpenedStudy> openStudy(const fs::path& path, UnreadMeasurement unread) {
    std::error_code code;
    if (isArchive(path) && fs::exists(path, code)) return openArchive(path, unread);
    Outcome<Study> study = readStudy(path, unread);
    if (!study) return study.diagnostics();
    Diagnostics messages = study.diagnostics();
    std::vector<PastRun> history = historyIn(study->directory, *study, messages);
    return {OpenedStudy{std::move(*study), nullptr, path, std::move(history)}, std::move(messages)};
}

Outcome<Done> saveStudy(const Study& study, const fs::path& path, const std::vector<PastRun>& history) {
    if (path.extension() == archiveEnding) return saveArchive(study, path, history);
    const Outcome<Done> written = writeStudy(study, path);
    if (!written) return written;
    if (Outcome<Done> done = replaceHistory(history, path); !done) return done;
    return written;
}

Outcome<Done> zipDirectory(const fs::path& directory, const fs::path& file, const Progress& progress) {
    return zipWhole(directory, file, {}, progress);
}

Outcome<Done> checkNewPlace(const fs::path& path) {
    std::error_code code;
    if (!fs::exists(fs::symlink_status(path, code))) return Done{};
    if (fs::is_directory(path, code) && fs::is_empty(path, code)) return Done{};
    const bool isFile = !fs::is_directory(path, code);
    return fileError(isFile ? phrase("this exists already") : phrase("this exists already and is not empty"),
                     path.string(), 0, 0, isFile ? phrase("Give another name.") : phrase("Name a new directory."));
}

namespace {

/// Whether a study may be packed there.
Outcome<Done> checkPackPlace(const OpenedStudy& opened, const fs::path& archive) {
    std::error_code code;
    if (!fs::exists(fs::symlink_status(archive, code))) return Done{};
    if (Outcome<Done> isFile = checkRegularFile(archive); !isFile) return isFile;
    if (fs::file_size(archive, code) == 0 && !code) return Done{};
    if (zipComment(archive) == packComment(opened)) return Done{};
    const bool isStudy = beginningOfEntry(archive, "mimetype", 100) == archiveType;
    return fileError(isStudy ? phrase("this exists already and is another study, or was saved since it was packed")
                             : phrase("this exists already and is no study"),
                     archive.string(), 0, 0, phrase("Give another name, or remove it first."));
}

}  // namespace

Outcome<Done> packStudy(const OpenedStudy& opened, const fs::path& archive, const Progress& progress) {
    if (Outcome<Done> isFree = checkPackPlace(opened, archive); !isFree) return isFree;
    return saveArchive(opened.study, archive, opened.history, packComment(opened), progress);
}

Outcome<Done> unpackArchive(const fs::path& archive, const fs::path& directory, const Progress& progress) {
    std::error_code code;
    fs::path target = fs::absolute(directory, code).lexically_normal();
    if (!target.has_filename()) target = target.parent_path();
    if (Outcome<Done> isNew = checkNewPlace(target); !isNew) return isNew;
    fs::path place = target.parent_path();
    while (!fs::exists(place, code) && place != place.parent_path()) place = place.parent_path();
    const Outcome<OwnedDirectory> own = OwnedDirectory::make(place, writingPrefix);
    if (!own) return cannotWrite(target, own.diagnostics().front().message);
    const fs::path beside = own->path() / "new";
    code.clear();
    if (!fs::create_directory(beside, code)) return cannotWrite(target, code);
    Outcome<Done> done = unpackInto({archive, beside, place}, progress);
    if (!done) return done;
    fs::create_directories(target.parent_path(), code);
    if (!code) fs::rename(beside, target, code);
    if (code) return cannotWrite(target, code);
    syncToDisk(target.parent_path());
    return done;
}

}  // namespace analogon
