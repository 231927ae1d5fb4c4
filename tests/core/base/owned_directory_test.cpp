#include "core/base/owned_directory.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "tests/kills.hpp"

namespace analogon {
namespace {

namespace fs = std::filesystem;

constexpr const char* prefix = "own-";

class OwnedDirectories : public testing::Test {
protected:
    void SetUp() override {
        place = fs::temp_directory_path() / ("owned-directory-test-" + std::to_string(getpid()));
        fs::remove_all(place);
        fs::create_directories(place);
    }
    void TearDown() override { fs::remove_all(place); }
    std::size_t entries() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(place), fs::directory_iterator{}));
    }
    /// What a process leaves that makes one, puts a file into it and is killed.
    fs::path leftover() const {
        int ends[2];
        EXPECT_EQ(pipe(ends), 0);
        const pid_t child = fork();
        if (child == 0) {
            const auto made = OwnedDirectory::make(place, prefix);
            std::ofstream(made->path() / "file") << "content";
            const std::string path = made->path().string();
            if (write(ends[1], path.data(), path.size()) < 0) _exit(1);
            raise(SIGKILL);
        }
        waitpid(child, nullptr, 0);
        std::string path(4096, '\0');
        path.resize(static_cast<std::size_t>(read(ends[0], path.data(), path.size())));
        close(ends[0]);
        close(ends[1]);
        return path;
    }
    fs::path place;
};

TEST_F(OwnedDirectories, AreThereAsLongAsTheyAreHeldAndForTheirOwnerAlone) {
    fs::path path;
    {
        const auto made = OwnedDirectory::make(place, prefix);
        ASSERT_TRUE(made) << format(made.diagnostics());
        path = made->path();
        EXPECT_EQ(fs::status(path).permissions() & fs::perms::all, fs::perms::owner_all);
        fs::create_directories(path / "a" / "b");
        std::ofstream(path / "a" / "b" / "file") << "content";
    }
    EXPECT_FALSE(fs::exists(path));
    EXPECT_EQ(entries(), 0u);
}

TEST_F(OwnedDirectories, OfTheDeadAreRemovedAndOfTheLivingNot) {
    const fs::path dead = leftover();
    ASSERT_TRUE(fs::exists(dead / "file"));
    const auto alive = OwnedDirectory::make(place, prefix);
    ASSERT_TRUE(alive);
    EXPECT_FALSE(fs::exists(dead));
    removeAbandoned(place, prefix);
    EXPECT_TRUE(fs::exists(alive->path())) << "its lock is held";
    EXPECT_FALSE(OwnedDirectory::adopt(alive->path()));
}

TEST_F(OwnedDirectories, AreNotToldByTheirNameOrByWhatSomebodyElsePutsThere) {
    const fs::path dead = leftover(), elsewhere = place / "elsewhere";
    fs::rename(dead, elsewhere);
    fs::create_directory_symlink(elsewhere, place / "own-link");
    fs::create_directories(place / "own-empty");
    fs::create_directories(place / "own-full");
    std::ofstream(place / "own-full" / "work") << "content";
    fs::create_directories(place / "own-other" / ".analogon-owned");
    fs::create_directories(place / "own-marked");
    std::ofstream(place / "own-marked" / ".analogon-owned") << "another text";
    fs::create_directories(place / "own-unmarked");
    std::ofstream(place / "own-unmarked" / ".analogon-owned");
    std::ofstream(place / "own-file") << "content";
    ASSERT_EQ(mkfifo((place / "own-fifo").c_str(), 0600), 0);
    fs::create_directories(place / "own-piped");
    ASSERT_EQ(mkfifo((place / "own-piped" / ".analogon-owned").c_str(), 0600), 0);
    const std::size_t before = entries();
    removeAbandoned(place, prefix);
    EXPECT_EQ(entries(), before);
    EXPECT_TRUE(fs::exists(elsewhere / "file")) << "a link is not followed";
    EXPECT_TRUE(fs::exists(place / "own-full" / "work"));
}

TEST_F(OwnedDirectories, CopiedBySomebodyBelongToThem) {
    const fs::path dead = leftover(), copy = place / "own-copy", moved = place / "own-moved";
    ASSERT_EQ(std::system(("cp -a '" + dead.string() + "' '" + copy.string() + "'").c_str()), 0);
    struct stat whole {
    }, copied{};
    ASSERT_EQ(stat((dead / ".analogon-owned").c_str(), &whole), 0);
    ASSERT_EQ(stat((copy / ".analogon-owned").c_str(), &copied), 0);
    ASSERT_EQ(copied.st_size, whole.st_size) << "the marker is in the copy, too";
    fs::rename(dead, moved);
    removeAbandoned(place, prefix);
    EXPECT_TRUE(fs::exists(copy / "file"));
    EXPECT_FALSE(OwnedDirectory::adopt(copy));
    EXPECT_TRUE(fs::exists(copy / "file"));
    EXPECT_FALSE(fs::exists(moved)) << "one that was moved is still ours";
}

/// Ours was moved away while it was in use, and something else put in its place.
TEST_F(OwnedDirectories, AreNotTakenForWhatLiesInTheirPlace) {
    {
        const auto made = OwnedDirectory::make(place, prefix);
        ASSERT_TRUE(made);
        fs::rename(made->path(), place / "elsewhere");
        fs::create_directories(made->path());
        std::ofstream(made->path() / "file") << "mine";
        std::ofstream(made->path() / ".analogon-owned") << "mine";
    }
    EXPECT_EQ(entries(), 2u);
    EXPECT_FALSE(OwnedDirectory::adopt(place / "elsewhere")->path().empty()) << "the dead one is known where it is";
    EXPECT_EQ(entries(), 1u);
}

TEST_F(OwnedDirectories, OfAnotherUserStay) {
    if (geteuid() != 0) GTEST_SKIP() << "only root can make something belong to somebody else";
    const fs::path directory = leftover();
    ASSERT_EQ(chown(directory.c_str(), 65534, 65534), 0);
    const fs::path file = leftover();
    ASSERT_EQ(chown((file / ".analogon-owned").c_str(), 65534, 65534), 0);
    removeAbandoned(place, prefix);
    EXPECT_TRUE(fs::exists(directory / "file"));
    EXPECT_TRUE(fs::exists(file / "file"));
}

TEST_F(OwnedDirectories, LeaveNothingWhereverTheirMakerIsKilled) {
    const auto make = [&] { (void)OwnedDirectory::make(place, prefix); };
    bool isOdd = false;  // there are no two versions to be told apart
    (void)killWhileSaving(11, make, [&] {
        removeAbandoned(place, prefix);
        EXPECT_EQ(entries(), 0u);
        return isOdd = !isOdd;
    });
}

TEST_F(OwnedDirectories, AreMadeByManyAtOnce) {
    std::vector<std::thread> threads;
    std::atomic<int> failed{0};
    for (int t = 0; t < 8; ++t)
        threads.emplace_back([&] {
            for (int i = 0; i < 50; ++i) {
                const auto made = OwnedDirectory::make(place, prefix);
                if (!made || !std::ofstream(made->path() / "file")) ++failed;
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(failed, 0);
    EXPECT_EQ(entries(), 0u);
}

TEST_F(OwnedDirectories, SayWhyNoneCanBeMade) {
    const auto nowhere = OwnedDirectory::make(place / "nowhere", prefix);
    ASSERT_FALSE(nowhere);
    EXPECT_NE(nowhere.diagnostics().front().message.find("No such file or directory"), std::string::npos);
}

}  // namespace
}  // namespace analogon
