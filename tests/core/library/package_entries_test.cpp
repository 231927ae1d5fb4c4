#include "core/library/package_entries.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/library/library.hpp"

namespace analogon {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class PackageEntries : public testing::Test {
protected:
    PackageEntries() : root_(fs::temp_directory_path() / ("analogon-entries-" + std::to_string(getpid()))) {
        write("Bench 2.0/package.mo",
              "package Bench model Shown end Shown; protected model Hidden end Hidden; end Bench;");
        write("Bench 2.0/Drives/package.mo", "within Bench; package Drives end Drives;");
        write("Bench 2.0/Drives/Drive.mo", "within Bench.Drives; model Drive end Drive;");
        write("Bench 2.0/Drives/notes.txt", "none");
        write("Single.mo", "package Single model Inner end Inner; end Single;");
    }
    ~PackageEntries() override { fs::remove_all(root_); }
    void write(const std::string& file, const std::string& text) const {
        fs::create_directories((root_ / file).parent_path());
        std::ofstream(root_ / file) << text;
    }
    static std::vector<std::string> namesOf(const std::vector<PackageEntry>& entries) {
        std::vector<std::string> names;
        for (const PackageEntry& entry : entries) names.push_back(entry.name);
        return names;
    }

    fs::path root_;
};

TEST_F(PackageEntries, OfASearchedPackageAreItsClassesAndFiles) {
    const Library library = Library().withDirectories({root_});
    const std::vector<PackageEntry> top = packageEntries(library, "Bench");
    EXPECT_THAT(namesOf(top), ElementsAre("Shown", "Drives"));
    ASSERT_NE(top[0].read, nullptr) << "it stands in the text of the package";
    EXPECT_EQ(top[0].read->qualifiedName, "Bench.Shown");
    EXPECT_EQ(top[1].read, nullptr);
    EXPECT_THAT(namesOf(packageEntries(library, "Bench.Drives")), ElementsAre("Drive"));
    EXPECT_THAT(namesOf(packageEntries(library, "Single")), ElementsAre("Inner"));
    EXPECT_THAT(packageEntries(library, "Nowhere"), IsEmpty());
}

TEST_F(PackageEntries, OfTheStudyAreNoFiles) {
    const auto own = Library().withDirectories({root_}).withSource(
        std::make_shared<const Source>("package.mo", "package Bench model Mine end Mine; end Bench;"));
    ASSERT_TRUE(own);
    EXPECT_THAT(namesOf(packageEntries(*own, "Bench")), ElementsAre("Mine"));
}

TEST_F(PackageEntries, OutermostAreThoseOfTheStudyAndOfSearchedDirectories) {
    const char* const was = std::getenv("MODELICAPATH");
    const std::string searched = was ? was : "";
    setenv("MODELICAPATH", root_.c_str(), 1);
    const auto own = Library().withSource(std::make_shared<const Source>("m.mo", "model Mine end Mine;"));
    ASSERT_TRUE(own);
    const std::vector<std::string> names = namesOf(packageEntries(*own, ""));
    if (was)
        setenv("MODELICAPATH", searched.c_str(), 1);
    else
        unsetenv("MODELICAPATH");
    for (const char* name : {"Mine", "Bench", "Single"}) EXPECT_THAT(names, Contains(name));
}

}  // namespace
}  // namespace analogon
