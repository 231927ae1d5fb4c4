#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

/// Sources of one library are compiled several at once (CMAKE_UNITY_BUILD): a name of one file's unnamed namespace is
/// then seen by the next. Two equal ones are refused by the compiler, but of two functions of one name with different
/// parameters the other file's may be the better match, and nobody is told. Hence no two have a name in common, but for
/// those of packaging/cmake/alone.txt, which are compiled one by one.
namespace {

namespace fs = std::filesystem;

using Meanings = std::map<std::string, std::string>;  // of each name: what it stands for, where that can be compared

/// What a line that begins in the first column defines.
std::optional<std::pair<std::string, std::string>> definitionIn(const std::string& line) {
    static const std::regex alias(R"(^using (\w+) = (.*);)");
    static const std::regex type(R"(^(?:struct|class|enum class|enum|union) (\w+))");
    static const std::regex function(R"(^[^=({]*?\b(\w+)\s*\()");
    static const std::regex variable(R"(^[\w:<>,* ]+?[ *&](\w+)(?:\[[^\]]*\])*\s*(?:=|\{|;))");
    std::smatch found;
    if (std::regex_search(line, found, alias)) return std::pair{found[1].str(), found[2].str()};
    if (line.rfind("using ", 0) == 0 || line.rfind("template", 0) == 0) return std::nullopt;
    for (const std::regex* each : {&type, &function, &variable})
        if (std::regex_search(line, found, *each)) return std::pair{found[1].str(), std::string{}};
    return std::nullopt;
}

/// The names of the unnamed namespaces of a source in the layout of packaging/check-format.sh.
Meanings unnamedNamesIn(std::istream& source) {
    Meanings names;
    bool isUnnamed = false;
    for (std::string line; std::getline(source, line);) {
        if (line.rfind("namespace {", 0) == 0) isUnnamed = true;
        if (line.rfind("}  // namespace", 0) == 0) isUnnamed = false;
        const bool isDefinition = isUnnamed && !line.empty() && std::isalpha(static_cast<unsigned char>(line[0])) &&
                                  line.rfind("namespace", 0) != 0 && line.rfind("TEST", 0) != 0;
        if (!isDefinition) continue;
        if (const auto definition = definitionIn(line)) names.insert(*definition);
    }
    return names;
}

/// One message for each name that a source has in common with one before it, and does not mean the same by.
std::vector<std::string> inCommon(const std::map<std::string, Meanings>& sources) {
    std::map<std::string, std::pair<std::string, std::string>> first;  // file and meaning of each name
    std::vector<std::string> messages;
    for (const auto& [file, names] : sources)
        for (const auto& [name, meaning] : names) {
            const auto [at, isNew] = first.insert({name, {file, meaning}});
            const auto& [other, otherMeaning] = at->second;
            if (!isNew && (meaning.empty() || meaning != otherMeaning))
                messages.push_back(name + " is in the unnamed namespaces of " + other + " and " + file);
        }
    return messages;
}

std::set<std::string> compiledAlone() {
    std::ifstream list(fs::path(ANALOGON_ROOT) / "packaging/cmake/alone.txt");
    std::set<std::string> files;
    for (std::string line; std::getline(list, line);)
        if (!line.empty() && line[0] != '#') files.insert(line);
    return files;
}

/// The sources below a folder that are compiled at once with others.
std::map<std::string, Meanings> sourcesBelow(const fs::path& folder, const std::set<std::string>& alone) {
    std::map<std::string, Meanings> sources;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string file = fs::relative(entry.path(), ANALOGON_ROOT).generic_string();
        if (entry.path().extension() != ".cpp" || alone.count(file)) continue;
        std::ifstream stream(entry.path());
        sources[file] = unnamedNamesIn(stream);
    }
    return sources;
}

std::vector<fs::path> libraries() {
    const fs::path root = ANALOGON_ROOT;
    std::vector<fs::path> folders{root / "app/analogon-cli", root / "ui"};
    for (const auto& entry : fs::directory_iterator(root / "core"))
        if (entry.is_directory()) folders.push_back(entry.path());
    return folders;
}

TEST(CompiledAtOnce, SourcesOfALibraryHaveNoUnnamedNameInCommon) {
    const std::set<std::string> alone = compiledAlone();
    std::size_t names = 0;
    for (const fs::path& folder : libraries()) {
        const auto sources = sourcesBelow(folder, alone);
        for (const auto& [file, found] : sources) names += found.size();
        for (const std::string& message : inCommon(sources))
            ADD_FAILURE() << message << ": name one of them by what sets it apart, or add a file to alone.txt";
    }
    EXPECT_GT(names, 1000u) << "the sources were not read";
    for (const std::string& file : alone) EXPECT_TRUE(fs::exists(fs::path(ANALOGON_ROOT) / file)) << file;
}

TEST(CompiledAtOnce, NamesOfUnnamedNamespacesAreRead) {
    std::istringstream source(
        "int seen();\nnamespace {\nstruct A {\n    int b;\n};\nusing C = int;\nusing std::move;\n"
        "const std::vector<int>& d(int e) {\nconstexpr double f = 1, g{2};\ntemplate <class T>\nT h(T i) {\n"
        "const char* const j[] = {\n}  // namespace\nint outside{};\n");
    std::string names;
    for (const auto& [name, meaning] : unnamedNamesIn(source)) names += name + " ";
    EXPECT_EQ(names, "A C d f h j ");
}

TEST(CompiledAtOnce, ANameInCommonIsToldUnlessBothMeanTheSame) {
    EXPECT_TRUE(inCommon({{"a.cpp", {{"f", ""}, {"T", "int"}}}, {"b.cpp", {{"g", ""}, {"T", "int"}}}}).empty());
    EXPECT_EQ(inCommon({{"a.cpp", {{"f", ""}, {"T", "int"}}}, {"b.cpp", {{"f", ""}, {"T", "long"}}}}),
              (std::vector<std::string>{"T is in the unnamed namespaces of a.cpp and b.cpp",
                                        "f is in the unnamed namespaces of a.cpp and b.cpp"}));
}

}  // namespace
