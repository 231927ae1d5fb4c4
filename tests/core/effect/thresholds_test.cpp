#include "core/effect/thresholds.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

namespace analogon {
namespace {

namespace fs = std::filesystem;

TEST(Thresholds, HaveAUnitAMeaningAndAnOrigin) {
    std::set<std::pair<std::string_view, std::string_view>> names;
    for (const ThresholdRow& row : thresholds()) {
        EXPECT_TRUE(names.emplace(row.group, row.name).second) << row.group << "." << row.name << " stands twice";
        EXPECT_TRUE(std::isfinite(row.value)) << row.name;
        EXPECT_FALSE(row.unit.empty() || row.meaning.empty() || row.origin.empty() || row.guard.empty())
            << row.group << "." << row.name;
    }
    EXPECT_GT(names.size(), 100u);
}

TEST(Thresholds, AreAllUsed) {
    std::set<std::string> words;
    for (const auto& file : fs::recursive_directory_iterator(fs::path(ANALOGON_ROOT) / "core/effect")) {
        const fs::path& path = file.path();
        if (path.extension() != ".cpp" && path.extension() != ".hpp") continue;
        std::ifstream source(path);
        std::string word;
        for (char c; source.get(c);) {
            if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
                word += c;
                continue;
            }
            if (!word.empty()) words.insert(std::exchange(word, {}));
        }
    }
    for (const ThresholdRow& row : thresholds())
        EXPECT_TRUE(words.contains(std::string(row.name))) << row.group << "." << row.name;
}

TEST(Thresholds, AreAtMostAHundredAndFifty) { EXPECT_LE(thresholds().size(), 150u); }

TEST(Thresholds, AreGuardedByTestsThatExist) {
    std::string sources;
    for (const auto& file : fs::recursive_directory_iterator(fs::path(ANALOGON_ROOT) / "tests/core/effect")) {
        if (file.path().extension() != ".cpp") continue;
        std::ifstream source(file.path());
        sources.append(std::istreambuf_iterator<char>(source), {});
    }
    for (const ThresholdRow& row : thresholds()) {
        const std::size_t dot = row.guard.find('.');
        ASSERT_NE(dot, std::string::npos) << row.group << "." << row.name;
        const std::string test =
            std::string(row.guard.substr(0, dot)) + ", " + std::string(row.guard.substr(dot + 1)) + ")";
        EXPECT_NE(sources.find("(" + test), std::string::npos) << row.group << "." << row.name << ": " << row.guard;
    }
}

}  // namespace
}  // namespace analogon
