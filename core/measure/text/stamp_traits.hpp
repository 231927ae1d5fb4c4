#pragma once

#include <cstddef>
#include <cstdint>

#include "core/measure/text/stamp_series.hpp"

namespace analogon {

/// Whether a row has a stamp.
inline bool isTold(const Stamp& stamp) { return stamp.hasDate() || stamp.hasClock; }

/// What all stamps of a column have.
struct StampTraits {
    bool haveDate{true}, haveClock{true}, haveZone{true}, anyDate{}, anyZone{}, haveTwoFields{true}, anyFraction{};
    bool mayCountDays{true}, anyMayCountDays{}, anyCountsDays{};
    bool areMidnight{true};  // as spreadsheets write dates
    std::uint8_t orders{0xFF};
    std::size_t count{};
};

StampTraits traitsOf(const StampSeries& stamps);

}  // namespace analogon
