#include "core/report/logo.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace analogon {
namespace {

namespace fs = std::filesystem;

class Logo : public ::testing::Test {
protected:
    Outcome<std::string> of(const std::string& bytes) const {
        std::ofstream(file_, std::ios::binary) << bytes;
        return logoUri(file_, "logo.png");
    }
    void TearDown() override { fs::remove(file_); }

    const fs::path file_ = fs::temp_directory_path() / ("logo-test-" + std::to_string(getpid()));
};

TEST_F(Logo, IsEmbeddedAsWhatItsContentIs) {
    const Outcome<std::string> png = of("\x89PNG\r\n\x1a\nab");
    ASSERT_TRUE(png);
    EXPECT_EQ(*png, "data:image/png;base64,iVBORw0KGgphYg==");
    const Outcome<std::string> jpeg =
        of("\xff\xd8\xff"
           "abc");
    ASSERT_TRUE(jpeg);
    EXPECT_EQ(*jpeg, "data:image/jpeg;base64,/9j/YWJj");
    const Outcome<std::string> svg = of("<?xml version=\"1.0\"?>\n<svg/>");
    ASSERT_TRUE(svg);
    EXPECT_TRUE(svg->starts_with("data:image/svg+xml;base64,PD94bWwg")) << *svg;
}

TEST_F(Logo, ThatNoBrowserShowsIsRefusedWithItsName) {
    for (const char* bytes : {"", "PK\x03\x04", "text with <svg in it"}) {
        const Outcome<std::string> other = of(bytes);
        ASSERT_FALSE(other) << bytes;
        EXPECT_EQ(other.diagnostics().front().place.file, "logo.png");
        EXPECT_EQ(other.diagnostics().front().message, "the logo is neither PNG, JPEG nor SVG");
    }
}

TEST_F(Logo, ThatIsTooLargeOrMissingIsRefused) {
    const std::string most = "<svg>" + std::string(largestLogo - 5, ' ');
    EXPECT_TRUE(of(most));
    const Outcome<std::string> larger = of(most + ' ');
    ASSERT_FALSE(larger);
    EXPECT_NE(larger.diagnostics().front().message.find("512 kB"), std::string::npos);
    const Outcome<std::string> missing = logoUri(file_.string() + ".none", "logo.png");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.diagnostics().front().place.file, "logo.png");
}

}  // namespace
}  // namespace analogon
