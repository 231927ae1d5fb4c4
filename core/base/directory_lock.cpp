#include "core/base/directory_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <thread>

namespace analogon {

namespace {

/// Whether the path still leads to the directory that was opened: it may have been exchanged for another meanwhile.
bool isStill(const std::filesystem::path& path, int directory) {
    struct stat held {
    }, there{};
    return fstat(directory, &held) == 0 && stat(path.c_str(), &there) == 0 && held.st_ino == there.st_ino &&
           held.st_dev == there.st_dev;
}

}  // namespace

DirectoryLock::DirectoryLock(const std::filesystem::path& directory, Kind kind, std::chrono::milliseconds wait) {
    const auto end = std::chrono::steady_clock::now() + wait;
    const int how = (kind == Kind::Shared ? LOCK_SH : LOCK_EX) | LOCK_NB;
    for (;;) {
        directory_ = FileHandle(open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        if (!directory_.isOpen()) return;
        const bool isHeld = flock(directory_.number(), how) == 0;
        if (isHeld && isStill(directory, directory_.number())) return;
        if (!isHeld && errno != EWOULDBLOCK && errno != EINTR) return;
        isBusy_ = !isHeld && std::chrono::steady_clock::now() >= end;
        if (isBusy_) return;
        if (!isHeld) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

}  // namespace analogon
