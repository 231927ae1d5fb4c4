#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/measure/text/text_recording.hpp"

/// Ways to write a table that programs have beside the usual ones, each as a kind.
namespace analogon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class OddKinds : public testing::Test {
protected:
    void read(const std::string& text) {
        const LookedAtText looked = lookAtText(text, "odd.csv");
        ASSERT_TRUE(looked.table) << format(looked.table.diagnostics());
        table = *looked.table;
        start = looked.recording->start;
        told = format(looked.table.diagnostics());
    }
    const Column& column(const std::string& name) const {
        const Column* const found = table->find(name);
        static const Column none;
        EXPECT_TRUE(found) << name;
        return found ? *found : none;
    }

    std::shared_ptr<const Table> table;
    std::string start, told;
};

TEST_F(OddKinds, OneLetterBehindEveryNumberOfAColumnIsItsUnit) {
    read("t,u,state\n0s,1.5,1A\n1s,2,2B\n2s,-3.5,3A\n3s,4,1B\n");  // neither are the last rows a footer
    EXPECT_EQ(column("t").unit, "s");
    EXPECT_THAT(column("t").values, ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(column("u").values, ElementsAre(1.5, 2, -3.5, 4));
    EXPECT_EQ(table->find("state"), nullptr);  // amperes and bytes: words
}

TEST_F(OddKinds, APrefixBehindNumbersIsNotTakenForMetres) {
    const LookedAtText looked = lookAtText("t [s],u\n0,200.5m\n1,210.5m\n2,220.5m\n3,230.5m\n", "odd.csv");
    EXPECT_TRUE(!looked.table || !looked.table.value()->find("u"));
}

TEST_F(OddKinds, AKeyInFrontOfTheNamesShiftsNoColumn) {
    read(
        "\"Model\",\"X\"\n\"TraceName\",\"CH1\",\"CH2\"\n\"VUnit\",\"V\",\"A\"\n\"HResolution\",0.1,0.1\n"
        "\"HOffset\",-1,-1\n\"HUnit\",\"s\",\"s\"\n20.5,-3,\n21.5,-4,\n22.5,-6,\n");
    EXPECT_THAT(column("CH1").values, ElementsAre(20.5, 21.5, 22.5));
    EXPECT_EQ(column("CH1").unit, "V");
    EXPECT_THAT(column("CH2").values, ElementsAre(-3, -4, -6));
    EXPECT_EQ(column("CH2").unit, "A");
    EXPECT_THAT(column("time").values, ElementsAre(-1, testing::DoubleEq(-0.9), testing::DoubleEq(-0.8)));
}

TEST_F(OddKinds, CellsThatOnlyTheFirstRowsHaveAreEmptyInTheOthers) {
    read(
        "no,Time,T [degC],Serial\n1,10:00:00,20.5,A17\n2,10:00:01,21\n3,10:00:02,22\n4,10:00:03,23\n"
        "5,10:00:04,24\n6,10:00:05,25\n");
    EXPECT_THAT(column("T").values, ElementsAre(20.5, 21, 22, 23, 24, 25));
    EXPECT_THAT(column("Time").values, ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST_F(OddKinds, ATimeWithAUnitAndWithoutAName) {
    read("in s,C1 in V\n0,1.5\n0.5,2\n1,4\n");
    EXPECT_EQ(column("c1").unit, "s");
    EXPECT_EQ(column("C1").unit, "V");
    EXPECT_EQ(told.find("no column is a time"), std::string::npos);
}

TEST_F(OddKinds, ChannelsInRowsAreToldToBe) {
    const LookedAtText looked = lookAtText("Time [s];0;0.5;1;1.5\nU [V];20.5;21;22;23\nI [A];1;2;3;5\n", "odd.csv");
    EXPECT_FALSE(looked.table);
    EXPECT_THAT(format(looked.table.diagnostics()), HasSubstr("stand in rows"));
    read("state;t [s];u [V]\nheat;0;0.5\nhold;1;1.5\nend;2;2.5\n");
    EXPECT_THAT(column("t").values, ElementsAre(0, 1, 2));
}

TEST_F(OddKinds, AQuotientOfANameAndAUnitInBrackets) {
    read("Zeit/s;n/(1/min)\n0;1000\n1;1100\n2;1300\n");
    EXPECT_EQ(column("n").unit, "1/min");
}

TEST_F(OddKinds, ARateAboveOneColumn) {
    read("Sample Rate: 10 Hz\nU [V]\n20.5\n21\n22.5\n");
    EXPECT_THAT(column("U").values, ElementsAre(20.5, 21, 22.5));
    EXPECT_THAT(column("time").values, ElementsAre(0, 0.1, 0.2));
}

TEST_F(OddKinds, ASecondRecordingBelowIsToldToBeOne) {
    const std::string head = "Channels\t2\nSamples\t3\nX_Value\tU [V]\tI [A]\n";
    const LookedAtText looked =
        lookAtText(head + "0\t1.5\t2\n0.5\t2\t3\n1\t4\t5\n" + head + "0\t1\t2\n0.5\t2\t3\n1\t4\t5\n", "odd.txt");
    EXPECT_FALSE(looked.table);
    EXPECT_THAT(format(looked.table.diagnostics()),
                testing::AnyOf(HasSubstr("two recordings"), HasSubstr("header stands here again")));
}

TEST_F(OddKinds, UnitsBehindTheNumbersWithoutABlank) {
    read("t,u,f\n0.0s,1.5V,20kHz\n0.1s,2V,21kHz\n0.2s,-3.5V,22kHz\n");
    EXPECT_EQ(column("t").unit, "s");
    EXPECT_EQ(column("u").unit, "V");
    EXPECT_THAT(column("u").values, ElementsAre(1.5, 2, -3.5));
    EXPECT_THAT(column("f").values, ElementsAre(20, 21, 22));
}

TEST_F(OddKinds, CodesThatLookLikeQuantitiesAreWords) {
    read("t [s],part\n0,2A\n1,3A\n2,2A\n");
    EXPECT_THAT(table->texts, ElementsAre("part"));
    EXPECT_THAT(told, HasSubstr("column 'part' is read as text: '2A' is no number"));
}

TEST_F(OddKinds, UnitsInOtherBrackets) {
    read("t{s},p<bar>,x {raw}\n0,1,2\n1,2,3\n2,3,4\n");
    EXPECT_EQ(column("t").unit, "s");
    EXPECT_EQ(column("p").unit, "bar");
    EXPECT_EQ(column("x {raw}").unit, "") << "a remark is none";
}

TEST_F(OddKinds, NumbersThatAreWordsAreTold) {
    read("t [s];R [Ohm];n\n0;1.5k;1,00,200.5\n1;2.5k;1,00,201.5\n2;3k;1,00,202.5\n");
    EXPECT_THAT(told, HasSubstr("column 'R' is read as text: '1.5k' is no number"));
    EXPECT_THAT(told, HasSubstr("column 'n' is read as text: '1,00,200.5' is no number"));
    read("t [s];state\n0;idle\n1;run\n2;idle\n");
    EXPECT_EQ(told, "");
}

TEST_F(OddKinds, TheNewestRowFirst) {
    read("time [s],u [V],state\n0.4,1,c\n0.2,NaN,b\n0.1,3,b\n0,4,a\n");
    ASSERT_TRUE(table->time);
    EXPECT_THAT(column("time").values, ElementsAre(0, 0.1, 0.2, 0.4));
    EXPECT_EQ(column("u").values[0], 4);
    EXPECT_EQ(column("u").values[1], 3);
    ASSERT_EQ(column("u").blanks.size(), 1u);
    EXPECT_EQ(column("u").blanks[0].row, 2u) << "a gap goes with its row";
    EXPECT_THAT(table->lines, ElementsAre(5, 4, 3, 2));
    EXPECT_THAT(told, HasSubstr("the newest stands first"));
}

TEST_F(OddKinds, TheNewestStampFirst) {
    read("Time,u [V]\n03/14/2024 10:00:02,3\n03/14/2024 10:00:01,2\n03/14/2024 10:00:00,1\n");
    EXPECT_THAT(column("Time").values, ElementsAre(0, 1, 2));
    EXPECT_THAT(column("u").values, ElementsAre(1, 2, 3));
    EXPECT_EQ(start, "2024-03-14T10:00:00");
    // day and month are told apart by what keeps the rows in one order, also in this one
    read("Time,u [V]\n02/04/2024 00:00:00,3\n01/04/2024 00:00:00,2\n12/03/2024 00:00:00,1\n");
    EXPECT_EQ(start, "2024-03-12T00:00:00");
}

}  // namespace
}  // namespace analogon
