#include "core/archive/temporary_directory.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

namespace analogon {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = "analogon-study-";

/// Directories "analogon-study-PID-…" of processes that are no more.
void removeAbandoned(const fs::path& place) {
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(place, fs::directory_options::skip_permission_denied, code)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(prefix)) continue;
        const long owner = std::strtol(name.c_str() + prefix.size(), nullptr, 10);
        if (owner > 0 && kill(static_cast<pid_t>(owner), 0) != 0 && errno == ESRCH) fs::remove_all(entry.path(), code);
    }
}

}  // namespace

Outcome<std::shared_ptr<const TemporaryDirectory>> TemporaryDirectory::make() {
    std::error_code code;
    const fs::path place = fs::temp_directory_path(code);
    if (code)
        return fileError(phrase("there is no place for temporary files: {}", code.message()), "", 0, 0,
                         phrase("Set TMPDIR to a directory that may be written."));
    removeAbandoned(place);
    std::string name = (place / fmt::format("{}{}-XXXXXX", prefix, getpid())).string();
    if (!mkdtemp(name.data()))
        return fileError(phrase("no temporary directory can be made: {}", std::strerror(errno)), place.string(), 0, 0,
                         phrase("Check that it may be written and has room, or set TMPDIR."));
    return std::shared_ptr<const TemporaryDirectory>(new TemporaryDirectory(name));
}

TemporaryDirectory::~TemporaryDirectory() {
    std::error_code code;
    fs::remove_all(path_, code);
}

}  // namespace analogon
