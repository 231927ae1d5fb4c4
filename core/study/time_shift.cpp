#include "core/study/time_shift.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "core/base/median.hpp"
#include "core/fit/clock.hpp"

namespace analogon {

namespace {

constexpr std::size_t fewest = 16, most = std::size_t{1} << 17;  // samples
constexpr double leastVariance = 1e-9;                           // left by rounding, of the whole
constexpr double surelyAlike = 0.95;                             // a correlation
constexpr double fewestIndependent = 5;                          // samples of what is left
constexpr double asGood = 10;                                    // twice the difference of log likelihoods

using Spectrum = std::vector<std::complex<double>>;

/// Without gaps and repeated stamps.
struct Samples {
    std::vector<double> time, values;

    double length() const { return time.back() - time.front(); }
    double step() const {
        std::vector<double> steps;
        for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
        return median(std::move(steps));
    }
};

Samples samplesOf(const ComparedCourse& course) {
    Samples samples;
    for (std::size_t i = 0; i < std::min(course.time.size(), course.values.size()); ++i) {
        if (!std::isfinite(course.values[i]) || !std::isfinite(course.time[i])) continue;
        if (!samples.time.empty() && course.time[i] <= samples.time.back()) continue;
        samples.time.push_back(course.time[i]);
        samples.values.push_back(course.values[i]);
    }
    return samples;
}

/// On an even raster from the first stamp on, with mean 0 and variance 1. Empty: the values do not change.
std::vector<double> onEvenRaster(const Samples& samples, double step) {
    std::vector<double> even(static_cast<std::size_t>(samples.length() / step * (1 + 1e-12)) + 1);
    double mean = 0, variance = 0;
    for (std::size_t i = 0; i < even.size(); ++i) {
        const TimeStencil stencil = stencilAt(samples.time, samples.time.front() + static_cast<double>(i) * step);
        even[i] = stencil.value([&](int at) { return samples.values[static_cast<std::size_t>(at)]; });
        mean += even[i] / static_cast<double>(even.size());
    }
    double largest = 0;
    for (double& value : even) {
        largest = std::max(largest, std::abs(value));
        value -= mean;
        variance += value * value / static_cast<double>(even.size());
    }
    if (!(variance > 1e-24 * largest * largest)) return {};
    for (double& value : even) value /= std::sqrt(variance);
    return even;
}

Spectrum spectrumOf(std::vector<double> values, std::size_t length) {
    values.resize(length, 0.0);
    Spectrum spectrum;
    Eigen::FFT<double>().fwd(spectrum, values);
    return spectrum;
}

/// Correlation at every lag: reference i beside other i + lag.
class Lags {
public:
    Lags(const std::vector<double>& x, const std::vector<double>& y) : x_(x), y_(y), sumX_(x), sumY_(y) {
        std::size_t length = 1;
        while (length < x.size() + y.size()) length *= 2;
        const Spectrum ofX = spectrumOf(x, length), ofY = spectrumOf(y, length);
        Spectrum cross(ofX.size());
        for (std::size_t i = 0; i < cross.size(); ++i) cross[i] = std::conj(ofX[i]) * ofY[i];
        Eigen::FFT<double>().inv(products_, cross);
        const std::size_t least = std::max(fewest, std::min(x.size(), y.size()) / 2);
        first_ = -static_cast<std::ptrdiff_t>(x.size() - least);
        last_ = static_cast<std::ptrdiff_t>(y.size() - least);
    }

