#include "core/export/traces_mf4.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>

#include "core/export/export.hpp"
#include "core/measure/open/open_recording.hpp"
#include "core/study/run.hpp"

namespace analogon {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A path that is taken away with the test.
class Mf4File : public ::testing::Test {
protected:
    void SetUp() override {
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        directory_ = std::filesystem::temp_directory_path() / ("analogon-mf4-" + std::string(info->name()));
        std::filesystem::remove_all(directory_);
        std::filesystem::create_directories(directory_);
        file_ = directory_ / "traces.mf4";
    }
    void TearDown() override { std::filesystem::remove_all(directory_); }

    MeasurementFile opened() const {
        const Outcome<MeasurementFile> recording = openRecording(file_);
        EXPECT_TRUE(recording.hasValue()) << format(recording.diagnostics());
        return recording ? *recording : MeasurementFile{};
    }
    static std::vector<double> read(const MeasurementFile& recording, std::size_t group, std::size_t channel) {
        const Outcome<ChannelValues> values = readValues(recording, group, channel);
        EXPECT_TRUE(values.hasValue()) << format(values.diagnostics());
        return values ? values->numbers : std::vector<double>{};
    }

    std::filesystem::path directory_, file_;
};

std::vector<std::uint64_t> bitsOf(const std::vector<double>& values) {
    std::vector<std::uint64_t> bits;
    for (const double value : values) bits.push_back(std::isnan(value) ? 0 : std::bit_cast<std::uint64_t>(value));
    return bits;
}

TEST_F(Mf4File, ReadsBackBitForBitWithUnitsAndComments) {
    const std::vector<double> time{0, 0.1, 0.2, 1e9 + 1.0 / 3},
        values{-0.0, 1.0 / 3, std::nan(""), std::numeric_limits<double>::denorm_min()},
        others{1e308, -1e-308, 2, std::nextafter(1.0, 2.0)};
    std::vector<double> many(20'001);
    std::iota(many.begin(), many.end(), 0.25);
    const std::vector<Mf4Group> groups{
        {"a \"b\" <c>",
         "about a & b",
         {{"time", "s", "", time}, {"T", "°C", "of the winding", values}, {"i", "A", "", others}}},
        {"long", "", {{"time", "s", "", many}, {"n", "", "counts", many}}},
        {"empty", "", {{"time", "s", "", {}}, {"n", "", "", {}}}}};
    ASSERT_TRUE(writeMf4(groups, "a <test>", file_));
    const MeasurementFile recording = opened();
    EXPECT_EQ(recording.format, "ASAM MDF 4.10");
    ASSERT_EQ(recording.groups.size(), 3u);
    EXPECT_EQ(recording.groups[0].name, "a \"b\" <c>");
    EXPECT_EQ(recording.groups[0].master, MasterKind::Time);
    EXPECT_EQ(recording.groups[0].masterChannel, 0u);
    const RecordedChannel& channel = recording.groups[0].channels[1];
    EXPECT_EQ(channel.name, "T");
    EXPECT_EQ(channel.unit, "°C");
    EXPECT_EQ(channel.comment, "of the winding");
    EXPECT_EQ(bitsOf(read(recording, 0, 0)), bitsOf(time));
    EXPECT_EQ(bitsOf(read(recording, 0, 1)), bitsOf(values));
    EXPECT_EQ(bitsOf(read(recording, 0, 2)), bitsOf(others));
    EXPECT_EQ(read(recording, 1, 1), many);
    EXPECT_EQ(recording.groups[2].samples, 0u);
    EXPECT_TRUE(recording.start.empty()) << "nobody knows when it was recorded: " << recording.start;
}

TEST_F(Mf4File, EveryBlockLiesOnEightBytesAndWithinTheFile) {
    ASSERT_TRUE(writeMf4({{"g", "c", {{"time", "s", "", {0, 1, 2}}, {"x", "V", "words", {1, 2, 3}}}}}, "why", file_));
    std::ifstream stream(file_, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    const auto number = [&](std::size_t at) {
        std::uint64_t value = 0;
        std::memcpy(&value, bytes.data() + at, 8);
        return value;
    };
    std::size_t blocks = 0, at = 64;
    for (; at < bytes.size(); ++blocks) {
        ASSERT_EQ(bytes.substr(at, 2), "##") << at;
        ASSERT_LE(at + number(at + 8), bytes.size());
        for (std::uint64_t link = 0; link < number(at + 16); ++link) {
            const std::uint64_t target = number(at + 24 + 8 * link);
            if (target == 0) continue;
            ASSERT_EQ(target % 8, 0u);
            EXPECT_EQ(bytes.substr(target, 2), "##");
        }
        at += (number(at + 8) + 7) / 8 * 8;
    }
    EXPECT_GE(blocks, 12u);
    EXPECT_NE(bytes.find("##FH"), std::string::npos) << "the standard asks for a history";
}

TEST_F(Mf4File, HoldsWhatWasMeasuredWhatTheModelSaysAndTheDifference) {
    const Outcome<Study> study = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
    ASSERT_TRUE(study) << format(study.diagnostics());
    const Outcome<Exported> exported = exportStudy(*study, ExportFormat::Mf4, file_);
    ASSERT_TRUE(exported) << format(exported.diagnostics());
    const MeasurementFile recording = opened();
    const Outcome<RunResult> result = runSimulate(*study, {}, {});
    ASSERT_TRUE(result);
    const std::vector<ExperimentState>& experiments = result->finding.final.experiments;
    ASSERT_EQ(recording.groups.size(), 3 * experiments.size());
    for (std::size_t e = 0; e < experiments.size(); ++e) {
        const OutputState& output = experiments[e].outputs.front();
        const auto valuesOf = [&](std::size_t group) {
            const std::vector<RecordedChannel>& channels = recording.groups[group].channels;
            const auto found = std::find_if(channels.begin(), channels.end(),
                                            [&](const RecordedChannel& c) { return c.name == output.name; });
            EXPECT_NE(found, channels.end());
            EXPECT_EQ(found->unit, output.unit);
            return read(recording, group, static_cast<std::size_t>(found - channels.begin()));
        };
        const std::vector<double> measured = valuesOf(3 * e), simulated = valuesOf(3 * e + 1),
                                  residual = valuesOf(3 * e + 2);
        EXPECT_EQ(recording.groups[3 * e].name, experiments[e].name + " measured");
        EXPECT_EQ(read(recording, 3 * e, 0), experiments[e].time);
        ASSERT_EQ(measured.size(), static_cast<std::size_t>(output.measured.size()));
        for (std::size_t i = 0; i < measured.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            ASSERT_EQ(measured[i], output.measured[row]);
            ASSERT_EQ(simulated[i], output.simulated[row]);
            ASSERT_EQ(residual[i], output.measured[row] - output.simulated[row]);
        }
    }
    std::vector<std::string> names;
    for (const RecordedChannel& channel : recording.groups[0].channels) names.push_back(channel.name);
    EXPECT_THAT(names, ElementsAre("time", "ctrl_var", "T_amb", "i_mod"));
    EXPECT_THAT(recording.groups[0].channels[1].comment, HasSubstr("input of the model"));
}

}  // namespace
}  // namespace analogon
