#include "core/effect/model/score.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/effect/model/null_model.hpp"
#include "core/residual/noise.hpp"
#include "core/residual/quantisation.hpp"
#include "tests/core/effect/left_by.hpp"

namespace analogon {
namespace {

Eigen::VectorXd gaussian(int n, std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    Eigen::VectorXd x(n);
    for (double& v : x) v = normal(generator);
    return x;
}

Eigen::VectorXd wave(int n, double periods) {
    Eigen::VectorXd x(n);
    for (int k = 0; k < n; ++k) x[k] = std::sin(2 * M_PI * periods * k / n);
    return x;
}

ResidualChannel oneChannel(int n) {
    ResidualChannel c{0, 0, 0, n, {}};
    for (int k = 0; k < n; ++k) c.samples.push_back(k);
    return c;
}

TEST(ResidualChannels, LeaveOutWhatWasNotMeasuredOrHasNoWeight) {
    FitExperiment e;
    e.measured = Eigen::MatrixXd::Ones(3, 5);
    e.measured(0, 2) = std::nan("");
    e.weights = Eigen::Vector3d(1, 0, 2);
    FitProblem problem;
    problem.experiments.push_back(e);
    const std::vector<ResidualChannel> channels = residualChannels(problem);
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].samples, (std::vector<int>{0, 1, 3, 4}));
    EXPECT_EQ(channels[1].output, 2);
    EXPECT_EQ(channels[1].begin, 4);
    EXPECT_EQ(channels[1].end, 9);
}

/// A slow signal read by a converter of steps of 1, with noise of a tenth of a step; the model knows the signal but
/// for `missed` of it.
struct Converted {
    FitProblem problem;
    Eigen::VectorXd residual;

    explicit Converted(double missed) {
        constexpr int n = 3000;
        const Eigen::VectorXd signal = 12 * wave(n, 3), noise = 0.1 * gaussian(n, 4);
        const Eigen::VectorXd simulated = signal - missed * wave(n, 7);
        FitExperiment e;
        e.measured = (signal + noise).array().round().matrix().transpose();
        constexpr double weight = 2.5;  // 1/deviation
        e.weights = Eigen::VectorXd::Constant(1, weight);
        residual = weight * (simulated - e.measured.row(0).transpose());
        problem.experiments.push_back(e);
    }
    ResidualChannel channel() const { return residualChannels(problem).front(); }
};

TEST(ResidualChannels, AreNoiseBesideWhatAConverterRoundsOff) {
    const Converted right(0);
    EXPECT_DOUBLE_EQ(quantisationStep(right.channel().measured), 2.5);
    EXPECT_LT(summarise(right.residual).whiteProbability, whiteSignificance) << "rounding repeats with the signal";
    EXPECT_TRUE(isNoise(right.channel(), right.residual));
}

TEST(ResidualChannels, AreNoNoiseWhereMoreIsMissing) {
    const Converted wrong(0.3);
    EXPECT_FALSE(isNoise(wrong.channel(), wrong.residual));
}

/// A speed counted by an encoder, of 1 step a sample; the model knows the speed but for `missed` of it.
FitProblem counted(double missed, Eigen::VectorXd& residual) {
    constexpr int n = 3000;
    const Eigen::VectorXd speed = 12 * wave(n, 3) + 0.37 * wave(n, 41);
    Eigen::VectorXd counts(n);
    double angle = 0.2;
    for (int k = 0; k < n; ++k) {
        const double before = std::floor(angle);
        angle += speed[k];
        counts[k] = std::floor(angle) - before;
    }
    FitExperiment e;
    e.measured = counts.transpose();
    e.weights = Eigen::VectorXd::Ones(1);
    residual = speed - missed * wave(n, 7) - counts;
    FitProblem problem;
    problem.experiments.push_back(e);
    return problem;
}

TEST(ResidualChannels, AreNoiseBesideWhatAnEncoderCounts) {
    Eigen::VectorXd residual;
    const FitProblem right = counted(0, residual);
    EXPECT_LT(summarise(residual).whiteProbability, whiteSignificance) << "too much now is too little next";
    EXPECT_TRUE(isNoise(residualChannels(right).front(), residual));
    const FitProblem wrong = counted(0.4, residual);
    EXPECT_FALSE(isNoise(residualChannels(wrong).front(), residual));
}

