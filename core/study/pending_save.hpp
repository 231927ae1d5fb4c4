#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <system_error>

#include "core/base/diagnostic.hpp"

/// A save into a directory that exists cannot be one step of the file system. Its files are written into a folder
/// within the directory first; the renaming of that folder to ".analogon-saved-…" is the moment the save holds. Until
/// its files are at their places, whoever reads the study reads them in the folder and writes nothing; whoever writes
/// the study moves them first.
namespace analogon {

class PendingSave {
public:
    /// The files of a save that was done in a directory, as far as they are not at their places. A folder is that of a
    /// save by the list inside it; links are none, whatever their names.
    static PendingSave in(const std::filesystem::path& directory);

    /// Where a file of the study lies now.
    std::filesystem::path place(const std::filesystem::path& name) const;
    bool removes(const std::string& model) const { return removed_.contains(model); }
    /// The names of files that are not at their places.
    const std::set<std::string>& files() const { return files_; }

    /// Moves the files to their places and the empty folder into `spent`, a directory of the caller's own.
    std::error_code finish(const std::filesystem::path& spent) const;

private:
    std::filesystem::path directory_, folder_;  // no folder: nothing is pending
    std::set<std::string> files_, removed_;
};

/// Makes the files below `written` the pending save of a directory: `files`, and the models that are no more.
/// `written` must lie in the same file system. What is there when this returns is safe on the disk.
std::error_code commitSave(const std::filesystem::path& written, const std::filesystem::path& directory,
                           const std::set<std::string>& files, const std::set<std::string>& removed);

/// How long to wait for another program that saves the same study, and what to say when that was not enough.
constexpr std::chrono::seconds longestSave{10};
Diagnostic isBeingSaved(const std::filesystem::path& study);

/// Whether a path leads out of the directory that it is relative to.
bool leavesDirectory(const std::filesystem::path& path);
/// Whether a name leads through a link below a directory, or out of it: nothing is written there.
bool leadsAway(const std::filesystem::path& directory, const std::filesystem::path& name);

}  // namespace analogon
