#include "core/measure/text/labelled.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/measure/text/text_file.hpp"

namespace analogon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TextFile read(std::string_view text) {
    Outcome<TextFile> file = readTextFile(text, "serial.txt", {});
    EXPECT_TRUE(file.hasValue()) << format(file.diagnostics());
    return file ? *file : TextFile{};
}

TEST(LabelledText, NamesInFrontOfNumbersAreThoseOfTheColumns) {
    const TextFile file = read("T1:20.5,T2:-3,pwm:128\nT1:20.6,T2:-4,pwm:129\nT1:20.75,T2:-5,pwm:130\n");
    ASSERT_EQ(file.groups.size(), 1u);
    EXPECT_THAT(file.groups[0].table.names(), ElementsAre("T1", "T2", "pwm"));
    EXPECT_THAT(file.groups[0].table.find("T2")->values, ElementsAre(-3, -4, -5));
    EXPECT_THAT(file.found.english(), HasSubstr("names in front of the numbers"));
}

TEST(LabelledText, AStampInBracketsIsTheTime) {
    const TextFile file = read(
        "[2024-03-05 10:00:00.5] INFO T=23.5 P = 3\n[2024-03-05 10:00:01.5] INFO T=24 P = 4\n"
        "[2024-03-05 10:00:02.5] INFO T=25 P = 6\n");
    const TextGroup& group = file.groups.at(0);
    ASSERT_TRUE(group.time);
    EXPECT_THAT(group.table.columns[*group.time].values, ElementsAre(0, 1, 2));
    EXPECT_THAT(group.table.find("T")->values, ElementsAre(23.5, 24, 25));
    EXPECT_THAT(group.table.find("P")->values, ElementsAre(3, 4, 6));
}

TEST(LabelledText, AnArrowBehindAStampPartsItFromTheValues) {
    for (const char* const separator : {"\t", ",", ";", " "}) {
        const std::string s = separator;
        const TextFile file =
            read("12:00:00.250 -> 20.5" + s + "1\n12:00:00.500 -> 20.6" + s + "2\n12:00:00.750 -> 20.75" + s + "3\n");
        const TextGroup& group = file.groups.at(0);
        ASSERT_TRUE(group.time) << s;
        EXPECT_THAT(group.table.columns[*group.time].values, ElementsAre(0, 0.25, 0.5)) << s;
        EXPECT_THAT(group.table.columns.back().values, ElementsAre(1, 2, 3)) << s;
    }
}

TEST(LabelledText, KeysOfAPreambleAndClocksAreNoNames) {
    std::string store;
    EXPECT_FALSE(withoutLabels("Interval: 0.1\nStart: 3\nRange: 5\nt,u\n0,1\n1,2\n2,3\n", store));
    EXPECT_FALSE(withoutLabels("time,u\n10:00:00,1\n10:00:01,2\n10:00:02,3\n", store));
    EXPECT_FALSE(withoutLabels("T:1\nT:2\n", store)) << "too few to tell";
}

}  // namespace
}  // namespace analogon
