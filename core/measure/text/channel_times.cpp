#include "core/measure/text/channel_times.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/median.hpp"
#include "core/base/unit.hpp"
#include "core/measure/column_header.hpp"
#include "core/measure/text/preamble.hpp"
#include "core/measure/text/remark.hpp"
#include "core/measure/text/time_column.hpp"
#include "core/measure/time_name.hpp"

namespace analogon {

namespace {

/// "t1" and "t2", "X" and "X_2": one name and a number behind it.
bool isNumberedAs(const std::string& a, const std::string& b) {
    const auto withoutNumber = [](const std::string& name) {
        return name.substr(0, name.find_last_not_of("0123456789_ .#") + 1);
    };
    return a != b && !withoutNumber(a).empty() && withoutNumber(a) == withoutNumber(b);
}

/// "t_gps", "torque.time", "ECU_Time", "runtime": a word for the time stands among others, or ends one.
bool speaksOfTime(const std::string& name) {
    constexpr std::array<std::string_view, 7> words{"t", "time", "zeit", "ts", "timestamp", "clock", "uhrzeit"};
    if (name == "T") return false;  // a temperature, or a torque
    const std::string key = plainKey(name);
    if (key.ends_with("time") || key.ends_with("zeit")) return true;
    for (std::size_t begin = 0; begin < key.size();) {
        const std::size_t end = std::min(key.find(' ', begin), key.size());
        const std::string_view word = std::string_view(key).substr(begin, end - begin);
        if (std::find(words.begin(), words.end(), word) != words.end()) return true;
        begin = end + 1;
    }
    return false;
}

/// "t1", "t_a": "x" may be a length as well.
bool isShortForTime(const std::string& name) {
    return name.substr(0, name.find_first_of("0123456789_ .#")) == "t" || speaksOfTime(name);
}

std::vector<double> stepsOf(const std::vector<double>& values) {
    std::vector<double> steps;
    double last = NAN;
    for (const double value : values) {
        if (std::isnan(value)) continue;
        if (!std::isnan(last)) steps.push_back(value - last);
        last = value;
    }
    return steps;
}

/// As the clock of a logger runs, and nothing that is measured.
bool hasEvenSteps(const std::vector<double>& values) {
    constexpr double share = 0.95, apart = 0.02;
    const std::vector<double> steps = stepsOf(values);
    if (steps.size() < 3) return false;
    const double usual = median(steps);
    const auto even = std::count_if(steps.begin(), steps.end(),
                                    [&](double step) { return std::abs(step - usual) <= apart * std::abs(usual); });
    return usual > 0 && static_cast<double>(even) >= share * static_cast<double>(steps.size());
}

bool risesStrictly(const std::vector<double>& values) {
    const std::vector<double> steps = stepsOf(values);
    return !steps.empty() && std::all_of(steps.begin(), steps.end(), [](double step) { return step > 0; });
}

/// A logger that was started again, or a wrong stamp: a time nevertheless, whose fault is told where it is used.
bool risesMostly(const std::vector<double>& values) {
    constexpr double share = 0.9;
    const std::vector<double> steps = stepsOf(values);
    const auto up = std::count_if(steps.begin(), steps.end(), [](double step) { return step > 0; });
    return steps.size() > 2 && static_cast<double>(up) >= share * static_cast<double>(steps.size());
}

double secondsIn(const Column& column) {
    const std::string& unit = column.unit.empty() ? unitAtEnd(column.name) : column.unit;
    const auto convert = areConvertible(unit, "s") ? convertUnit(unit, "s") : convertUnit("s", "s");
    return convert ? convert->factor : 1;
}

/// How two times lie to each other, row by row.
struct Distance {
    bool areSameRows{true};  // filled in the same ones
    bool isConstant{true};   // nowhere nearer or farther
    double shift{};          // [s] of the first row
};

Distance distanceOf(const Column& a, const Column& b) {
    Distance distance;
    const double fromA = secondsIn(a), fromB = secondsIn(b);
    const double step = fromA * median(stepsOf(a.values));
    const auto rounding = [step](double first, double second) {
        return std::max(1e-9 * (std::abs(first) + std::abs(second)), 0.01 * step);
    };
    bool isFirst = true;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        if (std::isnan(a.values[i]) != std::isnan(b.values[i])) distance.areSameRows = false;
        if (std::isnan(a.values[i]) || std::isnan(b.values[i])) continue;
        const double first = fromA * a.values[i], second = fromB * b.values[i];
        if (isFirst) distance.shift = second - first;
        isFirst = false;
        if (std::abs(second - first - distance.shift) > rounding(first, second)) distance.isConstant = false;
    }
    distance.isConstant = distance.isConstant && distance.areSameRows;
    return distance;
}

double coveredBy(const Column& column) {
    double span = 0;
    for (const double step : stepsOf(column.values)) span += step;
    return secondsIn(column) * span;
}

/// As long in the same rows, but for a percent and the last digit of a stamp: one may be the clock of another device,
/// recorded beside the first.
bool isAsFast(const Column& a, const Column& b) {
    const auto longest = [](const Column& column) {
        const std::vector<double> steps = stepsOf(column.values);
        return steps.empty() ? 0.0 : secondsIn(column) * *std::max_element(steps.begin(), steps.end());
    };
    const double one = coveredBy(a), other = coveredBy(b);
    return std::abs(one - other) <= std::max({0.01 * one, longest(a), longest(b)});
}

enum class Side { None, Left, Right };

class TimesFinder {
public:
    TimesFinder(const RawTable& raw, std::size_t first) : raw_(raw), first_(first) {
        for (std::size_t i = 0; i < raw.kinds.size(); ++i)
            if (i == first || (raw.kinds[i] != CellKind::Words && isTime(i))) all_.push_back(i);
    }

