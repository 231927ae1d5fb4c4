#include "core/library/package_files.hpp"

#include <algorithm>
#include <system_error>

#include "core/library/package_loader.hpp"

namespace analogon {

namespace fs = std::filesystem;

namespace {

void collect(const fs::path& directory, int depth, std::vector<fs::path>& files) {
    std::error_code code;
    if (depth > deepestPackage || !fs::exists(directory / "package.mo", code)) return;
    std::vector<fs::path> inner;
    for (fs::directory_iterator entry(directory, code), end; !code && entry != end; entry.increment(code)) {
        std::error_code lost;
        if (entry->is_directory(lost))
            inner.push_back(entry->path());
        else if (entry->is_regular_file(lost) &&
                 (entry->path().extension() == ".mo" || entry->path().filename() == "package.order"))
            files.push_back(entry->path());
    }
    for (const fs::path& each : inner) collect(each, depth + 1, files);
}

}  // namespace

std::vector<fs::path> packageFiles(const fs::path& path) {
    std::error_code code;
    std::vector<fs::path> files;
    if (fs::is_regular_file(path, code))
        files.push_back(path);
    else
        collect(path, 0, files);
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace analogon
