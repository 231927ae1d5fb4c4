#include "core/measure/text/channel_times.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/measure/text/question_rows.hpp"
#include "core/measure/text/text_file.hpp"
#include "core/measure/text/text_recording.hpp"

namespace analogon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// The columns of each group, the time in front.
using Groups = std::vector<std::vector<std::string>>;

struct Read {
    Groups groups;
    std::vector<std::size_t> rows;
    Questions asked;
    std::string told;
};

Read read(const std::string& text, TimeColumns times = TimeColumns::Found) {
    ReadOptions options;
    options.times = times;
    Read out;
    const Outcome<TextFile> file = readTextFile(text, "test.csv", options, {}, out.asked);
    out.told = format(file.diagnostics());
    EXPECT_TRUE(file.hasValue()) << out.told;
    if (!file) return out;
    for (const TextGroup& group : file->groups) {
        std::vector<std::string> names;
        if (group.time) names.push_back(group.table.columns[*group.time].name);
        for (std::size_t i = 0; i < group.table.columns.size(); ++i)
            if (group.time != i) names.push_back(group.table.columns[i].name);
        out.groups.push_back(names);
        out.rows.push_back(group.table.lines.size());
    }
    return out;
}

/// Two pairs, the second slower and shorter.
std::string pairs(const std::string& head) {
    std::string text = head + "\n";
    for (int i = 0; i < 12; ++i) {
        text += std::to_string(i) + "e-2;" + std::to_string(20 + i % 3) + ";";
        text += i < 4 ? std::to_string(5 * i) + "e-2;" + std::to_string(300 - i) + "\n" : ";\n";
    }
    return text;
}

/// Two pairs in full rows: the second time is `factor` times the first, later by `shift` hundredths of a second.
std::string full(const std::string& head, int factor, int shift = 0) {
    std::string text = head + "\n";
    for (int i = 0; i < 12; ++i)
        text += std::to_string(i) + "e-2;" + std::to_string(20 + i % 3) + ";" + std::to_string(factor * i + shift) +
                "e-2;" + std::to_string(300 - i) + "\n";
    return text;
}

TEST(ChannelTimes, EachChannelHasTheTimeInFrontOfItHoweverThatIsCalled) {
    for (const char* head :
         {"t1 [s];a [V];t2 [s];b [A]", "t1;a;t2;b", "t_a;a;t_b;b", "torque.time;a;speed.time;b",
          "time [s];a;runtime [s];b", "t [s];a;t_gps [s];b", "Zeit;a;Zeit 2;b", "t [s];a;ECU_Time [s];b"}) {
        const Read file = read(pairs(head));
        ASSERT_EQ(file.groups.size(), 2u) << head << "\n" << file.told;
        EXPECT_EQ(file.groups[0].back(), "a") << head;
        EXPECT_EQ(file.groups[1].back(), "b") << head;
        EXPECT_THAT(file.rows, ElementsAre(12, 4)) << head;
        EXPECT_THAT(file.told, HasSubstr("2 columns of time: each channel belongs to the one on its left")) << head;
        EXPECT_THAT(file.asked, IsEmpty()) << head << ": rows that end tell it";
    }
}

TEST(ChannelTimes, TheValuesStandAtTheirOwnTimes) {
    const Outcome<Table> table = textTables(pairs("t1;a;t2;b"), "test.csv");
    ASSERT_TRUE(table) << format(table.diagnostics());
    ASSERT_EQ(table->others.size(), 1u);
    const Table& slow = *table->others.front();
    ASSERT_TRUE(slow.time);
    EXPECT_THAT(slow.columns[*slow.time].values, ElementsAre(0, 0.05, 0.1, 0.15));
    EXPECT_THAT(slow.find("b")->values, ElementsAre(300, 299, 298, 297));
}

TEST(ChannelTimes, ATimeBehindItsChannelIsTakenForThat) {
    std::string text = "a [V];t_a [s];b [A];t_b [s]\n";
    for (int i = 0; i < 8; ++i)
        text += "1." + std::to_string(i) + ";" + std::to_string(i) + "e-2;" +
                (i < 3 ? "7;" + std::to_string(4 * i) + "e-2\n" : ";\n");
    const Read file = read(text);
    EXPECT_EQ(file.groups, (Groups{{"t_a", "a"}, {"t_b", "b"}})) << file.told;
    EXPECT_THAT(file.told, HasSubstr("the one on its right"));
}

TEST(ChannelTimes, TimesInFrontOfAllChannelsAreToldApartByTheirLengths) {
    std::string text = "time_fast [s];time_slow [s];a [V];b [A]\n", even = text;
    for (int i = 0; i < 8; ++i) {
        const std::string fast = std::to_string(i) + "e-2;", slow = std::to_string(4 * i) + "e-2;";
        text += fast + (i < 3 ? slow : ";") + "1." + std::to_string(i) + ";" + (i < 3 ? "7\n" : "\n");
        even += fast + slow + "1." + std::to_string(i) + ";7\n";
    }
    const Read file = read(text);
    EXPECT_EQ(file.groups, (Groups{{"time_fast", "a"}, {"time_slow", "b"}})) << file.told;
    EXPECT_THAT(file.rows, ElementsAre(8, 3));
    const Read open = read(even);
    EXPECT_EQ(open.groups.size(), 1u);
    EXPECT_THAT(open.told, HasSubstr("'time_fast' and 'time_slow' are both times and differ"));
    EXPECT_EQ(open.asked.size(), 1u);
}

