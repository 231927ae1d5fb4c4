#include <gtest/gtest.h>

#include <ctime>
#include <fstream>

#include "core/measure/open/open_recording.hpp"

/// Damaged and malicious files of the binary formats; passed over where they are not at hand.
namespace analogon {
namespace {

namespace fs = std::filesystem;

/// It can be opened, and all that it lists can be read.
bool isReadable(const fs::path& file) {
    const Outcome<MeasurementFile> recording = openRecording(file);
    if (!recording) return false;
    for (std::size_t g = 0; g < recording->groups.size(); ++g)
        for (std::size_t c = 0; c < recording->groups[g].channels.size(); ++c)
            if (!readValues(*recording, g, c)) return false;
    return true;
}

TEST(HostileFiles, BinaryOnesAreReadOrRefusedAsTheyShould) {
    const fs::path root = ANALOGON_ROOT "/../shared/verification/hostile";
    if (!fs::exists(root / "MANIFEST.csv")) GTEST_SKIP() << "the collection of hostile files is not there";
    std::ifstream manifest(root / "MANIFEST.csv");
    int checked = 0;
    for (std::string line; std::getline(manifest, line);) {
        if (!line.starts_with("mat/") && !line.starts_with("mdf4/")) continue;
        const std::string file = line.substr(0, line.find(','));
        std::string expected = line.substr(line.find(',', file.size() + 1) + 1);
        expected = expected.substr(0, expected.find(','));
        const std::clock_t begin = std::clock();  // of this process: others do not count
        const bool isRead = isReadable(root / file);
        EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 5) << file;
        const bool isDecided = expected == "reject" || expected == "accept" || expected == "seed";
        EXPECT_TRUE(!isDecided || isRead == (expected != "reject")) << file << " is " << (isRead ? "read" : "refused");
        ++checked;
    }
    EXPECT_GT(checked, 20);
}

}  // namespace
}  // namespace analogon
