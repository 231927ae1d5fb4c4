#include "core/measure/question.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/measure/text/question_rows.hpp"
#include "core/measure/text/text_file.hpp"

namespace analogon {
namespace {

using testing::ElementsAre;

/// What is asked of a text; each answer of a choice must be one that the reader takes, and must end the question.
Questions askedOf(const std::string& text, const ReadOptions& options = {}) {
    Questions asked;
    static_cast<void>(readTextFile(text, "test.csv", options, {}, asked));
    for (const Question& question : asked)
        for (const Reading& reading : question.readings) {
            Questions again;
            const Outcome<TextFile> read = readTextFile(text, "test.csv", reading.options, {}, again);
            EXPECT_TRUE(read.hasValue()) << reading.label.english() << ": " << format(read.diagnostics());
            for (const Question& next : again) EXPECT_NE(next.text, question.text) << reading.label.english();
        }
    return asked;
}

std::vector<std::string> valuesUnder(const QuestionRows& rows, std::size_t reading) {
    std::vector<std::string> values;
    for (const QuestionRow& row : rows.rows) values.push_back(row.values.at(reading));
    return values;
}

TEST(Question, NothingIsAskedOfATextThatTells) {
    EXPECT_TRUE(askedOf("t [s],u [V]\n0,1.5\n1,2.5\n").empty());
    EXPECT_TRUE(askedOf("t [s];u [V]\n0;1,5\n1;2,5\n").empty());
    EXPECT_TRUE(askedOf("time;u\n2024-03-04 10:00:00;1\n2024-03-04 10:00:01;2\n").empty());
}

TEST(Question, AMarkOfDecimalsOrThousandsIsAskedWithBothReadings) {
    const std::string text = "t [s];n [1/min]\n0;1.234\n1;2.345\n2;2.345\n";
    const Questions asked = askedOf(text);
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0].line, 2);
    ASSERT_EQ(asked[0].readings.size(), 2u);
    EXPECT_EQ(asked[0].readings[0].options.decimal, '.');
    EXPECT_EQ(asked[0].readings[1].options.thousands, '.');
    const QuestionRows rows = rowsUnder(text, "test.csv", asked[0], 2);
    EXPECT_EQ(rows.column, "n");
    ASSERT_EQ(rows.rows.size(), 2u);
    EXPECT_EQ(rows.rows[0].line, 2);
    EXPECT_EQ(rows.rows[0].text, "0;1.234");
    EXPECT_THAT(valuesUnder(rows, 0), ElementsAre("1.234 1/min", "2.345 1/min"));
    EXPECT_THAT(valuesUnder(rows, 1), ElementsAre("1234 1/min", "2345 1/min"));
}

TEST(Question, BesideDecimalsThatAreToldTheOtherMarkPartsThousands) {
    const std::string text = "t [s];T [degC];p [mbar]\n0;60,100;1.110\n1;60,107;1.113\n2;60,114;1.116\n";
    const Questions asked = askedOf(text);  // both answers are ways to read it
    ASSERT_EQ(asked.size(), 1u);
    const QuestionRows rows = rowsUnder(text, "test.csv", asked[0], 2);
    EXPECT_EQ(rows.column, "T");
    EXPECT_THAT(valuesUnder(rows, 0), ElementsAre("60.1 degC", "60.107 degC"));
    EXPECT_THAT(valuesUnder(rows, 1), ElementsAre("60100 degC", "60107 degC"));
}

TEST(Question, AMarkThatComesUpFarBelowIsAskedThere) {
    std::string text = "t;u\n";
    for (int i = 0; i < 30'000; ++i) text += fmt::format("{};{}\n", i, i);
    text += "30000;1.234\n30001;1.235\n";
    const Questions asked = askedOf(text);
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0].line, 30'002);
    const QuestionRows rows = rowsUnder(text, "test.csv", asked[0], 3);
    ASSERT_EQ(rows.rows.size(), 2u);
    EXPECT_EQ(rows.rows[0].line, 30'002);
    EXPECT_THAT(valuesUnder(rows, 1), ElementsAre("1234", "1235"));
}

TEST(Question, DayOrMonthInFrontIsAskedWithTheMoments) {
    const std::string text = "time,u\n03/04/2024 11:59:58 PM,1\n04/04/2024 12:00:00 AM,2\n05/04/2024 12:00:02 AM,3\n";
    const Questions asked = askedOf(text);
    ASSERT_EQ(asked.size(), 1u);
    ASSERT_EQ(asked[0].readings.size(), 2u);
    EXPECT_EQ(asked[0].readings[0].options.timeFormat, "%d/%m/%Y %I:%M:%S %p");
    EXPECT_EQ(asked[0].readings[1].options.timeFormat, "%m/%d/%Y %I:%M:%S %p");
    EXPECT_EQ(asked[0].readings[0].label, "2024-04-03 (day, month, year)");
    const QuestionRows rows = rowsUnder(text, "test.csv", asked[0], 2);
    EXPECT_THAT(valuesUnder(rows, 0), ElementsAre("2024-04-03 23:59:58", "2024-04-04 00:00:00"));
    EXPECT_THAT(valuesUnder(rows, 1), ElementsAre("2024-03-04 23:59:58", "2024-04-04 00:00:00"));
}

TEST(Question, ADateInAColumnOfItsOwnIsAskedToo) {
    const std::string text = "Date;Time;u\n03/04/24;10:00:00,5;1\n04/04/24;10:00:00,5;2\n05/04/24;10:00:00,5;3\n";
    const Questions asked = askedOf(text);
    ASSERT_EQ(asked.size(), 1u);
    ASSERT_GE(asked[0].readings.size(), 2u);
    EXPECT_EQ(asked[0].readings.back().options.timeFormat, "%m/%d/%y %H:%M:%S,%f");
}

TEST(Question, AClockOfTwoFieldsIsAsked) {
    const Questions asked = askedOf("clock;u\n10:30;1\n10:31;2\n10:32;3\n");
    ASSERT_EQ(asked.size(), 1u);
    const QuestionRows rows = rowsUnder("clock;u\n10:30;1\n10:31;2\n10:32;3\n", "test.csv", asked[0], 2);
    EXPECT_THAT(valuesUnder(rows, 0), ElementsAre("60 s", "120 s"));
    EXPECT_THAT(valuesUnder(rows, 1), ElementsAre("1 s", "2 s"));
}

TEST(Question, SecondsOrDaysAreAsked) {
    const Questions asked = askedOf("time;u\n45000.5;1\n45000.501;2\n45000.502;3\n");
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0].readings[1].options.timeFormat, "d");
}

