#pragma once

#include <span>

#include "core/base/outcome.hpp"

namespace analogon {

/// One quantity as one logger stamped it. The stamps ascend; NaN among the values is a gap.
struct ComparedCourse {
    std::span<const double> time;  // [s]
    std::span<const double> values;
};

/// How much later a logger stamps than another one: other(t + shift) runs as reference(t).
struct TimeShift {
    double shift{};        // [s] the clock of the other channel in a study, where that of the reference is 0
    double deviation{};    // [s] one standard deviation
    double correlation{};  // of the two where they overlap, so shifted
};

/// By the largest cross-correlation of the two on an even raster, over shifts under which half of the shorter one
/// overlaps; between its samples as the spectrum of the two has it. Their scales and offsets may differ. Faults: one of
/// them does not change or is too short; they are not alike; another shift does as well (they repeat); they change so
/// slowly that any shift does. What does as well is judged by the likelihood under residuals of first order (AR 1).
/// Knapp, Carter: The generalized correlation method for estimation of time delay. IEEE Trans. ASSP 24 (1976).
Outcome<TimeShift> timeShift(const ComparedCourse& reference, const ComparedCourse& other);

}  // namespace analogon
