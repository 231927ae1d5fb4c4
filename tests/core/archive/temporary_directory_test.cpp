#include "core/archive/temporary_directory.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

namespace analogon {
namespace {

namespace fs = std::filesystem;

class TemporaryDirectories : public testing::Test {
protected:
    void SetUp() override {
        place = fs::temp_directory_path() / ("temporary-directory-test-" + std::to_string(getpid()));
        fs::create_directories(place);
        if (const char* given = std::getenv("TMPDIR")) before = given;
        setenv("TMPDIR", place.c_str(), 1);
    }
    void TearDown() override {
        before.empty() ? unsetenv("TMPDIR") : setenv("TMPDIR", before.c_str(), 1);
        fs::remove_all(place);
    }
    fs::path place;
    std::string before;
};

/// Names as this program gave them to its directories: with the number of a process that is no more, or with digits.
TEST_F(TemporaryDirectories, LeaveEveryOtherDirectoryAloneWhateverItsName) {
    for (const char* name : {"analogon-study-2026-11-bench", "analogon-study-999999999-AbCdEf", "analogon-study-x"}) {
        fs::create_directories(place / name);
        fs::create_directories(place / (name + std::string("-full")));
        std::ofstream(place / (name + std::string("-full")) / "work.csv") << "t,y\n0,1\n";
    }
    const std::size_t entries = static_cast<std::size_t>(
        std::distance(fs::recursive_directory_iterator(place), fs::recursive_directory_iterator{}));
    { ASSERT_TRUE(TemporaryDirectory::make()); }
    EXPECT_EQ(std::distance(fs::recursive_directory_iterator(place), fs::recursive_directory_iterator{}),
              static_cast<std::ptrdiff_t>(entries));
}

TEST_F(TemporaryDirectories, OfAKilledProcessAreRemovedByTheNextOne) {
    const pid_t child = fork();
    if (child == 0) {
        const auto made = TemporaryDirectory::make();
        std::ofstream((*made)->path() / "model.mo") << "model M\nend M;\n";
        raise(SIGKILL);
    }
    waitpid(child, nullptr, 0);
    ASSERT_FALSE(fs::is_empty(place));
    {
        const auto made = TemporaryDirectory::make();
        ASSERT_TRUE(made);
        EXPECT_TRUE(fs::is_empty((*made)->path()));
        EXPECT_EQ(std::distance(fs::directory_iterator(place), fs::directory_iterator{}), 1);
    }
    EXPECT_TRUE(fs::is_empty(place));
}

}  // namespace
}  // namespace analogon
