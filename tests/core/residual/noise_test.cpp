#include "core/residual/noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace analogon {
namespace {

Eigen::VectorXd gaussian(int count, double sigma, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0.0, sigma);
    Eigen::VectorXd result(count);
    for (double& value : result) value = normal(random);
    return result;
}

Eigen::VectorXd slow(int count) {
    Eigen::VectorXd result(count);
    for (int k = 0; k < count; ++k) result[k] = 20.0 + 5.0 * std::sin(0.005 * k) + (k / 700) % 2 * 3.0;
    return result;
}

TEST(NoiseFromDifferences, IsRightOnWhiteNoiseOverASlowSignalWithSteps) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const Eigen::VectorXd signal = slow(8000) + gaussian(8000, 0.2, seed);
        EXPECT_NEAR(noiseFromDifferences(signal), 0.2, 0.03 * 0.2) << seed;
    }
}

TEST(NoiseFromDifferences, LeavesGapsOut) {
    Eigen::VectorXd signal = gaussian(6000, 1.0, 7);
    for (int k = 500; k < 6000; k += 500) signal.segment(k, 20).setConstant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_NEAR(noiseFromDifferences(signal), 1.0, 0.04);
}

TEST(NoiseFromDifferences, KnowsALoggerOfALowerRate) {
    for (const int interval : {2, 5, 20}) {
        Eigen::VectorXd signal = gaussian(6000, 1.0, 7);
        for (int k = 0; k < 6000; ++k)
            if (k % interval != 0) signal[k] = std::numeric_limits<double>::quiet_NaN();
        EXPECT_NEAR(noiseFromDifferences(signal), 1.0, 0.15) << interval;
    }
}

TEST(NoiseFromDifferences, IsZeroForASmoothSignalAndForOneWithFewSteps) {
    Eigen::VectorXd steps(3000);
    for (int k = 0; k < 3000; ++k) steps[k] = (k / 1000) * 2.0;
    EXPECT_EQ(noiseFromDifferences(steps), 0.0);
    Eigen::VectorXd smooth(3000);
    for (int k = 0; k < 3000; ++k) smooth[k] = std::sin(0.002 * k);
    EXPECT_LT(noiseFromDifferences(smooth), 1e-6);
}

TEST(NoiseFromDifferences, SeesQuantisationOfASlowSignal) {
    // A slow temperature in steps of 0.1: most neighbours are equal.
    Eigen::VectorXd quantised(5000), residual(5000);
    for (int k = 0; k < 5000; ++k) {
        const double exact = 25.0 + 6.0 * std::sin(0.003 * k);
        quantised[k] = 0.1 * std::round(exact / 0.1);
        residual[k] = quantised[k] - exact;
    }
    EXPECT_NEAR(noiseFromDifferences(quantised), 0.1 / std::sqrt(12.0), 0.15 * 0.1 / std::sqrt(12.0));
    EXPECT_NEAR(noiseFromDifferences(residual), 0.1 / std::sqrt(12.0), 0.15 * 0.1 / std::sqrt(12.0));
}

TEST(NoiseFromDifferences, AddsNoiseAndQuantisationOfTheSameSize) {
    // Sheppard: sigma^2 + q^2 / 12.
    const Eigen::VectorXd noise = gaussian(8000, 0.1, 3);
    Eigen::VectorXd signal(8000);
    for (int k = 0; k < 8000; ++k) signal[k] = 0.1 * std::round((30.0 + 4.0 * std::sin(0.002 * k) + noise[k]) / 0.1);
    const double expected = std::sqrt(0.01 + 0.01 / 12.0);
    EXPECT_NEAR(noiseFromDifferences(signal), expected, 0.05 * expected);
}

/// Four times as strong in every third stretch.
Eigen::VectorXd burstyNoise(int count, unsigned seed) {
    Eigen::VectorXd noise = gaussian(count, 1, seed);
    for (int k = 0; k < count; ++k) noise[k] *= k / 300 % 3 == 1 ? 4 : 1;
    return noise;
}

TEST(LocalNoise, FollowsNoiseThatComesAndGoesOverASlowSignal) {
    const Eigen::VectorXd local = localNoise(slow(6000) + burstyNoise(6000, 3));
    ASSERT_EQ(local.size(), 6000);
    double quiet = 0, loud = 0;
    for (int k = 0; k < 6000; ++k)
        if (k % 300 > 50 && k % 300 < 250)
            (k / 300 % 3 == 1 ? loud : quiet) += local[k] / (k / 300 % 3 == 1 ? 1393 : 2587);
    EXPECT_NEAR(loud / quiet, 4, 0.3);
}

