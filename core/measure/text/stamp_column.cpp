#include "core/measure/text/stamp_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/file_fault.hpp"
#include "core/base/median.hpp"
#include "core/measure/text/counted_days.hpp"
#include "core/measure/text/remark.hpp"
#include "core/measure/text/stamp_traits.hpp"
#include "core/measure/text/time_format.hpp"
#include "core/measure/text/zone_clock.hpp"
#include "core/measure/time_name.hpp"

namespace analogon {

namespace {

constexpr std::int64_t second = 1'000'000'000, hour = 3600 * second, day = 24 * hour;
constexpr std::int64_t none = std::numeric_limits<std::int64_t>::min();

bool holdsDates(const RawTable& raw, std::size_t column) {
    if (column >= raw.kinds.size() || raw.kinds[column] != CellKind::Stamp) return false;
    const StampTraits traits = traitsOf(raw.stamps[column]);
    return traits.count > 0 && traits.haveDate && traits.areMidnight;
}

bool holdsClocks(const RawTable& raw, std::size_t column) {
    if (column >= raw.kinds.size() || raw.kinds[column] != CellKind::Stamp) return false;
    const StampTraits traits = traitsOf(raw.stamps[column]);
    return traits.count > 0 && traits.haveClock && !traits.anyDate;
}

/// The clock that belongs to a column of dates: beside it, or the only one there is.
std::optional<std::size_t> clockOf(const RawTable& raw, std::size_t date) {
    if (holdsClocks(raw, date + 1)) return date + 1;
    if (date > 0 && holdsClocks(raw, date - 1)) return date - 1;
    std::optional<std::size_t> only;
    for (std::size_t i = 0; i < raw.kinds.size(); ++i) {
        if (!holdsClocks(raw, i)) continue;
        if (only) return std::nullopt;
        only = i;
    }
    return only;
}

/// A date in one column and the clock in another one are one stamp, which is called as the clock is.
void joinDateAndClock(RawTable& raw, Diagnostics& told) {
    for (std::size_t i = 0; i < raw.kinds.size(); ++i) {
        const std::optional<std::size_t> clock = holdsDates(raw, i) ? clockOf(raw, i) : std::nullopt;
        if (!clock) continue;
        for (std::size_t row = 0; row < raw.stamps[i].size(); ++row) {
            Stamp stamp = raw.stamps[*clock][row];
            const Stamp date = raw.stamps[i][row];
            const bool isWhole = isTold(stamp) && isTold(date);
            stamp.date = date.date;
            stamp.orders = date.orders;
            raw.stamps[*clock].put(row, isWhole ? stamp : Stamp{});
        }
        raw.firstStamps[*clock] = raw.firstStamps[i] + ' ' + raw.firstStamps[*clock];
        told.push_back(remark(phrase("the time is that of columns '{}' and '{}' together",
                                     cited(raw.table.columns[i].name), cited(raw.table.columns[*clock].name)),
                              raw.table.file));
        raw.erase(i);
        return;
    }
}

/// A column of milliseconds beside stamps that have none.
void addMilliseconds(RawTable& raw, Diagnostics& told) {
    for (std::size_t i = 0; i + 1 < raw.kinds.size(); ++i) {
        if (raw.kinds[i] != CellKind::Stamp || raw.kinds[i + 1] != CellKind::Number) continue;
        const Column& column = raw.table.columns[i + 1];
        const std::string name = inLowerCase(column.name);
        const bool isNamed = name == "ms" || name == "msec" || name.starts_with("millisec") ||
                             name.starts_with("millisek") ||
                             (column.unit == "ms" && column.name == fmt::format("c{}", i + 2));  // it has no name
        if (!isNamed || traitsOf(raw.stamps[i]).anyFraction) continue;
        const auto isPart = [](double value) { return value >= 0 && value < 1000; };
        if (!std::all_of(column.values.begin(), column.values.end(), isPart)) continue;
        for (std::size_t row = 0; row < raw.stamps[i].size(); ++row) {
            Stamp stamp = raw.stamps[i][row];
            stamp.nanoseconds += std::llround(column.values[row] * 1e6);
            stamp.hasFraction = true;
            raw.stamps[i].put(row, stamp);
        }
        told.push_back(remark(phrase("the milliseconds in column '{}' belong to the time in '{}'", cited(column.name),
                                     cited(raw.table.columns[i].name)),
                              raw.table.file));
        raw.erase(i + 1);
        return;
    }
}

/// One column of stamps on its way to seconds.
class StampColumn {
public:
    StampColumn(const RawTable& raw, std::size_t index, const ReadOptions& options, Questions& asked)
        : raw_(raw),
          column_(raw.table.columns[index]),
          stamps_(raw.stamps[index]),
          firstText_(raw.firstStamps[index]),
          options_(options),
          asked_(asked),
          traits_(traitsOf(stamps_)) {}

