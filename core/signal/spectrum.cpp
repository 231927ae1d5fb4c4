#include "core/signal/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "core/signal/formula.hpp"

namespace analogon {

namespace {

constexpr std::size_t fewestSamples = 16;

/// A record on an even raster without gaps.
struct EvenRecord {
    double rate{};  // [Hz]
    std::vector<std::vector<double>> values;
};

/// On straight lines over what is missing, from the first to the last number.
Outcome<std::vector<double>> bridged(std::span<const double> time, std::span<const double> values,
                                     std::span<const double> even) {
    std::vector<double> t, y;
    for (std::size_t i = 0; i < std::min(time.size(), values.size()); ++i)
        if (std::isfinite(values[i])) {
            t.push_back(time[i]);
            y.push_back(values[i]);
        }
    if (t.size() < fewestSamples || 2 * t.size() < time.size())
        return error(phrase("a spectrum needs at least {} samples, half of which may be missing; here are {} of {}",
                            fewestSamples, t.size(), time.size()));
    std::vector<double> result = valuesAt(t, y, even);
    for (std::size_t i = 0; i < result.size(); ++i)
        if (!std::isfinite(result[i])) result[i] = even[i] < t.front() ? y.front() : y.back();
    return result;
}

Outcome<EvenRecord> evenRecord(std::span<const double> time, std::initializer_list<std::span<const double>> channels) {
    EvenRecord record;
    if (time.size() < fewestSamples)
        return error(phrase("a spectrum needs at least {} samples, half of which may be missing; here are {} of {}",
                            fewestSamples, time.size(), time.size()));
    std::vector<double> steps(time.size() - 1);
    for (std::size_t i = 0; i + 1 < time.size(); ++i) steps[i] = time[i + 1] - time[i];
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
    const double step = steps[steps.size() / 2];
    record.rate = 1 / step;
    constexpr double mostGrowth = 8;  // of the number of samples, where the raster is uneven
    const double count = std::min((time.back() - time.front()) / step + 1.5, mostGrowth * double(time.size()));
    std::vector<double> even(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < even.size(); ++i) even[i] = time.front() + static_cast<double>(i) * step;
    for (const std::span<const double> channel : channels) {
        Outcome<std::vector<double>> values = bridged(time, channel, even);
        if (!values) return values.diagnostics();
        record.values.push_back(std::move(*values));
    }
    return record;
}

std::size_t segmentOf(std::size_t samples, int wanted) {
    const std::size_t target = wanted > 0 ? static_cast<std::size_t>(wanted) : std::max(fewestSamples, samples / 8);
    std::size_t segment = fewestSamples / 2;
    while (2 * segment <= std::min(target, samples)) segment *= 2;
    return segment;
}

/// The transforms of all segments, one behind the other.
class Segments {
public:
    Segments(std::size_t samples, std::size_t length) : samples_(samples), length_(length), window_(length) {
        for (std::size_t i = 0; i < length; ++i) {
            window_[i] = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * double(i) / double(length));
            power_ += window_[i] * window_[i];
        }
    }
    int count() const { return static_cast<int>((samples_ - length_) / (length_ / 2)) + 1; }
    double power() const { return power_; }

    std::vector<std::complex<double>> transform(const std::vector<double>& values, int segment) {
        const auto begin =
            values.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(segment) * length_ / 2);
        std::vector<double> part(begin, begin + static_cast<std::ptrdiff_t>(length_));
        double mean = 0;
        for (const double v : part) mean += v / double(length_);
        for (std::size_t i = 0; i < length_; ++i) part[i] = (part[i] - mean) * window_[i];
        std::vector<std::complex<double>> result;
        fft_.fwd(result, part);
        result.resize(length_ / 2 + 1);
        return result;
    }

private:
    std::size_t samples_, length_;
    std::vector<double> window_;
    double power_{};
    Eigen::FFT<double> fft_;
};

