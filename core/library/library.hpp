#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/syntax/ast.hpp"

namespace analogon {

class LazyPackages;
struct MeasuredSignals;

/// A class with the full name it has in the library.
struct LibraryClass {
    std::string qualifiedName;  // "Analogon.Mechanics.Inertia"
    syntax::ClassPtr definition;
    std::string scope;  // qualified name of the enclosing class; empty at the top
};

/// All classes known to a study: packages from search paths and the study's own files. A value: adding a
/// file gives a new library that shares the trees of the old one, so it is cheap to copy and to vary.
class Library {
public:
    /// Adds a package: a directory with package.mo (and package.order), or one .mo file. A directory that holds
    /// packages, or files of single classes, is searched for them: what lies there is read when it is named, and
    /// classes() does not list it.
    Outcome<Library> withPath(const std::filesystem::path& path) const;
    /// Adds one text; a class of the same qualified name is replaced, with all it holds.
    Outcome<Library> withSource(SourcePtr source) const;

    /// Adds many texts: the same as one behind the other, but what is there already is copied once. Faults of all.
    Outcome<Library> withSources(const std::vector<SourcePtr>& sources) const;

    /// Adds directories that hold packages; earlier ones are searched first.
    Library withDirectories(std::vector<std::filesystem::path> directories) const;
    /// With what recordings hold of one of its classes, in place of what was known before. flatten() heeds it, also
    /// where the text of the class is varied.
    Library withMeasured(MeasuredSignals signals) const;
    /// What recordings hold of a class; empty where nothing is known of it.
    const MeasuredSignals& measured(std::string_view className) const;

    /// What is wrong with the files of searched directories that were read so far.
    Diagnostics lazyFaults() const;

    /// By its full name ("Analogon.Mechanics.Inertia"), or by one that it had in an older version of its library; null
    /// when unknown.
    const LibraryClass* find(std::string_view qualifiedName) const;

    /// Looks a name up as the specification says: from the scope (a qualified class name) outward, through
    /// imports and inherited classes. Null when unknown.
    const LibraryClass* lookup(const syntax::Name& name, std::string_view scope) const;
    const LibraryClass* lookup(std::string_view dottedName, std::string_view scope) const;

    /// All classes, in package order, outer before inner.
    const std::vector<const LibraryClass*>& classes() const { return content().order; }
    /// Names for suggestions.
    std::vector<std::string> names() const;

    /// The classes it inherits from directly, in the order of its extends clauses; unknown ones are left out.
    std::vector<const LibraryClass*> bases(const LibraryClass& derived) const;

    /// Whether `derived` is `base` or inherits from it (through any number of extends).
    bool isDerived(std::string_view derived, std::string_view base) const;

private:
    struct Content {
        std::map<std::string, std::shared_ptr<const LibraryClass>, std::less<>> classes;
        std::vector<const LibraryClass*> order;

        void add(std::vector<LibraryClass> added);
        std::size_t takeOut(const std::string& qualifiedName);
    };
    const Content& content() const;
    std::string usedVersion(std::string_view package) const;
    Library with(std::vector<LibraryClass> added) const;

    std::shared_ptr<const Content> content_;           // null: empty
    std::shared_ptr<LazyPackages> lazy_;               // null: no directories are searched
    std::shared_ptr<const MeasuredSignals> measured_;  // null: of no class
};

/// The directory that holds `Analogon/package.mo`: what the environment variable ANALOGON_LIBRARY names, or else beside
/// the program (../share/analogon) or the source tree it was built from, the first that exists.
std::filesystem::path builtInLibraryPath();

/// The block library `Analogon`, parsed once per process and shared (thread-safe).
Outcome<Library> builtInLibrary();

}  // namespace analogon
