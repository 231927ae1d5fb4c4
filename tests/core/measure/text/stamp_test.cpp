#include "core/measure/text/stamp.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/measure/text/time_format.hpp"
#include "core/measure/text/zone_clock.hpp"

namespace analogon {
namespace {

constexpr std::int64_t second = 1'000'000'000, hour = 3600 * second, day = 24 * hour;

/// By the only order that the stamp allows, or by the given one.
std::string iso(std::string_view text, DateOrder order) {
    const std::optional<Stamp> stamp = readStamp(text);
    if (!stamp || !stamp->allows(order)) return "none";
    return isoText(*dayOf(*stamp, order) * day + stamp->nanoseconds, stamp->zone);
}

TEST(Stamp, ReadsDatesInTheOrdersOfTheWorld) {
    EXPECT_EQ(iso("2024-06-15T10:30:00.5Z", DateOrder::YearMonthDay), "2024-06-15T10:30:00.5Z");
    EXPECT_EQ(iso("2024/06/15 10:30:00+02:00", DateOrder::YearMonthDay), "2024-06-15T10:30:00+02:00");
    EXPECT_EQ(iso("15.06.2024 10:30:00,25", DateOrder::DayMonthYear), "2024-06-15T10:30:00.25");
    EXPECT_EQ(iso("06/15/24 10:30:00 PM", DateOrder::MonthDayYear), "2024-06-15T22:30:00");
    EXPECT_EQ(iso("15-Jun-2024 23:59:59.999", DateOrder::DayMonthYear), "2024-06-15T23:59:59.999");
    EXPECT_EQ(iso("3. M\xC3\xA4rz 2024 1:02:03", DateOrder::DayMonthYear), "2024-03-03T01:02:03");
    EXPECT_EQ(iso("Jun 15, 2024 10:30:00", DateOrder::DayMonthYear), "2024-06-15T10:30:00");
    EXPECT_EQ(iso("20240615T103000", DateOrder::YearMonthDay), "2024-06-15T10:30:00");
    EXPECT_EQ(iso("'12-07-01 09:14:03", DateOrder::YearMonthDay), "2012-07-01T09:14:03");
    EXPECT_EQ(iso("2021-04-14 13:10:34.255.812.740", DateOrder::YearMonthDay), "2021-04-14T13:10:34.25581274");
    EXPECT_EQ(iso("2024-06-15 10:30:00:250", DateOrder::YearMonthDay), "2024-06-15T10:30:00.25");
}

TEST(Stamp, ReadsTheDayOfTheYear) {
    for (const char* text : {"2024-167 10:30:00.5", "2024 167 10:30:00.5", "2024/167 10:30:00.5", "2024:167:10:30:00.5",
                             "2024-167T10:30:00.5"})
        EXPECT_EQ(iso(text, DateOrder::YearMonthDay), "2024-06-15T10:30:00.5") << text;
    EXPECT_EQ(iso("2023-365", DateOrder::YearMonthDay), "2023-12-31T00:00:00");
    EXPECT_EQ(iso("2024-366 00:00:00", DateOrder::YearMonthDay), "2024-12-31T00:00:00");
    for (const char* text : {"2023-366 00:00:00", "2024-000 10:00:00", "2024 167", "2024.167", "2024-1670 10:00:00"})
        EXPECT_FALSE(readStamp(text)) << text;
    EXPECT_EQ(isoText(*dayOf(*readStamp("24/060 01:00", "%y/%j %H:%M"), DateOrder::YearMonthDay) * day).substr(0, 10),
              "2024-02-29");
}

TEST(Stamp, CountsDaysInFrontOfAClock) {
    EXPECT_EQ(readStamp("167:10:30:00")->nanoseconds, 167 * day + 10 * hour + 1800 * second);
    EXPECT_EQ(readStamp("1:10:30:00.25")->nanoseconds, day + 10 * hour + 1800 * second + 250'000'000);
    EXPECT_EQ(readStamp("0 days 00:00:01.500000")->nanoseconds, 1'500'000'000);
    EXPECT_EQ(readStamp("2 Tage 01:00:00")->nanoseconds, 49 * hour);
    EXPECT_EQ(readStamp("10:30:00:250")->nanoseconds, 10 * hour + 1800 * second + 250'000'000);
    EXPECT_EQ(readStamp("10:30:00:25")->nanoseconds, 10 * hour + 1800 * second + 250'000'000);  // no thirtieth hour
    const std::optional<Stamp> open = readStamp("1:10:30:05");
    EXPECT_TRUE(open->mayCountDays);
    EXPECT_EQ(open->nanoseconds, hour + 630 * second + 50'000'000);
    EXPECT_EQ(inDays(*open).nanoseconds, day + 10 * hour + 1805 * second);
}

TEST(Stamp, KnowsTheHalvesOfTheDayInTheirSpellings) {
    for (const char* half : {" PM", "pm", " p.m.", " p. m.", "\xC2\xA0p.\xC2\xA0m.", "\xE2\x80\xAFPM"})
        EXPECT_EQ(readStamp(std::string("01:30:00") + half)->nanoseconds, 13 * hour + 1800 * second) << half;
    EXPECT_FALSE(readStamp("01:30:00 pma"));
    EXPECT_FALSE(readStamp("01:30:00 p"));
}

TEST(Stamp, LeavesOpenWhatIsOpen) {
    const std::optional<Stamp> stamp = readStamp("03/04/2024 10:00:00");
    ASSERT_TRUE(stamp);
    EXPECT_TRUE(stamp->allows(DateOrder::DayMonthYear));
    EXPECT_TRUE(stamp->allows(DateOrder::MonthDayYear));
    EXPECT_FALSE(stamp->allows(DateOrder::YearMonthDay));
    EXPECT_FALSE(readStamp("15/04/2024")->allows(DateOrder::MonthDayYear));
    EXPECT_FALSE(readStamp("03.04.2024")->allows(DateOrder::MonthDayYear));
}

TEST(Stamp, ReadsClocksAndElapsedTimes) {
    EXPECT_EQ(readStamp("00:00:01.5")->nanoseconds, 1'500'000'000);
    EXPECT_EQ(readStamp("125:10:00")->nanoseconds, 125 * hour + 600 * second);
    EXPECT_EQ(readStamp("-00:00:00.25")->nanoseconds, -250'000'000);
    EXPECT_EQ(readStamp("1.02:00:00")->nanoseconds, 26 * hour);
    EXPECT_EQ(readStamp("2d 01:00:00")->nanoseconds, 49 * hour);
    EXPECT_EQ(readStamp("12:05:00 AM")->nanoseconds, 300 * second);
    EXPECT_EQ(readStamp("12:05:00 p.m.")->nanoseconds, 12 * hour + 300 * second);
    EXPECT_EQ(readStamp("01:30.5")->nanoseconds, 90'500'000'000);  // minutes and seconds
    EXPECT_TRUE(readStamp("10:30")->hasTwoFields);
}

TEST(Stamp, KnowsWhatIsNone) {
    for (const char* text : {"", "12", "1.5", "1.234,5", "10:70:00", "2024-13-01", "31.31.2024", "Sensor 3", "1.28.4.8",
                             "a:b:c", "10:30:00 XY", "99:99", "2024-06-15x10:00:00", "T:1"})
        EXPECT_FALSE(readStamp(text)) << text;
}

TEST(Stamp, FollowsAFormat) {
    const auto read = [](const char* text, const char* format) {
        const std::optional<Stamp> stamp = readStamp(text, format);
        return stamp ? isoText(*dayOf(*stamp, DateOrder::YearMonthDay) * day + stamp->nanoseconds) : "none";
    };
    EXPECT_EQ(read("03/04/2024 10:00:00", "%d/%m/%Y %H:%M:%S"), "2024-04-03T10:00:00");
    EXPECT_EQ(read("03/04/2024 10:00:00.125", "%m/%d/%Y %H:%M:%S.%f"), "2024-03-04T10:00:00.125");
    EXPECT_EQ(read("03.04.24 10:00:00", "dd.MM.yy HH:mm:ss"), "2024-04-03T10:00:00");
    EXPECT_EQ(read("20240403100000", "%Y%m%d%H%M%S"), "2024-04-03T10:00:00");
    EXPECT_EQ(read("2024-04-03 10.00.00", "%Y-%m-%d %H.%M.%S"), "2024-04-03T10:00:00");
    EXPECT_EQ(read("03.04.24", "dd.MM.yy HH:mm:ss"), "none");
    EXPECT_EQ(readStamp("05:30", "%M:%S")->nanoseconds, 330 * second);
    EXPECT_EQ(readStamp("93000.5", "%H%M%S")->nanoseconds, 9 * hour + 1800 * second + 500'000'000);
    EXPECT_EQ(readStamp("103000", "%H%M%S")->nanoseconds, 10 * hour + 1800 * second);
    EXPECT_FALSE(readStamp("500", "%H%M%S"));  // five minutes past midnight, or five hours
}

TEST(TimeFormat, MayBeTheTimeBetweenTwoRows) {
    EXPECT_EQ(intervalOf("0.001 s"), 0.001);
    EXPECT_EQ(intervalOf("2 ms"), 0.002);
    EXPECT_EQ(intervalOf("1 kHz"), 0.001);
    EXPECT_EQ(intervalOf("0.5"), 0.5);
    EXPECT_FALSE(intervalOf("%H:%M:%S"));
    EXPECT_FALSE(intervalOf("-1 s"));
    EXPECT_FALSE(intervalOf("5 V"));
}

TEST(ZoneClock, KnowsSummerTime) {
    const std::optional<ZoneClock> berlin = ZoneClock::named("Europe/Berlin");
    ASSERT_TRUE(berlin);
    const std::int64_t october = *dayOf(*readStamp("2024-10-27"), DateOrder::YearMonthDay) * day;
    const std::int64_t first = berlin->momentOf(october + 2 * hour + 1800 * second, october);
    const std::int64_t second_ = berlin->momentOf(october + 2 * hour, first);
    EXPECT_EQ(first, october + 1800 * second);  // summer time, two hours ahead
    EXPECT_EQ(second_, october + hour);         // the clock was set back
    EXPECT_EQ(ZoneClock::named("+02:00")->momentOf(2 * hour, 0), 0);
    EXPECT_FALSE(ZoneClock::named("Europe/Nowhere"));
}

}  // namespace
}  // namespace analogon
