#include "core/effect/judge/remainder.hpp"

#include <cmath>
#include <random>

#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

constexpr double interval = 0.5;

double steady(double) { return 4; }
double changing(double t) { return std::fmod(t, 300) < 130 ? 4 + std::sin(0.05 * t) : 1 + 0.5 * std::cos(0.11 * t); }

double even(int) { return 1; }
double inBursts(int k) { return k / 250 % 3 == 1 ? 5 : 1; }

struct Run {
    double (*strength)(int) = even;      // of the noise at each sample
    double (*power)(double) = changing;  // that heats the body
    int rows{3000};
};

/// What the body leaves whose sensor has noise, which forgets in `memory` samples, and an error of its own.
template <class Error>
Leftovers left(unsigned seed, double memory, Error error, const Run& told = {}) {
    const auto [strength, power, rows] = told;
    FitParameter capacity, joint;
    capacity.name = "body.C", joint.name = "joint.G";
    capacity.start = 4, capacity.min = 0.1, capacity.max = 100;
    joint.start = 0.2, joint.min = 0.001, joint.max = 10;
    EstimationTask task = warmBody({capacity, joint});
    Recording run = warmBodyRecording("run", rows);
    std::mt19937 random(seed);
    std::normal_distribution<double> scatter;
    const double kept = std::exp(-1 / memory);
    double T = 300, noise = scatter(random);
    for (int k = 0; k < rows; ++k) {
        run.time.push_back(k * interval);
        run.inputs(0, k) = power(k * interval);
        run.outputs(0, k) = T + error(T) + 0.2 * strength(k) * noise;
        noise = kept * noise + std::sqrt(1 - kept * kept) * scatter(random);
        constexpr int inner = 50;
        for (int m = 0; m < inner; ++m) {
            const double a = (m + 0.5) / inner;
            const double P = (1 - a) * power(k * interval) + a * power((k + 1) * interval);
            T += interval / inner * (P - 0.25 * (T - 300)) / 5;
        }
    }
    task.recordings.push_back(std::move(run));
    const Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, {}, {});
    EXPECT_TRUE(null) << format(null.diagnostics());
    return null ? leftovers(*null, {}) : Leftovers();
}

TEST(Leftovers, TakeSlowNoiseForNoise) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const Leftovers found = left(seed, 40, [](double) { return 0.0; });
        EXPECT_TRUE(found.structure.empty()) << "seed " << seed;
        ASSERT_EQ(found.noise.size(), 1u) << "seed " << seed;
        EXPECT_EQ(found.noise.front().output, "T");
    }
}

TEST(Leftovers, TakeNoiseThatComesAndGoesForNoise) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const Leftovers found = left(seed, 0.1, [](double) { return 0.0; }, {inBursts});
        EXPECT_TRUE(found.structure.empty()) << "seed " << seed;
    }
}

TEST(Leftovers, FindWhatMovesWithTheModelInNoiseThatComesAndGoes) {
    const Leftovers found = left(1, 0.1, [](double T) { return 0.02 * std::pow(T - 310, 2); }, {inBursts});
    ASSERT_EQ(found.structure.size(), 1u);
    EXPECT_TRUE(found.uneven.empty());
}

TEST(Leftovers, FindWhatMovesWithTheModelInSlowNoise) {
    const Leftovers found = left(1, 20, [](double T) { return 0.01 * std::pow(T - 310, 2); });
    ASSERT_EQ(found.structure.size(), 1u);
    EXPECT_EQ(found.structure.front().output, "T");
    EXPECT_TRUE(found.noise.empty());
}

TEST(Leftovers, TellWhatTheyMoveWithMostFirst) {
    const Leftovers found = left(1, 0.1, [](double T) { return 0.02 * std::pow(T - 310, 2); });
    ASSERT_EQ(found.structure.size(), 1u);
    const std::vector<Correlate>& movesWith = found.structure.front().movesWith;
    ASSERT_GE(movesWith.size(), 1u);
    EXPECT_FALSE(movesWith.front().variable.empty());
    for (std::size_t i = 1; i < movesWith.size(); ++i)
        EXPECT_LE(std::abs(movesWith[i].correlation), std::abs(movesWith[i - 1].correlation));
}

TEST(Leftovers, FindStructureWhereTheInputStandsStill) {
    const Leftovers found = left(1, 0.1, [](double T) { return 2 * std::sin(T - 300); }, {even, steady});
    ASSERT_EQ(found.structure.size(), 1u) << "a body that is heated evenly moves as well";
    EXPECT_TRUE(found.noise.empty());
    const Leftovers noise = left(1, 0.1, [](double) { return 0.0; }, {even, steady});
    EXPECT_TRUE(noise.structure.empty());
}

TEST(Leftovers, FindStructureInFewerSamplesThanTellWhatItMovesWith) {
    const auto bent = [](double T) { return 5 * std::sin(2 * (T - 300)); };
    const Leftovers found = left(1, 0.1, bent, {even, changing, 20});
    ASSERT_EQ(found.structure.size(), 1u);
    EXPECT_TRUE(found.structure.front().movesWith.empty());
    int judged = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const auto none = [](double) { return 0.0; };
        judged += left(seed, 0.1, none, {even, changing, 20}).structure.empty();
    }
    EXPECT_EQ(judged, 20) << "white noise is noise";
}

}  // namespace
}  // namespace analogon
