#include "core/measure/text/stamp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>

#include "core/measure/csv_dialect.hpp"
#include "core/measure/text/stamp_parts.hpp"

namespace analogon {

namespace {

constexpr std::int64_t second = 1'000'000'000, minute = 60 * second, hour = 60 * minute, day = 24 * hour;

constexpr std::uint8_t bit(DateOrder order) { return static_cast<std::uint8_t>(1u << static_cast<int>(order)); }

/// The orders under which these three numbers are a day. Points stand between day, month and year alone.
std::uint8_t ordersOf(std::string_view a, std::string_view b, std::string_view c, char mark) {
    const int first = numberOfDigits(a), middle = numberOfDigits(b), last = numberOfDigits(c);
    const auto isDay = [](int value) { return value >= 1 && value <= 31; };
    const auto isMonth = [](int value) { return value >= 1 && value <= 12; };
    std::uint8_t orders = 0;
    const bool yearIsFirst = a.size() == 4, yearIsLast = c.size() == 4;
    const bool isShort = a.size() <= 2 && c.size() == 2;
    if ((yearIsFirst || (isShort && a.size() == 2 && mark != '.')) && isMonth(middle) && isDay(last) && !yearIsLast)
        orders |= bit(DateOrder::YearMonthDay);
    if (!yearIsFirst && (yearIsLast || isShort)) {
        if (isDay(first) && isMonth(middle)) orders |= bit(DateOrder::DayMonthYear);
        if (mark != '.' && isMonth(first) && isDay(middle)) orders |= bit(DateOrder::MonthDayYear);
    }
    return orders;
}

bool readNumericDate(StampParts& parts, Stamp& stamp) {
    StampParts ahead = parts;
    const std::string_view a = ahead.digits(4);
    const char mark = ahead.front();
    if (a.empty() || (mark != '.' && mark != '-' && mark != '/')) return false;
    ahead.take(mark);
    const std::string_view b = ahead.digits(2);
    if (b.empty() || !ahead.take(mark)) return false;
    const std::string_view c = ahead.digits(4);
    if (c.empty() || isDigit(ahead.front()) || c.size() == 3 || a.size() == 3) return false;
    stamp.orders = ordersOf(a, b, c, mark);
    if (stamp.orders == 0) return false;
    stamp.date = {static_cast<std::int16_t>(numberOfDigits(a)), static_cast<std::int16_t>(numberOfDigits(b)),
                  static_cast<std::int16_t>(numberOfDigits(c))};
    parts = ahead;
    return true;
}

/// 15-Jun-2024, 15. Juni 2024, Jun 15, 2024
bool readNamedDate(StampParts& parts, Stamp& stamp) {
    StampParts ahead = parts;
    std::string_view dayDigits = ahead.digits(2);
    ahead.skip(". -/");
    const int month = monthOf(ahead.letters());
    if (month == 0) return false;
    ahead.skip(". -/");
    if (dayDigits.empty()) {
        dayDigits = ahead.digits(2);
        ahead.skip(", ");
    }
    const std::string_view year = ahead.digits(4);
    if (dayDigits.empty() || (year.size() != 4 && year.size() != 2)) return false;
    stamp.date = {static_cast<std::int16_t>(numberOfDigits(dayDigits)), static_cast<std::int16_t>(month),
                  static_cast<std::int16_t>(numberOfDigits(year))};
    stamp.orders = bit(DateOrder::DayMonthYear);
    parts = ahead;
    return true;
}

/// 2024-167, 2024 167, 2024:167: the day of the year; without a minus sign between them, in front of a clock alone.
bool readOrdinalDate(StampParts& parts, Stamp& stamp) {
    StampParts ahead = parts;
    const std::string_view year = ahead.digits(4);
    const char mark = ahead.front();
    if (year.size() != 4 || std::string_view("-/.: ").find(mark) == std::string_view::npos) return false;
    ahead.skip(std::string_view(&mark, 1));
    const std::string_view digits = ahead.digits(4);
    if (digits.size() != 3 || (ahead.isAtEnd() && mark != '-')) return false;
    if (!ahead.isAtEnd() && !ahead.take(mark == ':' ? ':' : ' ') && !ahead.take('T')) return false;
    if (!putOrdinal(numberOfDigits(year), numberOfDigits(digits), stamp)) return false;
    parts = ahead;
    return true;
}

/// 20240615T103000
bool readCompactDate(StampParts& parts, Stamp& stamp) {
    StampParts ahead = parts;
    const std::string_view digits = ahead.digits(9);
    if (digits.size() != 8 || ahead.front() != 'T') return false;
    stamp.date = {static_cast<std::int16_t>(numberOfDigits(digits.substr(0, 4))),
                  static_cast<std::int16_t>(numberOfDigits(digits.substr(4, 2))),
                  static_cast<std::int16_t>(numberOfDigits(digits.substr(6, 2)))};
    stamp.orders = bit(DateOrder::YearMonthDay);
    if (!dayOf(stamp, DateOrder::YearMonthDay)) return false;
    ahead.take('T');
    const std::string_view clock = ahead.digits(6);
    if (clock.size() != 6) return false;
    stamp.hasClock = true;
    stamp.nanoseconds = numberOfDigits(clock.substr(0, 2)) * hour + numberOfDigits(clock.substr(2, 2)) * minute +
                        numberOfDigits(clock.substr(4, 2)) * second;
    parts = ahead;
    return true;
}

/// AM, a.m., "a. m.", also behind and with the blanks that break no line.
void readHalf(StampParts& parts, Stamp& stamp) {
    constexpr std::string_view blanks = " \xC2\xA0\xE2\x80\xAF";
    StampParts ahead = parts;
    ahead.skip(blanks);
    const bool isMorning = ahead.take('a') || ahead.take('A');
    if (!isMorning && !ahead.take('p') && !ahead.take('P')) return;
    ahead.take('.');
    ahead.skip(blanks);
    if (!ahead.take('m') && !ahead.take('M')) return;
    ahead.take('.');
    const std::int64_t hours = stamp.nanoseconds / hour;
    if (isLetter(ahead.front()) || hours < 1 || hours > 12) return;
    if (isMorning && hours == 12) stamp.nanoseconds -= 12 * hour;
    if (!isMorning && hours != 12) stamp.nanoseconds += 12 * hour;
    parts = ahead;
}

/// Days in front of a clock: "3d 10:30:00", "3 10:30:00", "3.10:30:00", "3 days 10:30:00".
std::int64_t readDays(StampParts& parts) {
    StampParts ahead = parts;
    const std::string_view digits = ahead.digits(4);
    if (digits.empty()) return 0;
    const bool isParted = ahead.front() == ' ';
    ahead.skip(" ");
    const std::string word = inLowerCase(ahead.letters());
    const bool isWord = word == "d" || word == "day" || word == "days" || word == "tag" || word == "tage";
    if (!isWord && (!word.empty() || !(isParted || ahead.take('.')))) return 0;
    ahead.skip(" ,");
    if (!isDigit(ahead.front())) return 0;
    parts = ahead;
    return numberOfDigits(digits);
}

/// Seconds behind days, hours and minutes: 167:10:30:00, 1:10:30:00.5; its decimals are left. Where all fields have
/// two digits they may be hours to hundredths as well. False: they are, as far as one stamp tells.
bool readSecondsBehindDays(StampParts& parts, const std::array<std::string_view, 3>& fields, Stamp& stamp) {
    StampParts ahead = parts;
    ahead.take(':');
    const std::string_view last = ahead.digits(3);
    const bool hasDecimals = ahead.front() == '.' || ahead.front() == ',';
    const bool isClock = last.size() == 2 && numberOfDigits(fields[1]) < 24 && numberOfDigits(last) < 60;
    stamp.countsDays = isClock && (fields[0].size() == 3 || hasDecimals);
    stamp.mayCountDays = isClock && !stamp.countsDays;
    if (!stamp.countsDays) return false;
    stamp.nanoseconds = numberOfDigits(fields[0]) * day + numberOfDigits(fields[1]) * hour +
                        numberOfDigits(fields[2]) * minute + numberOfDigits(last) * second;
    parts = ahead;
    return true;
}

/// h:mm, h:mm:ss, h:mm:ss.f, h:mm:ss:mmm; with a sign and days in front where nothing else stands there.
bool readClock(StampParts& parts, Stamp& stamp) {
    StampParts ahead = parts;
    const bool isNegative = !stamp.hasDate() && ahead.take('-');
    if (!stamp.hasDate() && !isNegative) ahead.take('+');
    const std::int64_t days = stamp.hasDate() ? 0 : readDays(ahead);
    const std::string_view hours = ahead.digits(6);
    if (hours.empty() || !ahead.take(':')) return false;
    const std::string_view minutes = ahead.digits(2);
    if (minutes.empty() || numberOfDigits(minutes) > 59 || isDigit(ahead.front())) return false;
    stamp.hasTwoFields = ahead.front() != ':';
    std::int64_t value = numberOfDigits(hours) * hour + numberOfDigits(minutes) * minute;
    if (ahead.take(':')) {
        const std::string_view seconds = ahead.digits(2);
        if (seconds.empty() || numberOfDigits(seconds) > 60) return false;
        value += numberOfDigits(seconds) * second;
        const bool mayHaveDays = !stamp.hasDate() && days == 0 && ahead.front() == ':';
        if (mayHaveDays && readSecondsBehindDays(ahead, {hours, minutes, seconds}, stamp)) value = stamp.nanoseconds;
    }
    const char mark = ahead.front();
    if ((mark == '.' || mark == ',' || (mark == ':' && !stamp.hasTwoFields)) && ahead.rest().size() > 1 &&
        isDigit(ahead.rest()[1])) {
        ahead.take(mark);
        stamp.hasFraction = true;
        const std::int64_t fraction = readFraction(ahead);
        if (stamp.hasTwoFields) value /= 60;  // minutes, seconds and their decimals
        stamp.hasTwoFields = false;
        value += fraction;
    }
    stamp.hasClock = true;
    stamp.nanoseconds = value + days * day;
    readHalf(ahead, stamp);
    if (isNegative) stamp.nanoseconds = -stamp.nanoseconds;
    parts = ahead;
    return true;
}

std::int16_t twoDigits(std::int16_t year) {
    if (year >= 100) return year;
    return static_cast<std::int16_t>(year + (year < 70 ? 2000 : 1900));
}

}  // namespace

std::optional<int> readZone(std::string_view text) {
    struct Named {
        std::string_view name;
        int minutes;
    };
    constexpr std::array<Named, 13> named{Named{"Z", 0}, {"UTC", 0},    {"GMT", 0},    {"CET", 60},   {"CEST", 120},
                                          {"MEZ", 60},   {"MESZ", 120}, {"EST", -300}, {"EDT", -240}, {"PST", -480},
                                          {"PDT", -420}, {"MST", -420}, {"JST", 540}};
    StampParts parts(withoutBlanks(text));
    StampParts ahead = parts;
    const std::string_view word = ahead.letters();
    if (!word.empty()) {
        const auto found = std::find_if(named.begin(), named.end(), [&](const Named& n) { return n.name == word; });
        if (found == named.end()) return std::nullopt;
        if (ahead.isAtEnd()) return found->minutes;
        if (word != "UTC" && word != "GMT") return std::nullopt;
        parts = ahead;
    }
    const bool isWest = parts.front() == '-';
    if (!parts.take('+') && !parts.take('-')) return std::nullopt;
    const std::string_view hours = parts.digits(2);
    parts.take(':');
    const std::string_view minutes = parts.digits(2);
    if (hours.empty() || !parts.isAtEnd() || minutes.size() == 1 || numberOfDigits(hours) > 14) return std::nullopt;
    const int east = 60 * numberOfDigits(hours) + numberOfDigits(minutes);
    return isWest ? -east : east;
}

std::optional<Stamp> readStamp(std::string_view text) {
    text = withoutBlanks(text);
    const bool isCutYear = text.starts_with('\'');  // '12-07-01
    if (isCutYear) text.remove_prefix(1);
    if (text.size() < 4 || text.size() > 60) return std::nullopt;
    Stamp stamp;
    StampParts parts(text);
    if (isLetter(parts.front()) && monthOf(StampParts(text).letters()) == 0) {  // a day of the week
        const std::size_t length = parts.letters().size();
        if (length < 2 || length > 10) return std::nullopt;
        parts.skip(", .");
    }
    const bool isOrdinal = readOrdinalDate(parts, stamp);
    const bool hasDate =
        isOrdinal || readCompactDate(parts, stamp) || readNumericDate(parts, stamp) || readNamedDate(parts, stamp);
    if (hasDate && isCutYear && stamp.allows(DateOrder::YearMonthDay)) stamp.orders = bit(DateOrder::YearMonthDay);
    if (hasDate && !isOrdinal && !stamp.hasClock) {
        const std::string_view before = parts.rest();
        parts.skip(" T,_");
        if (parts.front() == '-') parts.skip("- ");
        if (before.size() == parts.rest().size() && !parts.isAtEnd()) return std::nullopt;
    }
    if (!stamp.hasClock && !parts.isAtEnd() && !readClock(parts, stamp)) return std::nullopt;
    if (!parts.isAtEnd()) {
        if (stamp.hasClock && (parts.front() == '.' || parts.front() == ',')) {
            parts.cut(1);
            stamp.nanoseconds += readFraction(parts);
        }
        if (!parts.isAtEnd()) {
            const std::optional<int> zone = readZone(parts.rest());
            if (!zone) return std::nullopt;
            stamp.zone = static_cast<std::int16_t>(*zone);
        }
    }
    if (!stamp.hasDate() && !stamp.hasClock) return std::nullopt;
    if (stamp.hasDate() && stamp.nanoseconds > day) return std::nullopt;
    return stamp;
}

Stamp inDays(Stamp stamp) {
    const std::int64_t clock = stamp.nanoseconds;
    stamp.nanoseconds = clock / hour * day + clock / minute % 60 * hour + clock / second % 60 * minute +
                        clock % second * 100;  // hundredths were read
    stamp.mayCountDays = stamp.hasFraction = false;
    stamp.countsDays = true;
    return stamp;
}

std::optional<std::int64_t> dayOf(const Stamp& stamp, DateOrder order) {
    const auto& d = stamp.date;
    const bool yearFirst = order == DateOrder::YearMonthDay;
    const int year = twoDigits(yearFirst ? d[0] : d[2]);
    const int month = order == DateOrder::MonthDayYear ? d[0] : d[1];
    const int dayOfMonth = yearFirst ? d[2] : order == DateOrder::DayMonthYear ? d[0] : d[1];
    const std::chrono::year_month_day date{std::chrono::year(year),
                                           std::chrono::month(static_cast<unsigned>(std::max(month, 0))),
                                           std::chrono::day(static_cast<unsigned>(std::max(dayOfMonth, 0)))};
    // nanoseconds since 1970 hold no more
    if (!date.ok() || year < 1700 || year > 2250) return std::nullopt;
    return std::chrono::sys_days(date).time_since_epoch().count();
}

std::string isoText(std::int64_t nanoseconds, std::int16_t zone) {
    const std::chrono::sys_time<std::chrono::nanoseconds> time{std::chrono::nanoseconds(nanoseconds)};
    const auto days = std::chrono::floor<std::chrono::days>(time);
    const std::chrono::year_month_day date(days);
    const std::int64_t ofDay = (time - days).count();
    std::string text = fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}", static_cast<int>(date.year()),
                                   static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), ofDay / hour,
                                   ofDay / minute % 60, ofDay / second % 60);
    if (ofDay % second != 0) {
        text += fmt::format(".{:09}", ofDay % second);
        text.erase(text.find_last_not_of('0') + 1);
    }
    if (zone == Stamp::noZone) return text;
    if (zone == 0) return text + 'Z';
    return text + fmt::format("{}{:02}:{:02}", zone < 0 ? '-' : '+', std::abs(zone) / 60, std::abs(zone) % 60);
}

}  // namespace analogon
