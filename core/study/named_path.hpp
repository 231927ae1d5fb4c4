#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/study/study.hpp"

namespace analogon {

/// A path that study.json names.
struct NamedPath {
    enum class Key { Measurement, Library, Logo };
    Key key{};
    std::string path;        // as it stands there
    std::string experiment;  // whose measurement it is
    std::string pointer;     // where it stands (core/study/json_places.hpp)
};

/// All of them. What holds for the paths of a study is asked of this list, so a new member of study.json that is a path
/// must be put into it.
std::vector<NamedPath> namedPaths(const Study& study);

/// Whether a path leads to a place within the directory it is relative to, and no link on its way out of it.
bool staysWithin(const std::filesystem::path& directory, const std::filesystem::path& path);

}  // namespace analogon
