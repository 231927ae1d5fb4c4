#include "core/library/library.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <system_error>
#include <utility>

#include "core/base/text.hpp"
#include "core/library/lazy_packages.hpp"
#include "core/library/measured_signals.hpp"
#include "core/library/moved_classes.hpp"
#include "core/library/name_search.hpp"
#include "core/library/package_loader.hpp"
#include "core/syntax/parser.hpp"

namespace analogon {

namespace fs = std::filesystem;

namespace {

/// Parts of a dotted name; a dot within a quoted identifier does not separate.
syntax::Name splitName(std::string_view dotted) {
    syntax::Name name;
    if (dotted.starts_with('.')) {
        name.absolute = true;
        dotted.remove_prefix(1);
    }
    std::string part;
    bool isQuoted = false;
    for (std::size_t i = 0; i <= dotted.size(); ++i) {
        if (i == dotted.size() || (dotted[i] == '.' && !isQuoted)) {
            name.parts.push_back({std::exchange(part, {}), {}, {}});
            continue;
        }
        if (dotted[i] == '\'' && (i == 0 || dotted[i - 1] != '\\')) isQuoted = !isQuoted;
        part += dotted[i];
    }
    return name;
}

bool isWithin(std::string_view name, std::string_view outer) {
    return name == outer || (name.size() > outer.size() && name.starts_with(outer) && name[outer.size()] == '.');
}

/// Whether packages, or files of single classes, lie in a directory that is no package itself.
bool holdsClasses(const fs::path& directory) {
    std::error_code problem;
    for (fs::directory_iterator entry(directory, problem), end; !problem && entry != end; entry.increment(problem)) {
        std::error_code lost;
        if (entry->path().extension() == ".mo" || fs::exists(entry->path() / "package.mo", lost)) return true;
    }
    return false;
}

/// The enumerations of the language (section 4.9), which no text declares.
const LibraryClass* builtinClass(std::string_view name) {
    static const auto classes = [] {
        const auto source =
            std::make_shared<const Source>("the Modelica language",
                                           "type StateSelect = enumeration(never, avoid, default, prefer, always);\n"
                                           "type AssertionLevel = enumeration(error, warning);\n");
        std::map<std::string, LibraryClass, std::less<>> made;
        for (const syntax::ClassPtr& one : syntax::parse(source).definition.classes)
            made.emplace(one->name, LibraryClass{one->name, one, {}});
        return made;
    }();
    const auto found = classes.find(name);
    return found == classes.end() ? nullptr : &found->second;
}

}  // namespace

Library Library::withDirectories(std::vector<fs::path> directories) const {
    Library result = *this;
    if (directories.empty()) return result;
    if (lazy_) directories.insert(directories.end(), lazy_->directories().begin(), lazy_->directories().end());
    result.lazy_ = std::make_shared<LazyPackages>(std::move(directories));
    return result;
}

Library Library::withMeasured(MeasuredSignals signals) const {
    Library result = *this;
    result.measured_ = std::make_shared<const MeasuredSignals>(std::move(signals));
    return result;
}

const MeasuredSignals& Library::measured(std::string_view className) const {
    static const MeasuredSignals none;
    return measured_ && measured_->className == className ? *measured_ : none;
}

Diagnostics Library::lazyFaults() const { return lazy_ ? lazy_->faults() : Diagnostics(); }

Outcome<Library> Library::withPath(const fs::path& path) const {
    std::error_code problem;
    if (fs::is_directory(path, problem) && !fs::exists(path / "package.mo", problem) && holdsClasses(path))
        return withDirectories({path});
    PackageLoader loader;
    loader.load(path);
    if (hasError(loader.diagnostics())) return std::move(loader.diagnostics());
    return Outcome<Library>(with(std::move(loader.classes())), std::move(loader.diagnostics()));
}

Outcome<Library> Library::withSource(SourcePtr source) const {
    PackageLoader loader;
    loader.loadSource(std::move(source));
    if (hasError(loader.diagnostics())) return std::move(loader.diagnostics());
    return Outcome<Library>(with(std::move(loader.classes())), std::move(loader.diagnostics()));
}

Outcome<Library> Library::withSources(const std::vector<SourcePtr>& sources) const {
    auto next = std::make_shared<Content>(content());
    Diagnostics faults, warnings;
    for (const SourcePtr& source : sources) {
        PackageLoader loader;
        loader.loadSource(source);
        Diagnostics& to = hasError(loader.diagnostics()) ? faults : warnings;
        to.insert(to.end(), loader.diagnostics().begin(), loader.diagnostics().end());
        next->add(std::move(loader.classes()));
    }
    if (!faults.empty()) return faults;
    Library result = *this;
    result.content_ = std::move(next);
    return {std::move(result), std::move(warnings)};
}

const Library::Content& Library::content() const {
    static const Content nothing;
    return content_ ? *content_ : nothing;
}

Library Library::with(std::vector<LibraryClass> added) const {
    auto next = std::make_shared<Content>(content());
    next->add(std::move(added));
    Library result = *this;
    result.content_ = std::move(next);
    return result;
}

/// The classes come outer before inner: each that is not part of one before replaces its namesake.
void Library::Content::add(std::vector<LibraryClass> added) {
    auto place = order.size();
    std::string root;
    for (LibraryClass& one : added) {
        if (root.empty() || !isWithin(one.qualifiedName, root)) {
            root = one.qualifiedName;
            place = takeOut(root);
        }
        const auto kept = std::make_shared<const LibraryClass>(std::move(one));
        classes[kept->qualifiedName] = kept;
        order.insert(order.begin() + static_cast<std::ptrdiff_t>(place++), kept.get());
    }
}

/// Takes a class out with all it holds; where in the order its successor belongs.
std::size_t Library::Content::takeOut(const std::string& qualifiedName) {
    // all names within it stand beside each other
    const auto inner = classes.lower_bound(qualifiedName + '.');
    const bool hasInner = inner != classes.end() && isWithin(inner->first, qualifiedName);
    const auto own = classes.find(qualifiedName);
    if (own == classes.end() && !hasInner) return order.size();  // a new name needs no look at all the others
    const LibraryClass* const known = own == classes.end() ? nullptr : own->second.get();
    const auto place = static_cast<std::size_t>(std::find(order.begin(), order.end(), known) - order.begin());
    std::erase_if(order, [&](const LibraryClass* one) { return isWithin(one->qualifiedName, qualifiedName); });
    auto end = inner;
    while (end != classes.end() && isWithin(end->first, qualifiedName)) ++end;
    classes.erase(inner, end);
    classes.erase(qualifiedName);
    return std::min(place, order.size());
}

const LibraryClass* Library::find(std::string_view qualifiedName) const {
    const auto& classes = content().classes;
    const std::string_view root = qualifiedName.substr(0, qualifiedName.find('.'));
    if (const auto first = classes.lower_bound(root); first != classes.end() && isWithin(first->first, root)) {
        const auto entry = classes.find(qualifiedName);
        if (entry != classes.end()) return entry->second.get();
    }
    if (root.size() == qualifiedName.size())
        if (const LibraryClass* builtin = builtinClass(qualifiedName)) return builtin;
    const bool isWhole = classes.contains(root);  // a package of the study
    if (lazy_ && !isWhole)
        if (const LibraryClass* found = lazy_->find(qualifiedName, [&] { return usedVersion(root); })) return found;
    if (!lazy_ && !isWhole) return nullptr;
    const std::string now = newName(qualifiedName);
    return now.empty() ? nullptr : find(now);
}

/// What an annotation uses(Package(version = "…")) of the study's own classes says; empty: nothing.
std::string Library::usedVersion(std::string_view package) const {
    const auto& classes = content().classes;
    for (auto at = classes.begin(); at != classes.end();) {
        // names within one of the top stand beside each other: on to the next
        const LibraryClass* const one = at->second.get();
        at = classes.lower_bound(at->first.substr(0, at->first.find('.')) + static_cast<char>('.' + 1));
        if (!one->scope.empty() || !one->definition->annotation) continue;
        const syntax::Modification* uses = one->definition->annotation->find("uses");
        if (!uses) continue;
        for (const syntax::Modification& used : uses->arguments) {
            if (used.name.text() != package) continue;
            for (const syntax::Modification& said : used.arguments)
                if (said.name.text() == "version" && said.value) return said.value->text;
        }
    }
    return {};
}

namespace {

/// What is asked for within a package of a directory is often asked for again, by other models: kept as long as the
/// study has nothing of its own (`isOwn`, by the first part of a name) that was asked for on the way.
template <class IsOwn, class Search>
const LibraryClass* remembered(const Library& library, LazyPackages* lazy, const std::string& what,
                               std::string_view scope, const IsOwn& isOwn, const Search& find) {
    NameSearch search(library);
    if (!lazy || scope.empty() || isOwn(scope.substr(0, scope.find('.')))) return find(search);
    const LazyPackages::Meaning* const known = lazy->meaning(what, scope);
    if (known && std::none_of(known->roots.begin(), known->roots.end(), isOwn)) return known->found;
    const LibraryClass* const found = find(search);
    if (!known && std::none_of(search.roots().begin(), search.roots().end(), isOwn))
        lazy->remember(what, scope, {found, search.roots()});
    return found;
}

/// Whether the study itself has classes whose names begin with this part.
template <class Classes>
auto ownRoots(const Classes& classes) {
    return [&classes](std::string_view root) {
        const auto first = classes.lower_bound(root);
        return first != classes.end() && isWithin(first->first, root);
    };
}

}  // namespace

const LibraryClass* Library::lookup(const syntax::Name& name, std::string_view scope) const {
    return remembered(*this, lazy_.get(), name.text(), scope, ownRoots(content().classes),
                      [&](NameSearch& search) { return search.find(name, scope); });
}

const LibraryClass* Library::lookup(std::string_view dottedName, std::string_view scope) const {
    return lookup(splitName(dottedName), scope);
}

std::vector<std::string> Library::names() const {
    std::vector<std::string> result;
    result.reserve(classes().size());
    for (const LibraryClass* one : classes()) result.push_back(one->qualifiedName);
    return result;
}

std::vector<const LibraryClass*> Library::bases(const LibraryClass& derived) const {
    std::vector<const LibraryClass*> result;
    NameSearch search(*this);
    const auto add = [&](const syntax::Name& name) {
        const LibraryClass* const base =
            remembered(*this, lazy_.get(), "extends " + name.text(), derived.qualifiedName, ownRoots(content().classes),
                       [&](NameSearch& own) { return own.findBase(name, derived); });
        if (base) result.push_back(base);
    };
    if (derived.definition->isShort && !derived.definition->isEnumeration) add(derived.definition->shortBase);
    if (derived.definition->extendsItself)
        if (const LibraryClass* const original = search.extended(derived)) result.push_back(original);
    for (const syntax::Extends& clause : derived.definition->bases) add(clause.base);
    return result;
}

bool Library::isDerived(std::string_view derived, std::string_view base) const {
    const LibraryClass* start = find(derived);
    const LibraryClass* wanted = find(base);
    if (!start || !wanted) return false;
    std::set<const LibraryClass*> seen{start};
    std::vector<const LibraryClass*> open{start};
    while (!open.empty()) {
        const LibraryClass* one = open.back();
        open.pop_back();
        if (one == wanted) return true;
        for (const LibraryClass* next : bases(*one)) {
            if (seen.insert(next).second) open.push_back(next);
        }
    }
    return false;
}

fs::path builtInLibraryPath() {
    // one that is told counts, also where nothing is found: another in its place would be taken for it
    if (const char* given = std::getenv("ANALOGON_LIBRARY"); given != nullptr && *given != 0) return given;
    std::vector<fs::path> candidates;
    std::error_code problem;
    const fs::path program = fs::read_symlink("/proc/self/exe", problem);
    if (!problem) candidates.push_back(program.parent_path().parent_path() / "share" / "analogon");
    candidates.emplace_back(ANALOGON_SOURCE_LIBRARY);
    for (const fs::path& candidate : candidates) {
        if (fs::exists(candidate / "Analogon" / "package.mo", problem)) return candidate;
    }
    return candidates.back();
}

Outcome<Library> builtInLibrary() {
    static const Outcome<Library> library = [] {
        const fs::path path = builtInLibraryPath() / "Analogon";
        std::error_code problem;
        if (!fs::exists(path / "package.mo", problem))
            return Outcome<Library>(error(phrase("there is no block library at {}", path.string()), {},
                                          phrase("let ANALOGON_LIBRARY name the folder that holds Analogon/package.mo, "
                                                 "or leave it unset")));
        Outcome<Library> own = Library().withPath(path);
        return own ? Outcome<Library>(own->withDirectories(packageDirectories()), own.diagnostics()) : own;
    }();
    return library;
}

}  // namespace analogon
