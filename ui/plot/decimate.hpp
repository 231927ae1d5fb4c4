#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

namespace analogon::ui {

/// Smallest and largest of some values; empty while low > high.
struct ValueRange {
    double low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

    bool isEmpty() const { return low > high; }
    void add(double value) {  // comparisons with NaN do not hold: nothing is added
        if (value < low) low = value;
        if (value > high) high = value;
    }
    void add(const ValueRange& other) {
        low = std::min(low, other.low);
        high = std::max(high, other.high);
    }
};

/// The range of any stretch of a trace without a look at each sample: ranges of blocks are kept, and only the ends of a
/// stretch are read sample by sample. What is not finite is left out.
class ValueExtent {
public:
    ValueExtent() = default;
    explicit ValueExtent(std::span<const double> values);

    /// Of the samples [begin, end) of the values it was made from.
    ValueRange of(std::span<const double> values, std::size_t begin, std::size_t end) const;
    const ValueRange& whole() const { return whole_; }

private:
    std::vector<ValueRange> blocks_;
    ValueRange whole_;
};

/// Indices of the samples in [from, to] and one on either side. `time` rises.
std::pair<std::size_t, std::size_t> samplesWithin(std::span<const double> time, double from, double to);

/// What a line through the samples covers in each of `count` columns that [from, to] is cut into, so that no peak is
/// lost and neighbours touch; empty before the first and after the last sample.
std::vector<ValueRange> columnRanges(std::span<const double> time, std::span<const double> values,
                                     const ValueExtent& extent, double from, double to, int count);

/// Distance of grid lines: 1, 2 or 5 times a power of ten, about `count` in the range.
double niceStep(double range, int count);

/// The same for an axis with labels: finer where only one label would stand in the range, which tells no scale.
double labelStep(double low, double high, int count);

}  // namespace analogon::ui
