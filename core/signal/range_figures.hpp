#pragma once

#include <span>

namespace analogon {

/// What a signal does between two moments, over the time and not over the samples: mean = ∫y dt / ∫dt,
/// rms = √(∫y² dt / ∫dt), with y on straight lines between its samples; gaps (NaN) are left out.
struct RangeFigures {
    double mean{}, rms{};  // NaN: nothing was measured there
    double low{}, high{};
    double length{};  // [s] that was looked at
};

/// `time` rises; what lies outside of it is not looked at.
RangeFigures figuresWithin(std::span<const double> time, std::span<const double> values, double from, double to);

}  // namespace analogon
