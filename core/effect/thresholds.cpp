#include "core/effect/thresholds.hpp"

namespace analogon {

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