    Diagnostics read() {
        if (traits_.count == 0) return {};
        if (!options_.timeZone.empty() && !(zone_ = ZoneClock::named(options_.timeZone)))
            return {fileError(phrase("the time zone '{}' is not known", cited(options_.timeZone)), raw_.table.file, 0,
                              0, phrase("Write \"time_zone\" as \"Europe/Berlin\", \"UTC\" or \"+02:00\"."))};
        if (traits_.anyDate != traits_.haveDate) return {uneven(phrase("have a date and some have none"))};
        if (traits_.anyZone != traits_.haveZone && options_.timeZone.empty())
            return {uneven(phrase("have a time zone and some have none"))};
        return traits_.haveDate ? readDates() : readClocks();
    }

    const std::vector<std::int64_t>& moments() const { return moments_; }
    bool isAbsolute() const { return traits_.haveDate && traits_.count > 0; }
    /// Counts from a start, and not from midnight.
    bool countsFromStart() const { return countsFromStart_; }
    std::string start() const {
        if (!isAbsolute() || isOrderOpen_) return {};
        const std::size_t first = firstRow(), last = lastRow();
        const Stamp stamp = stamps_[moments_[last] < moments_[first] ? last : first];
        return isoText(*dayOf(stamp, order_) * day + stamp.nanoseconds, stamp.zone);
    }
    Diagnostics remarks;

private:
    int lineOf(std::size_t row) const { return raw_.table.lines[row]; }
    std::size_t firstRow() const {
        std::size_t row = 0;
        while (!isTold(stamps_[row])) ++row;
        return row;
    }
    std::size_t lastRow() const {
        std::size_t row = stamps_.size() - 1;
        while (!isTold(stamps_[row])) --row;
        return row;
    }

    Diagnostic uneven(const Text& how) const {
        return fileError(
            phrase("some stamps in column '{}' {}", cited(column_.name), how), raw_.table.file, 0, 0,
            phrase("Tell how they are written in the study: \"read\": {{\"time_format\": …, \"time_zone\": …}}."));
    }

    /// `take(row, moment)` for each stamp, in one order of its date; false: there is no such day, or it was enough.
    template <class Take>
    bool forEachMoment(DateOrder order, const Take& take) const {
        std::int64_t previous = none;
        for (std::size_t i = 0; i < stamps_.size(); ++i) {
            const Stamp stamp = stamps_[i];
            if (!isTold(stamp)) continue;
            const std::optional<std::int64_t> date = dayOf(stamp, order);
            if (!date) return false;
            std::int64_t moment = *date * day + stamp.nanoseconds;
            if (stamp.zone != Stamp::noZone)
                moment -= stamp.zone * 60 * second;
            else if (zone_)
                moment = zone_->momentOf(moment, previous);
            previous = moment;
            if (!take(i, moment)) return false;
        }
        return true;
    }

    bool isPossible(DateOrder order) const {
        return (traits_.orders >> static_cast<int>(order) & 1) != 0 &&
               forEachMoment(order, [](std::size_t, std::int64_t) { return true; });
    }

    /// In the order of the rows, or the newest first.
    bool isSorted(DateOrder order, bool isNewestFirst) const {
        std::int64_t last = isNewestFirst ? std::numeric_limits<std::int64_t>::max() : none;
        return forEachMoment(order, [&](std::size_t, std::int64_t moment) {
            const std::int64_t before = std::exchange(last, moment);
            return isNewestFirst ? moment <= before : moment >= before;
        });
    }

