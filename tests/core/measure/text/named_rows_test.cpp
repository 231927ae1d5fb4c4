#include "core/measure/text/named_rows.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace analogon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class RowsWithNames : public testing::Test {
protected:
    bool read(const std::string& text) {
        Outcome<TextFile> read = readTextFile(text, "long.csv", {});
        told = format(read.diagnostics());
        if (read) file = std::move(*read);
        return read.hasValue();
    }
    const std::vector<double>& times(std::size_t group) const {
        return file.groups.at(group).table.columns.at(0).values;
    }
    const Column& value(std::size_t group) const { return file.groups.at(group).table.columns.at(1); }

    TextFile file;
    std::string told;
};

TEST_F(RowsWithNames, AreOneChannelForEachName) {
    std::string text = "time;name;value;unit\n";
    for (int i = 0; i < 5; ++i) text += fmt::format("{0}.5;U;{1}.25;V\n{0}.75;speed;-{1};rpm\n", i, i + 20);
    text += "6.5;U;30;V\n";
    ASSERT_TRUE(read(text)) << told;
    ASSERT_EQ(file.groups.size(), 2u);
    EXPECT_THAT(times(0), ElementsAre(0.5, 1.5, 2.5, 3.5, 4.5, 6.5));
    EXPECT_EQ(value(0).name, "U");
    EXPECT_EQ(value(0).unit, "V");
    EXPECT_THAT(value(0).values, ElementsAre(20.25, 21.25, 22.25, 23.25, 24.25, 30));
    EXPECT_THAT(times(1), ElementsAre(0.75, 1.75, 2.75, 3.75, 4.75));
    EXPECT_EQ(value(1).name, "speed");
    EXPECT_EQ(value(1).unit, "rpm");
    EXPECT_THAT(told, HasSubstr("there are 2 channels"));
}

TEST_F(RowsWithNames, ShareTheBeginningOfTheirDates) {
    std::string text = "\"VarName\";\"TimeString\";\"VarValue\";\"Validity\"\n";
    for (int i = 0; i < 4; ++i)
        text += fmt::format("\"T_oil\";\"15.06.2024 10:30:0{0}\";{0},5;1\n\"p_oil\";\"15.06.2024 10:30:0{1}\";2,5;1\n",
                            i, i + 1);
    ASSERT_TRUE(read(text)) << told;
    ASSERT_EQ(file.groups.size(), 2u);
    EXPECT_THAT(times(0), ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(times(1), ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(value(0).values, ElementsAre(0.5, 1.5, 2.5, 3.5));
}

TEST_F(RowsWithNames, MayBeNumbersOfChannels) {
    std::string text = "Index,Channel,Reading,Unit,Time (s)\n";
    for (int i = 0; i < 4; ++i) text += fmt::format("{},101,{}.5,V,{}\n{},102,7,A,{}.5\n", 2 * i, i, i, 2 * i + 1, i);
    ASSERT_TRUE(read(text)) << told;
    ASSERT_EQ(file.groups.size(), 2u);
    EXPECT_EQ(value(0).name, "Channel 101");
    EXPECT_EQ(value(0).unit, "V");
    EXPECT_THAT(value(0).values, ElementsAre(0.5, 1.5, 2.5, 3.5));
    EXPECT_EQ(value(1).unit, "A");
}

TEST_F(RowsWithNames, ThatAreCalledOtherwiseAreNotMixed) {
    std::string text = "time,place,amount\n";
    for (int i = 0; i < 8; ++i) text += fmt::format("{0},front,{0}.5\n{0},rear,-{0}\n", i);
    EXPECT_FALSE(read(text));
    EXPECT_THAT(told, HasSubstr("rows of several channels"));
}

TEST_F(RowsWithNames, AreNoneWhereAStateStandsBesideAValue) {
    std::string text = "time,state,value\n";
    for (int i = 0; i < 9; ++i) text += fmt::format("{0},{1},{0}.5\n", i, i < 4 ? "heating" : "holding");
    ASSERT_TRUE(read(text)) << told;
    ASSERT_EQ(file.groups.size(), 1u);
    EXPECT_EQ(value(0).name, "state");
    EXPECT_EQ(file.groups[0].table.columns.at(2).values.size(), 9u);
}

}  // namespace
}  // namespace analogon
