#include "core/study/results_record.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "core/base/file_step.hpp"
#include "core/base/regular_file.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

constexpr const char* recordName = ".analogon-results";
constexpr std::string_view head = "analogon-results-1";
constexpr std::uint64_t largestRecord = 64u << 20;  // [byte]

/// "1234 1764280000.123456789": the size and the time of the last change; empty: no plain file.
std::string stampOf(const fs::path& file) {
    struct stat status {};
    if (lstat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
    return fmt::format("{} {}.{:09}", status.st_size, static_cast<long long>(status.st_mtim.tv_sec),
                       static_cast<long>(status.st_mtim.tv_nsec));
}

}  // namespace

bool ResultsRecord::write(const fs::path& directory) {
    std::string text(head);
    std::error_code code;
    for (fs::recursive_directory_iterator entry(directory, code), end; !code && entry != end; entry.increment(code))
        if (const std::string stamp = stampOf(entry->path()); !stamp.empty())
            text += fmt::format("\n{} {}", stamp, entry->path().lexically_relative(directory).string());
    std::ofstream stream(directory / recordName, std::ios::binary);
    stream << text << '\n';
    stream.close();
    syncToDisk(directory / recordName);
    return !code && stream.good();
}

ResultsRecord ResultsRecord::read(const fs::path& directory) {
    ResultsRecord record;
    record.directory_ = directory;
    if (!isPlainFile(directory / recordName)) return record;
    const Outcome<std::string> text = readRegularFile(directory / recordName, largestRecord);
    if (!text) return record;
    std::istringstream lines(*text);
    std::string line;
    if (!std::getline(lines, line) || line != head) return record;
    while (std::getline(lines, line)) {
        const std::size_t end = line.find(' ', std::min(line.size(), line.find(' ') + 1));
        if (end != std::string::npos) record.files_[line.substr(end + 1)] = line.substr(0, end);
    }
    record.files_[recordName] = stampOf(directory / recordName);
    return record;
}

bool ResultsRecord::isUnchangedFile(const fs::path& file) const {
    const auto known = files_.find(file.lexically_relative(directory_).string());
    return known != files_.end() && known->second == stampOf(file);
}

bool ResultsRecord::isUnchanged(const std::string& name) const {
    const fs::path path = directory_ / name;
    if (!isPlainDirectory(path)) return isUnchangedFile(path);
    std::error_code code;
    for (fs::recursive_directory_iterator entry(path, code), end; !code && entry != end; entry.increment(code))
        if (!isPlainDirectory(entry->path()) && !isUnchangedFile(entry->path())) return false;
    return !code;
}

bool ResultsRecord::isAll() const {
    std::error_code code;
    for (fs::directory_iterator entry(directory_, code), end; !code && entry != end; entry.increment(code)) {
        const std::string name = entry->path().filename().string();
        if (!isResultName(name) || !isUnchanged(name)) return false;
    }
    return !code;
}

bool holdsResults(const fs::path& directory) {
    if (isPlainFile(directory / recordName)) return ResultsRecord::read(directory).isUnchanged(recordName);
    if (!isPlainFile(directory / "report.json")) return false;
    std::ifstream stream(directory / "report.json", std::ios::binary);
    std::string begin(4096, '\0');
    stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<std::size_t>(stream.gcount()));
    return begin.find("\"analogon-report-1\"") != std::string::npos;
}

bool isResultName(const std::string& name) {
    return std::find(std::begin(resultNames), std::end(resultNames), name) != std::end(resultNames);
}

}  // namespace analogon
