#include "core/base/regular_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>

namespace analogon {

namespace {

namespace fs = std::filesystem;

Diagnostic cannotOpen(const fs::path& file) {
    return fileError(phrase("the file cannot be opened"), file.string(), 0, 0,
                     phrase("Check its name and its access rights."));
}

/// Without waiting for whoever may be at the other end of a pipe.
Outcome<FileHandle> openRegular(const fs::path& file, struct stat& status) {
    FileHandle handle(open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    if (!handle.isOpen() || fstat(handle.number(), &status) != 0) return cannotOpen(file);
    if (S_ISDIR(status.st_mode)) return fileError(phrase("this is a directory, not a file"), file.string());
    if (!S_ISREG(status.st_mode))
        return fileError(phrase("this is a pipe or a device, not a file"), file.string(), 0, 0,
                         phrase("Copy what it gives into a file."));
    return handle;
}

}  // namespace

Outcome<std::string> readRegularFile(const fs::path& file, std::uint64_t largest) {
    struct stat status {};
    const Outcome<FileHandle> handle = openRegular(file, status);
    if (!handle) return handle.diagnostics();
    const auto tooLarge = [&] {
        return fileError(phrase("the file has more than {} MB", largest >> 20), file.string());
    };
    if (static_cast<std::uint64_t>(status.st_size) > largest) return tooLarge();
    // one more than there should be: its end is seen without making room for more
    std::string bytes(static_cast<std::size_t>(status.st_size) + 1, '\0');
    std::size_t count = 0;
    for (;;) {
        if (count == bytes.size()) {  // at its end, unless it grows
            if (bytes.size() > largest) return tooLarge();
            bytes.resize(bytes.size() + 4096);
        }
        const ssize_t more = read(handle->number(), bytes.data() + count, bytes.size() - count);
        if (more < 0 && errno == EINTR) continue;
        if (more < 0) return fileError(phrase("the file cannot be read"), file.string());
        if (more == 0) break;
        count += static_cast<std::size_t>(more);
    }
    bytes.resize(count);
    return bytes;
}

Outcome<OpenFile> openRegularFile(const fs::path& file) {
    struct stat status {};
    Outcome<FileHandle> handle = openRegular(file, status);
    if (!handle) return handle.diagnostics();
    return OpenFile{std::move(*handle), static_cast<std::uint64_t>(status.st_size)};
}

Outcome<Done> checkRegularFile(const fs::path& file) {
    struct stat status {};
    const Outcome<FileHandle> handle = openRegular(file, status);
    return handle ? Outcome<Done>(Done{}) : Outcome<Done>(handle.diagnostics());
}

}  // namespace analogon
