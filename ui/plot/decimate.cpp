#include "ui/plot/decimate.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace analogon::ui {

namespace {

constexpr std::size_t blockSize = 64;

void addFinite(ValueRange& range, double value) {
    if (std::isfinite(value)) range.add(value);
}

void addFinite(ValueRange& range, std::span<const double> values) {
    for (const double v : values) addFinite(range, v);
}

/// A block of a long trace is nearly always finite, and then its range is found several values at a time.
ValueRange rangeOfBlock(std::span<const double> block) {
    ValueRange range;
    const Eigen::Map<const Eigen::ArrayXd> values(block.data(), static_cast<Eigen::Index>(block.size()));
    const bool isFinite = (values - values).sum() == 0;  // what is not finite less itself is NaN
    if (isFinite && !block.empty())
        range = {values.minCoeff(), values.maxCoeff()};
    else
        addFinite(range, block);
    return range;
}

}  // namespace

ValueExtent::ValueExtent(std::span<const double> values) {
    blocks_.reserve(values.size() / blockSize + 1);
    for (std::size_t begin = 0; begin < values.size(); begin += blockSize) {
        const ValueRange block = rangeOfBlock(values.subspan(begin, std::min(blockSize, values.size() - begin)));
        whole_.add(block);
        blocks_.push_back(block);
    }
}

ValueRange ValueExtent::of(std::span<const double> values, std::size_t begin, std::size_t end) const {
    ValueRange range;
    const std::size_t firstBlock = (begin + blockSize - 1) / blockSize, lastBlock = end / blockSize;
    if (firstBlock >= lastBlock) {
        addFinite(range, values.subspan(begin, end - begin));
        return range;
    }
    addFinite(range, values.subspan(begin, firstBlock * blockSize - begin));
    for (std::size_t i = firstBlock; i < lastBlock; ++i) range.add(blocks_[i]);
    addFinite(range, values.subspan(lastBlock * blockSize, end - lastBlock * blockSize));
    return range;
}

std::pair<std::size_t, std::size_t> samplesWithin(std::span<const double> time, double from, double to) {
    auto begin = static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), from) - time.begin());
    auto end = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), to) - time.begin());
    if (begin > 0) --begin;
    if (end < time.size()) ++end;
    return {begin, end};
}

std::vector<ValueRange> columnRanges(std::span<const double> time, std::span<const double> values,
                                     const ValueExtent& extent, double from, double to, int count) {
    std::vector<ValueRange> columns(static_cast<std::size_t>(std::max(0, count)));
    const std::size_t size = std::min(time.size(), values.size());
    if (size == 0 || !(to > from)) return columns;
    time = time.first(size);
    const double width = (to - from) / count;
    auto next = static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), from) - time.begin());
    // The line between the samples on either side of a moment.
    const auto lineAt = [&](std::size_t behind, double t) {
        const double part = (t - time[behind - 1]) / (time[behind] - time[behind - 1]);
        return values[behind - 1] + part * (values[behind] - values[behind - 1]);
    };
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const double left = from + static_cast<double>(i) * width, right = left + width;
        if (next > 0 && next < size) addFinite(columns[i], lineAt(next, left));
        const auto behind = std::lower_bound(time.begin() + static_cast<std::ptrdiff_t>(next), time.end(), right);
        const auto end = static_cast<std::size_t>(behind - time.begin());
        columns[i].add(extent.of(values, next, end));
        if (end > 0 && end < size) addFinite(columns[i], lineAt(end, right));
        next = end;
    }
    return columns;
}

double niceStep(double range, int count) {
    if (!(range > 0) || !std::isfinite(range) || count < 1) return 1;
    const double rough = range / count;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    constexpr double rounded = 1 - 1e-9;  // 0.4 * 0.05 is 0.02
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough * rounded) return factor * power;
    return 10 * power;
}

double labelStep(double low, double high, int count) {
    double step = niceStep(high - low, count);
    for (int k = 0; k < 4 && std::floor(high / step) - std::ceil(low / step) < 1; ++k) step = niceStep(0.4 * step, 1);
    return step;
}

}  // namespace analogon::ui
