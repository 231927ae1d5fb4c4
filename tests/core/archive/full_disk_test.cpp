/// What is left where a disk runs full at any moment of a write.
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "core/archive/archive.hpp"
#include "core/study/results.hpp"
#include "tests/tree.hpp"

namespace analogon {
namespace {

namespace fs = std::filesystem;

/// A small disk of its own, on which less and less is left free.
class FullDisk : public testing::Test {
protected:
    void SetUp() override {
        place = fs::temp_directory_path() / ("full-disk-test-" + std::to_string(getpid()));
        fs::create_directories(place);
        if (mount("tmpfs", place.c_str(), "tmpfs", 0, "size=4m") != 0)
            GTEST_SKIP() << "no small disk can be made here (" << std::strerror(errno) << "): root alone may";
        isMounted = true;
        Outcome<Study> read = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
        ASSERT_TRUE(read);
        one = *read;
        for (StudyExperiment& e : one.experiments)
            one.tables[e.file] = std::make_shared<const Table>(one.tables.at(e.file)->slice(0, 200));
        one.directory.clear();
        other = one;
        other.models["model.mo"] += "// other\n";
    }
    void TearDown() override {
        if (isMounted) umount2(place.c_str(), MNT_DETACH);
        std::error_code code;
        fs::remove(place, code);
    }
    /// Calls `write` with ever less free, until even the first byte has no room. `look` says whether what is there is
    /// whole, and gives its version; nothing else may be there.
    template <class Write, class Look>
    void fill(const Write& write, const Look& look) {
        const char* wanted = std::getenv("ANALOGON_DISK_STEP");
        const std::uint64_t step = wanted ? std::strtoull(wanted, nullptr, 10) : 4096;
        const std::string names = namesBelow(place);
        int failed = 0, written = 0;
        for (std::uint64_t room = 0; written < 2; room += step) {
            struct statvfs disk {};
            ASSERT_EQ(statvfs(place.c_str(), &disk), 0);
            const std::uint64_t left = disk.f_bavail * disk.f_frsize;
            ASSERT_LT(room, left) << "it was never written";
            std::ofstream(place / "filler", std::ios::binary) << std::string(left - room, '\0');
            const Outcome<Done> done = write();
            fs::remove(place / "filler");
            ++(done ? written : failed);
            look(static_cast<bool>(done));
            ASSERT_EQ(namesBelow(place), names) << "with room for " << room << " bytes";
            if (HasFatalFailure()) return;
        }
        EXPECT_GT(failed, 1);
    }
    static bool isOther(const Study& study) { return study.models.at("model.mo").ends_with("// other\n"); }

    Study one, other;
    fs::path place;
    bool isMounted{};
};

TEST_F(FullDisk, LeavesAnArchiveAsItWas) {
    const fs::path file = place / "a.analogon";
    ASSERT_TRUE(saveStudy(one, file));
    bool isNew = false;
    fill([&] { return saveStudy(isNew ? one : other, file); },
         [&](bool isWritten) {
             const auto opened = openStudy(file);
             ASSERT_TRUE(opened) << format(opened.diagnostics());
             if (isWritten) isNew = !isNew;
             EXPECT_EQ(isOther(opened->study), isNew);
         });
}

TEST_F(FullDisk, LeavesADirectoryAsItWas) {
    const fs::path directory = place / "study";
    ASSERT_TRUE(writeStudy(one, directory));
    bool isNew = false;
    fill([&] { return writeStudy(isNew ? one : other, directory); },
         [&](bool isWritten) {
             const auto study = readStudy(directory);
             ASSERT_TRUE(study) << format(study.diagnostics());
             if (isWritten) isNew = !isNew;
             EXPECT_EQ(isOther(*study), isNew);
         });
}

TEST_F(FullDisk, LeavesResultsAsTheyWere) {
    RunResult first, second;
    first.completed = one;
    second.completed = other;
    ASSERT_TRUE(writeResults(first, "fit", place / "out"));
    bool isNew = false;
    fill([&] { return writeResults(isNew ? first : second, "fit", place / "out"); },
         [&](bool isWritten) {
             const auto study = readStudy(place / "out" / "study");
             ASSERT_TRUE(study) << format(study.diagnostics());
             if (isWritten) isNew = !isNew;
             EXPECT_EQ(isOther(*study), isNew);
         });
}

TEST_F(FullDisk, UnpacksAllOrNothing) {
    const fs::path file = fs::temp_directory_path() / ("full-disk-test-" + std::to_string(getpid()) + ".analogon");
    ASSERT_TRUE(saveStudy(one, file));
    fill([&] { return unpackArchive(file, place / "out"); },
         [&](bool isWritten) {
             EXPECT_EQ(fs::exists(place / "out"), isWritten);
             fs::remove_all(place / "out");
         });
    fs::remove(file);
}

}  // namespace
}  // namespace analogon