    const std::vector<std::size_t>& all() const { return all_; }

    /// On which side of its channels each of the times stands; None: neither.
    Side side(const std::vector<std::size_t>& times) const {
        bool isParted = true;
        for (std::size_t k = 1; k < times.size(); ++k) isParted = isParted && hasChannel(times[k - 1] + 1, times[k]);
        if (!isParted) return Side::None;
        if (hasChannel(times.back() + 1, raw_.kinds.size())) return Side::Left;
        return hasChannel(0, times.front()) ? Side::Right : Side::None;
    }

    /// Times that are another raster than the first one, each channel having its own.
    std::vector<std::size_t> own() const {
        std::vector<std::size_t> own;
        for (const std::size_t time : all_)
            if (time == first_ || isOwn(time)) own.push_back(time);
        return own;
    }

    /// Whether a row may be one moment for all channels.
    bool mayBeOneMoment(const std::vector<std::size_t>& times) const {
        return std::all_of(times.begin(), times.end(),
                           [&](std::size_t time) { return distanceOf(column(first_), column(time)).areSameRows; });
    }

private:
    const Column& column(std::size_t index) const { return raw_.table.columns[index]; }

    bool hasChannel(std::size_t begin, std::size_t end) const {
        for (std::size_t i = begin; i < end; ++i)
            if (raw_.kinds[i] != CellKind::Words && std::find(all_.begin(), all_.end(), i) == all_.end()) return true;
        return false;
    }

    /// By its name, as sure as the first one is.
    bool isNamed(std::size_t index) const {
        const Column& it = column(index);
        const bool isNumbered = isNumberedAs(it.name, column(first_).name) &&
                                (it.header == column(first_).header || areConvertible(it.unit, "s"));
        return namesTime(it.name) || isNumbered;
    }

    bool isTime(std::size_t index) const {
        const Column& it = column(index);
        const bool hasUnit = areConvertible(it.unit, "s");
        if (!hasUnit && !it.unit.empty()) return false;
        if (isNamed(index)) return rises(it.values) || (hasUnit && risesMostly(it.values));
        if (hasUnit) return speaksOfTime(it.name) && risesStrictly(it.values);
        return column(first_).unit.empty() && isShortForTime(it.name) && risesStrictly(it.values) &&
               hasEvenSteps(it.values);
    }

