#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fit/fit.hpp"

namespace analogon {

namespace {

/// A power of two in which no square of a value overflows or vanishes; 1 for all common values, which stay as they are.
double unitOf(const Eigen::Ref<const Eigen::RowVectorXd>& simulated,
              const Eigen::Ref<const Eigen::RowVectorXd>& measured) {
    double largest = 0.0;
    for (Eigen::Index k = 0; k < measured.size(); ++k) {
        if (std::isnan(measured[k])) continue;
        for (const double value : {std::abs(measured[k]), std::abs(simulated[k])})
            if (std::isfinite(value)) largest = std::max(largest, value);
    }
    const bool isCommon = largest < 1e100 && largest > 1e-100;
    return isCommon || largest == 0.0 ? 1.0 : std::ldexp(1.0, std::ilogb(largest));
}

}  // namespace

// The mean square error of eqs. 11 to 13 of the 2014 paper, at the samples: the simulation yields its outputs at
// the measured times, so that the linear interpolation of eqs. 9 and 10 acts on the inputs alone.
ErrorFigures errorFigures(const Eigen::Ref<const Eigen::RowVectorXd>& simulated,
                          const Eigen::Ref<const Eigen::RowVectorXd>& measured) {
    double square = 0.0, norm = 0.0, sum = 0.0, largest = 0.0;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    Eigen::Index count = 0;
    const double unit = unitOf(simulated, measured);
    for (Eigen::Index k = 0; k < measured.size(); ++k) {
        const double m = measured[k] / unit;
        if (std::isnan(m)) continue;
        const double difference = simulated[k] / unit - m;
        ++count;
        square += difference * difference;
        norm += m * m;
        sum += m;
        // NaN must show: a simulation that failed has no error figure.
        if (!(std::abs(difference) <= largest)) largest = std::abs(difference);
        low = std::min(low, m);
        high = std::max(high, m);
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    if (count == 0) return {nan, nan, nan, nan, nan};
    const auto n = static_cast<double>(count), mean = sum / n;
    double spread = 0.0;
    for (Eigen::Index k = 0; k < measured.size(); ++k) {
        if (!std::isnan(measured[k])) spread += (measured[k] / unit - mean) * (measured[k] / unit - mean);
    }
    ErrorFigures figures;
    const double rms = std::sqrt(square / n);
    figures.rmse = rms * unit;
    // A channel that stands still has no range: its magnitude takes the place, where it has one.
    const double scale = high > low ? high - low : std::abs(high);
    figures.errorPercent = scale > 0.0 ? 100.0 * rms / scale : nan;
    figures.relativeRmsPercent = norm > 0.0 ? 100.0 * std::sqrt(square / norm) : nan;
    figures.fitPercent = high > low && spread > 0.0 ? 100.0 * (1.0 - std::sqrt(square / spread)) : nan;
    figures.maxAbs = largest * unit;
    return figures;
}

}  // namespace analogon
