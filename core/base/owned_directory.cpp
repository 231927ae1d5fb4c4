#include "core/base/owned_directory.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string_view>
#include <utility>

#include "core/base/file_handle.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

constexpr const char* marker = ".analogon-owned";
constexpr std::string_view markerHead = "analogon-directory-2\nMade by Analogon for its own use, and removed by it.\n";
constexpr std::size_t longestMarker = 512;  // [byte]
/// An unusual mode, set as the directory is made: it tells one whose maker was killed before it could mark it.
constexpr mode_t ownMode = S_ISVTX | S_IRWXU;

std::string randomEnding() {
    static constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
    std::random_device random;
    std::string ending;
    for (int i = 0; i < 6; ++i) ending += letters[random() % letters.size()];
    return ending;
}

/// What a copy of a directory does not have: its number (inode) together with the moment it was made at, which nobody
/// can set; where the file system does not keep that, together with the device. The device of a disk may be another one
/// after the machine was started again.
std::string identityOf(int directory) {
    struct statx whole {};
    if (statx(directory, "", AT_EMPTY_PATH, STATX_INO | STATX_BTIME, &whole) == 0 && (whole.stx_mask & STATX_BTIME))
        return fmt::format("{} made at {}.{:09}", whole.stx_ino, whole.stx_btime.tv_sec, whole.stx_btime.tv_nsec);
    struct stat status {};
    if (fstat(directory, &status) != 0) return {};
    return fmt::format("{} on {}", status.st_ino, status.st_dev);
}

std::string markerTextOf(int directory) { return fmt::format("{}directory {}\n", markerHead, identityOf(directory)); }

bool isOwnDirectory(const struct stat& status) { return S_ISDIR(status.st_mode) && status.st_uid == geteuid(); }

/// A directory inherits the set-group bit of the one around it.
bool hasOwnMode(const struct stat& status) { return (status.st_mode & 07777 & ~S_ISGID) == ownMode; }

/// Whether nothing but an unwritten marker is inside: its maker was killed as it began.
bool holdsNothing(int directory) {
    const int copy = openat(directory, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR* const list = copy < 0 ? nullptr : fdopendir(copy);
    if (!list) {
        if (copy >= 0) close(copy);
        return false;
    }
    bool isEmpty = true;
    while (const dirent* entry = readdir(list)) {
        const std::string_view name = entry->d_name;
        if (name != "." && name != ".." && name != marker) isEmpty = false;
    }
    closedir(list);
    return isEmpty;
}

/// Whether an open marker is still the one in its directory.
bool isInPlace(int directory, int file) {
    struct stat held {
    }, there{};
    return fstat(file, &held) == 0 && fstatat(directory, marker, &there, AT_SYMLINK_NOFOLLOW) == 0 &&
           held.st_ino == there.st_ino && held.st_dev == there.st_dev;
}

/// Marks a directory and holds its lock; -1: it is gone, or a cleaner was faster. The marker is written after its lock
/// is held, so that one with its text and without a lock belongs to the dead.
int mark(const fs::path& path) {
    const FileHandle directory(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (!directory.isOpen()) return -1;
    FileHandle file(openat(directory.number(), marker, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
    if (!file.isOpen() || (flock(file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)) return -1;
    if (!isInPlace(directory.number(), file.number())) return -1;
    const std::string text = markerTextOf(directory.number());
    const ssize_t written = write(file.number(), text.data(), text.size());
    if (written == static_cast<ssize_t>(text.size())) return file.release();
    const int fault = written < 0 ? errno : ENOSPC;
    unlinkat(directory.number(), marker, 0);
    errno = fault;
    return -1;
}

Diagnostic noneIn(const fs::path& place, int fault) {
    return fileError(std::error_code(fault, std::generic_category()).message(), place.string());
}

}  // namespace

Outcome<OwnedDirectory> OwnedDirectory::make(const fs::path& place, const std::string& prefix, Left left) {
    if (left == Left::Removed) removeAbandoned(place, prefix);
    for (int i = 0; i < 100; ++i) {
        const fs::path path = place / (prefix + randomEnding());
        if (mkdir(path.c_str(), ownMode) != 0) {
            if (errno == EEXIST) continue;
            return noneIn(place, errno);
        }
        errno = 0;
        if (const int lock = mark(path); lock >= 0) return OwnedDirectory(path, FileHandle(lock));
        const int fault = errno;
        rmdir(path.c_str());
        if (fault == ENOENT || fault == EEXIST || fault == EWOULDBLOCK || fault == 0) continue;  // a cleaner was faster
        return noneIn(place, fault);
    }
    return noneIn(place, EEXIST);
}

std::optional<OwnedDirectory> OwnedDirectory::adopt(const fs::path& path) {
    const FileHandle directory(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    struct stat status {};
    if (!directory.isOpen() || fstat(directory.number(), &status) != 0 || !isOwnDirectory(status)) return std::nullopt;
    FileHandle file(openat(directory.number(), marker, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (!file.isOpen()) {
        if (errno == ENOENT && hasOwnMode(status)) rmdir(path.c_str());  // fails unless it is empty
        return std::nullopt;
    }
    struct stat marked {};
    if (fstat(file.number(), &marked) != 0 || !S_ISREG(marked.st_mode) || marked.st_uid != geteuid())
        return std::nullopt;
    if (flock(file.number(), LOCK_EX | LOCK_NB) != 0 || !isInPlace(directory.number(), file.number()))
        return std::nullopt;
    std::string text(longestMarker, '\0');
    const ssize_t count = pread(file.number(), text.data(), text.size(), 0);
    text.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
    const std::string expected = markerTextOf(directory.number());
    const bool wasJustBegun = expected.starts_with(text) && hasOwnMode(status) && holdsNothing(directory.number());
    if (text != expected && !wasJustBegun) return std::nullopt;
    return OwnedDirectory(path, std::move(file));
}

OwnedDirectory::~OwnedDirectory() { remove(); }

OwnedDirectory::OwnedDirectory(OwnedDirectory&& other) noexcept
    : path_(std::exchange(other.path_, {})), lock_(std::move(other.lock_)) {}

OwnedDirectory& OwnedDirectory::operator=(OwnedDirectory&& other) noexcept {
    if (this == &other) return *this;
    remove();
    path_ = std::exchange(other.path_, {});
    lock_ = std::move(other.lock_);
    return *this;
}

void OwnedDirectory::release() {
    path_.clear();
    lock_.reset();
}

/// The marker goes last: should the program be ended meanwhile, the rest is still known. What somebody has put at this
/// path meanwhile, in the place of ours, stays.
void OwnedDirectory::remove() {
    if (path_.empty()) return;
    const FileHandle directory(open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (!directory.isOpen() || !isInPlace(directory.number(), lock_.number())) return release();
    std::error_code code;
    for (fs::directory_iterator entry(path_, code), end; !code && entry != end; entry.increment(code)) {
        std::error_code lost;
        if (entry->path().filename() != marker) fs::remove_all(entry->path(), lost);
    }
    if (fs::remove(path_ / marker, code)) rmdir(path_.c_str());
    release();
}

void removeAbandoned(const fs::path& place, const std::string& prefix) {
    std::error_code code;
    std::vector<fs::path> candidates;
    for (fs::directory_iterator entry(place, fs::directory_options::skip_permission_denied, code), end;
         !code && entry != end; entry.increment(code))
        if (entry->path().filename().string().starts_with(prefix)) candidates.push_back(entry->path());
    for (const fs::path& path : candidates) (void)OwnedDirectory::adopt(path);
}

}  // namespace analogon
