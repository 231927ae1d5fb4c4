#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "core/library/library.hpp"

namespace analogon {

/// One look-up of a name (Modelica 3.6, sections 5.3.1 and 5.3.2). Remembers what it has visited, so that classes
/// which inherit from each other in a circle, or in many ways, end it like any others. Private to the library.
class NameSearch {
public:
    explicit NameSearch(const Library& library) : library_(library) {}

    /// The class a simple or dotted name means within a scope.
    const LibraryClass* find(const syntax::Name& name, std::string_view scope);
    /// The class a base's name means in the class that extends it: names it inherits itself do not count.
    const LibraryClass* findBase(const syntax::Name& name, const LibraryClass& derived);
    /// The inherited class that `model extends M` continues; null when there is none.
    const LibraryClass* extended(const LibraryClass& heir);

    /// The first parts of all names that were asked for.
    const std::set<std::string, std::less<>>& roots() const { return roots_; }

private:
    const LibraryClass* ask(std::string_view qualifiedName);
    const LibraryClass* findFirst(std::string_view identifier, std::string_view scope, const LibraryClass* heir);
    const LibraryClass* findRest(const LibraryClass* found, const syntax::Name& name, std::size_t part);
    const LibraryClass* declaredOrInherited(const LibraryClass& in, std::string_view identifier);
    const LibraryClass* inherited(const LibraryClass& in, std::string_view identifier);
    const LibraryClass* imported(const LibraryClass& in, std::string_view identifier);
    const LibraryClass* nested(std::string_view scope, std::string_view identifier);

    const Library& library_;
    std::map<std::pair<const LibraryClass*, std::string>, const LibraryClass*> visited_;
    std::set<std::string, std::less<>> roots_;
};

}  // namespace analogon
