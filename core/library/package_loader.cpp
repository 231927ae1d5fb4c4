#include "core/library/package_loader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

#include "core/base/regular_file.hpp"
#include "core/syntax/parser.hpp"

namespace analogon {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t largestText = 64u << 20;  // [byte] of a file

std::string qualified(const std::string& scope, const std::string& name) {
    return scope.empty() ? name : fmt::format("{}.{}", scope, name);
}

}  // namespace

/// What a package directory holds beside package.mo.
struct PackageLoader::Entries {
    std::set<std::string> directories;
    std::set<std::string> files;  // without .mo

    bool contains(const std::string& name) const { return directories.count(name) + files.count(name) > 0; }
};

void PackageLoader::load(const fs::path& path) {
    std::error_code problem;
    if (fs::is_directory(path, problem)) {
        loadDirectory(path, {}, 0);
    } else if (fs::exists(path, problem)) {
        if (const SourcePtr source = read(path)) loadSource(source);
    } else {
        diagnostics_.push_back(fileError(phrase("no such file or directory"), path.string()));
    }
}

void PackageLoader::loadSource(SourcePtr source) {
    auto parsed = syntax::parse(std::move(source));
    diagnostics_.insert(diagnostics_.end(), parsed.diagnostics.begin(), parsed.diagnostics.end());
    const std::string scope = parsed.definition.within ? parsed.definition.within->text() : std::string{};
    std::set<std::string> names;
    for (const syntax::ClassPtr& definition : parsed.definition.classes) {
        if (!names.insert(definition->name).second) {
            diagnostics_.push_back(
                error(phrase("the class \"{}\" is defined twice", definition->name), definition->nameSpan));
        }
        add(definition, scope);
    }
}

void PackageLoader::loadDirectory(const fs::path& directory, const std::string& scope, int depth) {
    const fs::path packageFile = directory / "package.mo";
    std::error_code problem;
    if (!fs::exists(packageFile, problem)) {
        diagnostics_.push_back(fileError(phrase("the directory holds no package.mo"), directory.string(), 0, 0,
                                         phrase("give the directory of a package, or one .mo file")));
        return;
    }
    if (depth > deepestPackage) {
        diagnostics_.push_back(fileError(phrase("packages are nested too deep"), directory.string()));
        return;
    }
    // The directory names the package; only a top one may be kept under another name (say, with a version).
    const std::string expected = depth == 0 ? std::string{} : directory.filename().string();
    const syntax::ClassPtr package = parseOne(packageFile, expected, scope);
    if (!package) return;
    const std::string name = qualified(scope, package->name);
    classes_.push_back({name, package, scope});
    const Entries entries = entriesOf(directory);
    for (const std::string& entry : packageOrder(directory, entries, *package)) {
        if (entries.directories.count(entry)) {
            loadDirectory(directory / entry, name, depth + 1);
        } else if (entries.files.count(entry)) {
            loadFile(directory / (entry + ".mo"), name);
        } else {
            for (const syntax::ClassPtr& nested : package->classes) {
                if (nested->name == entry) add(nested, name);
            }
        }
    }
}

PackageLoader::Entries PackageLoader::entriesOf(const fs::path& directory) {
    Entries entries;
    std::error_code problem;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory, problem)) {
        std::error_code ignored;
        if (entry.path().extension() == ".mo") {
            if (entry.path().filename() != "package.mo") entries.files.insert(entry.path().stem().string());
        } else if (fs::exists(entry.path() / "package.mo", ignored)) {
            entries.directories.insert(entry.path().filename().string());
        }
    }
    if (problem) diagnostics_.push_back(fileError(problem.message(), directory.string()));
    return entries;
}