    /// Whether the stamps follow each other in this order as they do in that of the moments.
    bool isSameCourse(DateOrder order) const {
        std::int64_t shift = none;
        return forEachMoment(order, [&](std::size_t row, std::int64_t moment) {
            if (shift == none) shift = moments_[row] - moment;
            return moments_[row] - moment == shift;
        });
    }

    /// Day before month or month before day: what makes the time go back is not meant.
    Diagnostics readDates() {
        std::vector<DateOrder> orders;
        for (const DateOrder order : {DateOrder::YearMonthDay, DateOrder::DayMonthYear, DateOrder::MonthDayYear})
            if (isPossible(order)) orders.push_back(order);
        if (orders.empty()) return {uneven(phrase("have day and month in another order than others"))};
        for (const bool isNewestFirst : {false, true}) {
            std::vector<DateOrder> sorted = orders;
            std::erase_if(sorted, [&](DateOrder order) { return !isSorted(order, isNewestFirst); });
            if (sorted.empty()) continue;
            orders = std::move(sorted);
            break;
        }
        order_ = orders.front();
        moments_.assign(stamps_.size(), none);
        forEachMoment(order_, [this](std::size_t row, std::int64_t moment) {
            moments_[row] = moment;
            return true;
        });
        for (std::size_t i = 1; i < orders.size(); ++i)
            if (!isSameCourse(orders[i])) return {openOrder(orders)};
        isOrderOpen_ = orders.size() > 1;
        return zone_ || traits_.haveZone ? Diagnostics{} : checkSummerTime();
    }

    Diagnostic openOrder(const std::vector<DateOrder>& orders) {
        const std::size_t row = firstRow();
        const Stamp first = stamps_[row];
        const auto& d = first.date;
        Question question{Question::Kind::Choice, phrase("Which day is '{}'?", cited(firstText_)), lineOf(row)};
        for (const DateOrder order : orders)
            if (const std::string format = stampFormatOf(firstText_, order); !format.empty())
                question.readings.push_back(
                    {phrase("{} ({})", isoText(*dayOf(first, order) * day).substr(0, 10), nameOf(order)),
                     withFormat(format)});
        if (question.readings.size() > 1) asked_.push_back(std::move(question));
        return fileError(phrase("the date {:02}/{:02}/{:02} in column '{}' may have the day or the month in front, and "
                                "the stamps differ",
                                d[0], d[1], d[2], cited(column_.name)),
                         raw_.table.file, lineOf(row), 0,
                         phrase("Say it in the study: \"read\": {{\"time_format\": \"%d/%m/%Y %H:%M:%S\"}} or "
                                "\"%m/%d/%Y %H:%M:%S\"."));
    }

    static Text nameOf(DateOrder order) {
        if (order == DateOrder::YearMonthDay) return phrase("year, month, day");
        return order == DateOrder::DayMonthYear ? phrase("day, month, year") : phrase("month, day, year");
    }

    ReadOptions withFormat(std::string format) const {
        ReadOptions options = options_;
        options.timeFormat = std::move(format);
        return options;
    }

    /// Of many rows some say it.
    double usualStep() const {
        constexpr std::size_t many = 100'000;
        const std::size_t stride = 1 + moments_.size() / many;
        std::vector<double> steps;
        for (std::size_t i = 1; i < moments_.size(); i += stride)
            if (moments_[i] > moments_[i - 1] && moments_[i - 1] != none)
                steps.push_back(static_cast<double>(moments_[i] - moments_[i - 1]));
        return steps.empty() ? 0 : median(std::move(steps));
    }

    /// A clock that goes back by an hour, or leaves one out at two in a Sunday night of March, may be summer time.
    Diagnostics checkSummerTime() {
        const double step = usualStep();
        if (!(step > 0) || step > 0.4 * static_cast<double>(hour)) return {};
        for (std::size_t i = 1; i < moments_.size(); ++i) {
            if (moments_[i] == none || moments_[i - 1] == none) continue;
            const auto change = static_cast<double>(moments_[i] - moments_[i - 1]);
            if (std::abs(change + static_cast<double>(hour) - step) < 3 * step && change < 0)
                return {summerTime(i, true)};
            if (std::abs(change - static_cast<double>(hour) - step) < 0.5 * step && isSpringNight(i))
                return {summerTime(i, false)};
        }
        return {};
    }

