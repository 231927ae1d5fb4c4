#include "core/effect/thresholds.hpp"

#ifdef ANALOGON_SETTABLE_THRESHOLDS
#include <cmath>
#include <cstdlib>
#include <string>
#endif

namespace analogon {

#ifdef ANALOGON_SETTABLE_THRESHOLDS
double threshold::setOff(std::string_view name, double value) {
    const char* wanted = std::getenv("ANALOGON_THRESHOLD");
    if (!wanted) return value;
    const std::string_view text = wanted;
    const std::size_t space = text.find(' ');
    if (space == std::string_view::npos || text.substr(0, space) != name) return value;
    const double off = value * std::strtod(wanted + space, nullptr);
    return value == std::round(value) && std::abs(value) >= 1 ? std::round(off) : off;
}
#endif

std::span<const ThresholdRow> thresholds() {
    static const ThresholdRow rows[] = {
#define THRESHOLD(group, type, name, value, unit, meaning, origin, guard) \
    {#group, #name, static_cast<double>(threshold::group::name), unit, meaning, origin, guard},
#include "core/effect/thresholds.def"
#undef THRESHOLD
    };
    return rows;
}

}  // namespace analogon
