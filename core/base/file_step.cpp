#include "core/base/file_step.hpp"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>

#include "core/base/file_handle.hpp"

namespace analogon {

namespace fs = std::filesystem;

namespace {

std::error_code renamed(const fs::path& from, const fs::path& to, unsigned how) {
    if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), how) == 0) return {};
    return {errno, std::generic_category()};
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

bool isPlainFile(const fs::path& path) {
    std::error_code code;
    return fs::is_regular_file(fs::symlink_status(path, code));
}

bool isPlainDirectory(const fs::path& path) {
    std::error_code code;
    return fs::is_directory(fs::symlink_status(path, code));
}

}  // namespace analogon