TEST(OrthogonalProjector, TakesOutWhatTheParametersCanImitate) {
    const int n = 500;
    Eigen::MatrixXd jacobian(n, 2);
    jacobian << 1e-9 * wave(n, 1), 1e6 * wave(n, 2);  // any magnitude counts alike
    const OrthogonalProjector complement(jacobian);
    EXPECT_EQ(complement.rank(), 2);
    const Eigen::VectorXd imitated = 3 * wave(n, 1) - 2 * wave(n, 2);
    EXPECT_LT(complement(Eigen::MatrixXd(imitated)).norm() / imitated.norm(), 1e-12);
    const Eigen::VectorXd coefficients = complement.coefficients(imitated);
    EXPECT_NEAR(coefficients[0], 3e9, 1);
    EXPECT_NEAR(coefficients[1], -2e-6, 1e-12);
}

TEST(OrthogonalProjector, CountsAColumnTwiceInTheJacobianOnce) {
    Eigen::MatrixXd jacobian(100, 2);
    jacobian << wave(100, 1), 2 * wave(100, 1);
    EXPECT_EQ(OrthogonalProjector(jacobian).rank(), 1);
}

TEST(ScoreColumns, FindsStrengthAndExplainedSquares) {
    const int n = 2000;
    const OrthogonalProjector complement(wave(n, 1));
    const Eigen::VectorXd trace = wave(n, 3);
    const Eigen::VectorXd residual = gaussian(n, 1) - 0.5 * trace;  // simulated minus measured: the effect is missing
    const ColumnScore s = scoreColumns(complement, residual, trace, true);
    EXPECT_NEAR(s.visible, 1, 1e-9);
    EXPECT_NEAR(s.strengths[0], 0.5, 0.1);
    EXPECT_NEAR(s.explained, 0.25 * n / 2, 60);
    EXPECT_FALSE(s.wrongSign);
    EXPECT_TRUE(scoreColumns(complement, -residual, trace, true).wrongSign);
    EXPECT_FALSE(scoreColumns(complement, -residual, trace, false).wrongSign);
}

TEST(ScoreColumns, SaysHowLittleOfAnAbsorbedEffectIsVisible) {
    const int n = 1000;
    const Eigen::VectorXd trace = wave(n, 1) + 1e-3 * wave(n, 5);
    const ColumnScore s = scoreColumns(OrthogonalProjector(wave(n, 1)), gaussian(n, 2), trace, false);
    EXPECT_NEAR(s.visible, 1e-3, 1e-5);
}

TEST(ScoreColumns, TellsNoStrengthOfWhatTheParametersImitate) {
    const int n = 1000;
    Eigen::MatrixXd columns(n, 3);
    columns << wave(n, 3), 2 * wave(n, 1), wave(n, 5);
    const Eigen::VectorXd residual = gaussian(n, 1) - 0.5 * wave(n, 3) + 0.7 * wave(n, 5);
    const ColumnScore s = scoreColumns(OrthogonalProjector(wave(n, 1)), residual, columns, false);
    EXPECT_NEAR(s.strengths[0], 0.5, 0.1);
    EXPECT_EQ(s.strengths[1], 0) << "what rounding leaves of it fits anything";
    EXPECT_NEAR(s.strengths[2], -0.7, 0.1);
    EXPECT_EQ(s.directions->cols(), 2);
}

TEST(ExplainedTogether, ShowsTwoEffectsThatHideEachOther) {
    const int n = 400;
    const auto direction = [](Eigen::VectorXd v) { return Eigen::MatrixXd(v / v.norm()); };
    const Eigen::VectorXd common = wave(n, 3);
    // alike but for a tenth, and present with opposite signs: alone, each explains next to nothing
    const Eigen::MatrixXd a = direction(common + 0.1 * wave(n, 7)), b = direction(common - 0.1 * wave(n, 7));
    const Eigen::MatrixXd other = direction(wave(n, 7) + 2 * wave(n, 11));
    const Eigen::VectorXd residual = 10 * (a - b).col(0);
    const auto scored = [&](const Eigen::MatrixXd& columns) {
        ColumnScore score;
        score.directions = columns;
        score.along = columns.transpose() * residual;
        return score;
    };
    const auto alone = [&](const Eigen::MatrixXd& columns) { return scored(columns).along.squaredNorm(); };
    const auto together = [&](const Eigen::MatrixXd& x, const Eigen::MatrixXd& y) {
        return explainedTogether(scored(x), scored(y));
    };
    EXPECT_LT(alone(a), 0.02 * residual.squaredNorm());
    EXPECT_GT(alone(other), 5 * alone(a));
    EXPECT_NEAR(together(a, b), residual.squaredNorm(), 1e-5 * residual.squaredNorm());
    EXPECT_LT(together(a, other), 0.5 * residual.squaredNorm());
    // two of a kind are one
    EXPECT_NEAR(together(a, a), alone(a), 1e-5 * alone(a));
}

