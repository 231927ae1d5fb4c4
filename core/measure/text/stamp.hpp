#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Dates and clocks as they are written in text files.
namespace analogon {

/// In which order day, month and year stand.
enum class DateOrder : std::uint8_t { YearMonthDay, DayMonthYear, MonthDayYear };

/// A date, a clock, or both.
struct Stamp {
    std::array<std::int16_t, 3> date{};  // the three numbers as they stand; months by name are put to their number
    std::uint8_t orders{};               // the orders that are possible, a bit each; 0: there is no date
    bool hasClock{};
    bool hasTwoFields{};         // 10:30: hours and minutes, or minutes and seconds
    bool hasFraction{};          // decimals behind the seconds
    bool mayCountDays{};         // 1:10:30:05: hours to hundredths, as it is read, or days to seconds; see inDays
    bool countsDays{};           // 167:10:30:00: days in front of the hours
    std::int16_t zone{noZone};   // [min] east of Greenwich
    std::int64_t nanoseconds{};  // of the clock; of two fields as hours and minutes

    static constexpr std::int16_t noZone = INT16_MAX;
    bool hasDate() const { return orders != 0; }
    bool allows(DateOrder order) const { return (orders >> static_cast<int>(order) & 1) != 0; }
};

/// 2024-06-15T10:30:00.5Z, 15.06.2024 10:30:00,5, 06/15/24 10:30:00 PM, 15-Jun-2024, 10:30:00.5, 125:10:00, +02:00 …;
/// with the day of the year: 2024-167 10:30:00, 2024 167 10:30:00.5, 167:10:30:00; "0 days 00:00:01.5".
std::optional<Stamp> readStamp(std::string_view text);

/// A stamp that may count days, as one that does.
Stamp inDays(Stamp stamp);

/// By a format: %Y %y %m %d %j %H %I %M %S %f %p %b %z, or the letters yyyy MM dd HH mm ss SSS tt.
std::optional<Stamp> readStamp(std::string_view text, std::string_view format);

/// The format by which a stamp is read in one order of its date: "%d/%m/%Y %I:%M:%S %p"; empty: there is none.
std::string stampFormatOf(std::string_view text, DateOrder order);

/// Days since 1970-01-01; none: there is no such day.
std::optional<std::int64_t> dayOf(const Stamp& stamp, DateOrder order);

/// "Z", "UTC", "+02:00", "GMT-5", "CET" as minutes east of Greenwich.
std::optional<int> readZone(std::string_view text);

/// "2024-06-15T10:30:00.5", of nanoseconds since 1970-01-01; with its zone behind it where it has one.
std::string isoText(std::int64_t nanoseconds, std::int16_t zone = Stamp::noZone);

}  // namespace analogon
