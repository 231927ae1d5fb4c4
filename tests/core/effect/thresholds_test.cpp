#include "core/effect/thresholds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace analogon {
namespace {

namespace fs = std::filesystem;

TEST(Thresholds, HaveAUnitAMeaningAndAnOrigin) {
    std::set<std::pair<std::string_view, std::string_view>> names;
    for (const ThresholdRow& row : thresholds()) {
        EXPECT_TRUE(names.emplace(row.group, row.name).second) << row.group << "." << row.name << " stands twice";
        EXPECT_TRUE(std::isfinite(row.value)) << row.name;
        EXPECT_FALSE(row.unit.empty() || row.meaning.empty() || row.origin.empty()) << row.group << "." << row.name;
    }
    EXPECT_GT(names.size(), 100u);
}

TEST(Thresholds, AreAllUsed) {
    std::string sources;
    for (const auto& file : fs::recursive_directory_iterator(fs::path(ANALOGON_ROOT) / "core/effect")) {
        const fs::path& path = file.path();
        if (path.extension() != ".cpp" && path.extension() != ".hpp") continue;
        std::ostringstream text;
        text << std::ifstream(path).rdbuf();
        sources += text.str();
    }
    for (const ThresholdRow& row : thresholds()) {
        const std::regex word("\\b" + std::string(row.name) + "\\b");
        EXPECT_TRUE(std::regex_search(sources, word)) << row.group << "." << row.name;
    }
}

}  // namespace
}  // namespace analogon
