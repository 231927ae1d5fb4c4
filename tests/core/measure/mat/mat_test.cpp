#include "core/measure/mat/mat.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <matio.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/measure/open/open_recording.hpp"

namespace analogon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class MatTest : public testing::TestWithParam<mat_ft> {
protected:
    ~MatTest() override { std::filesystem::remove(file); }

    static matvar_t* numbers(const char* name, std::vector<double> values, std::size_t columns = 1) {
        std::size_t dimensions[2] = {values.size() / columns, columns};
        return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dimensions, values.data(), 0);
    }
    static matvar_t* text(const char* name, std::string words) {
        std::size_t dimensions[2] = {1, words.size()};
        return Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UTF8, 2, dimensions, words.data(), 0);
    }
    void write(std::vector<matvar_t*> variables) const {
        mat_t* mat = Mat_CreateVer(file.c_str(), nullptr, GetParam());
        ASSERT_NE(mat, nullptr);
        for (matvar_t* variable : variables) {
            Mat_VarWrite(mat, variable, MAT_COMPRESSION_NONE);
            Mat_VarFree(variable);
        }
        Mat_Close(mat);
    }
    static std::vector<double> valuesOf(const MeasurementFile& recording, std::size_t group, const std::string& name) {
        const auto& channels = recording.groups.at(group).channels;
        for (std::size_t i = 0; i < channels.size(); ++i)
            if (channels[i].name == name) {
                const Outcome<ChannelValues> values = readValues(recording, group, i);
                EXPECT_TRUE(values) << format(values.diagnostics());
                return values ? values->numbers : std::vector<double>{};
            }
        ADD_FAILURE() << name;
        return {};
    }
    static std::string notes(const MeasurementFile& recording) {
        std::string all;
        for (const Text& note : recording.notes) all += note.english() + "\n";
        return all;
    }

    std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("analogon-mat-" + std::to_string(getpid()) + ".mat");
};

TEST(MatStacked, SignalsBehindOneAnotherAreChannels) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("analogon-mat-stacked-" + std::to_string(getpid()) + ".mat");
    mat_t* const mat = Mat_CreateVer(file.c_str(), nullptr, MAT_FT_MAT5);
    std::size_t one[2] = {1, 1}, three[2] = {3, 1}, stack[3] = {2, 1, 3};
    std::vector<double> time{0, 0.5, 1}, values{1, 10, 2, 20, 3, 30};
    const char* fields[] = {"time", "signals"};
    const char* inner[] = {"values", "label"};
    std::string label = "ab";
    std::size_t letters[2] = {1, 2};
    matvar_t* const signals = Mat_VarCreateStruct("signals", 2, one, inner, 2);
    Mat_VarSetStructFieldByName(signals, "values", 0,
                                Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 3, stack, values.data(), 0));
    Mat_VarSetStructFieldByName(signals, "label", 0,
                                Mat_VarCreate(nullptr, MAT_C_CHAR, MAT_T_UTF8, 2, letters, label.data(), 0));
    matvar_t* const record = Mat_VarCreateStruct("logs", 2, one, fields, 2);
    Mat_VarSetStructFieldByName(record, "time", 0,
                                Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, three, time.data(), 0));
    Mat_VarSetStructFieldByName(record, "signals", 0, signals);
    Mat_VarWrite(mat, record, MAT_COMPRESSION_NONE);
    Mat_VarFree(record);
    Mat_Close(mat);
    const Outcome<MeasurementFile> opened = openRecording(file);
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    const auto& channels = opened->groups.at(0).channels;
    ASSERT_EQ(channels.size(), 3u);
    EXPECT_EQ(channels[1].name, "ab(1)");
    EXPECT_THAT(readValues(*opened, 0, 1)->numbers, ElementsAre(1, 2, 3));
    EXPECT_EQ(channels[2].name, "ab(2)");
    EXPECT_THAT(readValues(*opened, 0, 2)->numbers, ElementsAre(10, 20, 30));
    std::filesystem::remove(file);
}

INSTANTIATE_TEST_SUITE_P(Levels, MatTest, testing::Values(MAT_FT_MAT4, MAT_FT_MAT5, MAT_FT_MAT73));

TEST_P(MatTest, TimesOfOneLengthBelongToWhatIsCalledAsTheyAre) {
    write({numbers("t1", {0, 0.5, 1}), numbers("U1", {1, 2, 3}), numbers("t2", {0, 2, 4}), numbers("U2", {4, 5, 6}),
           numbers("t_oil", {20, 21, 25}), numbers("odd", {7, 8, 9})});
    const Outcome<MeasurementFile> opened = openRecording(file);
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    const auto groupOf = [&](const std::string& name) -> const RecordedGroup& {
        for (const RecordedGroup& group : opened->groups)
            for (const RecordedChannel& channel : group.channels)
                if (channel.name == name) return group;
        ADD_FAILURE() << name;
        return opened->groups.front();
    };
    EXPECT_EQ(groupOf("U1").channels.front().name, "t1");
    EXPECT_EQ(groupOf("U2").channels.front().name, "t2");
    EXPECT_EQ(groupOf("t_oil").channels.front().name, "t1");  // rises, and not by even steps
    EXPECT_THAT(notes(*opened), HasSubstr("\"t2\" has as many values"));
}

