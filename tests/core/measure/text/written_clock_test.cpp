#include "core/measure/text/written_clock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/measure/text/text_file.hpp"

namespace analogon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(WrittenClock, IsToldFromSecondsByItsSteps) {
    EXPECT_TRUE(seemsWrittenClock({103058, 103059, 103100, 103101}));
    EXPECT_TRUE(seemsWrittenClock({95958.5, 95959.5, 100000.5}));
    EXPECT_TRUE(seemsWrittenClock({58, 59, 100, 101}));           // a minute past midnight
    EXPECT_TRUE(seemsWrittenClock({103000, 103100, 103200}));     // a minute each, or a hundred seconds
    EXPECT_FALSE(seemsWrittenClock({0, 100, 200, 300}));          // begins at zero, and is even as it stands
    EXPECT_FALSE(seemsWrittenClock({103058, 103059, 103060}));    // a sixtieth second
    EXPECT_FALSE(seemsWrittenClock({103000, 103001, 103002.5}));  // the same either way
    EXPECT_FALSE(seemsWrittenClock({1, 2, 100, 250}));
}

TEST(WrittenClock, MayHaveTheDateInFront) {
    EXPECT_EQ(writtenFormat({20240615103058, 20240615103059, 20240615103100}), "%Y%m%d%H%M%S");
    EXPECT_EQ(writtenFormat({202406151030, 202406151031}), "%Y%m%d%H%M");
    EXPECT_EQ(writtenFormat({20240630, 20240701}), "%Y%m%d");
    EXPECT_EQ(writtenFormat({103058, 103059, 103100, 103101}), "%H%M%S");
    EXPECT_EQ(writtenFormat({20240615, 20240632}), "");  // no such day
    EXPECT_EQ(writtenFormat({0, 1, 2}), "");
}

TEST(WrittenClock, IsAskedFor) {
    const std::string text = "time,T,p\n103058.5,20.5,101300\n103059.5,21,101400\n103100.5,22,101500\n";
    Questions asked;
    const Outcome<TextFile> open = readTextFile(text, "gps.csv", {}, {}, asked);
    EXPECT_FALSE(open);
    EXPECT_THAT(format(open.diagnostics()), HasSubstr("hours, minutes and seconds in one number"));
    ASSERT_EQ(asked.size(), 1u);
    ASSERT_EQ(asked[0].readings.size(), 2u);
    const auto timesBy = [&](const ReadOptions& options) {
        const Outcome<TextFile> file = readTextFile(text, "gps.csv", options);
        EXPECT_TRUE(file) << format(file.diagnostics());
        if (!file) return std::vector<double>();
        EXPECT_THAT(file->groups.at(0).table.find("p")->values, ElementsAre(101300, 101400, 101500));  // no clock
        return file->groups[0].table.columns[file->groups[0].time.value()].values;
    };
    EXPECT_THAT(timesBy(asked[0].readings[0].options), ElementsAre(0, 1, 2));
    EXPECT_THAT(timesBy(asked[0].readings[1].options), ElementsAre(103058.5, 103059.5, 103100.5));
}

}  // namespace
}  // namespace analogon
