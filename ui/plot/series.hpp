#pragma once

#include <memory>
#include <span>
#include <vector>

namespace analogon::ui {

/// Values that are drawn and never changed: copies share them, so that a plot, its residual and what is worked out
/// beside the window cost a long recording once.
class Series {
public:
    Series() = default;
    Series(std::vector<double> values) : values_(std::make_shared<const std::vector<double>>(std::move(values))) {}

    const std::vector<double>& values() const {
        static const std::vector<double> none;
        return values_ ? *values_ : none;
    }
    operator const std::vector<double>&() const { return values(); }
    operator std::span<const double>() const { return values(); }
    bool empty() const { return values().empty(); }
    std::size_t size() const { return values().size(); }
    double operator[](std::size_t i) const { return (*values_)[i]; }
    friend bool operator==(const Series& a, const std::vector<double>& b) { return a.values() == b; }

private:
    std::shared_ptr<const std::vector<double>> values_;
};

/// What was measured less what was simulated.
inline std::vector<double> residualOf(const Series& measured, const Series& simulated) {
    std::vector<double> left(simulated.size());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = measured[i] - simulated[i];
    return left;
}

}  // namespace analogon::ui
