#include "core/fit/clock.hpp"

#include <algorithm>
#include <string_view>

namespace analogon {

namespace {

constexpr std::string_view prefix = "clock ";

}  // namespace

std::string clockOf(const std::string& signal) { return std::string(prefix) + signal; }

bool isClock(const std::string& parameter) { return parameter.starts_with(prefix); }

std::string signalOfClock(const std::string& parameter) { return parameter.substr(prefix.size()); }

TimeStencil stencilAt(const std::vector<double>& time, double t) {
    const auto count = static_cast<int>(time.size());
    if (count < 2 || t <= time.front()) return {0, 1, {1.0}, {}};
    if (t >= time.back()) return {count - 1, 1, {1.0}, {}};
    const auto at = [&](int k) { return time[static_cast<std::size_t>(k)]; };
    const auto k = static_cast<int>(std::upper_bound(time.begin(), time.end(), t) - time.begin()) - 1;
    const double h = at(k + 1) - at(k), s = (t - at(k)) / h;
    TimeStencil stencil;
    stencil.first = std::max(0, k - 1);
    stencil.count = std::min(count - 1, k + 2) - stencil.first + 1;
    const auto add = [&](int sample, double weight, double slope) {
        const auto j = static_cast<std::size_t>(sample - stencil.first);
        stencil.weights[j] += weight;
        stencil.slopes[j] += slope;
    };
    // Slope at a sample: of the parabola through it and its neighbours, of the chord at the ends.
    const auto addSlope = [&](int sample, double weight, double slope) {
        const int before = std::max(0, sample - 1), after = std::min(count - 1, sample + 1);
        if (before == sample || after == sample) {
            const double chord = at(after) - at(before);
            add(after, weight / chord, slope / chord);
            add(before, -weight / chord, -slope / chord);
            return;
        }
        const double left = at(sample) - at(before), right = at(after) - at(sample), both = left + right;
        const double factors[] = {-right / (left * both), (right - left) / (left * right), left / (right * both)};
        for (int j = 0; j < 3; ++j) add(before + j, weight * factors[j], slope * factors[j]);
    };
    add(k, (1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s), 6.0 * s * (s - 1.0) / h);
    add(k + 1, s * s * (3.0 - 2.0 * s), -6.0 * s * (s - 1.0) / h);
    addSlope(k, h * s * (1.0 - s) * (1.0 - s), (1.0 - s) * (1.0 - 3.0 * s));
    addSlope(k + 1, h * s * s * (s - 1.0), s * (3.0 * s - 2.0));
    return stencil;
}

Eigen::RowVectorXd onLinesAt(const std::vector<double>& time, const Eigen::RowVectorXd& column, double offset) {
    Eigen::RowVectorXd shifted(column.size());
    std::size_t k = 0;
    for (Eigen::Index j = 0; j < column.size(); ++j) {
        const double stamp = std::clamp(time[static_cast<std::size_t>(j)] + offset, time.front(), time.back());
        while (k + 2 < time.size() && time[k + 1] <= stamp) ++k;
        const auto left = static_cast<Eigen::Index>(k);
        const double part = (stamp - time[k]) / (time[k + 1] - time[k]);
        shifted[j] = column[left] + part * (column[left + 1] - column[left]);
    }
    return shifted;
}

Eigen::RowVectorXd atStamps(const std::vector<double>& time, const Eigen::RowVectorXd& trace, double offset) {
    Eigen::RowVectorXd shifted(trace.size());
    for (Eigen::Index k = 0; k < trace.size(); ++k)
        shifted[k] = stencilAt(time, time[static_cast<std::size_t>(k)] - offset).value([&](int j) { return trace[j]; });
    return shifted;
}

}  // namespace analogon
