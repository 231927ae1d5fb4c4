#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

/// Reads every `#include "core/…"`, "ui/…" and "app/…" and holds it against the arrows in architecture.txt.
namespace {

namespace fs = std::filesystem;

using Arrows = std::map<std::string, std::set<std::string>>;

struct Include {
    std::string file;  // relative to the root
    int line{};
    std::string target;
};

fs::path root() { return ANALOGON_ROOT; }

Arrows readArrows(std::istream& text) {
    Arrows arrows;
    for (std::string line; std::getline(text, line);) {
        line = line.substr(0, line.find('#'));
        const std::size_t colon = line.find(':');
        if (colon == std::string::npos) continue;
        std::istringstream name(line.substr(0, colon)), targets(line.substr(colon + 1));
        std::string folder;
        name >> folder;
        std::set<std::string>& allowed = arrows[folder];
        for (std::string target; targets >> target;) allowed.insert(target);
    }
    return arrows;
}

/// "core/syntax" of "core/syntax/lexer.cpp"; "app" of "app/main.cpp".
std::string folderOf(const std::string& file) { return fs::path(file).parent_path().generic_string(); }

bool isAllowed(const Arrows& arrows, const std::string& from, const std::string& to) {
    if (from == to) return true;
    const auto line = arrows.find(from);
    if (line == arrows.end()) return false;
    if (line->second.contains(to)) return true;
    for (const std::string& pattern : line->second)
        if (pattern.ends_with("/*") && (to + "/").starts_with(pattern.substr(0, pattern.size() - 1))) return true;
    return false;
}

std::vector<Include> includesOf(const std::string& file, std::istream& text) {
    static const std::regex pattern(R"re(^\s*#\s*include\s*"((core|ui|app)/[^"]+)")re");
    std::vector<Include> includes;
    int number = 0;
    std::smatch match;
    for (std::string line; std::getline(text, line);) {
        ++number;
        if (std::regex_search(line, match, pattern)) includes.push_back({file, number, match[1].str()});
    }
    return includes;
}

std::vector<fs::path> sourceFiles() {
    std::vector<fs::path> files;
    for (const char* top : {"core", "ui", "app"}) {
        if (!fs::exists(root() / top)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(root() / top)) {
            const std::string extension = entry.path().extension().string();
            if (extension == ".hpp" || extension == ".cpp") files.push_back(entry.path());
        }
    }
    return files;
}

std::vector<std::string> violations(const Arrows& arrows, const std::vector<Include>& includes) {
    std::vector<std::string> found;
    for (const Include& i : includes) {
        const std::string from = folderOf(i.file), to = folderOf(i.target);
        if (!isAllowed(arrows, from, to))
            found.push_back(i.file + ":" + std::to_string(i.line) + ": " + from + " may not include from " + to);
    }
    return found;
}

Arrows declaredArrows() {
    std::ifstream text(root() / "tests/architecture.txt");
    return readArrows(text);
}

TEST(Architecture, IncludesFollowTheDeclaredArrows) {
    const Arrows arrows = declaredArrows();
    ASSERT_FALSE(arrows.empty());
    std::vector<Include> includes;
    for (const fs::path& file : sourceFiles()) {
        std::ifstream text(file);
        const auto found = includesOf(fs::relative(file, root()).generic_string(), text);
        includes.insert(includes.end(), found.begin(), found.end());
    }
    ASSERT_GT(includes.size(), 50u) << "the sources were not found";
    for (const std::string& violation : violations(arrows, includes)) ADD_FAILURE() << violation;
}

TEST(Architecture, EveryFolderWithSourcesHasItsLine) {
    const Arrows arrows = declaredArrows();
    std::set<std::string> missing;
    for (const fs::path& file : sourceFiles()) {
        const std::string folder = folderOf(fs::relative(file, root()).generic_string());
        if (!arrows.contains(folder)) missing.insert(folder);
    }
    for (const std::string& folder : missing) ADD_FAILURE() << folder << " has no line in tests/architecture.txt";
}

TEST(Architecture, DeclaredArrowsHaveNoCircle) {
    const Arrows arrows = declaredArrows();
    for (const auto& [folder, allowed] : arrows)
        for (const auto& [other, back] : arrows)
            EXPECT_FALSE(folder < other && isAllowed(arrows, folder, other) && isAllowed(arrows, other, folder))
                << folder << " and " << other << " may include each other";
}

TEST(Architecture, CoreNeverReachesTheScreen) {
    for (const auto& [folder, allowed] : declaredArrows()) {
        if (!folder.starts_with("core")) continue;
        for (const std::string& target : allowed) EXPECT_TRUE(target.starts_with("core/")) << folder << ": " << target;
    }
}

TEST(Architecture, ABackwardIncludeIsNamedWithFileAndLine) {
    std::istringstream rules("core/base:\ncore/syntax: core/base  # tree\napp: core/*\n");
    std::istringstream source(
        "#pragma once\n#include <map>\n#include \"core/syntax/ast.hpp\"\n#include \"ui/a.hpp\"\n");
    const Arrows arrows = readArrows(rules);
    const std::vector<std::string> found = violations(arrows, includesOf("core/base/x.hpp", source));
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0], "core/base/x.hpp:3: core/base may not include from core/syntax");
    EXPECT_EQ(found[1], "core/base/x.hpp:4: core/base may not include from ui");
    EXPECT_TRUE(violations(arrows, {{"core/syntax/y.cpp", 1, "core/base/source.hpp"}}).empty());
    EXPECT_TRUE(violations(arrows, {{"app/main.cpp", 1, "core/syntax/ast.hpp"}}).empty());
}

}  // namespace
