#include "core/effect/block/law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/core/effect/block/candidates_of.hpp"
#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

/// A body that loses, beside what its joint passes on, so much with the cube of its temperature over 300 K.
NullModel bodyWithCubicLoss(double factor) {
    constexpr int samples = 400, within = 50;
    constexpr double step = 0.25;
    EstimationTask task = warmBody({{"joint.G", "W/K", 0.3, 0.01, 10}});
    Recording r = warmBodyRecording("warm-up", samples);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 0.02);
    double T = 300;
    for (int k = 0; k < samples; ++k) {
        const double power = k / 100 % 2 == 0 ? 8 : 2;
        r.time.push_back(step * k);
        r.inputs(0, k) = power;
        r.outputs(0, k) = T + noise(random);
        const double next = (k + 1) / 100 % 2 == 0 ? 8 : 2;
        for (int i = 0; i < within; ++i) {
            const double part = (i + 0.5) / within, over = T - 300;
            T += step / within * ((1 - part) * power + part * next - 0.2 * over - factor * over * over * over) / 4;
        }
    }
    task.recordings = {r};
    return fittedModel(task);
}

TEST(LikelyLaws, AreWrittenForWhatAFlowLacks) {
    const NullModel null = bodyWithCubicLoss(2e-4);
    const std::vector<Law> laws = likelyLaws(null, 7, {}, 1, {});
    ASSERT_FALSE(laws.empty());
    const EffectClass& best = laws.front().candidate.effect;
    EXPECT_EQ(best.kind, "proposal.law");
    EXPECT_EQ(best.className.find("Missing"), 0u);
    EXPECT_NE(best.className.find('8'), std::string::npos) << "numbered on from the seven that are written";
    const auto ofBody = std::find_if(laws.begin(), laws.end(), [](const Law& law) {
        return law.candidate.effect.className.starts_with("MissingHeatFlow");
    });
    ASSERT_TRUE(ofBody != laws.end());
    EXPECT_NE(laws.front().text.find("model " + best.className), std::string::npos);
    EXPECT_LE(laws.size(), 12u) << "eight for flows, half as many for sensors";
}

TEST(LikelyLaws, AreNoneForNoise) { EXPECT_TRUE(likelyLaws(bodyWithCubicLoss(0), 0, {}, 1, {}).empty()); }

/// Quantities x0, x1 …, each a line of its own.
std::vector<LawQuantity> quantities(int count, const std::string& unit, double range) {
    NamedUnits names;
    Series series;
    for (int i = 0; i < count; ++i) {
        names.emplace_back("x" + std::to_string(i), unit);
        series[names.back().first] = {Eigen::VectorXd::LinSpaced(50, 0, range + i)};
    }
    series["own"] = {Eigen::VectorXd::LinSpaced(50, 3, 4)};
    return foreignQuantities(names, series, "own", std::nan(""));
}

TEST(ForeignQuantities, AreTenAtMost) {
    EXPECT_EQ(quantities(10, "V", 1).size(), 10u);
    EXPECT_EQ(quantities(14, "V", 1).size(), 10u);
}

TEST(ForeignQuantities, AreNoAnglesOfShaftsThatTurnOnAndOn) {
    EXPECT_EQ(quantities(1, "rad", 620).size(), 1u) << "of an actuator, before its gear";
    EXPECT_TRUE(quantities(1, "rad", 640).empty());
    EXPECT_EQ(quantities(1, "V", 640).size(), 1u);
}

TEST(ForeignQuantities, AreNoneThatMoveAsThePlacesOwn) {
    const Series series{{"T", {Eigen::VectorXd::LinSpaced(50, 300, 320)}},
                        {"port.T", {Eigen::VectorXd::LinSpaced(50, 300, 320)}},
                        {"v", {Eigen::VectorXd::LinSpaced(50, 0, 12)}}};
    const std::vector<LawQuantity> found =
        foreignQuantities({{"T", "K"}, {"v", "V"}, {"w", "rad/s"}}, series, "port.T", 0);
    ASSERT_EQ(found.size(), 1u) << "there is no series of w";
    EXPECT_EQ(found[0].variable, "v");
}

TEST(ShowsWaves, IsAnAngleThatPassesASixthOfATurn) {
    LawQuantity angle;
    angle.range = {0, 1.03};
    EXPECT_FALSE(showsWaves(angle));
    angle.range = {0, 1.06};
    EXPECT_TRUE(showsWaves(angle));
}

TEST(LikeliestTerms, AreEightOfFlowsAndFourOfSensorsBestFirst) {
    std::vector<LikelyTerms> ofFlows, ofSensors;
    for (std::size_t i = 0; i < 20; ++i) {
        ofFlows.push_back({i, {{0}, 1.0 + static_cast<double>(i)}});
        ofSensors.push_back({100 + i, {{0}, 1.5 + static_cast<double>(i)}});
    }
    const std::vector<LikelyTerms> likely = likeliestTerms(ofFlows, ofSensors);
    ASSERT_EQ(likely.size(), 12u);
    EXPECT_EQ(likely[0].probe, 119u);
    EXPECT_EQ(std::count_if(likely.begin(), likely.end(), [](const LikelyTerms& t) { return t.probe >= 100; }), 4);
    for (std::size_t i = 1; i < likely.size(); ++i) EXPECT_LE(likely[i].set.explained, likely[i - 1].set.explained);
}

}  // namespace
}  // namespace analogon