    std::ptrdiff_t first() const { return first_; }
    std::ptrdiff_t last() const { return last_; }
    std::size_t begin(std::ptrdiff_t lag) const { return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, -lag)); }
    std::size_t count(std::ptrdiff_t lag) const {
        const auto end = std::min(static_cast<std::ptrdiff_t>(x_.size()), static_cast<std::ptrdiff_t>(y_.size()) - lag);
        return static_cast<std::size_t>(end) - begin(lag);
    }
    double correlation(std::ptrdiff_t lag) const {
        const std::size_t from = begin(lag), n = count(lag), other = from + static_cast<std::size_t>(lag);
        const auto length = static_cast<std::ptrdiff_t>(products_.size());
        const double products = products_[static_cast<std::size_t>((lag + length) % length)];
        const auto [meanX, squareX] = sumX_.of(from, n);
        const auto [meanY, squareY] = sumY_.of(other, n);
        const double covariance = products / static_cast<double>(n) - meanX * meanY,
                     variances = (squareX - meanX * meanX) * (squareY - meanY * meanY);
        return variances > 1e-18 ? std::clamp(covariance / std::sqrt(variances), -1.0, 1.0) : 0;
    }
    /// Of the reference without what the other one explains; 0: nothing is left.
    double left(std::ptrdiff_t lag) const {
        const double r = std::max(0.0, correlation(lag));
        return std::max(leastVariance, 1 - r * r);
    }

private:
    class Sums {
    public:
        explicit Sums(const std::vector<double>& values) : sums_(values.size() + 1), squares_(values.size() + 1) {
            for (std::size_t i = 0; i < values.size(); ++i) {
                sums_[i + 1] = sums_[i] + values[i];
                squares_[i + 1] = squares_[i] + values[i] * values[i];
            }
        }
        /// Means of the values and of their squares.
        std::pair<double, double> of(std::size_t from, std::size_t n) const {
            const auto count = static_cast<double>(n);
            return {(sums_[from + n] - sums_[from]) / count, (squares_[from + n] - squares_[from]) / count};
        }

    private:
        std::vector<double> sums_, squares_;
    };

    const std::vector<double>&x_, &y_;
    Sums sumX_, sumY_;
    std::vector<double> products_;
    std::ptrdiff_t first_{}, last_{};
};

/// The two where they overlap at a lag, and what is left of the reference.
struct Overlap {
    std::vector<double> x, y;
    double squares{};      // of what is left
    double variance{};     // of what is left, as a share of the whole
    double independent{};  // samples of that

    Overlap(const std::vector<double>& reference, const std::vector<double>& other, const Lags& lags,
            std::ptrdiff_t lag, double fraction = 0) {
        const auto from = static_cast<std::ptrdiff_t>(lags.begin(lag)),
                   n = static_cast<std::ptrdiff_t>(lags.count(lag));
        x.assign(reference.begin() + from, reference.begin() + from + n);
        for (std::ptrdiff_t i = from + lag; i < from + lag + n; ++i) y.push_back(between(other, i, fraction));
        for (std::vector<double>* values : {&x, &y}) {
            double mean = 0;
            for (const double value : *values) mean += value / static_cast<double>(n);
            for (double& value : *values) value -= mean;
        }
        double xx = 0, xy = 0, yy = 0, neighbours = 0, last = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            xx += x[i] * x[i];
            xy += x[i] * y[i];
            yy += y[i] * y[i];
        }
        const double slope = xy / yy;
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double left = x[i] - slope * y[i];
            squares += left * left;
            neighbours += left * last;
            last = left;
        }
        variance = std::max(leastVariance, squares / xx);
        const double rho = squares > 0 ? std::clamp(neighbours / squares, 0.0, 0.999) : 0;
        independent = std::max(fewestIndependent, static_cast<double>(n) * (1 - rho) / (1 + rho));
    }

private:
    /// Cubic through the four samples around (Catmull, Rom).
    static double between(const std::vector<double>& values, std::ptrdiff_t i, double fraction) {
        const double whole = std::floor(fraction), t = fraction - whole;
        const auto at = [&](std::ptrdiff_t k) {
            const auto last = static_cast<std::ptrdiff_t>(values.size()) - 1;
            return values[static_cast<std::size_t>(
                std::clamp<std::ptrdiff_t>(i + static_cast<std::ptrdiff_t>(whole) + k, 0, last))];
        };
        const double a = at(-1), b = at(0), c = at(1), d = at(2);
        return b + t * (c - a) / 2 + t * t * (a - 2.5 * b + 2 * c - d / 2) + t * t * t * (1.5 * (b - c) + (d - a) / 2);
    }
};

/// Where between the samples the two fit best [samples], and how sharply what is left grows beside it.
struct Peak {
    double place{}, bend{};
};

