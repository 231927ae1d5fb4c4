#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/flat/pool_number.hpp"

/// Slopes of cubic pieces at the nodes of a curve, for ordinates that are numbers (double) or expressions (PoolNumber).
/// Each is a formula of its neighbours; n >= 2 nodes, abscissas strictly increasing.
namespace analogon {

/// As the enumeration Modelica.Blocks.Types.Smoothness counts.
enum class Smoothness { Linear = 1, Akima, Constant, FritschButland, Steffen, ModifiedAkima };

inline double magnitude(double a) { return std::fabs(a); }
inline double length(double a, double b) { return std::hypot(a, b); }
inline double least(double a, double b) { return std::min(a, b); }
inline double ifPositive(double tested, double then, double otherwise) { return tested > 0 ? then : otherwise; }

/// The mean of a and b; the plain one where neither weighs anything.
template <class Number>
Number weighted(const Number& a, const Number& wa, const Number& b, const Number& wb) {
    return ifPositive(wa + wb, (wa * a + wb * b) / (wa + wb), 0.5 * (a + b));
}

template <class Number>
std::vector<Number> secantsOf(const std::vector<double>& x, const std::vector<Number>& y) {
    std::vector<Number> secants(x.size() - 1);
    for (std::size_t i = 0; i + 1 < x.size(); ++i) secants[i] = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
    return secants;
}

/// Divided differences with two more on each side, so that the second differences go on as they are.
template <class Number>
std::vector<Number> extendedSecants(const std::vector<double>& x, const std::vector<Number>& y) {
    const std::size_t n = x.size();
    std::vector<Number> d = secantsOf(x, y);
    d.insert(d.begin(), 2, Number());
    d.resize(n + 3);
    d[1] = 2 * d[2] - d[3 < n + 1 ? 3 : 2];
    d[0] = 2 * d[1] - d[2];
    d[n + 1] = 2 * d[n] - d[n - 1 > 1 ? n - 1 : n];
    d[n + 2] = 2 * d[n + 1] - d[n];
    return d;
}

/// Akima (J. ACM 17 (1970) 589-602), or with the weights of MATLAB's makima.
template <class Number>
std::vector<Number> akimaSlopes(const std::vector<double>& x, const std::vector<Number>& y, bool isModified) {
    const std::vector<Number> d = extendedSecants(x, y);
    std::vector<Number> slopes(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        Number left = magnitude(d[i + 1] - d[i]), right = magnitude(d[i + 3] - d[i + 2]);
        if (isModified) {
            left = left + 0.5 * magnitude(d[i + 1] + d[i]);
            right = right + 0.5 * magnitude(d[i + 3] + d[i + 2]);
            slopes[i] = ifPositive(left + right, weighted(d[i + 1], right, d[i + 2], left), Number());
        } else {
            slopes[i] = weighted(d[i + 1], right, d[i + 2], left);
        }
    }
    return slopes;
}

/// No piece leaves the range of its ends: Steffen (Astron. Astrophys. 239 (1990) 443-450), or Fritsch & Butland (SIAM
/// J. Sci. Stat. Comput. 5 (1984) 300-304).
template <class Number>
std::vector<Number> monotoneSlopes(const std::vector<double>& x, const std::vector<Number>& y, bool isSteffen) {
    const std::size_t n = x.size();
    const std::vector<Number> d = secantsOf(x, y);
    std::vector<Number> slopes(n);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double before = x[i] - x[i - 1], behind = x[i + 1] - x[i];
        Number slope;
        if (isSteffen) {
            const Number p = (d[i - 1] * behind + d[i] * before) / (before + behind);
            const Number size = least(least(2 * magnitude(d[i - 1]), 2 * magnitude(d[i])), magnitude(p));
            slope = ifPositive(d[i], size, -size);
        } else {
            const double w1 = before + 2 * behind, w2 = 2 * before + behind;
            slope = (w1 + w2) / (w1 / d[i - 1] + w2 / d[i]);
        }
        slopes[i] = ifPositive(d[i - 1] * d[i], slope, Number());
    }
    slopes.front() = d.front();
    slopes.back() = d.back();
    return slopes;
}

template <class Number>
std::vector<Number> cubicSlopes(const std::vector<double>& x, const std::vector<Number>& y, Smoothness smoothness) {
    switch (smoothness) {
        case Smoothness::FritschButland:
            return monotoneSlopes(x, y, false);
        case Smoothness::Steffen:
            return monotoneSlopes(x, y, true);
        default:
            return akimaSlopes(x, y, smoothness == Smoothness::ModifiedAkima);
    }
}

/// Slopes which keep the cubic monotone on each piece (Fritsch & Carlson, SIAM J. Numer. Anal. 17 (1980) 238-246,
/// section 4).
template <class Number>
std::vector<Number> limitedSlopes(const std::vector<double>& x, const std::vector<Number>& y) {
    const std::size_t n = x.size();
    std::vector<Number> slopes(n);
    if (n < 2) return slopes;
    const std::vector<Number> secants = secantsOf(x, y);
    slopes.front() = secants.front();
    slopes.back() = secants.back();
    for (std::size_t i = 1; i + 1 < n; ++i)
        slopes[i] = ifPositive(secants[i - 1] * secants[i], 0.5 * (secants[i - 1] + secants[i]), Number());
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const Number& s = secants[i];
        const Number alpha = slopes[i] / s, beta = slopes[i + 1] / s;
        const Number radius = length(alpha, beta), by = 3 / radius, excess = radius - 3;
        const Number level = magnitude(s);  // 0: both slopes are
        slopes[i] = ifPositive(level, ifPositive(excess, by * alpha * s, slopes[i]), Number());
        slopes[i + 1] = ifPositive(level, ifPositive(excess, by * beta * s, slopes[i + 1]), Number());
    }
    return slopes;
}

}  // namespace analogon