    bool isSpringNight(std::size_t row) const {
        const std::int64_t days = moments_[row] >= 0 ? moments_[row] / day : (moments_[row] - day + 1) / day;
        const std::int64_t before = moments_[row - 1] - days * day, after = moments_[row] - days * day;
        const bool isSunday = ((days % 7) + 7 + 4) % 7 == 0;  // 1970-01-01 was a Thursday
        const bool isMarch = isoText(moments_[row]).substr(5, 2) == "03";
        return isSunday && isMarch && before < 2 * hour && after >= 3 * hour;
    }

    Diagnostic summerTime(std::size_t row, bool isBack) {
        Reading summer{phrase("summer time begins or ends here ({})", "Europe/Berlin"), options_},
            always{phrase("the clock knows no summer time ({})", "UTC"), options_};
        summer.options.timeZone = "Europe/Berlin";
        always.options.timeZone = "UTC";
        asked_.push_back({Question::Kind::Choice,
                          phrase("The clock in column '{}' jumps by an hour. Why?", cited(column_.name)),
                          lineOf(row),
                          {std::move(summer), std::move(always)}});
        return fileError(
            isBack ? phrase("the clock in column '{}' goes back by an hour here", cited(column_.name))
                   : phrase("the clock in column '{}' leaves out the hour from 2 to 3 here: a pause, or summer time",
                            cited(column_.name)),
            raw_.table.file, lineOf(row), 0,
            phrase("If it is summer time, tell the zone of the clock in the study: \"read\": {{\"time_zone\": "
                   "\"Europe/Berlin\"}}; if it is not, \"time_zone\": \"UTC\"."));
    }

    /// A clock without a date falls at midnight.
    Diagnostics readClocks() {
        if (traits_.haveTwoFields && options_.timeFormat.empty()) {
            const std::string header = inLowerCase(column_.header + column_.unit);
            const bool isHours = header.find("hh:mm") != std::string::npos || header.find("h:min") != std::string::npos;
            const bool isMinutes =
                header.find("mm:ss") != std::string::npos || header.find("min:s") != std::string::npos;
            if (isHours == isMinutes) return {openFields()};
            isInMinutes_ = isMinutes;
        }
        moments_.assign(stamps_.size(), none);
        std::int64_t days = 0, last = none;
        std::vector<std::string> midnights;
        for (std::size_t i = 0; i < stamps_.size(); ++i) {
            const Stamp stamp = stamps_[i];
            if (!isTold(stamp)) continue;
            std::int64_t moment = stamp.nanoseconds / (isInMinutes_ ? 60 : 1) + days * day;
            if (last != none && moment < last - day / 2) {
                days += 1;
                moment += day;
                midnights.push_back(std::to_string(lineOf(i)));
            }
            moments_[i] = last = moment;
        }
        const std::int64_t first =
            *std::find_if(moments_.begin(), moments_.end(), [](std::int64_t m) { return m != none; });
        const std::string name = inLowerCase(column_.header);
        for (const char* word :
             {"elapsed", "laufzeit", "duration", "dauer", "rel", "runtime", "run time", "test time", "seit"})
            countsFromStart_ = countsFromStart_ || name.find(word) != std::string::npos;
        countsFromStart_ = countsFromStart_ || first < 60 * second;
        constexpr std::size_t shown = 3;
        const bool areMany = midnights.size() > shown;
        midnights.resize(std::min(shown, midnights.size()));
        if (!midnights.empty())
            remarks.push_back(doubt(phrase("the clock in column '{}' passes midnight in line {}: a day is added there",
                                           cited(column_.name), listed(midnights) + (areMany ? ", …" : "")),
                                    raw_.table.file));
        return {};
    }

