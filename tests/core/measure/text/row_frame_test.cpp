#include "core/measure/text/row_frame.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/measure/text/text_file.hpp"

namespace analogon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// As a text, and from a file, which is changed while it is loaded.
TextFile read(const std::string& text) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("analogon-frame-" + std::to_string(getpid()) + ".csv");
    std::ofstream(path, std::ios::binary) << text;
    Questions asked;
    Outcome<TextFile> ofFile = readTextFile(path, {}, {}, asked), ofText = readTextFile(text, "frame.csv", {});
    std::filesystem::remove(path);
    EXPECT_TRUE(ofText) << format(ofText.diagnostics());
    EXPECT_TRUE(ofFile) << format(ofFile.diagnostics());
    if (!ofFile || !ofText) return {};
    for (const Column& column : ofText->groups.at(0).table.columns)
        EXPECT_EQ(ofFile->groups.at(0).table.find(column.name)->values, column.values) << column.name;
    return *ofText;
}

TEST(RowFrame, SettingsBesideTheFirstSamplesTellTheirUnits) {
    const std::vector<std::string> settings{"Record Length,20",   "Sample Interval,0.1", "Trigger Point,5",  ",",
                                            "Source,CH1",         "Vertical Units,V",    "Vertical Scale,2", ",",
                                            "Horizontal Units,s", "Horizontal Scale,1",  "Model,X20"};
    std::string text;
    for (std::size_t i = 0; i < 20; ++i)
        text += fmt::format("{},,{:.3f},{:.2f},\n", i < settings.size() ? settings[i] : ",",
                            0.1 * static_cast<double>(i) - 0.5, 20 + 0.5 * static_cast<double>(i));
    const TextFile file = read(text);
    const TextGroup& group = file.groups.at(0);
    ASSERT_EQ(group.table.columns.size(), 2u);
    ASSERT_TRUE(group.time);
    EXPECT_EQ(group.table.columns[0].unit, "s");
    EXPECT_EQ(group.table.columns[0].values.front(), -0.5);
    EXPECT_EQ(group.table.columns[1].name, "CH1");
    EXPECT_EQ(group.table.columns[1].unit, "V");
    EXPECT_EQ(group.table.columns[1].values.back(), 29.5);
    EXPECT_THAT(file.found.english(), HasSubstr("settings beside"));
}

TEST(RowFrame, ColumnsOfWordsInFrontOfNumbersStay) {
    std::string text = "state,mode,t [s],u [V]\n";
    for (int i = 0; i < 12; ++i) text += fmt::format("run,auto,{},{}.5\n", i, i);
    EXPECT_EQ(read(text).groups.at(0).table.columns.size(), 4u);
}

TEST(RowFrame, MarksAroundWholeLinesAreTakenOff) {
    std::string text = "\"t [s];u [V]\"\r\n";
    for (int i = 0; i < 12; ++i) text += fmt::format("\"0,{:02};{},5\"\r\n", i, i);
    const Table table = read(text).groups.at(0).table;
    ASSERT_EQ(table.columns.size(), 2u);
    EXPECT_EQ(table.find("t")->values.back(), 0.11);
    EXPECT_EQ(table.find("u")->values.back(), 11.5);
}

TEST(RowFrame, ADecimalCommaInAStampIsNoColumn) {
    std::string text = "Timestamp,u [V],i [A]\n";
    for (int i = 0; i < 12; ++i) text += fmt::format("2024-06-15 10:30:0{},{}00,{}.5,-1\n", i / 10, i % 10, i);
    const TextGroup group = read(text).groups.at(0);
    ASSERT_TRUE(group.time);
    EXPECT_DOUBLE_EQ(group.table.columns[*group.time].values.back(), 1.1);
    EXPECT_EQ(group.table.find("u")->values.back(), 11.5);
    EXPECT_EQ(group.table.find("i")->values.back(), -1);
}

TEST(RowFrame, ANumberBehindAStampThatHasAColumnIsOne) {
    std::string text = "Timestamp,n [rpm],i [A]\n";
    for (int i = 0; i < 12; ++i) text += fmt::format("2024-06-15 10:30:{:02},{}00,{}.5\n", i, 1 + i % 9, i);
    const Table table = read(text).groups.at(0).table;
    EXPECT_EQ(table.columns.size(), 3u);
    EXPECT_EQ(table.find("n")->values.front(), 100);
}

}  // namespace
}  // namespace analogon
