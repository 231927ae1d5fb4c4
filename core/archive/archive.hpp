#pragma once

#include <filesystem>
#include <memory>

#include "core/archive/temporary_directory.hpp"
#include "core/base/progress.hpp"
#include "core/study/run_history.hpp"
#include "core/study/study.hpp"

/// A study as one `.analogon` file: a zip archive with the entry `mimetype` first (stored, so that its text stands at
/// a fixed place of the file), then what a study directory holds. The history of its runs lies in a folder of its own,
/// which readers that do not know it pass over.
namespace analogon {

inline constexpr const char* archiveEnding = ".analogon";
inline constexpr const char* archiveType = "application/vnd.analogon.study+zip";

/// A study with the place its files lie in while it is in use.
struct OpenedStudy {
    Study study;
    std::shared_ptr<const TemporaryDirectory> files;  // null: a study that lies in a directory of its own
    std::filesystem::path origin;                     // what was opened
    std::vector<PastRun> history{};                   // its runs, oldest first
};

/// Messages in which files of an unpacked archive are called by their place in it, "lambda.analogon/model.mo".
Diagnostics namedAs(Diagnostics diagnostics, const OpenedStudy& opened);

/// Whether a path names an archive rather than a directory or a study.json.
bool isArchive(const std::filesystem::path& path);

/// Reads a study directory, its study.json or an archive. Messages about an archive name its entries as
/// "lambda.analogon/model.mo". Faults: see readZipDirectory and readStudy; an entry that is damaged or larger than it
/// says, one of ArchiveLimits, a measurement or a library outside of the archive. A history that is damaged is lost,
/// with a warning; the study is not.
/// Throws Stopped (core/base/stop) where that was asked for meanwhile.
Outcome<OpenedStudy> openStudy(const std::filesystem::path& path,
                               UnreadMeasurement unread = UnreadMeasurement::Refused);

/// Writes a study and its history into an archive (ending .analogon) or a directory. Whatever happens in between, the
/// archive is the old one or the new one, whole; so is the study of a directory, and its history follows. Notes: see
/// writeStudy.
Outcome<Done> saveStudy(const Study& study, const std::filesystem::path& path,
                        const std::vector<PastRun>& history = {});

/// Writes an opened study into an archive that is new, or was packed from the same study before and not saved since:
/// its comment tells. Anything else that is there stays. Atomic as saveStudy; all or nothing also where it is stopped.
Outcome<Done> packStudy(const OpenedStudy& opened, const std::filesystem::path& archive, const Progress& progress = {});

/// The files below a directory as a plain zip file, for formats of other tools. Atomic as saveStudy.
Outcome<Done> zipDirectory(const std::filesystem::path& directory, const std::filesystem::path& file,
                           const Progress& progress = {});

/// Whether something new can be written there: nothing has that name, or it is an empty directory.
Outcome<Done> checkNewPlace(const std::filesystem::path& path);

/// The files of an archive, byte for byte, in a directory that does not exist yet or is empty. All or nothing, also
/// where it is stopped.
Outcome<Done> unpackArchive(const std::filesystem::path& archive, const std::filesystem::path& directory,
                            const Progress& progress = {});

}  // namespace analogon