/// How much of each frequency the two have in common: the coherence over neighbouring ones, without what is so by
/// chance. What is noise alone tells nothing of the shift.
std::vector<double> coherenceOf(const Spectrum& x, const Spectrum& y) {
    constexpr std::ptrdiff_t reach = 4;
    constexpr double byChance = 2.0 / (2 * reach + 1);
    std::vector<double> shares(x.size() / 2);
    const auto last = static_cast<std::ptrdiff_t>(shares.size()) - 1;
    for (std::ptrdiff_t i = 0; i <= last; ++i) {
        std::complex<double> both;
        double ofX = 0, ofY = 0;
        for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(0, i - reach); k <= std::min(last, i + reach); ++k) {
            const auto at = static_cast<std::size_t>(k);
            both += std::conj(x[at]) * y[at];
            ofX += std::norm(x[at]);
            ofY += std::norm(y[at]);
        }
        const double found = ofX > 0 && ofY > 0 ? std::norm(both) / (ofX * ofY) : 0;
        shares[static_cast<std::size_t>(i)] = std::max(0.0, (found - byChance) / (1 - byChance));
    }
    return shares;
}

/// The course of a spectrum that is weighted, moved by some samples, and differentiated as often.
std::vector<double> courseOf(const Spectrum& spectrum, const std::vector<double>& weights, double shift, int order) {
    Spectrum changed(spectrum.size());
    const std::size_t length = spectrum.size();
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double omega = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(length);
        changed[i] = spectrum[i] * weights[i] * std::polar(1.0, omega * shift);
        if (order == 1) changed[i] *= std::complex<double>(0, omega);
        if (i > 0) changed[length - i] = std::conj(changed[i]);
    }
    std::vector<double> course;
    Eigen::FFT<double>().inv(course, changed);
    return course;
}

/// By least squares, without what is noise alone: the reference as a scaled, moved and shifted copy of the other one.
Peak peakOf(const Overlap& overlap) {
    const std::size_t n = overlap.x.size(), edge = std::max<std::size_t>(1, n / 20);
    std::vector<double> x = overlap.x, y = overlap.y;
    for (std::size_t i = 0; i < edge; ++i) {  // no step at the ends: the spectrum is that of a periodic course
        const double share =
            0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(i) / static_cast<double>(edge));
        for (std::vector<double>* values : {&x, &y}) {
            (*values)[i] *= share;
            (*values)[n - 1 - i] *= share;
        }
    }
    std::size_t length = 1;
    while (length < n) length *= 2;
    const Spectrum ofX = spectrumOf(x, length), ofY = spectrumOf(y, length);
    const std::vector<double> shares = coherenceOf(ofX, ofY), wanted = courseOf(ofX, shares, 0, 0);
    const auto inner = static_cast<std::ptrdiff_t>(n - 2 * edge);
    const auto part = [&](const std::vector<double>& course) {
        const Eigen::VectorXd values = Eigen::VectorXd::Map(course.data() + edge, inner);
        return Eigen::VectorXd(values.array() - values.mean());
    };
    Peak peak;
    constexpr int steps = 20;
    constexpr double farthest = 8;  // [samples]
    for (int step = 0; step < steps; ++step) {
        const Eigen::VectorXd moved = part(courseOf(ofY, shares, peak.place, 0)), reference = part(wanted);
        Eigen::VectorXd slope = part(courseOf(ofY, shares, peak.place, 1));
        if (!(moved.squaredNorm() > 0)) return peak;
        slope -= moved * (moved.dot(slope) / moved.squaredNorm());
        const double scale = moved.dot(reference) / moved.squaredNorm();
        peak.bend = scale * scale * slope.squaredNorm();
        if (!(peak.bend > 0) || !(scale > 0)) return {};
        const double change = std::clamp(slope.dot(reference) / (scale * slope.squaredNorm()), -0.5, 0.5);
        peak.place += change;
        if (std::abs(change) < 1e-7) break;
        if (std::abs(peak.place) > farthest) return {};
    }
    return peak;
}

Diagnostic untold(const Text& why) { return error(phrase("the shift in time cannot be told: {}", why)); }