TEST(Whitener, MakesAnAutoregressiveResidualWhite) {
    const int n = 4000;
    Eigen::VectorXd r = gaussian(n, 3);
    for (int k = 1; k < n; ++k) r[k] += 0.9 * r[k - 1];
    const std::vector<ResidualChannel> channels{oneChannel(n)};
    const Eigen::VectorXd white = Whitener(channels, r)(r);
    EXPECT_NEAR(white.squaredNorm() / n, 1, 0.05);
    EXPECT_LT(std::abs(autocorrelation(white, 1)[1]), 0.05);
}

TEST(AtSomeRows, KeepsHowAlikeDirectionsAre) {
    const int n = 20000;
    const auto direction = [](Eigen::VectorXd v) { return SharedColumns(Eigen::MatrixXd(v.normalized())); };
    const auto alike = [](const SharedColumns& a, const SharedColumns& b) {
        return static_cast<double>(atSomeRows(a, 4000)->col(0).dot(atSomeRows(b, 4000)->col(0)));
    };
    const Eigen::VectorXd slow = wave(n, 3), other = wave(n, 5);
    EXPECT_EQ(atSomeRows(direction(slow), 4000)->rows(), 4000);
    EXPECT_EQ(atSomeRows(direction(slow), n)->rows(), n);
    EXPECT_NEAR(alike(direction(slow), direction(slow + 0.1 * other)), 1 / std::hypot(1, 0.1), 1e-4);
    EXPECT_NEAR(alike(direction(slow), direction(other)), 0, 0.01);
    // every fifth row would show a wave of 4 003 periods as one of 3
    EXPECT_NEAR(alike(direction(slow), direction(wave(n, 4003))), 0, 0.05);
}

TEST(NoiseThreshold, GrowsWithTheNumberOfUnlikeCandidates) {
    const int n = 400;
    std::vector<SharedColumns> alike, unlike;
    for (int k = 0; k < 50; ++k) {
        alike.push_back(Eigen::MatrixXd(gaussian(n, 7).normalized()));
        unlike.push_back(Eigen::MatrixXd(gaussian(n, 100 + static_cast<std::uint64_t>(k)).normalized()));
    }
    const double one = noiseThreshold(alike, 0, 0.99, 1);
    EXPECT_NEAR(one, 6.63, 1.0);  // chi-square with one degree of freedom at 99 %
    EXPECT_GT(noiseThreshold(unlike, 0, 0.99, 1), one + 4);
}

/// Twenty candidates that share seven tenths of what they do: the quantile of the largest square, drawn directly.
TEST(NoiseThreshold, CountsWhatAlikeCandidatesDoNotShare) {
    constexpr int count = 20, draws = 20000;
    const double shared = std::sqrt(0.7), own = std::sqrt(0.3);
    std::vector<SharedColumns> alike;
    for (int k = 0; k < count; ++k) {
        Eigen::VectorXd column = Eigen::VectorXd::Zero(count + 1);
        column[0] = shared;
        column[1 + k] = own;
        alike.push_back(Eigen::MatrixXd(column));
    }
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::vector<double> largest;
    for (int i = 0; i < draws; ++i) {
        const double common = shared * normal(random);
        double most = 0;
        for (int k = 0; k < count; ++k) most = std::max(most, std::pow(common + own * normal(random), 2));
        largest.push_back(most);
    }
    std::sort(largest.begin(), largest.end());
    EXPECT_NEAR(noiseThreshold(alike, 0, 0.99, 1), largest[static_cast<std::size_t>(0.99 * draws)], 0.8);
}

TEST(ExplainedTogether, TakesDirectionsOfNearlyOneForOne) {
    const auto explained = [](double correlation) {
        ColumnScore a, b;
        a.directions = Eigen::MatrixXd{{1}, {0}};
        b.directions = Eigen::MatrixXd{{correlation}, {std::sqrt(1 - correlation * correlation)}};
        a.along = Eigen::VectorXd{{1}};
        b.along = Eigen::VectorXd{{-1}};
        return explainedTogether(a, b);
    };
    EXPECT_GT(explained(1 - 2e-4), 5000) << "2/(1 - correlation)";
    EXPECT_LT(explained(1 - 5e-5), 1) << "what tells them apart is not in the data";
}

}  // namespace
}  // namespace analogon
