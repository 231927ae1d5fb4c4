#include "core/archive/archive.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <quazip/quazip.h>
#include <quazip/quazipfile.h>
#include <quazip/quazipnewinfo.h>
#include <unistd.h>

#include <QBuffer>
#include <QFile>
#include <algorithm>
#include <cerrno>
#include <fstream>

#include "core/archive/archive_limits.hpp"
#include "core/archive/zip_directory.hpp"
#include "core/base/file_fault.hpp"
#include "core/base/file_step.hpp"
#include "core/base/owned_directory.hpp"
#include "core/base/regular_file.hpp"
#include "core/base/stop.hpp"
#include "core/base/visible.hpp"
#include "core/base/whole_file.hpp"
#include "core/study/json_places.hpp"
#include "core/study/pending_save.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

constexpr qint64 chunk = 1 << 20;  // [byte]

/// Opened by its bytes: a name that is no UTF-8 is no QString.
bool openFile(QFile& file, const fs::path& path, int flags, QIODevice::OpenMode mode) {
    const int handle = open(path.c_str(), flags | O_CLOEXEC, 0666);
    return handle >= 0 && file.open(handle, mode, QFileDevice::AutoCloseHandle);
}

bool openForReading(QFile& file, const fs::path& path) {
    return openFile(file, path, O_RDONLY | O_NONBLOCK, QIODevice::ReadOnly);
}

bool openNew(QFile& file, const fs::path& path) {
    return openFile(file, path, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW, QIODevice::ReadWrite);
}

std::error_code lastFault() { return {errno, std::generic_category()}; }

Diagnostic damaged(const fs::path& archive, const std::string& entry, const char* what) {
    return fileError(phrase("the entry \"{}\" {}", visibleName(entry), Text(what, {}, what)), archive.string(), 0, 0,
                     phrase("Get the file again from where it came from."));
}

/// Why a file is not written. One that took a part only has no fault of the system: the text of any file then.
Text reasonOf(const QFile& file) {
    const QString reason = file.errorString();
    return reason == QFile().errorString() ? phrase("the disk may be full") : Text(reason.toStdString());
}

/// Unpacks one entry; never more than the archive said it holds.
Outcome<Done> unpackEntry(QuaZip& zip, const fs::path& archive, const ZipEntry& entry, const fs::path& target,
                          const Progress& progress) {
    if (!zip.setCurrentFile(QString::fromStdString(entry.name), QuaZip::csSensitive))
        return damaged(archive, entry.name, "cannot be found");
    QuaZipFile from(&zip);
    if (!from.open(QIODevice::ReadOnly)) return damaged(archive, entry.name, "cannot be read: its header is damaged");
    std::error_code code;
    fs::create_directories(target.parent_path(), code);
    QFile to;
    if (code) return cannotWrite(target, code);
    if (!openNew(to, target)) return cannotWrite(target, lastFault());
    std::uint64_t left = entry.size;
    QByteArray bytes(chunk, Qt::Uninitialized);
    for (;;) {
        if (progress.stopRequested() || isStopped()) return fileError(phrase("interrupted"), archive.string());
        const qint64 count = from.read(bytes.data(), chunk);
        if (count < 0) return damaged(archive, entry.name, "is damaged: its compressed data cannot be read");
        if (count == 0) break;
        if (static_cast<std::uint64_t>(count) > left)
            return damaged(archive, entry.name, "is larger than the archive says");
        left -= static_cast<std::uint64_t>(count);
        if (to.write(bytes.constData(), count) != count) return cannotWrite(target, reasonOf(to));
    }
    if (left > 0) return damaged(archive, entry.name, "is shorter than the archive says");
    from.close();  // compares the checksum
    if (from.getZipError() != UNZ_OK) return damaged(archive, entry.name, "is damaged: its checksum does not fit");
    to.close();
    return to.error() == QFile::NoError ? Outcome<Done>(Done{}) : Outcome<Done>(cannotWrite(target, reasonOf(to)));
}

