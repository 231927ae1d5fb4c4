#include "core/effect/course/dependence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/effect/hand_made.hpp"
#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

constexpr int samples = 400;

/// A model of one parameter that acts all the time, in a recording with one unused channel of these values.
NullModel besideChannel(const Eigen::VectorXd& channel, const Eigen::VectorXd& residuals) {
    NullModel null = modelThatLeaves(residuals, Eigen::MatrixXd::Ones(samples, 1));
    null.variant.task.recordings.edit().front().spares = {
        {"fan", "1", std::vector<double>(channel.data(), channel.data() + channel.size())}};
    return null;
}

TEST(ExplainedByDependence, IsOfAParameterThatMovesWithTheChannel) {
    const Eigen::VectorXd fan = sineWave(samples, 3);
    const Eigen::VectorXd moved = 2 * fan;
    EXPECT_NEAR(explainedByDependence(besideChannel(fan, moved)), moved.squaredNorm(), 1e-6 * moved.squaredNorm());
    EXPECT_LT(explainedByDependence(besideChannel(fan, 2 * sineWave(samples, 5))), 1e-6);
}

TEST(ExplainedByDependence, IsOfNoStartValue) {
    NullModel null = besideChannel(sineWave(samples, 3), 2 * sineWave(samples, 3));
    null.fit.estimates.front().experiment = 0;
    EXPECT_EQ(explainedByDependence(null), 0);
}

TEST(ExplainedByDependence, AsksOfChannelsThatMoveAndThatEveryFittedRecordingHas) {
    EXPECT_EQ(explainedByDependence(besideChannel(Eigen::VectorXd::Constant(samples, 4), sineWave(samples, 3))), 0);
    NullModel lost = besideChannel(sineWave(samples, 3), sineWave(samples, 3));
    lost.variant.task.recordings.edit().front().spares.front().values[7] = std::nan("");
    EXPECT_EQ(explainedByDependence(lost), 0);
    NullModel second = besideChannel(sineWave(samples, 3), sineWave(samples, 3));
    Recording other = second.variant.task.recordings.front();
    other.spares.clear();
    second.variant.task.recordings.push_back(other);
    EXPECT_EQ(explainedByDependence(second), 0);
}

/// A body whose loss grows with a recorded fan: G = 0.2 + 0.1 (fan - 1)/2.
EstimationTask fannedBody() {
    constexpr double step = 0.25;
    EstimationTask task = warmBody({{"joint.G", "W/K", 0.25, 0.01, 10}});
    Recording r = warmBodyRecording("run", samples);
    SpareChannel fan{"fan", "1", {}};
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0, 0.02);
    double T = 300;
    for (int k = 0; k < samples; ++k) {
        const double t = step * k;
        r.time.push_back(t);
        r.inputs(0, k) = 8;
        r.outputs(0, k) = T + noise(random);
        fan.values.push_back(1 + std::sin(0.2 * t));
        for (int i = 0; i < 50; ++i)
            T += step / 50 * (8 - (0.2 + 0.05 * std::sin(0.2 * (t + step * (i + 0.5) / 50))) * (T - 300)) / 4;
    }
    r.spares = {fan};
    task.recordings = {r};
    return task;
}

TEST(BestDependence, IsFittedWithTheParametersOfTheModel) {
    const Outcome<NullModel> null = fitNull({fannedBody(), {}, {}}, {}, NoiseLevel::Estimate, {}, {});
    ASSERT_TRUE(null) << format(null.diagnostics());
    const std::optional<ChannelDependence> best = bestDependence(*null, {}, 1, {});
    ASSERT_TRUE(best);
    EXPECT_EQ(best->parameter, "joint.G");
    EXPECT_EQ(best->channel, "fan");
    EXPECT_NEAR(best->middle, 1, 0.01);
    EXPECT_NEAR(best->range, 2, 0.01);
    EXPECT_NEAR(best->value, 0.2, 0.005);
    EXPECT_NEAR(best->slope, 0.1, 0.005) << "over the range of the channel";
    EXPECT_NEAR(best->explained, null->sumOfSquares() - best->fit.optimum.residuals.squaredNorm(), 1e-6);
    EXPECT_GT(best->explained, 0.5 * null->sumOfSquares());
}

TEST(BestDependence, IsNoneWithoutAnUnusedChannel) {
    EstimationTask task = fannedBody();
    task.recordings.edit().front().spares.clear();
    const Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, {}, {});
    ASSERT_TRUE(null);
    EXPECT_FALSE(bestDependence(*null, {}, 1, {}));
}

}  // namespace
}  // namespace analogon