    bool isOwn(std::size_t time) const {
        const Distance distance = distanceOf(column(first_), column(time));
        if (!distance.areSameRows) return true;
        const bool isBesideAnother = std::find(all_.begin(), all_.end(), time - 1) != all_.end();
        if (isBesideAnother && isAsFast(column(first_), column(time))) return false;  // a date, and what a clock counts
        if (distance.isConstant)  // a time of day beside that of the run, or two loggers started one after the other
            return distance.shift != 0 && std::abs(distance.shift) < coveredBy(column(first_)) &&
                   isNumberedAs(column(first_).name, column(time).name);
        return isNamed(time) || !isAsFast(column(first_), column(time));
    }

    const RawTable& raw_;
    std::size_t first_;
    std::vector<std::size_t> all_;
};

/// Each column with the time on that side of it; what has none there has the nearest one.
std::vector<ChannelTime> bySide(std::vector<std::size_t> times, Side side, std::size_t columns, std::size_t first) {
    std::vector<ChannelTime> out;
    for (const std::size_t time : times) out.push_back({time, {}});
    for (std::size_t i = 0; i < columns; ++i) {
        std::size_t group = 0;
        for (std::size_t k = 0; k < times.size(); ++k)
            if (side == Side::Left ? times[k] <= i : k > 0 && times[k - 1] < i) group = k;
        out[group].columns.push_back(i);
    }
    const auto front = std::find_if(out.begin(), out.end(), [&](const ChannelTime& t) { return t.time == first; });
    std::rotate(out.begin(), front, front + 1);
    return out;
}

std::size_t filledRows(const Column& column) {
    std::size_t rows = column.values.size();
    while (rows > 0 && std::isnan(column.values[rows - 1])) --rows;
    return rows;
}

/// Times that stand together in front of the channels: each channel has the one that is as long. Empty: the lengths do
/// not tell.
std::vector<ChannelTime> byLength(const RawTable& raw, const std::vector<std::size_t>& times, std::size_t first) {
    std::vector<ChannelTime> out{{first, {}}};
    for (const std::size_t time : times)
        if (time != first) out.push_back({time, {}});
    for (std::size_t i = 0; i < raw.kinds.size(); ++i) {
        const auto itself = std::find_if(out.begin(), out.end(), [&](const ChannelTime& t) { return t.time == i; });
        std::vector<ChannelTime*> alike;
        if (itself != out.end()) alike.push_back(&*itself);
        for (ChannelTime& each : out)
            if (itself == out.end() && (raw.kinds[i] != CellKind::Words || each.time == first) &&
                (raw.kinds[i] == CellKind::Words ||
                 filledRows(raw.table.columns[each.time]) == filledRows(raw.table.columns[i])))
                alike.push_back(&each);
        if (alike.size() != 1) return {};
        alike.front()->columns.push_back(i);
    }
    return out;
}

ChannelTime oneTime(const RawTable& raw, std::size_t first) {
    ChannelTime all{first, {}};
    for (std::size_t i = 0; i < raw.kinds.size(); ++i) all.columns.push_back(i);
    return all;
}

Text readingName(TimeColumns times, const std::string& first) {
    if (times == TimeColumns::Left) return phrase("each channel has the time on its left");
    if (times == TimeColumns::Right) return phrase("each channel has the time on its right");
    return phrase("all channels have '{}'", cited(first));
}

/// The reading that is taken stands first.
void askTimes(const RawTable& raw, std::size_t first, std::size_t other, std::array<TimeColumns, 2> readings,
              const ReadOptions& options, Questions& asked) {
    const std::vector<Column>& columns = raw.table.columns;
    Question question{Question::Kind::Choice,
                      phrase("'{}' and '{}' are both times and differ. Which channels have which?",
                             cited(columns[first].name), cited(columns[other].name))};
    for (const TimeColumns reading : readings) {
        question.readings.push_back({readingName(reading, columns[first].name), options});
        question.readings.back().options.times = reading;
    }
    asked.push_back(std::move(question));
}

Diagnostic untold(const RawTable& raw, std::size_t first, std::size_t other) {
    const std::vector<Column>& columns = raw.table.columns;
    return doubt(phrase("'{}' and '{}' are both times and differ; all channels are taken to have '{}'",
                        cited(columns[first].name), cited(columns[other].name), cited(columns[first].name)),
                 raw.table.file, 0,
                 phrase("Where channels have times of their own, say it in the study: \"read\": {{\"times\": "
                        "\"left\"}}, or \"right\"."));
}

/// As it was told.
std::vector<ChannelTime> asTold(const RawTable& raw, const TimesFinder& finder, std::size_t first, TimeColumns told) {
    if (told == TimeColumns::One) return {oneTime(raw, first)};
    std::vector<ChannelTime> times =
        bySide(finder.all(), told == TimeColumns::Left ? Side::Left : Side::Right, raw.kinds.size(), first);
    // a time that no channel has is one of those of its neighbour
    for (std::size_t k = times.size(); k-- > 1;)
        if (times[k].columns.size() < 2) {
            times.front().columns.insert(times.front().columns.end(), times[k].columns.begin(), times[k].columns.end());
            times.erase(times.begin() + static_cast<std::ptrdiff_t>(k));
        }
    std::sort(times.front().columns.begin(), times.front().columns.end());
    return times;
}

}  // namespace

