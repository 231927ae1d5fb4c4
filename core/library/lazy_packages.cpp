#include "core/library/lazy_packages.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>

#include "core/base/regular_file.hpp"
#include "core/syntax/parser.hpp"

namespace analogon {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t largestText = 64u << 20;  // [byte] of a file

/// "4.1.0" as numbers, for comparison.
std::vector<int> numbersOf(std::string_view version) {
    std::vector<int> numbers;
    for (const char *at = version.data(), *end = at + version.size(); at < end; ++at) {
        int number = 0;
        const auto [next, problem] = std::from_chars(at, end, number);
        if (problem != std::errc{}) break;
        numbers.push_back(number);
        at = next;
    }
    return numbers;
}

/// A directory or file of this package, perhaps with its version behind the name: "Modelica 4.1.0".
struct Candidate {
    fs::path file;  // package.mo, or the single file
    std::string version;
};

std::optional<std::string> versionIn(const std::string& entry, const std::string& name) {
    if (entry == name) return std::string();
    if (entry.size() > name.size() + 1 && entry.starts_with(name) && entry[name.size()] == ' ')
        return entry.substr(name.size() + 1);
    return std::nullopt;
}

std::vector<Candidate> candidates(const fs::path& directory, const std::string& name) {
    std::vector<Candidate> found;
    std::error_code problem;
    for (fs::directory_iterator entry(directory, problem), end; !problem && entry != end; entry.increment(problem)) {
        std::error_code lost;
        const bool isPackage = fs::exists(entry->path() / "package.mo", lost);
        if (!isPackage && entry->path().extension() != ".mo") continue;
        const std::string own = isPackage ? entry->path().filename().string() : entry->path().stem().string();
        if (const auto version = versionIn(own, name))
            found.push_back({isPackage ? entry->path() / "package.mo" : entry->path(), *version});
    }
    return found;
}

/// The wanted version, else the newest; one without a version in its name is taken before those with another.
const Candidate& chosen(const std::vector<Candidate>& from, std::string_view version) {
    const auto rank = [&](const Candidate& c) {
        const int fit = !version.empty() && c.version == version ? 2 : c.version.empty() ? 1 : 0;
        return std::pair(fit, numbersOf(c.version));
    };
    return *std::max_element(from.begin(), from.end(),
                             [&](const Candidate& a, const Candidate& b) { return rank(a) < rank(b); });
}

}  // namespace

std::string_view enclosingName(std::string_view qualifiedName) {
    bool isQuoted = false;
    for (std::size_t i = qualifiedName.size(); i-- > 0;) {
        if (qualifiedName[i] == '\'' && (i == 0 || qualifiedName[i - 1] != '\\')) isQuoted = !isQuoted;
        if (qualifiedName[i] == '.' && !isQuoted) return qualifiedName.substr(0, i);
    }
    return {};
}

std::vector<fs::path> packageDirectories() {
    std::vector<fs::path> result;
    std::error_code problem;
    const auto take = [&](const fs::path& path) {
        if (!path.empty() && fs::is_directory(path, problem)) result.push_back(path);
    };
    if (const char* given = std::getenv("MODELICAPATH")) {
        const std::string_view list(given);
        for (std::size_t at = 0, end = 0; end != std::string_view::npos; at = end + 1) {
            end = list.find(':', at);
            take(list.substr(at, end == std::string_view::npos ? end : end - at));
        }
    }
    if (const char* home = std::getenv("HOME"); home && *home) take(fs::path(home) / ".openmodelica" / "libraries");
    return result;
}

const LibraryClass* LazyPackages::find(std::string_view qualifiedName, const std::function<std::string()>& version) {
    const std::lock_guard lock(mutex_);
    if (const LibraryClass* known = found(qualifiedName)) return known;
    if (missing_.contains(qualifiedName)) return nullptr;
    return searched(std::string(qualifiedName), version());
}

namespace {

/// No name has this sign in it.
std::string placeOf(std::string_view name, std::string_view scope) {
    std::string place(scope);
    place += '\n';
    place += name;
    return place;
}

}  // namespace

