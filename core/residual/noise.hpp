#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

namespace analogon {

/// Standard deviation of the white part of a signal from high-frequency differences: robust (median absolute)
/// estimate over third differences, so that trends and slow dynamics do not count. Samples are equidistant or
/// nearly so; NaN samples are left out. Steps of the signal are outliers to the median.
double noiseFromDifferences(const Eigen::Ref<const Eigen::VectorXd>& signal);

/// Standard deviation of a channel's noise from what a model leaves of it and from the rounding of its values; at least
/// a millionth of its range, since a recording that was simulated has none to speak of, and at least a thousandth of
/// the value of a channel that stands still. `residual` and `measured`: the same samples.
double channelNoise(const Eigen::Ref<const Eigen::VectorXd>& residual,
                    const Eigen::Ref<const Eigen::VectorXd>& measured);

/// Standard deviation of the noise near each sample, where it comes and goes (bursts of a disturbed supply, noise that
/// grows with the reading): root mean square of the third differences about it. Empty where the noise is as strong
/// throughout as such short stretches can tell, and in short signals.
Eigen::VectorXd localNoise(const Eigen::Ref<const Eigen::VectorXd>& signal);

/// An autoregressive model e_k = sum a_i e_{k-i} + w_k, order by BIC (Burg's method).
struct AutoregressiveModel {
    std::vector<double> coefficients;  // a_1 … a_order
    double innovation{};               // standard deviation of w
    /// w for a whole signal. The first samples are predicted by what is there, in units of what that leaves (Prais &
    /// Winsten 1954): told as they are, the first sample of slow noise would outweigh all others.
    Eigen::VectorXd whiten(const Eigen::Ref<const Eigen::VectorXd>& signal) const;
    /// A signal of the model, as it goes on long after its beginning.
    Eigen::VectorXd simulate(Eigen::Index count, std::mt19937_64& random) const;
};
AutoregressiveModel fitAutoregressive(const Eigen::Ref<const Eigen::VectorXd>& signal, int maxOrder);

/// What a residual looks like.
struct ResidualSummary {
    double noiseStd{};             // of the measurement noise, see noiseFromDifferences
    double standardDeviation{};    // of the residual itself
    double autocorrelationTime{};  // integrated, in samples: 1 for white noise
    bool white{};                  // no significant autocorrelation (Ljung-Box at 1 %) and no excess over the noise
    double whiteProbability{1};    // of so much autocorrelation in white noise (Ljung-Box, 20 lags)
};
ResidualSummary summarise(const Eigen::Ref<const Eigen::VectorXd>& residual);

/// Whether a signal looks like stationary noise of a sensor: white noise and a first-order Markov process of whatever
/// memory. No line stands out of its spectrum, its level stays the same throughout, nothing drives it by fits and
/// starts, and it forgets soon enough for the record to tell.
bool isStationaryNoise(const Eigen::Ref<const Eigen::VectorXd>& signal);

/// Probability that two independent noises of whatever colour are as coherent as these at some frequency (same samples,
/// equidistant). Averaged over overlapping segments (Welch 1967), few long and many short ones; distribution of the
/// coherence of independent signals: Carter, Knapp & Nuttall 1973.
double coherenceProbability(const Eigen::Ref<const Eigen::VectorXd>& a, const Eigen::Ref<const Eigen::VectorXd>& b);

/// Normalised autocorrelation for lags 0 … maxLag.
Eigen::VectorXd autocorrelation(const Eigen::Ref<const Eigen::VectorXd>& signal, int maxLag);

}  // namespace analogon
