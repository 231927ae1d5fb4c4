#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path& root() {
    static const fs::path path(ANALOGON_ROOT);
    return path;
}

std::string textOf(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

std::vector<fs::path> documents() {
    std::vector<fs::path> files;
    for (const char* name : {"README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"}) files.push_back(root() / name);
    for (const char* folder : {"docs", "tests"})
        for (const auto& file : fs::recursive_directory_iterator(root() / folder))
            if (file.path().extension() == ".md") files.push_back(file.path());
    return files;
}

/// Whether a path is there, as a folder, a file, or a header and a source without their endings.
bool isThere(const std::string& path) {
    for (const char* ending : {"", ".hpp", ".cpp"})
        if (fs::exists(root() / (path + ending))) return true;
    return false;
}

TEST(Documents, NameOnlyFilesThatAreThere) {
    const std::regex path("`((?:core|ui|app|tests|packaging|resources|docs|examples)/[A-Za-z0-9_./-]+)`");
    const std::regex placeholder(
        "/(STAGE|NAME|DOMAIN)\\b|/(STAGE|NAME|DOMAIN)_test|/Name\\.mo|/x(_test)?(\\.cpp)?$");  // of a recipe
    std::size_t count = 0;
    for (const fs::path& document : documents()) {
        const std::string text = textOf(document);
        for (std::sregex_iterator at(text.begin(), text.end(), path), end; at != end; ++at, ++count) {
            const std::string named = (*at)[1];
            EXPECT_TRUE(std::regex_search(named, placeholder) || isThere(named))
                << document.filename() << ": " << named;
        }
    }
    EXPECT_GT(count, 100u);
}

TEST(Documents, NameOnlyTestsThatAreThere) {
    const std::regex guard("`(\\w+)\\.(\\w+)` in `(tests/[^`]+)`");
    std::size_t count = 0;
    for (const fs::path& document : documents()) {
        const std::string text = textOf(document);
        for (std::sregex_iterator at(text.begin(), text.end(), guard), end; at != end; ++at, ++count) {
            const std::string name = (*at)[1].str() + ", " + (*at)[2].str() + ")";
            EXPECT_NE(textOf(root() / (*at)[3].str()).find(name), std::string::npos)
                << document.filename() << ": " << (*at)[0];
        }
    }
    EXPECT_GT(count, 50u);
}

}  // namespace
