#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/file_handle.hpp"
#include "core/base/outcome.hpp"

namespace analogon {

/// A directory that the program makes for its own use and removes again. It is known by what it holds, never by its
/// name: a marker file whose lock (flock) is held as long as its maker lives, in whatever container that runs. Locks
/// end with the process, so what a killed one has left behind is told from what is in use. The marker names the
/// directory that it was made for: a copy, which holds it too, belongs to whoever made the copy.
class OwnedDirectory {
public:
    enum class Left { Removed, Kept };
    /// A new directory `place`/`prefix`XXXXXX that nobody else can read. What dead processes of this user have left
    /// there is removed first, unless it is to be kept. The fault is the reason alone.
    static Outcome<OwnedDirectory> make(const std::filesystem::path& place, const std::string& prefix,
                                        Left left = Left::Removed);
    /// One that a dead process of this user has left behind; empty: there is none of that kind at this path.
    static std::optional<OwnedDirectory> adopt(const std::filesystem::path& path);

    ~OwnedDirectory();
    OwnedDirectory(OwnedDirectory&& other) noexcept;
    OwnedDirectory& operator=(OwnedDirectory&& other) noexcept;

    const std::filesystem::path& path() const { return path_; }
    /// Leaves it where it is, for a later process to adopt.
    void release();

private:
    OwnedDirectory(std::filesystem::path path, FileHandle lock) : path_(std::move(path)), lock_(std::move(lock)) {}
    void remove();

    std::filesystem::path path_;  // empty: none
    FileHandle lock_;
};

/// Removes what dead processes of this user have left in a directory: of the entries whose names begin with `prefix`
/// those that are owned directories which nobody holds.
void removeAbandoned(const std::filesystem::path& place, const std::string& prefix);

}  // namespace analogon
