#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/library/library.hpp"

namespace analogon {

constexpr int deepestPackage = 32;  // links on the disk may run in circles

/// Reads packages from disk into a list of classes (Modelica 3.6, section 13.4). Private to the library.
class PackageLoader {
public:
    void load(const std::filesystem::path& path);
    void loadSource(SourcePtr source);

    /// Outer before inner, in package order.
    std::vector<LibraryClass>& classes() { return classes_; }
    Diagnostics& diagnostics() { return diagnostics_; }

private:
    struct Entries;

    void loadDirectory(const std::filesystem::path& directory, const std::string& scope, int depth);
    void loadFile(const std::filesystem::path& file, const std::string& scope);
    Entries entriesOf(const std::filesystem::path& directory);
    std::vector<std::string> packageOrder(const std::filesystem::path& directory, const Entries& entries,
                                          const syntax::ClassDefinition& package);
    syntax::ClassPtr parseOne(const std::filesystem::path& file, const std::string& expectedName,
                              const std::string& scope);
    SourcePtr read(const std::filesystem::path& file);
    void add(const syntax::ClassPtr& definition, const std::string& scope);
    void addNested(const syntax::ClassDefinition& definition, const std::string& qualifiedName);

    std::vector<LibraryClass> classes_;
    Diagnostics diagnostics_;
};

}  // namespace analogon
