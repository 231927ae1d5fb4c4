#include "core/base/unit_alike.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/base/unit.hpp"

namespace analogon {

namespace {

std::string inSmall(std::string_view text) {
    std::string small;
    for (const char c : text)
        if (c != ' ' && c != '.' && c != '_') small += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return small;
}

/// The usual units with the usual parts and multiples of each; the greater first.
std::vector<std::string> usualUnits() {
    constexpr std::array<const char*, 7> prefixes{"", "M", "k", "h", "m", "u", "n"};
    constexpr std::array<const char*, 15> bases{"Pa",  "bar", "V", "A", "W", "Hz", "Ohm", "N",
                                                "N.m", "J",   "F", "H", "g", "m",  "s"};
    constexpr std::array<const char*, 16> others{"degC", "degF", "K",     "rpm", "1/min", "rad/s", "deg/s", "km/h",
                                                 "m/s",  "kg/h", "l/min", "l/h", "g/s",   "m/s2",  "%",     "Nm/rad"};
    std::vector<std::string> units(others.begin(), others.end());
    for (const char* const base : bases)
        for (const char* const prefix : prefixes) units.push_back(std::string(prefix) + base);
    return units;
}

}  // namespace

std::vector<std::string> unitsAlike(std::string_view unit) {
    static const std::vector<std::string> usual = usualUnits();
    const std::string wanted = inSmall(unit);
    std::vector<std::string> alike;
    if (wanted.empty() || unit.size() > 100) return alike;
    for (const std::string& other : usual)
        if (inSmall(other) == wanted && isKnownUnit(other)) alike.push_back(other);
    if (!alike.empty()) return alike;
    // a degree sign of another set of letters
    if (wanted.size() <= 3 && (wanted.front() & 0x80) != 0 && (wanted.back() == 'c' || wanted.back() == 'f'))
        return {wanted.back() == 'c' ? "degC" : "degF"};
    if (std::string near = unitAlike(unit); !near.empty()) alike.push_back(std::move(near));
    return alike;
}

}  // namespace analogon
