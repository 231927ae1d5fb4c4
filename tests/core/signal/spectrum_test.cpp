#include "core/signal/spectrum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace analogon {
namespace {

std::vector<double> times(int n, double step) {
    std::vector<double> t(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) t[static_cast<std::size_t>(i)] = i * step;
    return t;
}

std::vector<double> noise(int n, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<double> y(static_cast<std::size_t>(n));
    for (double& v : y) v = normal(random);
    return y;
}

double integral(const Spectrum& s) {
    return std::accumulate(s.density.begin(), s.density.end(), 0.0) * (s.frequency[1] - s.frequency[0]);
}

TEST(Welch, FindsATone) {
    const std::vector<double> t = times(4096, 0.01);
    std::vector<double> y;
    for (const double at : t) y.push_back(5 + 3 * std::sin(2 * std::numbers::pi * 12.5 * at));
    const auto s = welchSpectrum(t, y);
    ASSERT_TRUE(s);
    const auto peak = std::max_element(s->density.begin(), s->density.end()) - s->density.begin();
    EXPECT_NEAR(s->frequency[static_cast<std::size_t>(peak)], 12.5, 100.0 / 512);
    EXPECT_NEAR(s->frequency.back(), 50, 1e-9);
    EXPECT_NEAR(integral(*s), 4.5, 0.05);  // 3²/2; the mean is left out
}

TEST(Welch, OfWhiteNoiseIsFlatWithItsVarianceAsIntegral) {
    const auto s = welchSpectrum(times(65536, 0.001), noise(65536, 3), 512);
    ASSERT_TRUE(s);
    EXPECT_EQ(s->frequency.size(), 257u);
    EXPECT_EQ(s->segments, 255);
    EXPECT_NEAR(integral(*s), 1, 0.03);
    for (std::size_t k = 5; k < 250; ++k) EXPECT_NEAR(s->density[k], 2.0 / 1000, 0.9e-3) << k;
}

TEST(Welch, BridgesGapsAndUnevenStamps) {
    std::vector<double> t = times(4096, 0.01), y;
    for (std::size_t i = 1; i < t.size(); i += 2) t[i] += 0.001;
    for (const double at : t) y.push_back(std::sin(2 * std::numbers::pi * 3 * at));
    for (std::size_t i = 100; i < 110; ++i) y[i] = std::nan("");
    const auto s = welchSpectrum(t, y);
    ASSERT_TRUE(s);
    EXPECT_NEAR(integral(*s), 0.5, 0.02);
    EXPECT_FALSE(welchSpectrum(times(10, 1), noise(10, 1)));
    EXPECT_FALSE(welchSpectrum(t, std::vector<double>(t.size(), std::nan(""))));
}

TEST(Coherence, IsOneForAFilteredSignalAndLowForAStranger) {
    const int n = 32768;
    const std::vector<double> t = times(n, 0.01), x = noise(n, 5), other = noise(n, 6);
    std::vector<double> filtered(x);
    for (std::size_t i = 1; i < filtered.size(); ++i) filtered[i] = 0.7 * filtered[i - 1] + x[i];
    const auto same = coherence(t, x, filtered, 256), strange = coherence(t, x, other, 256);
    ASSERT_TRUE(same && strange);
    for (std::size_t k = 2; k < same->value.size() - 1; ++k) {
        EXPECT_GT(same->value[k], 0.98) << k;
        EXPECT_LT(strange->value[k], 0.15) << k;
    }
    EXPECT_FALSE(coherence(times(16, 1), noise(16, 1), noise(16, 2), 16)) << "one segment says nothing";
}

TEST(Histogram, CountsEverySampleOnce) {
    std::vector<double> y = noise(10000, 9);
    y.push_back(std::nan(""));
    const auto h = histogram(y);
    ASSERT_TRUE(h);
    EXPECT_EQ(h->edges.size(), h->counts.size() + 1);
    EXPECT_NEAR(std::accumulate(h->counts.begin(), h->counts.end(), 0.0), 1, 1e-9);
    const auto most = std::max_element(h->counts.begin(), h->counts.end()) - h->counts.begin();
    EXPECT_NEAR(h->edges[static_cast<std::size_t>(most)], 0, 0.5);
    const auto constant = histogram(std::vector<double>(20, 7.0));
    ASSERT_TRUE(constant);
    EXPECT_NEAR(std::accumulate(constant->counts.begin(), constant->counts.end(), 0.0), 1, 1e-9);
    EXPECT_FALSE(histogram(std::vector<double>{}));
}

}  // namespace
}  // namespace analogon
