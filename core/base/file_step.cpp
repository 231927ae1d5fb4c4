#include "core/base/file_step.hpp"

#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <vector>

#include "core/base/file_handle.hpp"

namespace analogon {

namespace fs = std::filesystem;

std::error_code lastFault() { return {errno, std::generic_category()}; }

namespace {

std::error_code renamed(const fs::path& from, const fs::path& to, unsigned how) {
    if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), how) == 0) return {};
    return lastFault();
}

}  // namespace

void syncToDisk(const fs::path& path) {
    const FileHandle file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.isOpen()) fsync(file.number());
}

std::error_code exchange(const fs::path& a, const fs::path& b) { return renamed(a, b, RENAME_EXCHANGE); }

std::error_code renameToNew(const fs::path& from, const fs::path& to) {
    std::error_code code = renamed(from, to, RENAME_NOREPLACE);
    if (code != std::errc::invalid_argument && code != std::errc::function_not_supported) return code;
    std::error_code ignored;  // a file system without it: a look, and a rename
    if (fs::exists(fs::symlink_status(to, ignored))) return std::make_error_code(std::errc::file_exists);
    code.clear();
    fs::rename(from, to, code);
    return code;
}

std::error_code copyToNew(const fs::path& from, const fs::path& to) {
    const FileHandle source(open(from.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));  // a pipe is not waited for
    struct stat status {};
    if (!source.isOpen() || fstat(source.number(), &status) != 0) return lastFault();
    if (!S_ISREG(status.st_mode)) return std::make_error_code(std::errc::not_supported);
    FileHandle target(open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, status.st_mode & 0777));
    if (!target.isOpen()) return lastFault();
    std::vector<char> bytes(1u << 20);
    for (ssize_t count = 0; (count = read(source.number(), bytes.data(), bytes.size())) != 0;) {
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return lastFault();
        for (ssize_t done = 0, now = 0; done < count; done += std::max<ssize_t>(now, 0)) {
            now = write(target.number(), bytes.data() + done, static_cast<std::size_t>(count - done));
            if (now < 0 && errno != EINTR) return lastFault();
        }
    }
    return close(target.release()) == 0 ? std::error_code() : lastFault();  // some file systems say so only now
}

bool isPlainFile(const fs::path& path) {
    std::error_code code;
    return fs::is_regular_file(fs::symlink_status(path, code));
}

bool isPlainDirectory(const fs::path& path) {
    std::error_code code;
    return fs::is_directory(fs::symlink_status(path, code));
}

}  // namespace analogon