TEST(LocalNoise, IsEmptyWhereNoiseIsEven) {
    for (unsigned seed = 1; seed <= 20; ++seed)
        EXPECT_EQ(localNoise(slow(6000) + gaussian(6000, 0.2, seed)).size(), 0) << seed;
    EXPECT_EQ(localNoise(Eigen::VectorXd::Zero(6000)).size(), 0);
}

TEST(Autoregressive, FindsOrderAndCoefficientsOfAKnownProcess) {
    const Eigen::VectorXd w = gaussian(20000, 0.5, 11);
    Eigen::VectorXd e = w;
    for (int k = 2; k < e.size(); ++k) e[k] = 1.2 * e[k - 1] - 0.5 * e[k - 2] + w[k];
    const AutoregressiveModel model = fitAutoregressive(e, 10);
    ASSERT_GE(model.coefficients.size(), 2u);
    ASSERT_LE(model.coefficients.size(), 3u);
    EXPECT_NEAR(model.coefficients[0], 1.2, 0.03);
    EXPECT_NEAR(model.coefficients[1], -0.5, 0.03);
    EXPECT_NEAR(model.innovation, 0.5, 0.01);
    const Eigen::VectorXd white = model.whiten(e);
    EXPECT_LT(autocorrelation(white.tail(white.size() - 10), 5).tail(5).cwiseAbs().maxCoeff(), 0.03);
}

TEST(Autoregressive, KeepsWhiteNoiseAsItIs) {
    const Eigen::VectorXd w = gaussian(5000, 2.0, 5);
    const AutoregressiveModel model = fitAutoregressive(w, 10);
    EXPECT_TRUE(model.coefficients.empty());
    EXPECT_NEAR(model.innovation, 2.0, 0.1);
    EXPECT_EQ(model.whiten(w), w);
}

TEST(Autocorrelation, MatchesASumByHand) {
    const Eigen::VectorXd signal = (Eigen::VectorXd(4) << 1.0, 3.0, 2.0, 6.0).finished();  // mean 3: -2 0 -1 3
    const Eigen::VectorXd rho = autocorrelation(signal, 3);
    EXPECT_DOUBLE_EQ(rho[0], 1.0);
    EXPECT_DOUBLE_EQ(rho[1], -3.0 / 14.0);
    EXPECT_DOUBLE_EQ(rho[2], 2.0 / 14.0);
    EXPECT_DOUBLE_EQ(rho[3], -6.0 / 14.0);
}

TEST(ResidualSummary, CallsWhiteNoiseWhite) {
    int white = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) white += summarise(gaussian(2000, 0.3, seed)).white;
    EXPECT_GE(white, 37);
    const ResidualSummary summary = summarise(gaussian(20000, 0.3, 99));
    EXPECT_NEAR(summary.noiseStd, 0.3, 0.01);
    EXPECT_NEAR(summary.standardDeviation, 0.3, 0.01);
    EXPECT_NEAR(summary.autocorrelationTime, 1.0, 0.15);
}

TEST(ResidualSummary, SeesALeftOverTrendAndAnOffset) {
    Eigen::VectorXd trend = gaussian(4000, 0.3, 2);
    for (int k = 0; k < 4000; ++k) trend[k] += 0.2 * std::sin(0.01 * k);
    const ResidualSummary summary = summarise(trend);
    EXPECT_FALSE(summary.white);
    EXPECT_NEAR(summary.noiseStd, 0.3, 0.02);
    EXPECT_GT(summary.autocorrelationTime, 5.0);
    EXPECT_FALSE(summarise((gaussian(4000, 0.3, 4).array() + 0.1).matrix()).white);
}

TEST(ResidualSummary, IntegratesTheAutocorrelationOfAFirstOrderProcess) {
    Eigen::VectorXd e = gaussian(40000, 1.0, 8);
    for (int k = 1; k < e.size(); ++k) e[k] += 0.8 * e[k - 1];
    EXPECT_NEAR(summarise(e).autocorrelationTime, (1.0 + 0.8) / (1.0 - 0.8), 1.2);
}