std::optional<std::size_t> firstOfPairedTimes(const Table& table, const std::vector<CellKind>& kinds) {
    std::vector<std::size_t> times;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const Column& column = table.columns[i];
        if ((!kinds.empty() && kinds[i] == CellKind::Words) || !column.unit.empty() || column.name == "T") continue;
        if (isShortForTime(column.name) && risesStrictly(column.values) && hasEvenSteps(column.values))
            times.push_back(i);
    }
    if (times.size() < 2) return std::nullopt;
    for (std::size_t k = 1; k < times.size(); ++k)
        if (times[k] == times[k - 1] + 1) return std::nullopt;  // columns that count, and no pairs
    return times.front();
}

std::vector<ChannelTime> timesOfChannels(const RawTable& raw, std::size_t first, const ReadOptions& options,
                                         Diagnostics& told, Questions& asked) {
    const TimesFinder finder(raw, first);
    if (options.times != TimeColumns::Found) return asTold(raw, finder, first, options.times);
    const std::vector<std::size_t> own = finder.own();
    const std::vector<std::size_t>& looked = own.size() > 1 ? own : finder.all();
    const Side side = finder.side(looked);
    const TimeColumns sided = side == Side::Right ? TimeColumns::Right : TimeColumns::Left;
    const auto other = std::find_if(looked.begin(), looked.end(), [&](std::size_t time) {
        return time != first &&
               (own.size() > 1 || !distanceOf(raw.table.columns[first], raw.table.columns[time]).isConstant);
    });
    if (other == looked.end()) return {oneTime(raw, first)};
    if (own.size() < 2) {
        if (side == Side::None) return {oneTime(raw, first)};
        askTimes(raw, first, *other, {TimeColumns::One, sided}, options, asked);
        told.push_back(untold(raw, first, *other));
        return {oneTime(raw, first)};
    }
    std::vector<ChannelTime> times =
        side == Side::None ? byLength(raw, own, first) : bySide(own, side, raw.kinds.size(), first);
    if (times.empty()) {
        askTimes(raw, first, *other, {TimeColumns::One, TimeColumns::Left}, options, asked);
        told.push_back(untold(raw, first, *other));
        return {oneTime(raw, first)};
    }
    Text how = side == Side::None   ? phrase("each channel belongs to the one that is as long")
               : side == Side::Left ? phrase("each channel belongs to the one on its left")
                                    : phrase("each channel belongs to the one on its right");
    told.push_back(remark(phrase("{} columns of time: {}", times.size(), std::move(how)), raw.table.file));
    if (side != Side::None && finder.mayBeOneMoment(own))
        askTimes(raw, first, *other, {sided, TimeColumns::One}, options, asked);
    return times;
}

}  // namespace analogon
