#include "core/base/file_step.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <iterator>

#include "tests/full_disk.hpp"

namespace analogon {
namespace {

namespace fs = std::filesystem;

TEST(FileStep, CopiesAFileWithItsRightsToANewPlaceAlone) {
    const fs::path place = fs::temp_directory_path() / ("file-step-test-" + std::to_string(getpid()));
    fs::create_directories(place);
    const std::string content(3'000'000, 'x');
    std::ofstream(place / "from") << content;
    fs::permissions(place / "from", fs::perms::owner_read);
    EXPECT_EQ(copyToNew(place / "from", place / "to"), std::error_code());
    EXPECT_EQ(bytesOf(place / "to"), content);
    EXPECT_EQ(fs::status(place / "to").permissions(), fs::perms::owner_read);
    EXPECT_EQ(copyToNew(place / "from", place / "to"), std::errc::file_exists);
    EXPECT_EQ(copyToNew(place / "nothing", place / "new"), std::errc::no_such_file_or_directory);
    ASSERT_EQ(mkfifo((place / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(copyToNew(place / "pipe", place / "new"), std::errc::not_supported);
    EXPECT_FALSE(fs::exists(place / "new"));
    fs::remove_all(place);
}

class FullDisk : public SmallDisk {};

TEST_F(FullDisk, IsTheReasonWhyACopyFails) {
    std::ofstream(place / "from") << std::string(100'000, 'x');
    EXPECT_EQ(withRoom(8192, [&] { return copyToNew(place / "from", place / "to"); }), std::errc::no_space_on_device);
}

}  // namespace
}  // namespace analogon
