#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include "core/measure/open/open_recording.hpp"

/// One measurement as ten versions of a format have it; passed over where the files are not at hand.
namespace analogon {
namespace {

namespace fs = std::filesystem;

fs::path folder() {
    const fs::path shared = fs::path("data") / "import_files" / "mdf" / "asammdf_demo";
    const fs::path beside = fs::path(ANALOGON_ROOT) / ".." / "shared" / shared;
    return fs::exists(beside) ? beside : fs::path(ANALOGON_ROOT) / ".." / ".." / "shared" / shared;
}

struct Channel {
    std::string name, unit;
    ChannelKind kind{};
    bool isMaster{};
    ChannelValues values;
};

std::vector<Channel> channelsOf(const fs::path& file) {
    const Outcome<MeasurementFile> recording = openRecording(file);
    EXPECT_TRUE(recording.hasValue()) << format(recording.diagnostics());
    std::vector<Channel> channels;
    if (!recording) return channels;
    for (std::size_t g = 0; g < recording->groups.size(); ++g)
        for (std::size_t c = 0; c < recording->groups[g].channels.size(); ++c) {
            const RecordedChannel& channel = recording->groups[g].channels[c];
            Outcome<ChannelValues> values = readValues(*recording, g, c);
            EXPECT_TRUE(values.hasValue()) << file << ' ' << channel.name;
            if (values)
                channels.push_back({channel.name, channel.unit, channel.kind, recording->groups[g].masterChannel == c,
                                    std::move(*values)});
        }
    return channels;
}

/// To the last bit; a gap is a gap. The program that made the versions rounded the stamps of some to nanoseconds.
bool isSame(const Channel& a, const Channel& b) {
    const auto areSame = [&](double x, double y) {
        if (a.isMaster && std::abs(x - y) < 1e-9) return true;
        return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y) || (x != x && y != y);
    };
    const std::vector<double>&first = a.values.numbers, &second = b.values.numbers;
    return a.values.texts == b.values.texts &&
           std::equal(first.begin(), first.end(), second.begin(), second.end(), areSame);
}

/// Version 2.00 has room for names of 31 letters; a master has the name that its version gives it.
bool mayBe(const Channel& cut, const Channel& whole) {
    constexpr std::size_t room = 31;
    if (cut.isMaster || whole.isMaster) return cut.isMaster == whole.isMaster;
    return cut.name == whole.name || (cut.name.size() == room && whole.name.starts_with(cut.name));
}

TEST(SameMeasurement, AllVersionsGiveEqualChannelsAndValues) {
    if (!fs::exists(folder())) GTEST_SKIP() << "the ten versions of one measurement are not at hand";
    std::vector<Channel> reference;
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(folder())) {
        const std::vector<Channel> channels = channelsOf(entry.path());
        ++files;
        if (reference.empty()) reference = channels;
        const std::string name = entry.path().filename().string();
        EXPECT_EQ(channels.size(), reference.size()) << name;
        std::vector<bool> taken(reference.size());
        for (const Channel& channel : channels) {
            std::size_t same = 0;
            while (same < reference.size() &&
                   (taken[same] || !(mayBe(channel, reference[same]) || mayBe(reference[same], channel)) ||
                    channel.kind != reference[same].kind || !isSame(channel, reference[same])))
                ++same;
            ASSERT_LT(same, reference.size()) << name << ": " << channel.name << " has other values elsewhere";
            EXPECT_TRUE(channel.isMaster || channel.unit == reference[same].unit) << name << ": " << channel.name;
            taken[same] = true;
        }
    }
    EXPECT_EQ(files, 10u);
}

}  // namespace
}  // namespace analogon
