#include "core/residual/noise.hpp"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "core/base/median.hpp"
#include "core/base/range.hpp"
#include "core/base/stop.hpp"
#include "core/residual/quantisation.hpp"

namespace analogon {

namespace {

constexpr double kMedianToSigma = 1.0 / 0.6744897501960817;

/// Runs of neighbouring values that are there.
std::vector<std::vector<double>> runsOf(const Eigen::Ref<const Eigen::VectorXd>& signal) {
    std::vector<std::vector<double>> runs(1);
    for (const double value : signal) {
        if (std::isnan(value)) {
            if (!runs.back().empty()) runs.emplace_back();
        } else {
            runs.back().push_back(value);
        }
    }
    return runs;
}

/// The signal as it is, or, where hardly any values have neighbours (a logger of a lower rate), its values alone.
Eigen::VectorXd onItsOwnRaster(const Eigen::Ref<const Eigen::VectorXd>& signal) {
    constexpr std::size_t neighbours = 4;
    Eigen::Index count = 0, inRuns = 0;
    for (const std::vector<double>& run : runsOf(signal)) {
        count += static_cast<Eigen::Index>(run.size());
        if (run.size() >= neighbours) inRuns += static_cast<Eigen::Index>(run.size());
    }
    if (2 * inRuns >= count) return signal;
    Eigen::VectorXd values(count);
    std::copy_if(signal.begin(), signal.end(), values.begin(), [](double x) { return !std::isnan(x); });
    return values;
}

std::vector<double> differences(const std::vector<std::vector<double>>& runs, int order) {
    std::vector<double> result;
    for (std::vector<double> run : runs) {
        for (int i = 0; i < order && !run.empty(); ++i) {
            for (std::size_t k = 0; k + 1 < run.size(); ++k) run[k] = run[k + 1] - run[k];
            run.pop_back();
        }
        result.insert(result.end(), run.begin(), run.end());
    }
    return result;
}

std::vector<double> magnitudes(std::vector<double> values) {
    for (double& value : values) value = std::abs(value);
    return values;
}

/// Standard deviation of the bulk: the median of magnitudes to begin with, then the RMS of what lies within three
/// times that, corrected for the tails cut off a Gaussian, until it settles. The median alone scatters by more
/// than twice as much.
double bulkDeviation(const std::vector<double>& values) {
    constexpr double cut = 3.0, keptVariance = 0.97334;  // 1 - 2 c phi(c) / (2 Phi(c) - 1)
    double sigma = kMedianToSigma * median(magnitudes(values));
    for (int round = 0; round < 8 && sigma > 0.0; ++round) {
        double sum = 0.0;
        int count = 0;
        for (const double value : values) {
            if (std::abs(value) > cut * sigma) continue;
            sum += value * value;
            ++count;
        }
        if (count == 0) break;
        const double next = std::sqrt(sum / count / keptVariance);
        if (std::abs(next - sigma) < 1e-4 * sigma) return next;
        sigma = next;
    }
    return sigma;
}

/// The step of a quantised signal that shows as jumps of one common size (or few multiples of it) scattered over
/// the record; 0 when there is no sign of it. `quiet`: what the signal moves between two samples otherwise.
double commonJump(const std::vector<std::vector<double>>& runs, double quiet) {
    std::size_t count = 0;
    std::vector<double> jumps;
    for (const std::vector<double>& run : runs) {
        const std::vector<double> moves = differences({run}, 1);
        double largest = 0.0;
        for (const double move : moves) largest = std::max(largest, std::abs(move));
        const double floor = std::max(6.0 * quiet, 1e-9 * largest);
        count += moves.size();
        for (std::size_t k = 1; k + 1 < moves.size(); ++k) {
            if (std::abs(moves[k]) <= floor) continue;
            // Less what the signal moves here anyway.
            jumps.push_back(std::abs(moves[k] - 0.5 * (moves[k - 1] + moves[k + 1])));
        }
    }
    // A few jumps are steps of the signal itself.
    if (jumps.size() < 8 || jumps.size() < count / 200) return 0.0;
    std::vector<double> sorted = jumps;
    std::sort(sorted.begin(), sorted.end());
    const double size = sorted[sorted.size() / 4];
    const auto isMultiple = [&](double jump) {
        const double ratio = jump / size;
        return std::abs(ratio - std::max(1.0, std::round(ratio))) < 0.15 && ratio < 4.5;
    };
    const auto common = std::count_if(jumps.begin(), jumps.end(), isMultiple);
    return common * 10 >= static_cast<std::ptrdiff_t>(jumps.size()) * 9 ? size : 0.0;
}

}  // namespace

double noiseFromDifferences(const Eigen::Ref<const Eigen::VectorXd>& signal) {
    const std::vector<std::vector<double>> runs = runsOf(onItsOwnRaster(signal));
    // Third differences of white noise have 1 + 9 + 9 + 1 times its variance; a short record must do with less.
    constexpr double gains[] = {1.0, 2.0, 6.0, 20.0};
    for (int order = 3; order >= 1; --order) {
        const std::vector<double> moved = differences(runs, order);
        if (moved.size() < (order > 1 ? 8u : 1u)) continue;
        const double white = bulkDeviation(moved) / std::sqrt(gains[order]);
        const double quiet = bulkDeviation(differences(runs, 1));
        const double step = commonJump(runs, quiet);
        return std::hypot(white, step / std::sqrt(12.0));
    }
    return 0.0;
}

Eigen::VectorXd localNoise(const Eigen::Ref<const Eigen::VectorXd>& signal) {
    constexpr Eigen::Index reach = 20, order = 3;  // samples to each side
    constexpr double gain = 20, least = 0.05, mostEven = 2;
    const Eigen::Index count = signal.size() - order;
    if (count < 10 * reach || !signal.allFinite()) return {};
    Eigen::VectorXd sums(count + 1);  // of the squares before each difference
    sums[0] = 0;
    for (Eigen::Index k = 0; k < count; ++k) {
        const double moved = signal[k + 3] - 3 * signal[k + 2] + 3 * signal[k + 1] - signal[k];
        sums[k + 1] = sums[k] + moved * moved;
    }
    const double smallest = least * std::sqrt(sums[count] / static_cast<double>(count) / gain);
    if (!(smallest > 0)) return {};
    Eigen::VectorXd local(signal.size());
    for (Eigen::Index k = 0; k < signal.size(); ++k) {
        const Eigen::Index from = std::clamp<Eigen::Index>(k - 1 - reach, 0, count - 1),
                           to = std::clamp<Eigen::Index>(k - 1 + reach, 1, count);
        local[k] = std::max(smallest, std::sqrt((sums[to] - sums[from]) / static_cast<double>(to - from) / gain));
    }
    Eigen::VectorXd sorted = local;
    std::sort(sorted.begin(), sorted.end());
    if (sorted[9 * sorted.size() / 10] < mostEven * sorted[sorted.size() / 10]) return {};
    return local;
}

Eigen::VectorXd AutoregressiveModel::whiten(const Eigen::Ref<const Eigen::VectorXd>& signal) const {
    Eigen::VectorXd result = signal;
    const auto order = static_cast<Eigen::Index>(coefficients.size());
    for (Eigen::Index k = order; k < signal.size(); ++k)
        for (Eigen::Index i = 1; i <= order; ++i)
            result[k] -= coefficients[static_cast<std::size_t>(i - 1)] * signal[k - i];
    // the beginning is told by shorter models, which leave more: Levinson's recursion, downwards
    Eigen::VectorXd shorter = Eigen::Map<const Eigen::VectorXd>(coefficients.data(), order);
    double share = 1;  // of the variance that the shorter model leaves, which this one does
    for (Eigen::Index k = order - 1; k >= 0; --k) {
        const double reflection = shorter[k], rest = std::max(1 - reflection * reflection, 1e-12);
        share *= rest;
        const Eigen::VectorXd head = shorter.head(k);
        shorter.head(k) = (head + reflection * head.reverse()) / rest;
        if (k >= signal.size()) continue;
        for (Eigen::Index i = 1; i <= k; ++i) result[k] -= shorter[i - 1] * signal[k - i];
        result[k] *= std::sqrt(share);
    }
    return result;
}

Eigen::VectorXd AutoregressiveModel::simulate(Eigen::Index count, std::mt19937_64& random) const {
    std::normal_distribution<double> scatter(0, innovation);
    const auto order = static_cast<Eigen::Index>(coefficients.size());
    Eigen::VectorXd all(2 * count);  // a record may begin anywhere in the memory of the noise
    for (Eigen::Index k = 0; k < all.size(); ++k) {
        all[k] = scatter(random);
        for (Eigen::Index i = 1; i <= std::min(order, k); ++i)
            all[k] += coefficients[static_cast<std::size_t>(i - 1)] * all[k - i];
    }
    return all.tail(count);
}

/// Burg 1975: reflection coefficients that minimise forward and backward errors together, so that the model is
/// always stable; the order is that of the least BIC = N ln(variance) + order ln(N).
AutoregressiveModel fitAutoregressive(const Eigen::Ref<const Eigen::VectorXd>& signal, int maxOrder) {
    std::vector<double> samples;
    for (const double value : signal) {
        if (std::isfinite(value)) samples.push_back(value);
    }
    AutoregressiveModel best;
    const auto count = static_cast<Eigen::Index>(samples.size());
    if (count == 0) return best;
    Eigen::VectorXd forward = Eigen::Map<const Eigen::VectorXd>(samples.data(), count);
    Eigen::VectorXd backward = forward;
    double variance = forward.squaredNorm() / static_cast<double>(count);
    best.innovation = std::sqrt(variance);
    if (variance <= 0.0) return best;
    const double n = static_cast<double>(count);
    double bestCriterion = n * std::log(variance);
    std::vector<double> a;
    for (int order = 1; order <= maxOrder && order + 2 < count; ++order) {
        const Eigen::Index rest = count - order;
        const auto f = forward.tail(rest);
        const auto b = backward.segment(order - 1, rest);
        const double power = f.squaredNorm() + b.squaredNorm();
        if (!(power > 0.0)) break;
        const double reflection = 2.0 * f.dot(b) / power;
        const Eigen::VectorXd nextForward = f - reflection * b;
        const Eigen::VectorXd nextBackward = b - reflection * f;
        forward.tail(rest) = nextForward;
        backward.tail(rest) = nextBackward;
        std::vector<double> next(a);
        for (std::size_t i = 0; i < a.size(); ++i) next[i] -= reflection * a[a.size() - 1 - i];
        next.push_back(reflection);
        a = std::move(next);
        variance *= 1.0 - reflection * reflection;
        if (!(variance > 0.0)) break;
        const double criterion = n * std::log(variance) + order * std::log(n);
        if (criterion < bestCriterion) {
            bestCriterion = criterion;
            best.coefficients = a;
            best.innovation = std::sqrt(variance);
        }
    }
    return best;
}

Eigen::VectorXd autocorrelation(const Eigen::Ref<const Eigen::VectorXd>& signal, int maxLag) {
    // A gap counts as the mean: it neither adds nor takes away correlation.
    double sum = 0.0;
    Eigen::Index count = 0;
    for (const double value : signal) {
        if (!std::isfinite(value)) continue;
        sum += value;
        ++count;
    }
    const double mean = count > 0 ? sum / static_cast<double>(count) : 0.0;
    const Eigen::VectorXd centred =
        signal.unaryExpr([mean](double value) { return std::isfinite(value) ? value - mean : 0.0; });
    Eigen::VectorXd result = Eigen::VectorXd::Zero(maxLag + 1);
    const double power = centred.squaredNorm();
    result[0] = 1.0;
    if (!(power > 0.0)) return result;
    for (Eigen::Index lag = 1; lag <= std::min<Eigen::Index>(maxLag, signal.size() - 1); ++lag) {
        stopPoint();
        const Eigen::Index rest = signal.size() - lag;
        result[lag] = centred.head(rest).dot(centred.tail(rest)) / power;
    }
    return result;
}

namespace {

/// 1 + 2 sum rho, summed while the lag is within five times the result (Sokal 1997, section 3).
double integratedTime(const Eigen::Ref<const Eigen::VectorXd>& residual) {
    const auto limit = static_cast<int>(residual.size() / 2);
    for (int reach = 64;; reach *= 4) {
        reach = std::min(reach, std::max(limit, 1));
        const Eigen::VectorXd rho = autocorrelation(residual, reach);
        double time = 1.0;
        for (int lag = 1; lag <= reach; ++lag) {
            time += 2.0 * rho[lag];
            if (lag >= 5.0 * std::max(time, 1.0)) return std::max(time, 1e-3);
        }
        if (reach >= limit) return std::max(time, 1e-3);
    }
}

/// Ljung & Box 1978: probability of an autocorrelation like this in white noise.
double ljungBox(const Eigen::VectorXd& rho, double count) {
    double q = 0.0;
    for (Eigen::Index lag = 1; lag < rho.size(); ++lag) q += rho[lag] * rho[lag] / (count - static_cast<double>(lag));
    q *= count * (count + 2.0);
    const double freedom = static_cast<double>(rho.size() - 1);
    return boost::math::gamma_q(0.5 * freedom, 0.5 * q);
}

}  // namespace

ResidualSummary summarise(const Eigen::Ref<const Eigen::VectorXd>& residual) {
    ResidualSummary summary;
    double sum = 0.0, square = 0.0;
    Eigen::Index count = 0;
    for (const double value : residual) {
        if (!std::isfinite(value)) continue;
        sum += value;
        square += value * value;
        ++count;
    }
    if (count == 0) return summary;
    const auto n = static_cast<double>(count);
    summary.noiseStd = noiseFromDifferences(residual);
    // About zero, not about the mean: an offset is something that the model does not explain.
    summary.standardDeviation = std::sqrt(square / n);
    summary.autocorrelationTime = integratedTime(residual);
    const int lags = static_cast<int>(std::min<Eigen::Index>(20, count / 5));
    if (lags < 1) return summary;
    const double probability = ljungBox(autocorrelation(residual, lags), n);
    summary.whiteProbability = probability;
    const double mean = sum / n;
    const bool hasOffset = mean * mean * n > 2.576 * 2.576 * (square / n - mean * mean);
    // The two deviations differ by chance: about 1 / sqrt(n) each.
    const bool exceeds = summary.standardDeviation > (1.05 + 4.0 / std::sqrt(n)) * summary.noiseStd;
    summary.white = probability > 0.01 && !hasOffset && !exceeds;
    return summary;
}

namespace {

/// The first half of the spectrum under a Hann window.
std::vector<std::complex<double>> halfSpectrum(const Eigen::Ref<const Eigen::VectorXd>& signal) {
    const auto count = static_cast<std::size_t>(signal.size());
    std::vector<double> windowed(count);
    for (std::size_t k = 0; k < count; ++k)
        windowed[k] = signal[static_cast<Eigen::Index>(k)] *
                      std::pow(std::sin(std::numbers::pi * static_cast<double>(k) / static_cast<double>(count)), 2);
    Eigen::FFT<double> transform;
    std::vector<std::complex<double>> spectrum;
    transform.fwd(spectrum, windowed);
    spectrum.resize(count / 2);
    return spectrum;
}

constexpr std::size_t firstBin = 2;  // below it there is the mean, and what leaks from it

/// Probability of the strongest line of a spectrum in noise whose spectrum is smooth: each bin of a periodogram over
/// the smooth spectrum is exponentially distributed (Priestley 1981, section 6.2), whose median is ln 2.
double lineProbability(const Eigen::VectorXd& signal) {
    constexpr std::size_t around = 25;
    // less steep without the first-order part of its colour, which cannot take a line
    const std::vector<std::complex<double>> spectrum = halfSpectrum(fitAutoregressive(signal, 1).whiten(signal));
    std::vector<double> power;
    for (std::size_t k = firstBin; k < spectrum.size(); ++k) power.push_back(std::norm(spectrum[k]));
    double largest = 0;
    for (std::size_t k = 0; k < power.size(); ++k) {
        const auto from = power.begin() + static_cast<std::ptrdiff_t>(k - std::min(k, around));
        const auto to = power.begin() + static_cast<std::ptrdiff_t>(std::min(k + around + 1, power.size()));
        const double smooth = median(std::vector<double>(from, to)) / std::numbers::ln2;
        if (smooth > 0) largest = std::max(largest, power[k] / smooth);
    }
    return static_cast<double>(power.size()) * std::exp(-largest);
}

/// What a second pole gains over one in the log-likelihood of a spectrum (Whittle 1953), beside white noise. Sensors
/// have white noise and a bias that wanders by a first-order Markov process; what falls off faster went through
/// something slow.
double gainOfSecondPole(const Eigen::VectorXd& signal) {
    const std::vector<std::complex<double>> spectrum = halfSpectrum(signal);
    std::vector<double> power, cosine;
    for (std::size_t k = firstBin; k < spectrum.size(); ++k) {
        power.push_back(std::norm(spectrum[k]));
        cosine.push_back(std::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(spectrum.size())));
    }
    const auto response = [](double pole, double c) {
        return (1 - pole) * (1 - pole) / (1 - 2 * pole * c + pole * pole);
    };
    // the level follows from the shape: poles 1 - 1/a and 1 - 1/b, and the share of white noise
    const auto likelihood = [&](double a, double b, double white) {
        double level = 0, logs = 0;
        for (std::size_t k = 0; k < power.size(); ++k) {
            const double shape = white + response(1 - 1 / a, cosine[k]) * response(1 - 1 / b, cosine[k]);
            level += power[k] / shape;
            logs += std::log(shape);
        }
        const auto count = static_cast<double>(power.size());
        return -count * std::log(level / count) - logs;
    };
    struct Point {
        double a, b, white, value;
    };
    const auto best = [&](bool isSecond) {
        Point top{1, 1, 1, -std::numeric_limits<double>::infinity()};
        const auto look = [&](double a, double b, double white) {
            a = std::max(a, 1.0);
            b = std::max(b, 1.0);
            if (const double value = likelihood(a, b, white); value > top.value) top = {a, b, white, value};
        };
        for (double a = 1; a < 1000; a *= 2)
            for (double b = 1; b <= (isSecond ? a : 1); b *= 2)
                for (double white = 1e-6; white < 10; white *= 4) look(a, b, white);
        for (double factor = 1.5; factor > 1.01; factor = std::sqrt(factor))
            for (int pass = 0; pass < 3; ++pass) {
                const Point p = top;
                for (const double f : {factor, 1 / factor}) {
                    look(p.a * f, p.b, p.white);
                    look(p.a, p.b, p.white * f);
                    look(p.a * f, p.b, p.white / f);
                    if (isSecond) {
                        look(p.a, p.b * f, p.white);
                        look(p.a * f, p.b / f, p.white);
                    }
                }
            }
        return top.value;
    };
    return best(true) - best(false);
}

/// Largest over smallest variance among parts of a signal without colour.
double unevenness(const Eigen::VectorXd& white) {
    constexpr Eigen::Index parts = 8;
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (Eigen::Index p = 0; p < parts; ++p) {
        const Eigen::Index from = white.size() * p / parts, to = white.size() * (p + 1) / parts;
        const double variance = white.segment(from, to - from).squaredNorm() / static_cast<double>(to - from);
        least = std::min(least, variance);
        most = std::max(most, variance);
    }
    return most / least;
}

}  // namespace

