#pragma once

#include <span>
#include <vector>

#include "core/base/outcome.hpp"

namespace analogon {

/// Over frequencies f[k] = k / (segment length), from 0 to half the sampling rate.
struct Spectrum {
    std::vector<double> frequency;  // [Hz]
    std::vector<double> density;    // one-sided power spectral density, unit of the signal squared per Hz
    int segments{};                 // that were averaged
};

struct Coherence {
    std::vector<double> frequency;  // [Hz]
    std::vector<double> value;      // |Sxy|² / (Sxx Syy), 0 … 1
    int segments{};
};

/// Power spectral density after Welch (1967): segments that overlap by half, each less its mean, Hann window, squares
/// averaged. The integral of the density is the variance. `segment`: samples of one, a power of two (0: an eighth of
/// the record, so that about 15 are averaged). Gaps (NaN) are bridged by straight lines; an uneven raster is brought to
/// an even one of its median step.
/// Faults: fewer than 16 samples; more than half of them missing.
Outcome<Spectrum> welchSpectrum(std::span<const double> time, std::span<const double> values, int segment = 0);

/// How far two signals of the same times move together, by frequency, from the same segments.
/// Faults: those of the spectrum; fewer than two segments, whose coherence is 1 whatever they hold.
Outcome<Coherence> coherence(std::span<const double> time, std::span<const double> first,
                             std::span<const double> second, int segment = 0);

struct Histogram {
    std::vector<double> edges;   // of the bins, one more than counts
    std::vector<double> counts;  // share of the samples, sum 1
};

/// Of the samples that are numbers, in bins of equal width after Freedman and Diaconis, 5 to 200 of them.
/// Faults: there is no number.
Outcome<Histogram> histogram(std::span<const double> values);

}  // namespace analogon
