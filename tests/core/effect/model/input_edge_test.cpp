#include "core/effect/model/input_edge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace analogon {
namespace {

EstimationTask taskOf(const Eigen::VectorXd& input) {
    Recording r;
    r.name = "run";
    r.inputNames = {"u"};
    r.outputNames = {"y"};
    r.inputs = input.transpose();
    r.outputs = input.transpose();
    for (Eigen::Index k = 0; k < input.size(); ++k) r.time.push_back(2 * static_cast<double>(k));
    r.spares = {{"flow", "1", r.time}};
    EstimationTask task;
    task.recordings = {r};
    return task;
}

Eigen::VectorXd stairs() {
    Eigen::VectorXd u(40);
    for (int k = 0; k < 40; ++k) u[k] = 3.0 * (k / 10 % 2) + (k < 20 ? 0.02 * k : 0.4);
    return u;
}

TEST(InputEdges, AreWhereAnInputJumpsBetweenTwoSamples) {
    const std::vector<InputEdge> edges = inputEdges(taskOf(stairs()));
    ASSERT_EQ(edges.size(), 3u);
    for (const InputEdge& e : edges) {
        EXPECT_EQ(e.sample % 10, 9);
        EXPECT_EQ(e.bend, 0);
    }
    Eigen::VectorXd slow(40);
    for (int k = 0; k < 40; ++k) slow[k] = std::sin(0.1 * k);
    EXPECT_TRUE(inputEdges(taskOf(slow)).empty());
}

TEST(InputEdges, AreBendsWhereARampIsSampledTooSlowly) {
    Eigen::VectorXd u(40);
    for (int k = 0; k < 40; ++k) u[k] = std::clamp(k - 19.5, 0.0, 2.0);
    const std::vector<InputEdge> edges = inputEdges(taskOf(u));
    ASSERT_FALSE(edges.empty());
    for (const InputEdge& e : edges) {
        EXPECT_GT(e.bend, 0);
        EXPECT_GE(e.sample, 19);
        EXPECT_LE(e.sample, 21);
    }
}

TEST(InputEdges, AreNoneWhereTheChangeIsSmallAgainstTheRange) {
    const auto countWithStep = [](double step) {
        Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(40, 0, 0.9);
        u.tail(20).array() += 9;
        u.tail(5).array() += step * 10;
        return inputEdges(taskOf(u)).size();
    };
    EXPECT_EQ(countWithStep(0.06), 2u) << "of the range";
    EXPECT_EQ(countWithStep(0.02), 1u) << "less than a thirtieth of it is none";
}

TEST(InputEdges, StandWhereTheIntervalsBesideThemHardlyMove) {
    const auto isJump = [](double slope) {
        Eigen::VectorXd u = slope * Eigen::VectorXd::LinSpaced(40, 0, 39);
        u.tail(20).array() += 1;
        const std::vector<InputEdge> edges = inputEdges(taskOf(u));
        return !edges.empty() && edges.front().bend == 0;
    };
    EXPECT_TRUE(isJump(0.06));
    EXPECT_FALSE(isJump(0.15)) << "that may be a ramp between two samples";
}

TEST(InputEdges, OfALongRecordAreFewOfAShortOneMany) {
    const auto countOf = [](int samples) {
        Eigen::VectorXd u(samples);
        for (int k = 0; k < samples; ++k) u[k] = k / 10 % 2;
        return inputEdges(taskOf(u)).size();
    };
    EXPECT_EQ(countOf(1'000), 60u);
    EXPECT_EQ(countOf(200'000), 8u) << "each costs as much as the record is long";
}

TEST(InputEdges, AreHeldWhereAllJumpNearTheNextSample) {
    EXPECT_TRUE(areHeld({{0, "u", 9, 0.85}, {0, "u", 19, 0.95}}));
    EXPECT_FALSE(areHeld({{0, "u", 9, 0.7}, {0, "u", 19, 0.95}}));
    InputEdge bend{0, "u", 9, 0.95};
    bend.bend = 1;
    EXPECT_FALSE(areHeld({bend}));
}

TEST(InputEdges, AreDrawnByMoreSamplesWithoutMeasurements) {
    EstimationTask task = taskOf(stairs());
    const Recording before = task.recordings[0];
    place(task, {{0, "u", 9, 0.25}});
    const Recording& r = task.recordings[0];
    ASSERT_EQ(r.time.size(), 42u);
    EXPECT_NEAR(r.time[10], 18.5, 1e-3);
    EXPECT_NEAR(r.time[11], 18.5, 1e-3);
    EXPECT_LT(r.time[10], r.time[11]);
    EXPECT_EQ(r.inputs(0, 10), before.inputs(0, 9));
    EXPECT_EQ(r.inputs(0, 11), before.inputs(0, 10));
    EXPECT_TRUE(std::isnan(r.outputs(0, 10)) && std::isnan(r.outputs(0, 11)));
    EXPECT_EQ(r.outputs(0, 12), before.outputs(0, 10));
    EXPECT_NEAR(r.spares[0].values[10], 18.5, 1e-3);
}

TEST(InputEdges, OfTwoInputsAddAsManySamplesWhereverTheyAre) {
    EstimationTask task = taskOf(stairs());
    task.recordings.edit()[0].inputNames.push_back("v");
    task.recordings.edit()[0].inputs.conservativeResize(2, Eigen::NoChange);
    task.recordings.edit()[0].inputs.row(1) = 2 * task.recordings[0].inputs.row(0);
    for (const double part : {0.2, 0.5, 0.50001, 0.8}) {
        EstimationTask drawn = task;
        place(drawn, {{0, "u", 9, 0.5}, {0, "v", 9, part}});
        const Recording& r = drawn.recordings[0];
        ASSERT_EQ(r.time.size(), 44u) << part;
        for (std::size_t k = 1; k < r.time.size(); ++k) EXPECT_LT(r.time[k - 1], r.time[k]) << part;
    }
}

}  // namespace
}  // namespace analogon
