#include "core/measure/tdms/tdms.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/measure/open/open_recording.hpp"
#include "tests/core/measure/mdf/mdf4_writer.hpp"

namespace analogon {
namespace {

using test::Bytes;
using testing::ElementsAre;
using testing::HasSubstr;

class Tdms : public testing::Test {
protected:
    ~Tdms() override { std::filesystem::remove(file); }

    Outcome<MeasurementFile> open(const std::string& bytes) {
        std::ofstream(file, std::ios::binary) << bytes;
        return openRecording(file);
    }
    static std::vector<double> numbers(const MeasurementFile& recording, std::size_t group, std::size_t channel) {
        const Outcome<ChannelValues> values = readValues(recording, group, channel);
        EXPECT_TRUE(values) << format(values.diagnostics());
        return values ? values->numbers : std::vector<double>{};
    }

    std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("analogon-tdms-" + std::to_string(getpid()) + ".tdms");
};

void putText(Bytes& bytes, const std::string& text) { bytes.put(static_cast<std::uint32_t>(text.size())).put(text); }

struct Object {
    std::string path;
    std::uint32_t type{};
    std::uint64_t count{};
    std::vector<std::pair<std::string, double>> numbers{};
    std::vector<std::pair<std::string, std::string>> texts{};
};

std::string meta(const std::vector<Object>& objects) {
    Bytes bytes;
    bytes.put(static_cast<std::uint32_t>(objects.size()));
    for (const Object& object : objects) {
        putText(bytes, object.path);
        if (object.type == 0)
            bytes.put(std::uint32_t{0xFFFFFFFF});
        else
            bytes.put(std::uint32_t{20}).put(object.type).put(std::uint32_t{1}).put(object.count);
        bytes.put(static_cast<std::uint32_t>(object.numbers.size() + object.texts.size()));
        for (const auto& [name, value] : object.numbers) {
            putText(bytes, name);
            bytes.put(std::uint32_t{10}).put(value);
        }
        for (const auto& [name, value] : object.texts) {
            putText(bytes, name);
            bytes.put(std::uint32_t{0x20});
            putText(bytes, value);
        }
    }
    return bytes.text;
}

std::string segment(std::uint32_t contents, const std::string& head, const std::string& raw, bool isOpen = false) {
    Bytes bytes;
    bytes.put(std::string("TDSm")).put(contents).put(std::uint32_t{4713});
    bytes.put(isOpen ? UINT64_MAX : std::uint64_t{head.size() + raw.size()}).put(std::uint64_t{head.size()});
    return bytes.text + head + raw;
}

constexpr std::uint32_t meta1 = 2, fresh = 4, raw1 = 8, interleaved = 32;

std::string doubles(std::initializer_list<double> values) {
    Bytes bytes;
    for (const double value : values) bytes.put(value);
    return bytes.text;
}

TEST_F(Tdms, ChannelsThatShareAStepAreAGroupWithItsTime) {
    const std::vector<std::pair<std::string, double>> step{{"wf_increment", 0.5}, {"wf_start_offset", 1.0}};
    const std::string head =
        meta({{"/"}, {"/'G'"}, {"/'G'/'a'", 10, 2, step, {{"unit_string", "V"}}}, {"/'G'/'it''s/b'", 3, 2, step}});
    Bytes raw;
    raw.put(doubles({1.5, 2.5})).put(std::int32_t{-7}).put(std::int32_t{8});
    const Outcome<MeasurementFile> opened = open(segment(meta1 | fresh | raw1, head, raw.text));
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    ASSERT_EQ(opened->groups.size(), 1u);
    EXPECT_EQ(opened->groups[0].channels[1].unit, "V");
    EXPECT_EQ(opened->groups[0].channels[2].name, "it's/b");
    EXPECT_THAT(numbers(*opened, 0, 0), ElementsAre(1.0, 1.5));
    EXPECT_THAT(numbers(*opened, 0, 1), ElementsAre(1.5, 2.5));
    EXPECT_THAT(numbers(*opened, 0, 2), ElementsAre(-7, 8));
}

TEST_F(Tdms, ASegmentWithoutItsOwnListGoesOnWithTheLastOneChunkByChunk) {
    const std::string head = meta({{"/'G'/'a'", 10, 1}, {"/'G'/'b'", 10, 1}});
    const std::string bytes =
        segment(meta1 | fresh | raw1, head, doubles({1, 10})) + segment(raw1, "", doubles({2, 20, 3, 30}));
    const Outcome<MeasurementFile> opened = open(bytes);
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_THAT(numbers(*opened, 0, 0), ElementsAre(1, 2, 3));
    EXPECT_THAT(numbers(*opened, 0, 1), ElementsAre(10, 20, 30));
}

TEST_F(Tdms, ReadsInterleavedValues) {
    const std::string head = meta({{"/'G'/'a'", 10, 2}, {"/'G'/'b'", 2, 2}});
    Bytes raw;
    raw.put(1.0).put(std::int16_t{5}).put(2.0).put(std::int16_t{6});
    const Outcome<MeasurementFile> opened = open(segment(meta1 | fresh | raw1 | interleaved, head, raw.text));
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_THAT(numbers(*opened, 0, 0), ElementsAre(1, 2));
    EXPECT_THAT(numbers(*opened, 0, 1), ElementsAre(5, 6));
}

TEST_F(Tdms, AppliesTheScalesOfAChannel) {
    const std::string head = meta({{"/'G'/'a'",
                                    2,
                                    2,
                                    {{"NI_Number_Of_Scales", 2},
                                     {"NI_Scale[1]_Linear_Slope", 0.5},
                                     {"NI_Scale[1]_Linear_Y_Intercept", -1},
                                     {"NI_Scale[1]_Linear_Input_Source", 0},
                                     {"NI_Scale[0]_Polynomial_Coefficients_Size", 3},
                                     {"NI_Scale[0]_Polynomial_Coefficients[0]", 1},
                                     {"NI_Scale[0]_Polynomial_Coefficients[1]", 0},
                                     {"NI_Scale[0]_Polynomial_Coefficients[2]", 2},
                                     {"NI_Scale[0]_Polynomial_Input_Source", 4294967295.0}},
                                    {{"NI_Scale[1]_Scale_Type", "Linear"}, {"NI_Scale[0]_Scale_Type", "Polynomial"}}}});
    Bytes raw;
    raw.put(std::int16_t{1}).put(std::int16_t{3});
    const Outcome<MeasurementFile> opened = open(segment(meta1 | fresh | raw1, head, raw.text));
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_THAT(numbers(*opened, 0, 0), ElementsAre(0.5, 8.5));
}

TEST_F(Tdms, StampsThatAreCalledATimeAreTheOneOfTheirGroup) {
    constexpr std::int64_t start = 3801292200;  // since 1904
    const std::string head = meta({{"/'G'/'Time'", 0x44, 3}, {"/'G'/'a'", 10, 3}});
    Bytes raw;
    for (int i = 0; i < 3; ++i) raw.put(std::uint64_t{1} << (i == 1 ? 63 : 62)).put(start + i);
    const Outcome<MeasurementFile> opened = open(segment(meta1 | fresh | raw1, head, raw.text + doubles({1, 2, 3})));
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    ASSERT_EQ(opened->groups.size(), 1u);
    EXPECT_EQ(opened->groups[0].master, MasterKind::Time);
    EXPECT_EQ(opened->groups[0].channels[0].unit, "s");
    EXPECT_THAT(numbers(*opened, 0, 0), ElementsAre(0, 1.25, 2));
    EXPECT_EQ(opened->groups[0].channels[1].kind, ChannelKind::Text) << "they stay as they are";
    EXPECT_THAT(numbers(*opened, 0, 2), ElementsAre(1, 2, 3));
    EXPECT_EQ(opened->start, "2024-06-15T10:30:00.250Z");
}

TEST_F(Tdms, AScaleThatCannotBeReadTakesTheUnitAlong) {
    const std::string head = meta({{"/'G'/'a'",
                                    2,
                                    2,
                                    {{"NI_Number_Of_Scales", 1}},
                                    {{"NI_Scale[0]_Scale_Type", "RTD"}, {"unit_string", "degC"}}}});
    Bytes raw;
    raw.put(std::int16_t{1000}).put(std::int16_t{3000});
    const Outcome<MeasurementFile> opened = open(segment(meta1 | fresh | raw1, head, raw.text));
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_EQ(opened->groups[0].channels[0].unit, "");
    EXPECT_THAT(opened->notes.front().english(), HasSubstr("RTD"));
}

TEST_F(Tdms, AFileThatWasNotClosedIsReadAsFarAsItGoes) {
    const std::string head = meta({{"/'G'/'a'", 10, 4}});
    const Outcome<MeasurementFile> opened = open(segment(meta1 | fresh | raw1, head, doubles({1, 2, 3}) + "123", true));
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_THAT(numbers(*opened, 0, 0), ElementsAre(1, 2, 3));
    EXPECT_THAT(opened->notes.front().english(), HasSubstr("did not close"));
}

TEST_F(Tdms, CountsThatOverflowAreNoValues) {
    std::vector<Object> objects;
    for (int i = 0; i < 80; ++i) objects.push_back({"/'G'/'c" + std::to_string(i) + "'", 10, std::uint64_t{1} << 58});
    const Outcome<MeasurementFile> opened = open(segment(meta1 | fresh | raw1, meta(objects), doubles({1, 2})));
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    std::size_t samples = 0;
    for (const RecordedGroup& group : opened->groups) samples += group.samples;
    EXPECT_LE(samples, 2u);
}

TEST_F(Tdms, EveryByteOfASmallFileMayBeDamaged) {
    const std::string head =
        meta({{"/'G'/'a'", 10, 2, {{"wf_increment", 0.5}}, {{"unit_string", "V"}}}, {"/'G'/'b'", 2, 2}});
    const std::string whole = segment(meta1 | fresh | raw1, head, doubles({1, 2}) + "1234") +
                              segment(raw1 | interleaved, "", doubles({1, 2}) + "1234");
    std::uint32_t state = 7;
    for (std::size_t at = 0; at < 4 * whole.size(); ++at) {
        std::string bytes = whole;
        state = state * 1664525u + 1013904223u;
        bytes[at % whole.size()] = static_cast<char>(state >> 24);
        bytes[(state >> 4) % whole.size()] = static_cast<char>(state >> 16);
        const Outcome<MeasurementFile> opened = open(bytes);
        if (!opened) continue;
        for (std::size_t g = 0; g < opened->groups.size(); ++g)
            for (std::size_t c = 0; c < opened->groups[g].channels.size(); ++c) {
                const Outcome<ChannelValues> values = readValues(*opened, g, c);
                if (values) {
                    EXPECT_LE(values->numbers.size(), whole.size());
                }
            }
    }
}

}  // namespace
}  // namespace analogon