    Diagnostic openFields() {
        const std::size_t row = firstRow();
        const auto minutes = stamps_[row].nanoseconds / (60 * second);
        const std::string text = fmt::format("{}:{:02}", minutes / 60, minutes % 60);
        asked_.push_back({Question::Kind::Choice,
                          phrase("What is '{}' in column '{}'?", text, cited(column_.name)),
                          lineOf(row),
                          {{phrase("hours and minutes"), withFormat("%H:%M")},
                           {phrase("minutes and seconds"), withFormat("%M:%S")}}});
        return fileError(
            phrase("'{}' in column '{}' may be hours and minutes or minutes and seconds", text, cited(column_.name)),
            raw_.table.file, lineOf(row), 0,
            phrase("Say it in the study: \"read\": {{\"time_format\": \"%H:%M\"}} or \"%M:%S\"."));
    }

    const RawTable& raw_;
    const Column& column_;
    const StampSeries& stamps_;
    const std::string& firstText_;
    const ReadOptions& options_;
    Questions& asked_;
    StampTraits traits_;
    std::optional<ZoneClock> zone_;
    std::vector<std::int64_t> moments_;  // [ns]; of a clock alone since midnight
    DateOrder order_{DateOrder::YearMonthDay};
    bool isOrderOpen_{}, countsFromStart_{}, isInMinutes_{};
};

/// That of the first row, or of the last one where the newest stands first.
std::int64_t firstOf(const std::vector<std::int64_t>& moments) {
    const auto isTold = [](std::int64_t m) { return m != none; };
    const auto first = std::find_if(moments.begin(), moments.end(), isTold);
    return first == moments.end() ? none : std::min(*first, *std::find_if(moments.rbegin(), moments.rend(), isTold));
}

/// Seconds since `zero`, with the places of what is missing.
void putSeconds(RawTable& raw, std::size_t index, const std::vector<std::int64_t>& moments, std::int64_t zero) {
    Column& column = raw.table.columns[index];
    column.values.clear();
    column.values.reserve(raw.table.lines.size());
    column.blanks.clear();
    for (std::size_t row = 0; row < raw.table.lines.size(); ++row) {
        const bool isMissing = row >= moments.size() || moments[row] == none;
        if (isMissing) column.blanks.push_back({static_cast<std::uint32_t>(row), 0});
        column.values.push_back(isMissing ? std::numeric_limits<double>::quiet_NaN()
                                          : static_cast<double>(moments[row] - zero) / 1e9);
    }
    column.unit = "s";
    raw.kinds[index] = CellKind::Number;
}

}  // namespace

Outcome<std::string> makeSeconds(RawTable& raw, const ReadOptions& options, Questions& asked) {
    if (Diagnostics faults = settleDays(raw, options, asked); !faults.empty()) return faults;
    Diagnostics told;
    joinDateAndClock(raw, told);
    addMilliseconds(raw, told);
    std::string start;
    std::int64_t firstDate = none, firstClock = none;
    std::vector<std::pair<std::size_t, StampColumn>> columns;
    for (std::size_t i = 0; i < raw.kinds.size(); ++i) {
        if (raw.kinds[i] != CellKind::Stamp) continue;
        StampColumn& column = columns.emplace_back(i, StampColumn(raw, i, options, asked)).second;
        if (Diagnostics faults = column.read(); !faults.empty()) return faults;
        told.insert(told.end(), column.remarks.begin(), column.remarks.end());
        if (start.empty()) start = column.start();
        const std::int64_t first = firstOf(column.moments());
        std::int64_t& zero = column.isAbsolute() ? firstDate : firstClock;
        if (first != none && !column.countsFromStart() && (zero == none || first < zero)) zero = first;
        raw.stamps[i] = {};  // of a long recording they are more than its seconds
    }
    if (columns.empty() && isStampFormat(options.timeFormat))
        return fileError(phrase("no column is a time of the form '{}'", cited(options.timeFormat)), raw.table.file, 0,
                         0,
                         phrase("\"time_format\" is written as \"%d.%m.%Y %H:%M:%S\", or as the time between two rows: "
                                "\"0.001 s\"."));
    for (const auto& [index, column] : columns) {
        const std::int64_t zero = column.countsFromStart() ? 0 : column.isAbsolute() ? firstDate : firstClock;
        putSeconds(raw, index, column.moments(), zero);
    }
    return {std::move(start), std::move(told)};
}

}  // namespace analogon