const LazyPackages::Meaning* LazyPackages::meaning(std::string_view name, std::string_view scope) const {
    const std::lock_guard lock(mutex_);
    const auto entry = meanings_.find(placeOf(name, scope));
    return entry == meanings_.end() ? nullptr : &entry->second;
}

void LazyPackages::remember(std::string_view name, std::string_view scope, Meaning meaning) {
    const std::lock_guard lock(mutex_);
    meanings_.try_emplace(placeOf(name, scope), std::move(meaning));
}

Diagnostics LazyPackages::faults() const {
    const std::lock_guard lock(mutex_);
    return faults_;
}

const LibraryClass* LazyPackages::found(std::string_view qualifiedName) const {
    const auto entry = classes_.find(qualifiedName);
    return entry == classes_.end() ? nullptr : &entry->second;
}

const LibraryClass* LazyPackages::searched(const std::string& qualifiedName, std::string_view version) {
    if (const LibraryClass* known = found(qualifiedName)) return known;
    if (missing_.contains(qualifiedName)) return nullptr;
    const std::string outer(enclosingName(qualifiedName));
    if (outer.empty()) {
        open(qualifiedName, version);
    } else if (searched(outer, version) && !found(qualifiedName)) {
        const auto package = opened_.find(outer);
        const std::string name = qualifiedName.substr(outer.size() + 1);
        if (package != opened_.end() && package->second.packages.contains(name)) {
            const fs::path directory = package->second.path / name;
            listed(qualifiedName, directory);
            read(directory / "package.mo", name, outer);
        } else if (package != opened_.end() && package->second.files.contains(name)) {
            read(package->second.path / (name + ".mo"), name, outer);
        }
    }
    const LibraryClass* const result = found(qualifiedName);
    if (!result) missing_.insert(qualifiedName);
    return result;
}

/// The first directory that holds the package counts.
void LazyPackages::open(const std::string& name, std::string_view version) {
    for (const fs::path& directory : directories_) {
        const std::vector<Candidate> here = candidates(directory, name);
        if (here.empty()) continue;
        const Candidate& best = chosen(here, version);
        if (best.file.filename() == "package.mo") listed(name, best.file.parent_path());
        return read(best.file, name, {});
    }
}

const LazyPackages::Directory& LazyPackages::listed(const std::string& package, const fs::path& path) {
    Directory directory{path, {}, {}};
    std::error_code problem;
    for (fs::directory_iterator entry(path, problem), end; !problem && entry != end; entry.increment(problem)) {
        std::error_code lost;
        if (entry->path().extension() == ".mo") {
            if (entry->path().filename() != "package.mo") directory.files.insert(entry->path().stem().string());
        } else if (fs::exists(entry->path() / "package.mo", lost)) {
            directory.packages.insert(entry->path().filename().string());
        }
    }
    return opened_[package] = std::move(directory);
}

void LazyPackages::read(const fs::path& file, const std::string& name, const std::string& scope) {
    Outcome<std::string> text = readRegularFile(file, largestText);
    if (!text) {
        faults_.insert(faults_.end(), text.diagnostics().begin(), text.diagnostics().end());
        return;
    }
    const auto parsed = syntax::parse(std::make_shared<const Source>(file.string(), std::move(*text)));
    if (hasError(parsed.diagnostics)) {
        faults_.insert(faults_.end(), parsed.diagnostics.begin(), parsed.diagnostics.end());
        return;
    }
    for (const syntax::ClassPtr& definition : parsed.definition.classes)
        if (definition->name == name) add(definition, scope);
}

void LazyPackages::add(const syntax::ClassPtr& definition, const std::string& scope) {
    std::string name = scope.empty() ? definition->name : scope + "." + definition->name;
    classes_.try_emplace(name, LibraryClass{name, definition, scope});
    for (const syntax::ClassPtr& nested : definition->classes) add(nested, name);
}

}  // namespace analogon