TEST_P(MatTest, VectorsOfOneLengthShareTheTimeOfThatLength) {
    write({numbers("t", {0, 0.5, 1}), numbers("y", {1, 2, 3}), numbers("odd", {4, 5}), numbers("R0", {47})});
    const Outcome<MeasurementFile> opened = openRecording(file);
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    ASSERT_EQ(opened->groups.size(), 2u);
    EXPECT_EQ(opened->groups[0].master, MasterKind::Time);
    EXPECT_THAT(valuesOf(*opened, 0, "t"), ElementsAre(0, 0.5, 1));
    EXPECT_THAT(valuesOf(*opened, 0, "y"), ElementsAre(1, 2, 3));
    EXPECT_EQ(opened->groups[1].master, MasterKind::None);
    EXPECT_THAT(valuesOf(*opened, 1, "odd"), ElementsAre(4, 5));
}

TEST_P(MatTest, ColumnsOfAMatrixAreChannels) {
    write({numbers("time", {0, 1, 2}), numbers("M", {1, 2, 3, 10, 20, 30}, 2)});
    const Outcome<MeasurementFile> opened = openRecording(file);
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_THAT(valuesOf(*opened, 0, "M(:,2)"), ElementsAre(10, 20, 30));
}

TEST_P(MatTest, ReadsTheStructureWithTimeOfSimulink) {
    if (GetParam() == MAT_FT_MAT4) GTEST_SKIP() << "level 4 has no structures";
    const char* outer[] = {"time", "signals"};
    const char* inner[] = {"values", "label"};
    std::size_t one[2] = {1, 1};
    matvar_t* signals = Mat_VarCreateStruct("signals", 2, one, inner, 2);
    Mat_VarSetStructFieldByName(signals, "values", 0, numbers(nullptr, {1, 2, 3, 10, 20, 30}, 2));
    Mat_VarSetStructFieldByName(signals, "label", 0, text(nullptr, "pos"));
    matvar_t* scope = Mat_VarCreateStruct("Scope", 2, one, outer, 2);
    Mat_VarSetStructFieldByName(scope, "time", 0, numbers(nullptr, {0, 1, 2}));
    Mat_VarSetStructFieldByName(scope, "signals", 0, signals);
    write({scope});
    const Outcome<MeasurementFile> opened = openRecording(file);
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    ASSERT_EQ(opened->groups.size(), 1u);
    EXPECT_EQ(opened->groups[0].name, "Scope");
    EXPECT_THAT(valuesOf(*opened, 0, "Scope.time"), ElementsAre(0, 1, 2));
    EXPECT_THAT(valuesOf(*opened, 0, "pos(2)"), ElementsAre(10, 20, 30));
}

TEST_P(MatTest, ATimeThatCountsNoSecondsIsTold) {
    // MATLAB's days since the year 0, of samples at 100 Hz
    write(
        {numbers("time", {738'000.5, 738'000.5 + 0.01 / 86'400, 738'000.5 + 0.02 / 86'400}), numbers("y", {1, 2, 3})});
    Outcome<MeasurementFile> opened = openRecording(file);
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_EQ(opened->groups[0].channels[0].unit, "d");
    EXPECT_THAT(notes(*opened), HasSubstr("'time' begin at 738000.5 and are taken for days"));
    write({numbers("time", {1'709'632'800'000, 1'709'632'800'010, 1'709'632'800'020}), numbers("y", {1, 2, 3})});
    opened = openRecording(file);
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_EQ(opened->groups[0].channels[0].unit, "ms");
    EXPECT_THAT(notes(*opened), HasSubstr("taken for ms since 1970"));
    // nine days of a clock of seconds, or days at ten minutes
    write({numbers("time", {738'000.5, 738'000.507, 738'000.514}), numbers("y", {1, 2, 3})});
    opened = openRecording(file);
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_EQ(opened->groups[0].channels[0].unit, "s");
    EXPECT_THAT(notes(*opened), HasSubstr("it is taken in seconds, and may be in days"));
    write({numbers("time", {0, 0.5, 1}), numbers("y", {1, 2, 3})});
    EXPECT_EQ(notes(*openRecording(file)), "");
}

TEST_P(MatTest, ACutFileIsRefused) {
    write({numbers("t", {0, 0.5, 1}), numbers("y", {1, 2, 3})});
    std::filesystem::resize_file(file, std::filesystem::file_size(file) * 7 / 10);
    const Outcome<MeasurementFile> opened = openRecording(file);
    EXPECT_FALSE(opened);
}

TEST_P(MatTest, AFileThatEndsBehindItsSignatureIsSaidToBeCutShort) {
    if (GetParam() != MAT_FT_MAT73) GTEST_SKIP() << "HDF5 alone begins with a signature";
    write({numbers("t", {0, 0.5, 1}), numbers("y", {1, 2, 3})});
    std::filesystem::resize_file(file, 544);
    const Outcome<MeasurementFile> opened = openRecording(file);
    ASSERT_FALSE(opened);
    EXPECT_NE(opened.diagnostics()[0].message.english().find("damaged or ends too early"), std::string::npos);
    EXPECT_NE(opened.diagnostics()[0].hint.english().find("copy it again"), std::string::npos);
}

TEST_P(MatTest, DamagedBytesCostNoMoreThanTheFile) {
    write({numbers("t", {0, 0.5, 1}), numbers("y", {1, 2, 3, 4, 5, 6}, 2), text("note", "bench")});
    std::ostringstream content;
    content << std::ifstream(file, std::ios::binary).rdbuf();
    const std::string whole = content.str();
    std::uint32_t state = 3;
    for (std::size_t i = 0; i < 300; ++i) {
        std::string bytes = whole;
        state = state * 1664525u + 1013904223u;
        bytes[(state >> 8) % bytes.size()] = static_cast<char>(state >> 24);
        std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
        const Outcome<MeasurementFile> opened = openRecording(file);
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
