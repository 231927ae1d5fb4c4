#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

namespace analogon {

inline std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// All below a directory, by name: kind, rights, time of the last change, and what is inside or where a link leads.
inline std::map<std::string, std::string> treeOf(const std::filesystem::path& root) {
    namespace fs = std::filesystem;
    std::map<std::string, std::string> tree;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
        struct stat status {};
        lstat(entry.path().c_str(), &status);
        std::string text = std::to_string(status.st_mode) + " " + std::to_string(status.st_mtim.tv_sec) + "." +
                           std::to_string(status.st_mtim.tv_nsec) + " ";
        if (entry.is_symlink()) {
            text += fs::read_symlink(entry.path()).string();
        } else if (entry.is_regular_file()) {
            text += bytesOf(entry.path());
        }
        tree[entry.path().lexically_relative(root).string()] = text;
    }
    return tree;
}

/// The names of what is below a directory, one behind the other, for a message.
inline std::string namesBelow(const std::filesystem::path& root) {
    std::string names;
    for (const auto& [name, text] : treeOf(root)) names += (names.empty() ? "" : " ") + name;
    return names;
}

}  // namespace analogon
