#pragma once

#include <chrono>
#include <filesystem>

#include "core/base/file_handle.hpp"

namespace analogon {

/// The lock of a directory (flock): many may read, or one may write. Nothing is written for it, and it ends with the
/// process that holds it.
class DirectoryLock {
public:
    enum class Kind { Shared, Exclusive };

    DirectoryLock() = default;
    /// Waits for those who hold it, at most so long. Where the directory cannot be opened, or its file system knows no
    /// locks, there is nobody to wait for.
    DirectoryLock(const std::filesystem::path& directory, Kind kind, std::chrono::milliseconds wait);

    /// Somebody else held it all the time.
    bool isBusy() const { return isBusy_; }

private:
    FileHandle directory_;
    bool isBusy_{};
};

}  // namespace analogon