/// Names in the order of package.order; what it forgets comes behind, what it invents is left out.
std::vector<std::string> PackageLoader::packageOrder(const fs::path& directory, const Entries& entries,
                                                     const syntax::ClassDefinition& package) {
    std::set<std::string> known = entries.directories;
    known.insert(entries.files.begin(), entries.files.end());
    for (const syntax::ClassPtr& nested : package.classes) {
        if (!known.insert(nested->name).second) {
            diagnostics_.push_back(error(phrase("\"{}\" stands in package.mo and in a file of its own", nested->name),
                                         nested->nameSpan, phrase("keep one of the two")));
        }
    }
    std::set<std::string> others;  // constants of the package may be listed too
    for (const syntax::Component& component : package.components) others.insert(component.name);

    const auto warn = [&](Text message, int line, Text hint) {
        Diagnostic diagnostic =
            fileError(std::move(message), (directory / "package.order").string(), line, 0, std::move(hint));
        diagnostic.severity = Severity::Warning;
        diagnostics_.push_back(std::move(diagnostic));
    };
    std::vector<std::string> order;
    std::error_code problem;
    const bool isGiven = fs::exists(directory / "package.order", problem);
    std::istringstream file;
    if (isGiven) {
        Outcome<std::string> text = readRegularFile(directory / "package.order", largestText);
        diagnostics_.insert(diagnostics_.end(), text.diagnostics().begin(), text.diagnostics().end());
        if (text) file.str(std::move(*text));
    }
    std::set<std::string> listed;
    std::string entry;
    for (int line = 1; std::getline(file, entry); ++line) {
        while (!entry.empty() && (entry.back() == '\r' || entry.back() == ' ')) entry.pop_back();
        if (entry.empty() || others.count(entry)) continue;
        if (!known.count(entry)) {
            const std::string near = suggestion(entry, {known.begin(), known.end()});
            warn(phrase("\"{}\" is listed but not there", entry), line,
                 near.empty() ? Text() : phrase("did you mean \"{}\"?", near));
        } else if (!listed.insert(entry).second) {
            warn(phrase("\"{}\" is listed twice", entry), line, {});
        } else {
            order.push_back(entry);
        }
    }
    for (const std::string& name : known) {
        if (listed.count(name)) continue;
        order.push_back(name);
        if (isGiven) warn(phrase("\"{}\" is not listed", name), 0, phrase("add a line with its name"));
    }
    return order;
}

void PackageLoader::loadFile(const fs::path& file, const std::string& scope) {
    if (const auto definition = parseOne(file, file.stem().string(), scope)) add(definition, scope);
}

/// The one class of a file within a package directory; null when it is at fault.
syntax::ClassPtr PackageLoader::parseOne(const fs::path& file, const std::string& expectedName,
                                         const std::string& scope) {
    const SourcePtr source = read(file);
    if (!source) return nullptr;
    const auto parsed = syntax::parse(source);
    diagnostics_.insert(diagnostics_.end(), parsed.diagnostics.begin(), parsed.diagnostics.end());
    if (parsed.definition.classes.empty()) return nullptr;
    const syntax::ClassPtr definition = parsed.definition.classes.front();
    if (parsed.definition.classes.size() > 1) {
        diagnostics_.push_back(error(phrase("a file of a package holds one class"),
                                     parsed.definition.classes[1]->nameSpan,
                                     phrase("give the second class a file of its own")));
    }
    if (!expectedName.empty() && definition->name != expectedName) {
        diagnostics_.push_back(
            error(phrase("the class is called \"{}\", its place on the disk \"{}\"", definition->name, expectedName),
                  definition->nameSpan, phrase("rename one of the two")));
        return nullptr;
    }
    const std::string within = parsed.definition.within ? parsed.definition.within->text() : std::string{};
    if (within != scope) {
        const Span span =
            parsed.definition.within && !within.empty() ? parsed.definition.within->span : Span{source.get(), 0, 0};
        diagnostics_.push_back(
            error(scope.empty() ? phrase("a top package stands within no other, not within \"{}\"", within)
                                : phrase("the file belongs to \"{}\" and must say so", scope),
                  span, scope.empty() ? phrase("write \"within ;\"") : phrase("write \"within {};\"", scope)));
    }
    return definition;
}

SourcePtr PackageLoader::read(const fs::path& file) {
    Outcome<std::string> text = readRegularFile(file, largestText);
    if (!text) {
        diagnostics_.insert(diagnostics_.end(), text.diagnostics().begin(), text.diagnostics().end());
        return nullptr;
    }
    return std::make_shared<const Source>(file.string(), std::move(*text));
}

void PackageLoader::add(const syntax::ClassPtr& definition, const std::string& scope) {
    const std::string name = qualified(scope, definition->name);
    classes_.push_back({name, definition, scope});
    addNested(*definition, name);
}

void PackageLoader::addNested(const syntax::ClassDefinition& definition, const std::string& qualifiedName) {
    for (const syntax::ClassPtr& nested : definition.classes) add(nested, qualifiedName);
}

}  // namespace analogon
