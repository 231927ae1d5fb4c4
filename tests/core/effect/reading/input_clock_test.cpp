#include "core/effect/reading/input_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

constexpr int samples = 240;
constexpr double interval = 2;  // [s], a tenth of the body's time constant

TEST(InputClocks, MoveTheColumnOfTheirInputAlone) {
    Recording stamped;
    stamped.time = {0, 1, 2, 3};
    stamped.inputNames = {"u", "v"};
    stamped.inputs.resize(2, 4);
    stamped.inputs << 0, 2, 4, 6, 1, 1, 5, 5;
    // a model with an effect may have an input more
    Recording drawn = stamped;
    drawn.inputNames = {"flow", "u", "v"};
    drawn.inputs.resize(3, 4);
    drawn.inputs << 7, 8, 9, 9, 0, 0, 0, 0, 0, 0, 0, 0;
    std::vector<Recording> recordings{drawn};
    setClocks(recordings, {stamped}, {{"u", 0.5}});
    Eigen::MatrixXd expected(3, 4);
    expected << 7, 8, 9, 9, 1, 3, 5, 6, 1, 1, 5, 5;
    EXPECT_TRUE(recordings[0].inputs.isApprox(expected));
    setClocks(recordings, {stamped}, {});
    EXPECT_TRUE(recordings[0].inputs.bottomRows(2).isApprox(stamped.inputs));
}

double powerAt(double t) { return 2 + std::sin(0.11 * t) + 0.7 * std::sin(0.31 * t + 1) + 0.4 * std::sin(0.73 * t); }

/// The warm body, its power stamped so much late; integrated in steps far below a sample.
EstimationTask recordedLate(double late) {
    EstimationTask task = warmBody({{"body.C", "J/K", 3.5, 1, 10}, {"joint.G", "W/K", 0.25, 0.05, 1}});
    Recording r = warmBodyRecording("run", samples);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 0.02);
    constexpr int inner = 200;
    double temperature = 300;
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(k * interval);
        r.inputs(0, k) = powerAt(k * interval - late);
        r.outputs(0, k) = temperature + noise(random);
        for (int i = 0; i < inner; ++i) {
            const double h = interval / inner, t = k * interval + (i + 0.5) * h;
            const double half = temperature + 0.5 * h * (powerAt(t) - 0.2 * (temperature - 300)) / 4;
            temperature += h * (powerAt(t) - 0.2 * (half - 300)) / 4;
        }
    }
    task.recordings = {r};
    return task;
}

std::vector<InputClock> likeliest(const EstimationTask& task) {
    FitOptions options;
    const Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, options, {});
    EXPECT_TRUE(null) << format(null.diagnostics());
    if (!null) return {};
    std::size_t group = 9;
    const std::vector<std::vector<std::string>> groups = clockGroups(task, task.recordings);
    EXPECT_EQ(groups, std::vector<std::vector<std::string>>{{"P"}});
    std::vector<InputClock> clocks = likeliestClocks(*null, task.recordings, {}, groups, options.simulation, {}, group);
    EXPECT_EQ(group, clocks.empty() ? 9u : 0u);
    return clocks;
}

TEST(LikeliestClocks, AreAsLateAsTheOutputsSay) {
    for (const double late : {0.3 * interval, 1.5 * interval}) {
        const std::vector<InputClock> clocks = likeliest(recordedLate(late));
        ASSERT_EQ(clocks.size(), 1u) << late;
        EXPECT_EQ(clocks[0].input, "P");
        EXPECT_NEAR(clocks[0].late, late, 0.1 * interval) << late;
    }
}

TEST(LikeliestClocks, AreNoneWhereTheInputIsOnTimeOrEarly) {
    for (const double late : {0.0, -interval}) {
        const std::vector<InputClock> clocks = likeliest(recordedLate(late));
        EXPECT_LT(clocks.empty() ? 0 : clocks[0].late, 0.05 * interval) << late;
    }
}

