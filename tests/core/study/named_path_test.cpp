#include "core/study/named_path.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/study/json_places.hpp"

namespace analogon {
namespace {

namespace fs = std::filesystem;

TEST(NamedPaths, AreAllThatStudyJsonNamesEachWithItsPlace) {
    const auto json = std::make_shared<const Source>("study.json", R"({"format": "analogon-study-1", "class": "M",
      "experiments": [{"name": "a", "role": "fit", "file": "path-1", "time": "t", "inputs": {}, "outputs": {"y": "Y"}},
        {"name": "b", "role": "validate", "file": "path-2", "time": "t", "inputs": {}, "outputs": {"y": "Y"}}],
      "parameters": {}, "library": ["path-3", "path-4"], "report": {"logo": "path-5"}})");
    const Outcome<Study> study = parseStudyJson(json);
    ASSERT_TRUE(study) << format(study.diagnostics());
    const std::vector<NamedPath> paths = namedPaths(*study);
    ASSERT_EQ(paths.size(), 5u);
    for (std::size_t i = 0; i < paths.size(); ++i) {
        EXPECT_EQ(paths[i].path, "path-" + std::to_string(i + 1));
        EXPECT_EQ(JsonPlaces(json).value(paths[i].pointer).text(), "\"" + paths[i].path + "\"");
        EXPECT_EQ(paths[i].key, i < 2   ? NamedPath::Key::Measurement
                                : i < 4 ? NamedPath::Key::Library
                                        : NamedPath::Key::Logo);
    }
    EXPECT_EQ(paths[1].experiment, "b");
}

TEST(NamedPaths, StayWithinADirectoryAlsoWhereLinksLeadOutOfIt) {
    const fs::path root = fs::temp_directory_path() / ("named-path-test-" + std::to_string(getpid()));
    const fs::path study = root / "study";
    fs::create_directories(study / "data");
    std::ofstream(root / "secret.csv") << "t,u\n";
    std::ofstream(study / "data" / "run.csv") << "t,u\n";
    fs::create_symlink(root / "secret.csv", study / "linked.csv");
    fs::create_directory_symlink(root, study / "around");
    fs::create_symlink("data/run.csv", study / "inner.csv");
    for (const char* inside :
         {"data/run.csv", "./data/run.csv", "data/../data/run.csv", "inner.csv", "missing.csv", "."})
        EXPECT_TRUE(staysWithin(study, inside)) << inside;
    for (const char* outside : {"/etc/passwd", "../secret.csv", "data/../../secret.csv", "linked.csv",
                                "around/secret.csv", "around/missing.csv", "..", ""})
        EXPECT_FALSE(staysWithin(study, outside)) << outside;
    fs::remove_all(root);
}

}  // namespace
}  // namespace analogon
