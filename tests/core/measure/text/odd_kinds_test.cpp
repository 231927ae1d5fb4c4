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