TEST(Question, CountsSince1970AreReadAndAsked) {
    const std::string text = "time;u\n1700000000000;1\n1700000000010;2\n1700000000020;3\n";
    Questions asked;
    EXPECT_TRUE(readTextFile(text, "test.csv", {}, {}, asked).hasValue());
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0].readings[0].options.timeFormat, "ms") << "as it was read";
    EXPECT_EQ(asked[0].readings[1].options.timeFormat, "s");
    EXPECT_TRUE(askedOf(text, asked[0].readings[1].options).empty());
}

TEST(Question, SummerTimeIsAsked) {
    std::string text = "time;u\n";
    for (int i = 0; i < 8; ++i) text += fmt::format("2023-10-29 02:{}0:00;{}\n", i < 6 ? i : i - 6, i);
    text += "2023-10-29 02:20:00;9\n2023-10-29 02:30:00;10\n";
    Questions asked;
    EXPECT_FALSE(readTextFile(text, "test.csv", {}, {}, asked).hasValue());
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0].line, 8);
    EXPECT_EQ(asked[0].readings[0].options.timeZone, "Europe/Berlin");
    EXPECT_TRUE(readTextFile(text, "test.csv", asked[0].readings[0].options).hasValue());
}

TEST(Question, WhichOfTwoRecordingsIsAsked) {
    const Questions asked = askedOf("t,u\n0,1\n1,2\n2,3\nt,u\n0,5\n1,6\n2,7\n3,8\n");
    ASSERT_EQ(asked.size(), 1u);
    ASSERT_EQ(asked[0].readings.size(), 1u);
    const QuestionRows rows = rowsUnder("t,u\n0,1\n1,2\n2,3\nt,u\n0,5\n1,6\n2,7\n3,8\n", "test.csv", asked[0], 2);
    ASSERT_EQ(rows.rows.size(), 2u);
    EXPECT_EQ(rows.rows[0].text, "0,5");
}

TEST(Question, RowsWithoutATimeAreAskedForTheirStep) {
    const Questions asked = askedOf("u [V];i [A]\n1,5;2\n1,6;3\n1,7;1\n");
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0].kind, Question::Kind::Interval);
    ReadOptions options;
    options.timeFormat = "1 kHz";
    EXPECT_TRUE(askedOf("u [V];i [A]\n1,5;2\n1,6;3\n1,7;1\n", options).empty());
}

TEST(Question, OneQuestionFollowsAnother) {
    const std::string text =
        "time;u\n03/04/2024 10:00:00;1.234\n04/04/2024 10:00:00;1.235\n05/04/2024 10:00:00;1.236\n";
    Questions asked;
    EXPECT_FALSE(readTextFile(text, "test.csv", {}, {}, asked).hasValue());
    ASSERT_EQ(asked.size(), 1u);
    const QuestionRows rows = rowsUnder(text, "test.csv", asked[0], 1);
    EXPECT_EQ(rows.column, "u") << "shown although the date is open, too";
    EXPECT_THAT(valuesUnder(rows, 1), ElementsAre("1234"));
    Questions next;
    EXPECT_FALSE(readTextFile(text, "test.csv", asked[0].readings[0].options, {}, next).hasValue());
    ASSERT_EQ(next.size(), 1u);
    EXPECT_EQ(next[0].readings[0].options.decimal, '.') << "what was told stays told";
    EXPECT_TRUE(readTextFile(text, "test.csv", next[0].readings[0].options).hasValue());
}

}  // namespace
}  // namespace analogon
