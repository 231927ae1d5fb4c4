#include "core/base/unit_alike.hpp"

#include <algorithm>
#include <cctype>

#include "core/base/unit.hpp"
#include "core/base/usual_unit.hpp"

namespace analogon {

namespace {

std::string inSmall(std::string_view text) {
    std::string small;
    for (const char c : text)
        if (c != ' ' && c != '.' && c != '_') small += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return small;
}

}  // namespace

std::vector<std::string> unitsAlike(std::string_view unit) {
    const std::string wanted = inSmall(unit);
    std::vector<std::string> alike;
    if (wanted.empty() || unit.size() > 100) return alike;
    for (const std::string& other : usualUnits())
        if (inSmall(other) == wanted && isKnownUnit(other)) alike.push_back(other);
    if (!alike.empty()) return alike;
    // a degree sign of another set of letters
    if (wanted.size() <= 3 && (wanted.front() & 0x80) != 0 && (wanted.back() == 'c' || wanted.back() == 'f'))
        return {wanted.back() == 'c' ? "degC" : "degF"};
    if (std::string near = unitAlike(unit); !near.empty()) alike.push_back(std::move(near));
    return alike;
}

}  // namespace analogon
