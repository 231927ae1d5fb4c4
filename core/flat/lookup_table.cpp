#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/flat/cubic_slopes.hpp"

namespace analogon {
namespace {

/// n-th derivative at h of c0 + c1 h + c2 h^2 + c3 h^3.
double cubicDerivative(double c0, double c1, double c2, double c3, double h, int n) {
    switch (n) {
        case 0:
            return c0 + h * (c1 + h * (c2 + h * c3));
        case 1:
            return c1 + h * (2 * c2 + h * 3 * c3);
        case 2:
            return 2 * c2 + 6 * c3 * h;
        case 3:
            return 6 * c3;
        default:
            return 0;
    }
}

/// n-th derivative of the interpolant.
double interpolate(const LookupTable& table, double at, int n) {
    const auto& x = table.x;
    const auto& y = table.y;
    assert(!x.empty() && x.size() == y.size());
    if (x.size() == 1) return n == 0 ? y.front() : 0.0;

    const auto upper = std::upper_bound(x.begin() + 1, x.end() - 1, at);
    auto i = static_cast<std::size_t>(upper - x.begin()) - 1;
    while (i > 0 && x[i + 1] == x[i]) --i;  // a jump at the very end
    const double width = x[i + 1] - x[i];
    const double secant = (y[i + 1] - y[i]) / width;
    if (table.interpolation == LookupTable::Interpolation::Constant)
        return n > 0 ? 0 : at >= x.back() ? y.back() : y[i];
    if (table.interpolation == LookupTable::Interpolation::Linear)
        return at >= x.back() && n == 0 && at == x[i + 1] ? y.back()
                                                          : cubicDerivative(y[i], secant, 0, 0, at - x[i], n);

    std::vector<double> computed;
    if (table.slopes.size() != x.size()) computed = limitedSlopes(x, y);
    const auto& slopes = computed.empty() ? table.slopes : computed;
    if (at < x.front()) return cubicDerivative(y.front(), slopes.front(), 0, 0, at - x.front(), n);
    // As at every node, what changes there is as it goes on behind it.
    const bool isBehind = at == x.back() && n > 1 && table.extrapolation != LookupTable::Extrapolation::None;
    if (at > x.back() || isBehind) return cubicDerivative(y.back(), slopes.back(), 0, 0, at - x.back(), n);
    const double c2 = (3 * secant - 2 * slopes[i] - slopes[i + 1]) / width;
    const double c3 = (slopes[i] + slopes[i + 1] - 2 * secant) / (width * width);
    return cubicDerivative(y[i], slopes[i], c2, c3, at - x[i], n);
}

/// The same with what is asked for outside of the table.
double extrapolate(const LookupTable& table, double at, int n) {
    if (at < table.begin) return 0;
    at -= table.shift;
    const double first = table.x.front(), last = table.x.back();
    if (table.extrapolation == LookupTable::Extrapolation::Slope || (at >= first && at < last) ||
        (at == last && table.extrapolation != LookupTable::Extrapolation::Periodic))
        return interpolate(table, at, n);
    switch (table.extrapolation) {
        case LookupTable::Extrapolation::Periodic:
            if (!(last > first)) return interpolate(table, first, n);
            at = first + std::fmod(at - first, last - first);
            return interpolate(table, at < first ? at + (last - first) : at, n);
        case LookupTable::Extrapolation::Hold:
            return n > 0 ? 0 : at < first ? table.y.front() : table.y.back();
        default:
            return std::nan("");
    }
}

}  // namespace

void LookupTable::prepare() {
    if (interpolation == Interpolation::MonotoneCubic) slopes = limitedSlopes(x, y);
}

double LookupTable::value(double at) const { return extrapolate(*this, at, order); }
double LookupTable::derivative(double at) const { return extrapolate(*this, at, order + 1); }

}  // namespace analogon