TEST(PickUp, ExplainsMoreThanALateInputOnlyWhereItIsOne) {
    const auto nullOf = [](const EstimationTask& task) {
        Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, FitOptions(), {});
        EXPECT_TRUE(null) << format(null.diagnostics());
        return std::move(*null);
    };
    const auto leftByClocks = [](const NullModel& null, const EstimationTask& task) {
        std::size_t group = 0;
        Variant drawn = null.variant;
        setClocks(drawn.task.recordings.edit(), task.recordings,
                  likeliestClocks(null, task.recordings, {}, {{"P"}}, FitOptions().simulation, {}, group));
        const std::optional<FitResult> fit = fitBeside(null, drawn, FitOptions(), {});
        return fit ? fit->optimum.residuals.squaredNorm() : -1;
    };
    EstimationTask picked = recordedLate(0);
    picked.recordings.edit()[0].outputs += 0.8 * picked.recordings[0].inputs;
    const NullModel pickUp = nullOf(picked);
    EXPECT_GT(explainedByPickUp(pickUp, {{"P", 1}}), pickUp.sumOfSquares() - leftByClocks(pickUp, picked));
    const EstimationTask late = recordedLate(1.5 * interval);
    const NullModel delayed = nullOf(late);
    EXPECT_LT(explainedByPickUp(delayed, {{"P", 1}}), delayed.sumOfSquares() - leftByClocks(delayed, late));
}

TEST(ClockGroups, AreEachInputThatChangesAndAllTogether) {
    EstimationTask task = recordedLate(0);
    Recording& r = task.recordings.edit()[0];
    r.inputNames = {"P", "still", "Q"};
    r.inputs.conservativeResize(3, Eigen::NoChange);
    r.inputs.row(1).setConstant(3);
    r.inputs.row(2) = 2 * r.inputs.row(0);
    EXPECT_EQ(clockGroups(task, task.recordings), (std::vector<std::vector<std::string>>{{"P"}, {"Q"}, {"P", "Q"}}));
}

TEST(ClockGroups, AreSixInputsOneByOneAndAllThatChange) {
    EstimationTask task;
    std::vector<std::string> names;
    for (int i = 0; i < 9; ++i) names.push_back("u" + std::to_string(i));
    Recording r = blankRecording("run", names, {"T"}, 2);
    r.time = {0, 1};
    r.inputs.col(0).setZero();
    r.inputs.col(1).setOnes();
    r.inputs(8, 1) = 0;
    task.recordings = {r};
    const std::vector<std::vector<std::string>> groups = clockGroups(task, task.recordings);
    ASSERT_EQ(groups.size(), 7u);
    EXPECT_EQ(groups[5], std::vector<std::string>{"u5"});
    EXPECT_EQ(groups[6].size(), 8u) << "the ninth stands still";
}

TEST(LatestOf, IsATwentiethOfTheShortestFittedRecording) {
    EstimationTask task;
    Recording one = blankRecording("one", {"u"}, {"T"}, 2), two = one, check = one;
    one.time = {10, 110};
    two.time = {0, 300};
    check.time = {0, 20};
    check.role = Role::Validate;
    task.recordings = {one, two, check};
    EXPECT_NEAR(latestOf(task), 5, 1e-12);
}

TEST(OffsetsFrom, EndBehindTwoThatDoWorse) {
    EXPECT_EQ(offsetsFrom(10, 1, 100, [](double late) { return 10 + late; }).offsets,
              (std::vector<double>{0, 0.25, 0.5}));
    const OffsetsTried tried = offsetsFrom(10, 1, 100, [](double late) { return std::abs(late - 1.5); });
    EXPECT_EQ(tried.offsets, (std::vector<double>{0, 0.25, 0.5, 1, 1.5, 2, 3}));
    EXPECT_EQ(tried.offsets[tried.least], 1.5);
    EXPECT_EQ(offsetsFrom(10, 1, 1, [](double late) { return -late; }).offsets, (std::vector<double>{0, 0.25, 0.5}))
        << "no column is as late as that";
}

}  // namespace
}  // namespace analogon
