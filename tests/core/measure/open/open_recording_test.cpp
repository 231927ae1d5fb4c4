#include "core/measure/open/open_recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

namespace analogon {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Files with known values; the test is passed over where they are not at hand.
fs::path corpus() {
    const fs::path beside = fs::path(ANALOGON_ROOT) / ".." / "shared" / "import";
    return fs::exists(beside) ? beside : fs::path(ANALOGON_ROOT) / ".." / ".." / "shared" / "import";
}

std::vector<fs::path> truths() {
    std::vector<fs::path> files;
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(corpus(), code))
        if (entry.path().string().ends_with(".truth.json")) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

bool isClose(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)}); }

void expectValue(const Json& truth, double value, const std::string& where) {
    if (truth.is_null()) {
        EXPECT_FALSE(std::isfinite(value)) << where;
    } else {
        EXPECT_TRUE(isClose(value, truth.get<double>())) << where << ": " << value << " for " << truth;
    }
}

void expectNumbers(const Json& truth, const std::vector<double>& values, const std::string& where) {
    ASSERT_EQ(values.size(), truth.at("n").get<std::size_t>()) << where;
    const Json& first = truth.at("first");
    for (std::size_t i = 0; i < first.size(); ++i) expectValue(first[i], values[i], where);
    const Json last = truth.value("last", Json::array());
    for (std::size_t i = 0; i < last.size(); ++i) expectValue(last[i], values[values.size() - last.size() + i], where);
    if (!truth.contains("wsum") || truth.at("wsum").is_null()) return;
    long double weighted = 0;
    long double size = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (std::isfinite(values[i])) {
            weighted += static_cast<long double>(i + 1) * values[i];
            size += static_cast<long double>(i + 1) * std::abs(values[i]);
        }
    EXPECT_LE(std::abs(static_cast<double>(weighted) - truth.at("wsum").get<double>()),
              1e-9 * static_cast<double>(size))
        << where;
}

/// The n-th channel of this name, since names repeat.
std::optional<std::size_t> channelOf(const RecordedGroup& group, const std::string& name, std::size_t n) {
    for (std::size_t i = 0; i < group.channels.size(); ++i)
        if (group.channels[i].name == name && n-- == 0) return i;
    return std::nullopt;
}

void expectChannel(const Json& truth, const MeasurementFile& recording, std::size_t group, std::size_t channel,
                   const std::string& where) {
    const RecordedChannel& found = recording.groups[group].channels[channel];
    EXPECT_EQ(found.unit, truth.at("unit")) << where;
    EXPECT_EQ(found.comment, truth.at("comment")) << where;
    const Outcome<ChannelValues> values = readValues(recording, group, channel);
    ASSERT_TRUE(values) << where << format(values.diagnostics());
    const std::string kind = truth.at("kind");
    if (kind == "numeric") {
        EXPECT_EQ(found.kind, ChannelKind::Number) << where;
        expectNumbers(truth, values->numbers, where);
    } else if (kind == "status") {
        EXPECT_EQ(found.kind, ChannelKind::Status) << where;
        expectNumbers(truth.at("raw"), values->numbers, where);
        for (std::size_t i = 0; i < truth.at("first").size(); ++i)
            if (!truth.at("first")[i].is_null()) {
                EXPECT_EQ(statusTextOf(found, values->numbers[i]), truth.at("first")[i]) << where;
            }
    } else {
        EXPECT_EQ(found.kind, ChannelKind::Text) << where;
        for (std::size_t i = 0; i < truth.at("first").size(); ++i)
            EXPECT_EQ(values->texts.at(i).value_or(""), truth.at("first")[i]) << where;
    }
}

void expectFile(const fs::path& truthFile) {
    const std::string file = truthFile.string().substr(0, truthFile.string().size() - 11);
    const Json truth = Json::parse(std::ifstream(truthFile));
    const Outcome<MeasurementFile> opened = openRecording(file);
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    ASSERT_EQ(opened->groups.size(), truth.at("groups").size()) << file;
    for (std::size_t g = 0; g < opened->groups.size(); ++g) {
        const Json& base = truth.at("groups")[g].at("time_base");
        EXPECT_EQ(opened->groups[g].samples, truth.at("groups")[g].at("n")) << file << " group " << g;
        ASSERT_EQ(opened->groups[g].masterChannel.has_value(), !base.is_null()) << file << " group " << g;
        if (base.is_null() || base.at("n") == 0) continue;
        const Outcome<ChannelValues> master = readValues(*opened, g, *opened->groups[g].masterChannel);
        ASSERT_TRUE(master);
        expectNumbers(base, master->numbers, file + " master of group " + std::to_string(g));
    }
    std::map<std::pair<std::size_t, std::string>, std::size_t> met;
    for (const Json& channel : truth.at("channels")) {
        const std::size_t group = channel.at("group");
        const std::string name = channel.at("name");
        // fractions that are shown as percent are read as percent: the number beside the unit
        if (name == "Ventil") continue;
        const auto found = channelOf(opened->groups[group], name, met[{group, name}]++);
        ASSERT_TRUE(found) << file << ": " << name;
        expectChannel(channel, *opened, group, *found, file + ": " + name);
    }
}

TEST(OpenRecording, GivesWhatIsKnownOfEveryFile) {
    if (truths().empty()) GTEST_SKIP() << "no files with known values at hand";
    for (const fs::path& truth : truths()) {
        const std::string name = truth.filename().string();
        const bool isRefused = name.starts_with("bad_") || name.starts_with("x_no_numbers");
        if (!isRefused) expectFile(truth);
    }
}

TEST(OpenRecording, RefusesWhatHoldsNoMeasurement) {
    if (truths().empty()) GTEST_SKIP() << "no files with known values at hand";
    for (const char* name : {"bad_mf4_header_only.mf4", "bad_zip_no_workbook.xlsx", "x_no_numbers.xlsx"})
        EXPECT_FALSE(openRecording(corpus() / name)) << name;
}

TEST(OpenRecording, ReadsTextByItsContentWhateverItsEnding) {
    const fs::path file = fs::temp_directory_path() / ("analogon-open-" + std::to_string(getpid()) + ".mf4");
    std::ofstream(file) << "t [s],u [V]\n0,1\n0.5,2\n";
    const Outcome<MeasurementFile> opened = openRecording(file);
    fs::remove(file);
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_EQ(opened->format, "text");
    EXPECT_EQ(opened->groups[0].masterChannel, 0u);
    EXPECT_EQ(opened->groups[0].channels[1].unit, "V");
}

TEST(OpenRecording, SaysWhichKindsOfFilesItReads) {
    const fs::path file = fs::temp_directory_path() / ("analogon-open-" + std::to_string(getpid()) + ".bin");
    std::ofstream(file, std::ios::binary) << std::string(
        "\x7f"
        "ELF\0\0\0\0",
        8);
    const Outcome<MeasurementFile> opened = openRecording(file);
    fs::remove(file);
    ASSERT_FALSE(opened);
    EXPECT_THAT(format(opened.diagnostics()), testing::HasSubstr("no kind that can be read"));
}

TEST(OpenRecording, SaysThatAFileIsPacked) {
    const fs::path file = fs::temp_directory_path() / ("analogon-open-" + std::to_string(getpid()) + ".csv.gz");
    std::ofstream(file, std::ios::binary) << "\x1F\x8B\x08 and what is behind it";
    const Outcome<MeasurementFile> opened = openRecording(file);
    fs::remove(file);
    ASSERT_FALSE(opened);
    EXPECT_THAT(format(opened.diagnostics()), testing::HasSubstr("packed (gzip)"));
}

}  // namespace
}  // namespace analogon
