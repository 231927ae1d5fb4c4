#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace analogon {

/// Smallest and largest of what was taken; NaN is not measured and does not count.
struct Range {
    double low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

    void take(double x) {
        if (std::isnan(x)) return;
        low = std::min(low, x);
        high = std::max(high, x);
    }
    void take(const Range& other) {
        low = std::min(low, other.low);
        high = std::max(high, other.high);
    }
    bool isEmpty() const { return low > high; }
    double width() const { return isEmpty() ? 0 : high - low; }
};

/// Of the values of a vector or a row.
template <class Values>
Range rangeOf(const Values& values) {
    Range range;
    for (const double x : values) range.take(x);
    return range;
}

}  // namespace analogon
