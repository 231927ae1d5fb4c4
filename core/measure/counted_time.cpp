#include "core/measure/counted_time.hpp"

#include <cmath>
#include <utility>

#include "core/measure/cited.hpp"

namespace analogon {

CountedTime countedTime(const std::vector<double>& values) {
    if (values.size() < 2) return {};
    constexpr double from = 9e8, to = 3e9;  // 1998 to 2065 [s since 1970]
    const double first = values.front(), step = (values.back() - first) / static_cast<double>(values.size() - 1);
    for (const auto& [unit, perSecond] : {std::pair{"ms", 1e3}, {"us", 1e6}, {"ns", 1e9}})
        if (first > from * perSecond && first < to * perSecond) return {std::string(unit), false};
    const bool isDay = (first > 30'000 && first < 70'000) || (first > 700'000 && first < 760'000);
    return {{}, isDay && step < 0.2 && first != std::floor(first)};
}

Text toldSince1970(const std::string& name, const std::string& unit) {
    return phrase("the numbers in column '{}' are taken for {} since 1970: no unit is given", cited(name), unit);
}

std::string takenTimeUnit(const std::string& name, const std::vector<double>& values, std::vector<Text>& notes) {
    const CountedTime counted = countedTime(values);
    if (!counted.unit.empty()) {
        notes.push_back(toldSince1970(name, counted.unit));
        return counted.unit;
    }
    if (!counted.mayBeDays) return {};
    // a step of 9 s in days: as seconds it would be a rate of 10 kHz over hours
    constexpr double shortest = 1e-4;
    const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
    if (step < shortest) {
        notes.push_back(phrase("the numbers in column '{}' begin at {:.9g} and are taken for days: no unit is given",
                               cited(name), values.front()));
        return "d";
    }
    notes.push_back(
        phrase("the time in column '{}' begins at {:.9g} and has no unit: it is taken in seconds, and may be in "
               "days",
               cited(name), values.front()));
    return {};
}

}  // namespace analogon
