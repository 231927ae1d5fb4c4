#include "core/measure/text/counted_days.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/measure/text/text_file.hpp"

namespace analogon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class CountedDays : public testing::Test {
protected:
    /// The times of a table with these stamps; empty: a fault, which is told.
    std::vector<double> timesOf(const std::string& header, const std::vector<std::string>& stamps,
                                const ReadOptions& options = {}) {
        std::string text = header + ";u [V]\n";
        for (std::size_t i = 0; i < stamps.size(); ++i) text += stamps[i] + ';' + std::to_string(i) + ".5\n";
        asked.clear();
        const Outcome<TextFile> file = readTextFile(text, "days.csv", options, {}, asked);
        told = format(file.diagnostics());
        return file && file->groups.at(0).time ? file->groups[0].table.columns[*file->groups[0].time].values
                                               : std::vector<double>();
    }

    std::string told;
    Questions asked;
};

TEST_F(CountedDays, OneStampTellsForAllOfAColumn) {
    EXPECT_THAT(timesOf("Time", {"99:23:59:59", "100:00:00:00", "100:00:00:01"}), ElementsAre(0, 1, 2));
    EXPECT_THAT(timesOf("Time", {"1:10:30:05", "1:10:30:70", "1:10:31:35"}), ElementsAre(0, 0.65, 1.3));
    EXPECT_TRUE(timesOf("Time", {"167:10:30:00", "10:30:00:250"}).empty());
    EXPECT_THAT(told, HasSubstr("count days and some do not"));
}

TEST_F(CountedDays, TheHeaderTells) {
    EXPECT_THAT(timesOf("Time (dd:hh:mm:ss)", {"01:10:30:05", "01:10:30:06"}), ElementsAre(0, 1));
    EXPECT_THAT(timesOf("Time (hh:mm:ss:ff)", {"01:10:30:05", "01:10:30:06"}), ElementsAre(0, 0.01));
}

TEST_F(CountedDays, AreAskedForWhereNothingTells) {
    const std::vector<std::string> stamps{"01:10:30:05", "01:10:30:06"};
    EXPECT_TRUE(timesOf("Time", stamps).empty());
    EXPECT_THAT(told, HasSubstr("may be days, hours, minutes and seconds, or hours"));
    ASSERT_EQ(asked.size(), 1u);
    ASSERT_EQ(asked[0].readings.size(), 2u);
    const ReadOptions days = asked[0].readings[0].options, hundredths = asked[0].readings[1].options;
    EXPECT_THAT(timesOf("Time", stamps, days), ElementsAre(0, 1));
    EXPECT_THAT(timesOf("Time", stamps, hundredths), ElementsAre(0, testing::DoubleNear(0.01, 1e-12)));
}

TEST_F(CountedDays, AreNotMeantWhereADateStandsBeside) {
    const Outcome<TextFile> file =
        readTextFile("Date;Time;u [V]\n2024-06-15;01:10:30:05;1\n2024-06-15;01:10:30:06;2\n", "days.csv", {});
    ASSERT_TRUE(file) << format(file.diagnostics());
    const TextGroup& group = file->groups.at(0);
    ASSERT_TRUE(group.time);
    EXPECT_NEAR(group.table.columns[*group.time].values[1], 0.01, 1e-12);
}

}  // namespace
}  // namespace analogon
