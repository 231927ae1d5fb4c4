#include "core/library/package_entries.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/library/lazy_packages.hpp"
#include "core/library/library.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

/// Packages and single files of a directory, by name; a version behind a space is left out.
std::set<std::string> namesIn(const fs::path& directory) {
    std::set<std::string> names;
    std::error_code problem;
    for (fs::directory_iterator entry(directory, problem), end; !problem && entry != end; entry.increment(problem)) {
        std::error_code lost;
        const fs::path& path = entry->path();
        const bool isPackage = fs::exists(path / "package.mo", lost);
        if (!isPackage && (path.extension() != ".mo" || path.filename() == "package.mo")) continue;
        const std::string name = isPackage ? path.filename().string() : path.stem().string();
        names.insert(name.substr(0, name.find(' ')));
    }
    return names;
}

/// What a package that was read from a searched directory holds beside the text of its own.
std::set<std::string> namesBeside(const LibraryClass& package) {
    if (!package.definition->source) return {};
    const fs::path file = package.definition->source->name();
    const bool isItsOwn = file.parent_path().filename().string().starts_with(package.definition->name);
    if (file.filename() != "package.mo" || !isItsOwn) return {};  // a package within the text of another
    return namesIn(file.parent_path());
}

}  // namespace

std::vector<PackageEntry> packageEntries(const Library& library, const std::string& package) {
    std::vector<PackageEntry> entries;
    std::set<std::string> known;
    bool isRead = false;
    for (const LibraryClass* c : library.classes()) {
        isRead = isRead || c->qualifiedName == package;
        if (c->scope == package && !c->definition->isProtected && known.insert(c->definition->name).second)
            entries.push_back({c->definition->name, c});
    }
    if (package.empty()) {
        for (const fs::path& directory : packageDirectories())
            for (const std::string& name : namesIn(directory))
                if (known.insert(name).second) entries.push_back({name, nullptr});
    } else if (const LibraryClass* found = isRead ? nullptr : library.find(package)) {
        for (const syntax::ClassPtr& inner : found->definition->classes)
            if (known.insert(inner->name).second && !inner->isProtected)
                entries.push_back({inner->name, library.find(package + '.' + inner->name)});
        for (const std::string& name : namesBeside(*found))
            if (known.insert(name).second) entries.push_back({name, nullptr});
    }
    return entries;
}

}  // namespace analogon
