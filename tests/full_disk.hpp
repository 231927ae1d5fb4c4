#pragma once

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/base/outcome.hpp"
#include "tests/tree.hpp"

namespace analogon {

/// A small disk of its own, on which less and less is left free. Root alone can make one.
class SmallDisk : public testing::Test {
protected:
    void SetUp() override {
        place = std::filesystem::temp_directory_path() / ("full-disk-test-" + std::to_string(getpid()));
        std::filesystem::create_directories(place);
        if (mount("tmpfs", place.c_str(), "tmpfs", 0, "size=4m") != 0)
            GTEST_SKIP() << "no small disk can be made here (" << std::strerror(errno) << "): root alone may";
        isMounted = true;
    }
    void TearDown() override {
        if (isMounted) umount2(place.c_str(), MNT_DETACH);
        std::error_code code;
        std::filesystem::remove(place, code);
    }

    /// What `act` gives while no more than so many bytes are free.
    template <class Act>
    auto withRoom(std::uint64_t room, const Act& act) {
        struct statvfs disk {};
        EXPECT_EQ(statvfs(place.c_str(), &disk), 0);
        const std::uint64_t left = disk.f_bavail * disk.f_frsize;
        EXPECT_LT(room, left) << "it was never written";
        std::ofstream(place / "filler", std::ios::binary) << std::string(left - std::min(left, room), '\0');
        auto result = act();
        std::filesystem::remove(place / "filler");
        return result;
    }

    /// Bytes from one try to the next; ANALOGON_DISK_STEP makes it smaller (a page of such a disk is 4096).
    static std::uint64_t stepOf(std::uint64_t usual) {
        const char* const wanted = std::getenv("ANALOGON_DISK_STEP");
        return wanted ? std::clamp<std::uint64_t>(std::strtoull(wanted, nullptr, 10), 512, usual) : usual;
    }

    /// Calls `write` with ever more room, from none on, until it was written twice. `look(whether it was written)`
    /// says whether what is there is whole; nothing else may be there, and what failed must say why.
    template <class Write, class Look>
    void fill(const Write& write, const Look& look, std::uint64_t step = 4096) {
        step = stepOf(step);
        const std::string names = namesBelow(place);
        int failed = 0, written = 0;
        for (std::uint64_t room = 0; written < 2; room += step) {
            SCOPED_TRACE("with room for " + std::to_string(room) + " bytes");
            const auto done = withRoom(room, write);
            ++(done ? written : failed);
            if (!done) {
                const std::string said = format(done.diagnostics());
                EXPECT_TRUE(said.find("the disk may be full") != std::string::npos ||
                            said.find("No space left on device") != std::string::npos)
                    << said;
                EXPECT_EQ(said.find("writing-"), std::string::npos) << "what is asked for is named: " << said;
            }
            look(static_cast<bool>(done));
            ASSERT_EQ(namesBelow(place), names);
            if (HasFailure()) return;
        }
        EXPECT_GT(failed, 1);
    }

    std::filesystem::path place;
    bool isMounted{};
};

}  // namespace analogon