/// Noise of unit variance of which neighbours correlate by `memory`, with as much white noise.
Eigen::VectorXd coloured(int count, double memory, unsigned seed) {
    Eigen::VectorXd result = gaussian(count, 1.0, seed);
    for (int k = 1; k < count; ++k) result[k] = memory * result[k - 1] + std::sqrt(1 - memory * memory) * result[k];
    return result + gaussian(count, 0.5, seed + 1000);
}

TEST(StationaryNoise, IsOfAnyColour) {
    for (const double memory : {0.0, 0.5, 0.9, 0.97})
        for (unsigned seed = 1; seed <= 20; ++seed)
            EXPECT_TRUE(isStationaryNoise(coloured(3000, memory, seed))) << memory << ' ' << seed;
}

TEST(StationaryNoise, HasNoLine) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        Eigen::VectorXd signal = coloured(3000, 0.9, seed), faint = signal;
        for (int k = 0; k < 3000; ++k) signal[k] += 0.7 * std::sin(0.35 * k);
        EXPECT_FALSE(isStationaryNoise(signal)) << seed;
        // too faint for anything but its line
        for (int k = 0; k < 3000; ++k) faint[k] += 0.2 * std::sin(1.5 * k);
        EXPECT_FALSE(isStationaryNoise(faint)) << seed;
    }
}

TEST(StationaryNoise, DoesNotComeAndGo) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        Eigen::VectorXd louder = coloured(3000, 0.5, seed), pulled = louder, drifting = louder;
        louder.segment(900, 600) *= 3;
        for (const int from : {400, 1300, 2200}) pulled.segment(from, 200).array() += 12;
        for (int k = 0; k < 3000; ++k) drifting[k] += 1e-3 * k;
        EXPECT_FALSE(isStationaryNoise(louder)) << seed;
        EXPECT_FALSE(isStationaryNoise(pulled)) << seed;
        EXPECT_FALSE(isStationaryNoise(drifting)) << seed;
    }
}

TEST(StationaryNoise, DidNotGoThroughSomethingSlow) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        Eigen::VectorXd slow = coloured(3000, 0.95, seed);
        for (int k = 1; k < 3000; ++k) slow[k] = 0.96 * slow[k - 1] + 0.04 * slow[k];
        EXPECT_FALSE(isStationaryNoise(slow + gaussian(3000, 0.05, seed + 50))) << seed;
    }
}

TEST(StationaryNoise, TakesARecordLongEnoughToTell) {
    EXPECT_FALSE(isStationaryNoise(gaussian(100, 1.0, 3)));
    EXPECT_FALSE(isStationaryNoise(coloured(3000, 0.998, 3)));
}

TEST(AutoregressiveModel, WhitensTheBeginningLikeTheRest) {
    const AutoregressiveModel model{{1.6, -0.62}, 0.1};
    std::mt19937_64 random(3);
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(5);
    constexpr int signals = 4000;
    for (int n = 0; n < signals; ++n)
        squares += model.whiten(model.simulate(200, random)).head(5).array().square().matrix() / signals;
    for (const double square : squares) EXPECT_NEAR(square, 0.01, 0.001);
}

TEST(AutoregressiveModel, SimulatesWhatItDescribes) {
    const AutoregressiveModel model{{0.9}, 1};
    std::mt19937_64 random(5);
    const Eigen::VectorXd signal = model.simulate(200000, random);
    EXPECT_NEAR(signal.squaredNorm() / 200000, 1 / (1 - 0.81), 0.15);
    EXPECT_NEAR(signal.head(199999).dot(signal.tail(199999)) / signal.squaredNorm(), 0.9, 0.01);
}

TEST(Coherence, IsLikelyByChanceOnlyWhereSignalsAreIndependent) {
    int rare = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const Eigen::VectorXd a = coloured(3000, 0.95, seed), b = coloured(3000, 0.8, 500 + seed),
                              common = coloured(3000, 0.95, 900 + seed);
        rare += coherenceProbability(a, b) < 0.05;
        EXPECT_GT(coherenceProbability(a, b), 1e-5) << seed;
        EXPECT_LT(coherenceProbability(a + 2 * common, b - 2 * common), 1e-6) << seed;
    }
    EXPECT_LE(rare, 8);
}

}  // namespace
}  // namespace analogon