/// Whether another lag does as well, far from the best one or everywhere around it.
std::optional<Diagnostic> rivalOf(const Lags& lags, std::ptrdiff_t best, const Overlap& overlap, double step) {
    // between its samples a course loses a part of its noise
    constexpr double keptNoise = 0.8, chance = 7;
    const double least = std::min(lags.left(best), overlap.variance / keptNoise);
    // what is left differs from lag to lag by chance, too: the noise of the two meets anew
    const auto isWorse = [&](std::ptrdiff_t lag, double factor) {
        const double n = overlap.independent *
                         std::min(1.0, static_cast<double>(lags.count(lag)) / static_cast<double>(lags.count(best)));
        return lags.correlation(lag) <= 0 ||
               n * std::log(lags.left(lag) / least) > factor * (asGood + chance * std::sqrt(n));
    };
    std::ptrdiff_t from = best, to = best;
    while (from > lags.first() && !isWorse(from - 1, 1)) --from;
    while (to < lags.last() && !isWorse(to + 1, 1)) ++to;
    const double shorter = static_cast<double>(lags.count(0 >= lags.first() && 0 <= lags.last() ? 0 : best));
    if (static_cast<double>(to - from) > std::max(8.0, 0.1 * shorter))
        return untold(phrase("the course changes so slowly that shifts over {:.3g} s do equally well",
                             static_cast<double>(to - from) * step));
    while (from > lags.first() && !isWorse(from - 1, 2)) --from;
    while (to < lags.last() && !isWorse(to + 1, 2)) ++to;
    for (std::ptrdiff_t lag = lags.first(); lag <= lags.last(); ++lag)
        if ((lag < from || lag > to) && !isWorse(lag, 1))
            return untold(phrase("the course repeats: one that differs by {:.4g} s does as well",
                                 static_cast<double>(std::abs(lag - best)) * step));
    if (best == lags.first() || best == lags.last())
        return untold(phrase("the two overlap by less than half of the shorter one"));
    return std::nullopt;
}

}  // namespace

Outcome<TimeShift> timeShift(const ComparedCourse& reference, const ComparedCourse& other) {
    const Samples first = samplesOf(reference), second = samplesOf(other);
    if (std::min(first.time.size(), second.time.size()) < fewest)
        return untold(phrase("less than {} samples were measured", fewest));
    const double longest = std::max(first.length(), second.length());
    const double step = std::max(std::min(first.step(), second.step()), longest / static_cast<double>(most));
    const std::vector<double> x = onEvenRaster(first, step), y = onEvenRaster(second, step);
    if (x.empty() || y.empty()) return untold(phrase("one of the two does not change"));
    if (std::min(x.size(), y.size()) < fewest) return untold(phrase("less than {} samples were measured", fewest));

    const Lags lags(x, y);
    const auto worth = [&](std::ptrdiff_t lag) {
        return -static_cast<double>(lags.count(lag)) * std::log(lags.left(lag));
    };
    std::ptrdiff_t best = lags.first();
    double highest = -1;
    for (std::ptrdiff_t lag = lags.first(); lag <= lags.last(); ++lag)
        if (const double value = worth(lag); value > highest) {
            highest = value;
            best = lag;
        }
    const Peak peak = peakOf(Overlap(x, y, lags, best));
    const Overlap overlap(x, y, lags, best, peak.place);
    const auto tried = static_cast<double>(lags.last() - lags.first() + 1);
    const bool isAlike = lags.correlation(best) > surelyAlike ||
                         -overlap.independent * std::log(overlap.variance) > 2 * asGood + 2 * std::log(tried);
    if (!isAlike || !(peak.bend > 0))
        return untold(phrase("the two are not alike (correlation {:.2f} at best)", lags.correlation(best)));
    if (const auto rival = rivalOf(lags, best, overlap, step)) return *rival;
    TimeShift found;
    found.shift = second.time.front() - first.time.front() + (static_cast<double>(best) + peak.place) * step;
    found.deviation = step * std::sqrt(overlap.squares / (overlap.independent * peak.bend));
    found.correlation = lags.correlation(best);
    return found;
}

}  // namespace analogon
