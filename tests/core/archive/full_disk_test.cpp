/// What is left where a disk runs full at any moment of a write.
#include "tests/full_disk.hpp"

#include "core/archive/archive.hpp"
#include "core/study/results.hpp"
#include "core/study/results_record.hpp"

namespace analogon {
namespace {

namespace fs = std::filesystem;

class FullDisk : public SmallDisk {
protected:
    void SetUp() override {
        SmallDisk::SetUp();
        if (!isMounted) return;
        Outcome<Study> read = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
        ASSERT_TRUE(read);
        one = *read;
        for (StudyExperiment& e : one.experiments)
            one.tables[e.file] = std::make_shared<const Table>(one.tables.at(e.file)->slice(0, 200));
        one.directory.clear();
        other = one;
        other.models["model.mo"] += "// other\n";
    }
    static bool isOther(const Study& study) { return study.models.at("model.mo").ends_with("// other\n"); }

    Study one, other;
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

/// As a study is composed, or saved under a new name.
TEST_F(FullDisk, LeavesNoNewDirectory) {
    const fs::path directory = place / "new";
    fill([&] { return saveStudy(one, directory); },
         [&](bool isWritten) {
             EXPECT_EQ(fs::exists(directory), isWritten);
             fs::remove_all(directory);
         });
}

/// A temporary directory on the disk that is full is no other case.
TEST_F(FullDisk, LeavesAnArchiveAsItWasWhereTemporaryFilesHaveNoRoomEither) {
    const fs::path file = place / "a.analogon";
    ASSERT_TRUE(saveStudy(one, file));
    const char* const usual = std::getenv("TMPDIR");
    const std::string elsewhere = usual ? usual : "";
    setenv("TMPDIR", place.c_str(), 1);
    bool isNew = false;
    std::string before = bytesOf(file);
    fill([&] { return saveStudy(isNew ? one : other, file); },
         [&](bool isWritten) {
             const std::string now = bytesOf(file);
             EXPECT_EQ(now != before, isWritten);
             before = now;
             if (isWritten) isNew = !isNew;
         });
    usual ? setenv("TMPDIR", elsewhere.c_str(), 1) : unsetenv("TMPDIR");
    const auto opened = openStudy(file);
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_EQ(isOther(opened->study), isNew);
}

/// Larger than what is tried out before the work, so that the disk runs full at each of their files. What is there is
/// known as results: the next run replaces it.
TEST_F(FullDisk, LeavesResultsAsTheyWere) {
    RunResult first, second;
    for (Study* study : {&one, &other}) study->models["more.mo"] = "// " + std::string(300'000, 'x') + "\n";
    first.completed = one;
    second.completed = other;
    for (const bool isShared : {false, true}) {
        SCOPED_TRACE(isShared);
        const fs::path out = place / (isShared ? "shared" : "out");
        ASSERT_TRUE(writeResults(first, "fit", out));
        if (isShared) std::ofstream(out / "notes.txt") << "mine";  // then they are replaced one by one
        bool isNew = false;
        fill([&] { return writeResults(isNew ? first : second, "fit", out); },
             [&](bool isWritten) {
                 const auto study = readStudy(out / "study");
                 ASSERT_TRUE(study) << format(study.diagnostics());
                 if (isWritten) isNew = !isNew;
                 EXPECT_EQ(isOther(*study), isNew);
                 EXPECT_TRUE(holdsResults(out));
             });
        fs::remove_all(out);
    }
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