TEST(ChannelTimes, WhereARowMayBeOneMomentBothReadingsAreShown) {
    const std::string text = full("t1 [s];a [V];t2 [s];b [A]", 5);
    const Read file = read(text);
    EXPECT_EQ(file.groups, (Groups{{"t1", "a"}, {"t2", "b"}}));
    ASSERT_EQ(file.asked.size(), 1u);
    ASSERT_EQ(file.asked[0].readings.size(), 2u);
    EXPECT_EQ(file.asked[0].readings[0].options.times, TimeColumns::Left);
    EXPECT_EQ(file.asked[0].readings[1].options.times, TimeColumns::One);
    const QuestionRows rows = rowsUnder(text, "test.csv", file.asked[0], 2);
    EXPECT_EQ(rows.column, "b");
    ASSERT_EQ(rows.rows.size(), 2u);
    EXPECT_EQ(rows.rows[0].line, 3) << "the first row is the same moment";
    EXPECT_EQ(rows.rows[0].values[0].english(), "299 A at 0.05 s");
    EXPECT_EQ(rows.rows[0].values[1].english(), "299 A at 0.01 s");
    EXPECT_EQ(read(text, TimeColumns::One).groups, (Groups{{"t1", "a", "t2", "b"}}));
    EXPECT_THAT(read(text, TimeColumns::One).asked, IsEmpty());
    EXPECT_EQ(read(text, TimeColumns::Left).groups, file.groups);
    EXPECT_THAT(read(text, TimeColumns::Left).asked, IsEmpty());
}

TEST(ChannelTimes, ALoggerThatWasStartedLaterKeepsItsShift) {
    const Read later = read(full("t1 [s];a [V];t2 [s];b [A]", 1, 3));
    EXPECT_EQ(later.groups, (Groups{{"t1", "a"}, {"t2", "b"}}));
    EXPECT_EQ(later.asked.size(), 1u);
    const Read sinceMidnight = read(full("Time [s];a [V];Time of day [s];b [A]", 1, 40000));
    EXPECT_EQ(sinceMidnight.groups.size(), 1u) << "the same moments, counted from elsewhere";
    EXPECT_THAT(sinceMidnight.asked, IsEmpty());
}

TEST(ChannelTimes, ThoseOfTheSameMomentsAreOneWhateverTheirUnits) {
    EXPECT_EQ(read(full("t1 [s];a [V];t2 [s];b [A]", 1)).groups.size(), 1u);
    std::string text = "t [s];a [V];t [ms];b [A]\n";
    for (int i = 0; i < 8; ++i)
        text += std::to_string(i) + "e-2;1;" + std::to_string(10 * i) + ";" + std::to_string(i) + "\n";
    const Read file = read(text);
    EXPECT_EQ(file.groups.size(), 1u) << file.told;
    EXPECT_THAT(file.asked, IsEmpty());
}

TEST(ChannelTimes, AClockThatIsRecordedBesideTheTimeIsAskedAbout) {
    std::string text = "Time [s];a [V];ECU_Time [s];b [A]\n";
    for (int i = 0; i < 400; ++i)
        text += std::to_string(i) + "e-2;1." + std::to_string(i % 7) + ";" + std::to_string(320000 + 1000 * i + i) +
                "e-5;" + std::to_string(i) + "\n";
    const Read file = read(text);
    EXPECT_EQ(file.groups.size(), 1u);
    ASSERT_EQ(file.asked.size(), 1u) << file.told;
    EXPECT_EQ(file.asked[0].readings[0].options.times, TimeColumns::One) << "what is taken stands first";
    EXPECT_THAT(file.told, HasSubstr("all channels are taken to have 'Time'"));
    EXPECT_EQ(read(text, TimeColumns::Left).groups, (Groups{{"Time", "a"}, {"ECU_Time", "b"}}));
}

TEST(ChannelTimes, ASecondTimeThatGoesBackIsOneAllTheSame) {
    std::string text = "t1 [s];a [V];t2 [s];b [A]\n";
    for (int i = 0; i < 20; ++i)
        text += std::to_string(i) + "e-2;1;" + std::to_string(i == 13 ? 1 : 5 * i) + "e-2;" + std::to_string(i) + "\n";
    EXPECT_EQ(read(text).groups, (Groups{{"t1", "a"}, {"t2", "b"}})) << "its fault is told where it is used";
}

TEST(ChannelTimes, WhatIsMeasuredIsNoTime) {
    // temperatures that rise, a duration that is counted, and a date beside a time
    std::string text = "t1;t2;p\n", counted = "time [s];a [V];heating time [s];b [A]\n";
    for (int i = 0; i < 12; ++i) {
        text += std::to_string(20 + i) + "." + std::to_string((i * 7) % 10) + ";" + std::to_string(40 + i * i) + ";1\n";
        counted += std::to_string(i) + ";1;" + std::to_string(i / 3) + ";2\n";
    }
    const Read warm = read(text);
    EXPECT_EQ(warm.groups, (Groups{{"t1", "t2", "p"}}));
    EXPECT_THAT(warm.told, HasSubstr("no column is a time"));
    EXPECT_EQ(read(counted).groups.size(), 1u);
    EXPECT_THAT(read(counted).told, Not(HasSubstr("columns of time")));
}

}  // namespace
}  // namespace analogon