std::vector<double> frequencies(std::size_t segment, double rate) {
    std::vector<double> f(segment / 2 + 1);
    for (std::size_t k = 0; k < f.size(); ++k) f[k] = double(k) * rate / double(segment);
    return f;
}

}  // namespace

Outcome<Spectrum> welchSpectrum(std::span<const double> time, std::span<const double> values, int segment) {
    const Outcome<EvenRecord> record = evenRecord(time, {values});
    if (!record) return record.diagnostics();
    const std::vector<double>& even = record->values.front();
    const std::size_t length = segmentOf(even.size(), segment);
    Segments segments(even.size(), length);
    Spectrum spectrum{frequencies(length, record->rate), std::vector<double>(length / 2 + 1), segments.count()};
    const double scale = 1 / (record->rate * segments.power() * segments.count());
    for (int s = 0; s < segments.count(); ++s) {
        const auto transform = segments.transform(even, s);
        for (std::size_t k = 0; k < transform.size(); ++k) {
            const double sides = k == 0 || k + 1 == transform.size() ? 1 : 2;
            spectrum.density[k] += sides * scale * std::norm(transform[k]);
        }
    }
    return spectrum;
}

Outcome<Coherence> coherence(std::span<const double> time, std::span<const double> first,
                             std::span<const double> second, int segment) {
    const Outcome<EvenRecord> record = evenRecord(time, {first, second});
    if (!record) return record.diagnostics();
    const std::vector<double>&x = record->values[0], &y = record->values[1];
    const std::size_t length = segmentOf(x.size(), segment);
    Segments segments(x.size(), length);
    if (segments.count() < 2)
        return error(phrase("a coherence needs at least two segments of {} samples; there are {}", length, x.size()));
    std::vector<double> xx(length / 2 + 1), yy(length / 2 + 1);
    std::vector<std::complex<double>> xy(length / 2 + 1);
    for (int s = 0; s < segments.count(); ++s) {
        const auto a = segments.transform(x, s), b = segments.transform(y, s);
        for (std::size_t k = 0; k < a.size(); ++k) {
            xx[k] += std::norm(a[k]);
            yy[k] += std::norm(b[k]);
            xy[k] += std::conj(a[k]) * b[k];
        }
    }
    Coherence result{frequencies(length, record->rate), std::vector<double>(xy.size()), segments.count()};
    for (std::size_t k = 0; k < xy.size(); ++k) {
        const double both = xx[k] * yy[k];
        result.value[k] = both > 0 ? std::norm(xy[k]) / both : 0;
    }
    return result;
}

Outcome<Histogram> histogram(std::span<const double> values) {
    std::vector<double> sorted;
    for (const double v : values)
        if (std::isfinite(v)) sorted.push_back(v);
    if (sorted.empty()) return error(phrase("there is no number to count"));
    std::sort(sorted.begin(), sorted.end());
    const auto quantile = [&](double part) {
        return sorted[static_cast<std::size_t>(part * double(sorted.size() - 1))];
    };
    const double low = sorted.front(), range = sorted.back() - low, spread = quantile(0.75) - quantile(0.25);
    const double width = 2 * spread / std::cbrt(double(sorted.size()));
    const double wanted = width > 0 && range > 0 ? std::ceil(range / width) : 0;
    const auto bins = static_cast<std::size_t>(std::clamp(wanted, 5.0, 200.0));
    const double step = range > 0 ? range / double(bins) : 1 / double(bins);
    const double begin = range > 0 ? low : low - 0.5;
    Histogram result{std::vector<double>(bins + 1), std::vector<double>(bins)};
    for (std::size_t i = 0; i <= bins; ++i) result.edges[i] = begin + double(i) * step;
    for (const double v : sorted)
        result.counts[std::min(bins - 1, static_cast<std::size_t>((v - begin) / step))] += 1 / double(sorted.size());
    return result;
}

}  // namespace analogon
