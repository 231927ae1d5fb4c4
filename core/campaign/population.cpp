#include "core/campaign/population.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numeric>

#include "core/base/median.hpp"

namespace analogon {

namespace {

struct Weighed {
    double sum{}, squares{}, cubes{}, mean{}, likelihood{};
};

Weighed weighed(const std::vector<double>& y, const std::vector<double>& variance, double between) {
    Weighed of;
    double weightedSum = 0, logs = 0, rest = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double w = 1 / (between + variance[i]);
        of.sum += w;
        of.squares += w * w;
        of.cubes += w * w * w;
        weightedSum += w * y[i];
        logs += std::log(between + variance[i]);
    }
    of.mean = weightedSum / of.sum;
    for (std::size_t i = 0; i < y.size(); ++i) rest += (y[i] - of.mean) * (y[i] - of.mean) / (between + variance[i]);
    of.likelihood = -0.5 * (logs + std::log(of.sum) + rest);
    return of;
}

/// Mid-ranks from 1, and the sum of t³ - t over the groups of t equal values.
std::pair<std::vector<double>, double> ranks(const std::vector<double>& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    std::vector<double> rank(values.size());
    double ties = 0;
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        while (end < order.size() && values[order[end]] == values[order[begin]]) ++end;
        for (std::size_t i = begin; i < end; ++i) rank[order[i]] = 0.5 * static_cast<double>(begin + end + 1);
        const double t = static_cast<double>(end - begin);
        ties += t * t * t - t;
    }
    return {std::move(rank), ties};
}

/// Correlation, and slope of y over x.
std::pair<double, double> correlationOf(const std::vector<double>& x, const std::vector<double>& y) {
    const double n = static_cast<double>(x.size());
    const double mx = std::accumulate(x.begin(), x.end(), 0.0) / n, my = std::accumulate(y.begin(), y.end(), 0.0) / n;
    double xx = 0, yy = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mx) * (x[i] - mx);
        yy += (y[i] - my) * (y[i] - my);
        xy += (x[i] - mx) * (y[i] - my);
    }
    if (!(xx > 0) || !(yy > 0)) return {0, 0};
    return {xy / std::sqrt(xx * yy), xy / xx};
}

double twoSided(double t, double freedom) {
    return 2 * boost::math::cdf(boost::math::complement(boost::math::students_t(freedom), std::abs(t)));
}

}  // namespace

Population populationOf(const std::vector<double>& values, const std::vector<double>& errors) {
    std::vector<double> y, variance;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (std::isfinite(values[i]) && std::isfinite(errors[i]) && errors[i] > 0) {
            y.push_back(values[i]);
            variance.push_back(errors[i] * errors[i]);
        }
    Population population;
    population.units = y.size();
    if (y.size() < 2) return population;
    const double n = static_cast<double>(y.size());
    const double plain = std::accumulate(y.begin(), y.end(), 0.0) / n;
    double spread = 0;
    for (const double one : y) spread += (one - plain) * (one - plain) / (n - 1);
    const double smallest = *std::min_element(variance.begin(), variance.end());
    // tau² from far below the errors to far above the spread, over its logarithm
    const double low = std::log(1e-6 * smallest), high = std::log(1e3 * (spread + smallest));
    const auto cost = [&](double log) { return -weighed(y, variance, std::exp(log)).likelihood; };
    constexpr int grid = 60, bits = 40;
    double best = low;
    for (int i = 1; i <= grid; ++i)
        if (const double at = low + (high - low) * i / grid; cost(at) < cost(best)) best = at;
    const double step = (high - low) / grid;
    const auto [at, lowest] = boost::math::tools::brent_find_minima(cost, best - step, best + step, bits);
    const Weighed none = weighed(y, variance, 0);
    population.between = -lowest > none.likelihood ? std::exp(at) : 0;
    const Weighed found = weighed(y, variance, population.between);
    population.mean = found.mean;
    population.meanError = 1 / std::sqrt(found.sum);
    const double ratio = found.squares / found.sum;
    const double information = 0.5 * (found.squares - 2 * found.cubes / found.sum + ratio * ratio);
    population.betweenError = information > 0 ? 1 / std::sqrt(information) : std::nan("");
    population.within = std::accumulate(variance.begin(), variance.end(), 0.0) / n;
    const double twice = 2 * std::max(0.0, found.likelihood - none.likelihood);
    population.pCommon =
        twice > 0 ? 0.5 * boost::math::cdf(boost::math::complement(boost::math::chi_squared(1), twice)) : 1;
    return population;
}

std::vector<OddUnit> oddUnits(const std::vector<double>& values, const std::vector<double>& errors, double level) {
    constexpr std::size_t fewest = 5;
    constexpr double efficiency = 0.37, normal = 1.4826;
    std::vector<double> y, variance, deviations;
    std::vector<std::size_t> units;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (std::isfinite(values[i]) && std::isfinite(errors[i])) {
            y.push_back(values[i]);
            variance.push_back(errors[i] * errors[i]);
            units.push_back(i);
        }
    if (y.size() < fewest) return {};
    const double middle = median(y);
    for (const double one : y) deviations.push_back(std::abs(one - middle));
    const double spread = normal * median(deviations);
    const double between = std::max(0.0, spread * spread - median(variance));
    std::vector<OddUnit> odd;
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double size = std::sqrt(between + variance[i]);
        if (!(size > 0)) continue;
        const double deviation = (y[i] - middle) / size;
        const double p = twoSided(deviation, efficiency * static_cast<double>(y.size() - 1));
        if (p < level) odd.push_back({units[i], deviation, p});
    }
    return odd;
}

double levelOfOne(double level, std::size_t comparisons) {
    return comparisons == 0 ? level : -std::expm1(std::log1p(-level) / static_cast<double>(comparisons));
}

std::vector<double> holm(const std::vector<double>& p) {
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
    std::vector<double> corrected(p.size());
    double highest = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        highest = std::max(highest, std::min(1.0, p[order[i]] * static_cast<double>(p.size() - i)));
        corrected[order[i]] = highest;
    }
    return corrected;
}

RankCorrelation rankCorrelation(const std::vector<double>& x, const std::vector<double>& y) {
    RankCorrelation found;
    if (x.size() < 4) return found;
    found.correlation = correlationOf(ranks(x).first, ranks(y).first).first;
    found.slope = correlationOf(x, y).second;
    const double freedom = static_cast<double>(x.size()) - 2, rest = 1 - found.correlation * found.correlation;
    found.p = rest > 0 ? twoSided(found.correlation * std::sqrt(freedom / rest), freedom) : 0;
    return found;
}

double kruskalWallis(const std::vector<std::size_t>& groups, const std::vector<double>& y) {
    const double n = static_cast<double>(y.size());
    const std::size_t count = groups.empty() ? 0 : *std::max_element(groups.begin(), groups.end()) + 1;
    if (count < 2 || y.size() < 4) return 1;
    const auto [rank, ties] = ranks(y);
    std::vector<double> sums(count), sizes(count);
    for (std::size_t i = 0; i < y.size(); ++i) {
        sums[groups[i]] += rank[i];
        ++sizes[groups[i]];
    }
    double h = -3 * (n + 1);
    for (std::size_t g = 0; g < count; ++g)
        if (sizes[g] > 0) h += 12 / (n * (n + 1)) * sums[g] * sums[g] / sizes[g];
    const double correction = 1 - ties / (n * n * n - n);
    if (!(correction > 0)) return 1;
    return boost::math::cdf(boost::math::complement(boost::math::chi_squared(static_cast<double>(count - 1)),
                                                    std::max(0.0, h / correction)));
}

}  // namespace analogon