bool isStationaryNoise(const Eigen::Ref<const Eigen::VectorXd>& signal) {
    constexpr double leastWhite = 1e-4, significance = 1e-6;
    constexpr Eigen::Index fewest = 200;
    constexpr double fewestMemories = 15, mostUneven = 3, mostKurtosis = 6, mostOfSecondPole = 15;
    constexpr int order = 12;
    Eigen::VectorXd there(signal.size());
    Eigen::Index count = 0;
    for (const double value : signal)
        if (std::isfinite(value)) there[count++] = value;
    there.conservativeResize(count);
    if (count < fewest || static_cast<double>(count) < fewestMemories * integratedTime(there)) return false;
    const Eigen::VectorXd white = fitAutoregressive(there, order).whiten(there);
    const double probability = ljungBox(autocorrelation(white, 20), static_cast<double>(count));
    const double kurtosis = white.array().pow(4).mean() / std::pow(white.array().square().mean(), 2);
    return probability > leastWhite && unevenness(white) < mostUneven && kurtosis < mostKurtosis &&
           lineProbability(there) > significance && gainOfSecondPole(there) < mostOfSecondPole;
}

double coherenceProbability(const Eigen::Ref<const Eigen::VectorXd>& a, const Eigen::Ref<const Eigen::VectorXd>& b) {
    constexpr Eigen::Index fewestInSegment = 16;
    double probability = 1;
    for (const Eigen::Index halves : {16, 64}) {  // in the record: segments of two that overlap by one
        const Eigen::Index half = a.size() / halves;
        if (2 * half < fewestInSegment) break;
        std::vector<std::complex<double>> cross(static_cast<std::size_t>(half));
        std::vector<double> powerA(cross.size()), powerB(cross.size());
        for (Eigen::Index s = 0; s + 1 < halves; ++s) {
            const std::vector<std::complex<double>> x = halfSpectrum(a.segment(s * half, 2 * half)),
                                                    y = halfSpectrum(b.segment(s * half, 2 * half));
            for (std::size_t k = 0; k < cross.size(); ++k) {
                cross[k] += x[k] * std::conj(y[k]);
                powerA[k] += std::norm(x[k]);
                powerB[k] += std::norm(y[k]);
            }
        }
        double largest = 0;
        for (std::size_t k = firstBin; k < cross.size(); ++k)
            if (powerA[k] > 0 && powerB[k] > 0)
                largest = std::max(largest, std::norm(cross[k]) / powerA[k] / powerB[k]);
        // neighbours under a Hann window share a sixth of their amplitude
        const double segments = static_cast<double>(halves - 1) / (1 + 2.0 / 36);
        probability = std::min(
            probability, 2 * static_cast<double>(cross.size()) * std::pow(1 - std::min(largest, 1.0), segments - 1));
    }
    return std::min(probability, 1.0);
}

namespace {

/// What the numbers of a channel alone leave open: at least a millionth of its range. One that does not move but for
/// a single step of its converter tells that step, and one that does not move at all nothing: sensors are rarely better
/// than a thousandth of what they show.
double leastNoise(const Eigen::Ref<const Eigen::VectorXd>& measured) {
    constexpr double ofRange = 1e-6, ofMagnitude = 1e-3;
    const Range range = rangeOf(measured);
    if (range.isEmpty()) return 0;
    if (!(range.width() > 0)) return ofMagnitude * std::abs(range.high);
    const bool hasTwoValues = std::all_of(measured.begin(), measured.end(),
                                          [&](double x) { return std::isnan(x) || x == range.low || x == range.high; });
    return hasTwoValues ? range.width() / std::sqrt(12.0) : ofRange * range.width();
}

}  // namespace

double channelNoise(const Eigen::Ref<const Eigen::VectorXd>& residual,
                    const Eigen::Ref<const Eigen::VectorXd>& measured) {
    return std::max({noiseFromDifferences(residual), quantisationNoise(measured), leastNoise(measured)});
}

}  // namespace analogon
