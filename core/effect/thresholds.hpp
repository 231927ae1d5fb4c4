#pragma once

#include <cstddef>
#include <numbers>
#include <span>
#include <string_view>

/// Every number by which a search decides, in one table (thresholds.def): as a constant, threshold::GROUP::NAME, and as
/// a list for whoever wants to see them all. A new one needs a row there, with the test that fails when it is off.
namespace analogon {

namespace threshold {

#ifdef ANALOGON_SETTABLE_THRESHOLDS
/// The value times the factor that the environment variable ANALOGON_THRESHOLD="GROUP.NAME FACTOR" gives, where it
/// names this one: tests/thresholds.py sets one off at a time, to see which test notices.
double setOff(std::string_view name, double value);

#define THRESHOLD(group, type, name, value, unit, meaning, origin, guard)        \
    namespace group {                                                            \
    inline const type name = static_cast<type>(setOff(#group "." #name, value)); \
    }
#else
#define THRESHOLD(group, type, name, value, unit, meaning, origin, guard) \
    namespace group {                                                     \
    inline constexpr type name = value;                                   \
    }
#endif
#include "core/effect/thresholds.def"
#undef THRESHOLD

}  // namespace threshold

struct ThresholdRow {
    std::string_view group, name;
    double value;
    std::string_view unit, meaning, origin, guard;
};

/// All of them, in the order of the table.
std::span<const ThresholdRow> thresholds();

}  // namespace analogon