/// All entries below a directory; returns the warnings.
Outcome<Done> unpackInto(const fs::path& archive, const fs::path& directory, const Progress& progress = {}) {
    const Outcome<std::vector<ZipEntry>> entries = readZipDirectory(archive);
    if (!entries) return entries.diagnostics();
    if (Outcome<Done> isBounded = checkLimits(archive, *entries); !isBounded) return isBounded;
    QFile file;
    QuaZip zip(&file);
    if (!openForReading(file, archive) || !zip.open(QuaZip::mdUnzip))
        return fileError(phrase("this is no zip archive"), archive.string());
    Diagnostics warnings = entries.diagnostics();
    for (const ZipEntry& entry : *entries) {
        Outcome<Done> done = unpackEntry(zip, archive, entry, directory / entry.name, progress);
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

/// An archive reads itself alone: a measurement from elsewhere would be a file of whoever opens it.
Outcome<Done> checkReach(const fs::path& directory, const fs::path& archive) {
    const fs::path place = directory / "study.json";
    Outcome<std::string> text = readRegularFile(place);
    if (!text) return Done{};  // told when it is read
    const auto json = std::make_shared<const Source>((archive / "study.json").string(), std::move(*text));
    const Outcome<Study> study = parseStudyJson(json);
    if (!study) return Done{};
    Diagnostics faults;
    for (std::size_t i = 0; i < study->experiments.size(); ++i) {
        const StudyExperiment& e = study->experiments[i];
        if (!leavesDirectory(e.file)) continue;
        faults.push_back(error(phrase("experiment '{}': the file '{}' is not in the archive", e.name, e.file),
                               JsonPlaces(json).value(fmt::format("/experiments/{}/file", i)),
                               phrase("An archive reads itself alone: put the measurement into it.")));
    }
    return faults.empty() ? Outcome<Done>(Done{}) : Outcome<Done>(faults);
}

Outcome<OpenedStudy> openArchive(const fs::path& archive) {
    Outcome<std::shared_ptr<const TemporaryDirectory>> files = TemporaryDirectory::make();
    if (!files) return files.diagnostics();
    const fs::path directory = (*files)->path();
    const Outcome<Done> unpacked = unpackInto(archive, directory);
    if (!unpacked) return unpacked.diagnostics();
    if (const Outcome<Done> isWithin = checkReach(directory, archive); !isWithin) return isWithin.diagnostics();
    Outcome<Study> study = readStudy(directory);
    Diagnostics messages = renamed(study.diagnostics(), directory.string(), archive.string());
    if (!study) return messages;
    messages.insert(messages.begin(), unpacked.diagnostics().begin(), unpacked.diagnostics().end());
    study->name = archive.stem().string();
    if (study->json)
        study->json = std::make_shared<const Source>((archive / "study.json").string(), study->json->text());
    for (auto& [name, table] : study->tables) {
        auto shown = std::make_shared<Table>(*table);
        shown->file = (archive / name).string();
        table = std::move(shown);
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

bool putEntry(QuaZip& zip, const std::string& name, QIODevice& from, bool isStored) {
    QuaZipNewInfo info(QString::fromStdString(name));
    info.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup | QFile::ReadOther);
    QuaZipFile to(&zip);
    const bool isOpen =
        isStored ? to.open(QIODevice::WriteOnly, info, nullptr, 0, 0, 0) : to.open(QIODevice::WriteOnly, info);
    if (!isOpen) return false;
    QByteArray bytes;
    while (!(bytes = from.read(chunk)).isEmpty())
        if (to.write(bytes) != bytes.size()) return false;
    to.close();
    return to.getZipError() == ZIP_OK;
}

/// The files of a directory as a zip file, on the disk when this returns; the type (null: none) stands first.
Outcome<Done> writeZip(const fs::path& directory, const fs::path& target, const fs::path& shown, const char* mimetype) {
    QFile file;
    if (!openNew(file, target)) return cannotWrite(shown, lastFault());
    QuaZip zip(&file);
    zip.setAutoClose(false);
    zip.setUtf8Enabled(true);
    zip.setDataDescriptorWritingEnabled(false);  // sizes stand before the data, so the type is at a fixed place
    bool isWritten = zip.open(QuaZip::mdCreate);
    if (isWritten && mimetype) {
        QByteArray type(mimetype);
        QBuffer buffer(&type);
        isWritten = buffer.open(QIODevice::ReadOnly) && putEntry(zip, "mimetype", buffer, true);
    }
    for (const std::string& name : filesBelow(directory)) {
        if (!isWritten) break;
        QFile from;
        isWritten = openForReading(from, directory / name) &&
                    putEntry(zip, name, from, name.ends_with(traceEnding)) &&  // digits of doubles: nothing to compress
                    from.error() == QFile::NoError;
    }
    zip.close();
    isWritten = isWritten && zip.getZipError() == ZIP_OK && file.flush() && fsync(file.handle()) == 0;
    return isWritten ? Outcome<Done>(Done{}) : Outcome<Done>(cannotWrite(shown, reasonOf(file)));
}

Outcome<Done> zipWhole(const fs::path& directory, const fs::path& path, const char* mimetype) {
    return writeWhole(path, [&](const fs::path& beside) { return writeZip(directory, beside, path, mimetype); });
}

Outcome<Done> saveArchive(const Study& study, const fs::path& path, const std::vector<PastRun>& history) {
    Outcome<std::shared_ptr<const TemporaryDirectory>> files = TemporaryDirectory::make();
    if (!files) return files.diagnostics();
    const fs::path directory = (*files)->path() / "study";
    if (Outcome<Done> done = writeStudy(study, directory); !done) return done;
    if (!history.empty())
        if (Outcome<Done> done = writeHistory(history, directory / historyFolder); !done) return done;
    return zipWhole(directory, path, archiveType);
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

Outcome<OpenedStudy> openStudy(const fs::path& path) {
    std::error_code code;
    if (isArchive(path) && fs::exists(path, code)) return openArchive(path);
    Outcome<Study> study = readStudy(path);
    if (!study) return study.diagnostics();
    Diagnostics messages = study.diagnostics();
    std::vector<PastRun> history = historyIn(study->directory, *study, messages);
    return {OpenedStudy{std::move(*study), nullptr, path, std::move(history)}, std::move(messages)};
}

Outcome<Done> saveStudy(const Study& study, const fs::path& path, const std::vector<PastRun>& history) {
    if (path.extension() == archiveEnding) return saveArchive(study, path, history);
    if (Outcome<Done> done = writeStudy(study, path); !done) return done;
    return replaceHistory(history, path);
}

Outcome<Done> zipDirectory(const fs::path& directory, const fs::path& file) {
    return zipWhole(directory, file, nullptr);
}

Outcome<Done> checkNewPlace(const fs::path& path) {
    std::error_code code;
    if (!fs::exists(fs::symlink_status(path, code))) return Done{};
    if (fs::is_directory(path, code) && fs::is_empty(path, code)) return Done{};
    const bool isFile = !fs::is_directory(path, code);
    return fileError(isFile ? phrase("this exists already") : phrase("this exists already and is not empty"),
                     path.string(), 0, 0, isFile ? phrase("Give another name.") : phrase("Name a new directory."));
}

Outcome<Done> checkArchivePlace(const fs::path& path) {
    std::error_code code;
    if (!fs::exists(fs::symlink_status(path, code))) return Done{};
    std::string begin;
    if (checkRegularFile(path)) {
        std::ifstream stream(path, std::ios::binary);
        begin.resize(38 + std::string(archiveType).size());
        stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    }
    if (begin.starts_with("PK") && begin.ends_with(archiveType)) return Done{};
    return fileError(phrase("this exists already and is no study"), path.string(), 0, 0, phrase("Give another name."));
}

Outcome<Done> unpackArchive(const fs::path& archive, const fs::path& directory, const Progress& progress) {
    std::error_code code;
    fs::path target = fs::absolute(directory, code).lexically_normal();
    if (!target.has_filename()) target = target.parent_path();
    if (Outcome<Done> isNew = checkNewPlace(target); !isNew) return isNew;
    fs::path place = target.parent_path();
    while (!fs::exists(place, code) && place != place.parent_path()) place = place.parent_path();
    const Outcome<OwnedDirectory> own = OwnedDirectory::make(place, ".analogon-writing-");
    if (!own) return cannotWrite(target, own.diagnostics().front().message);
    const fs::path beside = own->path() / "new";
    code.clear();
    if (!fs::create_directory(beside, code)) return cannotWrite(target, code);
    Outcome<Done> done = unpackInto(archive, beside, progress);
    if (!done) return renamed(done.diagnostics(), beside.string(), target.string());
    fs::create_directories(target.parent_path(), code);
    if (!code) fs::rename(beside, target, code);
    if (code) return cannotWrite(target, code);
    syncToDisk(target.parent_path());
    return done;
}

}  // namespace analogon
