#include "core/base/usual_unit.hpp"

#include <algorithm>
#include <array>

namespace analogon {

namespace {

std::vector<std::string> listOfUnits() {
    constexpr std::array<const char*, 7> prefixes{"", "M", "k", "h", "m", "u", "n"};
    constexpr std::array<const char*, 15> bases{"Pa",  "bar", "V", "A", "W", "Hz", "Ohm", "N",
                                                "N.m", "J",   "F", "H", "g", "m",  "s"};
    constexpr std::array<const char*, 18> others{"degC",  "degF", "K",   "rpm",    "1/min", "rad/s",
                                                 "deg/s", "km/h", "m/s", "kg/h",   "l/min", "l/h",
                                                 "g/s",   "m/s2", "%",   "Nm/rad", "Nm",    "psi"};
    std::vector<std::string> units(others.begin(), others.end());
    for (const char* const base : bases)
        for (const char* const prefix : prefixes) units.push_back(std::string(prefix) + base);
    return units;
}

}  // namespace

const std::vector<std::string>& usualUnits() {
    static const std::vector<std::string> units = listOfUnits();
    return units;
}

bool isUsualUnit(std::string_view unit) {
    const std::vector<std::string>& units = usualUnits();
    return std::find(units.begin(), units.end(), unit) != units.end();
}

}  // namespace analogon
