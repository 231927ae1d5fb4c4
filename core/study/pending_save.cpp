#include "core/study/pending_save.hpp"

#include <unistd.h>

#include <fstream>
#include <string_view>

#include "core/base/file_step.hpp"
#include "core/base/regular_file.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = ".analogon-saved-";
constexpr const char* listName = ".analogon-list";
/// Records of the list end with a NUL, which no name holds: "+model.mo" is a file, "-old.mo" a model that is no more.
constexpr std::string_view head = "analogon-save-1", tail = "end";
constexpr std::uint64_t largestList = 64u << 20;  // [byte]

/// The list of a folder; false: it is none.
bool readList(const fs::path& file, std::set<std::string>& files, std::set<std::string>& removed) {
    if (!isPlainFile(file)) return false;
    const Outcome<std::string> text = readRegularFile(file, largestList);
    if (!text) return false;
    bool isBegun = false;
    for (std::size_t at = 0, end = 0; (end = text->find('\0', at)) != std::string::npos; at = end + 1) {
        const std::string record = text->substr(at, end - at);
        if (!isBegun && record != head) return false;
        if (isBegun && record == tail) return true;
        if (isBegun && record.starts_with('+')) files.insert(record.substr(1));
        if (isBegun && record.starts_with('-')) removed.insert(record.substr(1));
        isBegun = true;
    }
    return false;
}

bool isModelName(const std::string& name) {
    const fs::path path(name);
    return path.extension() == ".mo" && path.filename() == path;
}

}  // namespace

Diagnostic isBeingSaved(const fs::path& study) {
    return fileError(phrase("another program is saving this study at the moment"), study.string(), 0, 0,
                     phrase("Try again when it has finished."));
}

bool leavesDirectory(const fs::path& path) {
    return path.is_absolute() || path.has_root_name() || path.lexically_normal().begin()->string() == "..";
}

bool leadsAway(const fs::path& directory, const fs::path& name) {
    if (name.is_absolute() || name.empty()) return true;
    fs::path at = directory;
    for (const fs::path& part : name.parent_path()) {
        if (part == "..") return true;
        at /= part;
        std::error_code code;
        if (fs::is_symlink(fs::symlink_status(at, code))) return true;
    }
    return name.filename() == ".." || name.filename() == ".";
}

PendingSave PendingSave::in(const fs::path& directory) {
    std::error_code code;
    for (fs::directory_iterator entry(directory, code), end; !code && entry != end; entry.increment(code)) {
        if (!entry->path().filename().string().starts_with(prefix) || !isPlainDirectory(entry->path())) continue;
        PendingSave found;
        if (!readList(entry->path() / listName, found.files_, found.removed_)) continue;
        found.directory_ = directory;
        found.folder_ = entry->path();
        std::erase_if(found.files_, [&](const std::string& name) {
            return leadsAway(found.folder_, name) || !isPlainFile(found.folder_ / name);
        });
        std::erase_if(found.removed_, [](const std::string& name) { return !isModelName(name); });
        return found;
    }
    PendingSave none;
    none.directory_ = directory;
    return none;
}

fs::path PendingSave::place(const fs::path& name) const {
    if (files_.contains(name.lexically_normal().generic_string())) return folder_ / name;
    return directory_ / name;
}

std::error_code PendingSave::finish(const fs::path& spent) const {
    if (folder_.empty()) return {};
    std::error_code code;
    for (const std::string& name : removed_) unlink((directory_ / name).c_str());
    for (const std::string& name : files_) {
        if (leadsAway(directory_, name)) return std::make_error_code(std::errc::too_many_symbolic_link_levels);
        fs::create_directories((directory_ / name).parent_path(), code);
        if (!code) fs::rename(folder_ / name, directory_ / name, code);
        if (code) return code;
    }
    syncToDisk(directory_);
    fs::rename(folder_, spent / folder_.filename(), code);
    return code;
}

std::error_code commitSave(const fs::path& written, const fs::path& directory, const std::set<std::string>& files,
                           const std::set<std::string>& removed) {
    std::string list(head);
    list += '\0';
    for (const std::string& name : files) (list += '+' + name) += '\0';
    for (const std::string& name : removed) (list += '-' + name) += '\0';
    (list += tail) += '\0';
    std::ofstream stream(written / listName, std::ios::binary);
    stream.write(list.data(), static_cast<std::streamsize>(list.size()));
    stream.close();
    if (!stream) return std::make_error_code(std::errc::no_space_on_device);
    syncToDisk(written / listName);
    syncToDisk(written);
    const std::string ending = written.parent_path().filename().string();
    std::error_code code = renameToNew(written, directory / (std::string(prefix) + ending));
    if (!code) syncToDisk(directory);
    return code;
}

}  // namespace analogon
