#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/library/library.hpp"

namespace analogon {

/// Packages in directories that are searched for them (Modelica 3.6, sections 13.3 and 13.4). A file is read when a
/// class in it is named for the first time, and once. Thread-safe; what was found stays where it is.
class LazyPackages {
public:
    explicit LazyPackages(std::vector<std::filesystem::path> directories) : directories_(std::move(directories)) {}

    const std::vector<std::filesystem::path>& directories() const { return directories_; }

    /// By its full name; null when there is none. `version` tells which one of a package is wanted where several lie
    /// side by side (empty: the newest); it is asked only where something must be read.
    const LibraryClass* find(std::string_view qualifiedName, const std::function<std::string()>& version);

    /// What a name means in a class of a package, and the first parts of all names that were asked for to find it:
    /// while the study has nothing of these itself, it means the same in every study.
    struct Meaning {
        const LibraryClass* found{};
        std::set<std::string, std::less<>> roots;
    };
    /// Null: nobody has asked yet.
    const Meaning* meaning(std::string_view name, std::string_view scope) const;
    void remember(std::string_view name, std::string_view scope, Meaning meaning);
    /// What is wrong with the files that were read so far.
    Diagnostics faults() const;

private:
    struct TextHash {
        using is_transparent = void;
        std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
    };
    struct Directory {
        std::filesystem::path path;
        std::set<std::string> packages;  // directories with a package.mo
        std::set<std::string> files;     // without .mo
    };

    const LibraryClass* found(std::string_view qualifiedName) const;
    const LibraryClass* searched(const std::string& qualifiedName, std::string_view version);
    void open(const std::string& name, std::string_view version);
    void read(const std::filesystem::path& file, const std::string& name, const std::string& scope);
    void add(const syntax::ClassPtr& definition, const std::string& scope);
    const Directory& listed(const std::string& package, const std::filesystem::path& path);

    std::vector<std::filesystem::path> directories_;
    mutable std::mutex mutex_;
    std::unordered_map<std::string, LibraryClass, TextHash, std::equal_to<>> classes_;
    std::unordered_set<std::string, TextHash, std::equal_to<>> missing_;
    std::unordered_map<std::string, Meaning, TextHash, std::equal_to<>> meanings_;  // by scope and name
    std::map<std::string, Directory> opened_;                                       // by qualified name of the package
    Diagnostics faults_;
};

/// Where packages of others lie: the directories of the environment variable MODELICAPATH, and where OpenModelica
/// keeps its own (~/.openmodelica/libraries). Only those that exist.
std::vector<std::filesystem::path> packageDirectories();

/// Part of a dotted name; a dot within a quoted identifier does not separate. "A.B" for "A.B.C", empty for "A".
std::string_view enclosingName(std::string_view qualifiedName);

}  // namespace analogon
