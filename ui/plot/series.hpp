#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/base/memory.hpp"

namespace analogon::ui {

/// Values that are drawn and never changed: copies share them, so that a plot, its residual and what is worked out
/// beside the window cost a long recording once. They may be part of something larger that it keeps alive.
class Series {
public:
    Series() = default;
    Series(std::vector<double> values) {
        const auto held = std::make_shared<const std::vector<double>>(std::move(values));
        values_ = *held;
        owner_ = held;
    }
    Series(std::shared_ptr<const void> owner, std::span<const double> values)
        : owner_(std::move(owner)), values_(values) {}

    std::span<const double> values() const { return values_; }
    operator std::span<const double>() const { return values_; }
    std::vector<double> copy() const { return {values_.begin(), values_.end()}; }
    bool empty() const { return values_.empty(); }
    std::size_t size() const { return values_.size(); }
    double operator[](std::size_t i) const { return values_[i]; }
    friend bool operator==(const Series& a, const std::vector<double>& b) { return std::ranges::equal(a.values_, b); }

private:
    std::shared_ptr<const void> owner_;
    std::span<const double> values_;
};

/// Whether there is a number among them.
inline bool hasValues(const Series& series) {
    return std::any_of(series.values().begin(), series.values().end(), [](double v) { return std::isfinite(v); });
}

/// What was measured less what was simulated.
inline Series residualOf(const Series& measured, const Series& simulated) {
    const auto left = std::make_shared<Eigen::VectorXd>();
    resizeLarge(*left, static_cast<std::ptrdiff_t>(simulated.size()), 1);
    const std::span<double> values(left->data(), simulated.size());
    std::transform(measured.values().begin(), measured.values().begin() + left->size(), simulated.values().begin(),
                   values.begin(), std::minus<>());
    return {left, values};
}

}  // namespace analogon::ui
