#include "core/campaign/population.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace analogon {
namespace {

struct Drawn {
    std::vector<double> values, errors;
};

/// Units around 10, with standard errors between 0.2 and 0.6.
Drawn draw(std::mt19937& random, std::size_t count, double between) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> size(0.2, 0.6);
    Drawn drawn;
    for (std::size_t i = 0; i < count; ++i) {
        drawn.errors.push_back(size(random));
        drawn.values.push_back(10 + between * normal(random) + drawn.errors.back() * normal(random));
    }
    return drawn;
}

TEST(Population, FindsMeanAndVarianceBetweenUnitsWithinItsStandardErrors) {
    std::mt19937 random(3);
    double meanZ = 0, squares = 0, promised = 0, bias = 0;
    constexpr int runs = 400;
    for (int i = 0; i < runs; ++i) {
        const Drawn d = draw(random, 60, 0.5);
        const Population p = populationOf(d.values, d.errors);
        meanZ += std::pow((p.mean - 10) / p.meanError, 2) / runs;
        squares += std::pow(p.between - 0.25, 2) / runs;
        promised += p.betweenError * p.betweenError / runs;
        bias += (p.between - 0.25) / runs;
    }
    EXPECT_NEAR(meanZ, 1, 0.2);
    EXPECT_NEAR(squares / promised, 1, 0.25);
    EXPECT_NEAR(bias, 0, 0.012);
}

TEST(Population, AgreesWithAValueByHandForEqualErrors) {
    // of equal errors the restricted likelihood gives the sample variance less s²
    const Population p = populationOf({1, 2, 3, 4.5}, {1, 1, 1, 1});
    const double mean = 10.5 / 4;
    const double variance =
        (std::pow(1 - mean, 2) + std::pow(2 - mean, 2) + std::pow(3 - mean, 2) + std::pow(4.5 - mean, 2)) / 3;
    EXPECT_NEAR(p.mean, mean, 1e-9);
    EXPECT_NEAR(p.between, variance - 1, 1e-5);
    EXPECT_NEAR(p.meanError, std::sqrt(variance / 4), 1e-6);
}

TEST(Population, CallsACommonParameterDifferentAtThePromisedRateAndADifferentOneAlmostAlways) {
    std::mt19937 random(4);
    int falsely = 0, rightly = 0;
    constexpr int runs = 1000;
    for (int i = 0; i < runs; ++i) {
        const Drawn common = draw(random, 40, 0), different = draw(random, 40, 0.5);
        falsely += populationOf(common.values, common.errors).pCommon < 0.05;
        rightly += populationOf(different.values, different.errors).pCommon < 0.05;
    }
    EXPECT_LT(falsely, 0.07 * runs);
    EXPECT_GT(falsely, 0.02 * runs);
    EXPECT_GT(rightly, 0.95 * runs);
}

TEST(OddUnits, AreSeldomNamedInCleanPopulationsOfAnySize) {
    std::mt19937 random(5);
    for (const std::size_t size : {8u, 30u, 300u})
        for (const double between : {0.0, 0.5, 3.0}) {
            int any = 0;
            constexpr int runs = 400;
            for (int i = 0; i < runs; ++i) {
                const Drawn d = draw(random, size, between);
                any += !oddUnits(d.values, d.errors, levelOfOne(0.05, size)).empty();
            }
            EXPECT_LE(any, 0.085 * runs) << size << " units, " << between << " between";
        }
}

TEST(OddUnits, AreThoseThatLieFarFromTheOthersForTheirOwnError) {
    std::mt19937 random(6);
    Drawn d = draw(random, 200, 0.5);
    d.values[17] += 6;
    d.values[40] += 6;
    d.errors[40] = 4;  // tells nothing
    d.values[60] -= 7;
    const std::vector<OddUnit> odd = oddUnits(d.values, d.errors, levelOfOne(0.05, 200));
    ASSERT_EQ(odd.size(), 2u);
    EXPECT_EQ(odd[0].unit, 17u);
    EXPECT_GT(odd[0].deviation, 0);
    EXPECT_EQ(odd[1].unit, 60u);
    EXPECT_LT(odd[1].deviation, 0);
}

TEST(Comparisons, AreCorrectedByHolm) {
    const std::vector<double> p = holm({0.01, 0.04, 0.03, 0.005});
    EXPECT_DOUBLE_EQ(p[3], 0.02);
    EXPECT_DOUBLE_EQ(p[0], 0.03);
    EXPECT_DOUBLE_EQ(p[2], 0.06);
    EXPECT_DOUBLE_EQ(p[1], 0.06);
    EXPECT_NEAR(levelOfOne(0.05, 1000), 5.129e-5, 1e-8);
}

TEST(Comparisons, OfRanksGiveThePublishedValues) {
    // x and y without ties, d² sums to 194: rho = 1 - 6*194/(10*99) = -0.17576
    const std::vector<double> x{106, 100, 86, 101, 99, 103, 97, 113, 112, 110};
    const std::vector<double> y{7, 27, 2, 50, 28, 29, 20, 12, 6, 17};
    EXPECT_NEAR(rankCorrelation(x, y).correlation, -0.17576, 1e-5);
    EXPECT_NEAR(rankCorrelation(x, y).p, 0.6272, 1e-4);
    // three groups of which one is higher: ranks 1-3, 4-6, 7-9 give H = 7.2, p = exp(-3.6)
    EXPECT_NEAR(kruskalWallis({0, 0, 0, 1, 1, 1, 2, 2, 2}, {1, 2, 3, 4, 5, 6, 7, 8, 9}), std::exp(-3.6), 1e-12);
}

TEST(Comparisons, AreSignificantByChanceAtTheirLevel) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    int ranks = 0, groups = 0;
    constexpr int runs = 2000;
    for (int i = 0; i < runs; ++i) {
        std::vector<double> x, y;
        std::vector<std::size_t> group;
        for (std::size_t k = 0; k < 40; ++k) {
            x.push_back(normal(random));
            y.push_back(normal(random));
            group.push_back(k % 3);
        }
        ranks += rankCorrelation(x, y).p < 0.05;
        groups += kruskalWallis(group, y) < 0.05;
    }
    EXPECT_NEAR(ranks, 0.05 * runs, 0.015 * runs);
    EXPECT_NEAR(groups, 0.05 * runs, 0.015 * runs);
}

}  // namespace
}  // namespace analogon
