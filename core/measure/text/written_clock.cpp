#include "core/measure/text/written_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/measure/text/stamp.hpp"

namespace analogon {

namespace {

struct Clock {
    double hours, minutes, seconds;
};

Clock clockOf(double written) {
    const double hours = std::floor(written / 10000), minutes = std::floor(written / 100) - 100 * hours;
    return {hours, minutes, written - 10000 * hours - 100 * minutes};
}

double secondsOf(double written) {
    const Clock clock = clockOf(written);
    return 3600 * clock.hours + 60 * clock.minutes + clock.seconds;
}

/// The longest step is no more than one and a half of the shortest.
template <class TimeOf>
bool isEven(const std::vector<double>& times, const TimeOf& timeOf) {
    double least = INFINITY, longest = 0;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double step = timeOf(times[i]) - timeOf(times[i - 1]);
        least = std::min(least, step);
        longest = std::max(longest, step);
    }
    return least > 0 && longest <= 1.5 * least;
}

}  // namespace

bool seemsWrittenClock(const std::vector<double>& times) {
    constexpr double large = 10000;  // one o'clock
    if (times.size() < 3) return false;
    const bool areClocks = std::all_of(times.begin(), times.end(), [](double time) {
        const Clock clock = clockOf(time);
        return time >= 0 && clock.hours < 24 && clock.minutes < 60 && clock.seconds < 60;
    });
    if (!areClocks) return false;
    const double asNumbers = times.back() - times.front(),
                 asClocks = secondsOf(times.back()) - secondsOf(times.front());
    if (!(std::abs(asNumbers - asClocks) > 1e-6 * std::abs(asNumbers))) return false;
    const bool isEvenAsNumbers = isEven(times, [](double time) { return time; });
    return times.front() >= large || (isEven(times, secondsOf) && !isEvenAsNumbers);
}

std::string writtenFormat(const std::vector<double>& times) {
    for (const auto& [format, digits] : {std::pair{"%Y%m%d%H%M%S", 14}, {"%Y%m%d%H%M", 12}, {"%Y%m%d", 8}}) {
        const auto isWritten = [&, letters = format, length = static_cast<std::size_t>(digits)](double time) {
            if (!(time > 0 && time < 1e15) || time != std::floor(time)) return false;
            const std::string text = fmt::format("{:.0f}", time);
            return text.size() == length && readStamp(text, letters).has_value();
        };
        if (times.size() > 1 && std::all_of(times.begin(), times.end(), isWritten)) return format;
    }
    return seemsWrittenClock(times) ? "%H%M%S" : std::string();
}

}  // namespace analogon
