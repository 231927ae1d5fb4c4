#include "core/effect/model/thin.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/effect/text_task.hpp"

namespace analogon {
namespace {

Recording counting(int samples, Role role = Role::Fit) {
    Recording r = blankRecording("run", {"u", "command"}, {"y"}, samples);
    r.role = role;
    r.held = {"command"};
    SpareChannel spare{"room", "K", {}};
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(0.5 * k);
        r.inputs(0, k) = k;
        r.inputs(1, k) = k < 4 ? 0 : 8;
        r.outputs(0, k) = 10 * k;
        spare.values.push_back(100 + k);
    }
    r.spares = {spare};
    return r;
}

TEST(Thinned, TakesMeansBehindTheFirstSample) {
    EstimationTask task;
    task.recordings = {counting(8)};
    const EstimationTask shorter = thinned(task, {3});
    const Recording& r = shorter.recordings.front();
    EXPECT_EQ(r.time, (std::vector<double>{0, 1.5, 3})) << "all steps are as long";
    EXPECT_EQ(r.inputs.row(0), (Eigen::RowVector3d(0, 3, 6)));
    EXPECT_EQ(r.outputs.row(0), (Eigen::RowVector3d(0, 30, 60)));
    EXPECT_EQ(r.spares.front().values, (std::vector<double>{100, 103, 106}));
}

TEST(Thinned, LeavesOutWhatWasNotMeasured) {
    EstimationTask task;
    task.recordings = {counting(8)};
    Eigen::MatrixXd& y = task.recordings.edit().front().outputs;
    y(0, 3) = y(0, 5) = y(0, 6) = y(0, 7) = std::nan("");
    const EstimationTask shorter = thinned(task, {3});
    const Recording& r = shorter.recordings.front();
    EXPECT_EQ(r.outputs(0, 1), 30) << "of 20 and 40";
    EXPECT_TRUE(std::isnan(r.outputs(0, 2)));
}

/// A held input moves the plant by what it is between the new samples: 0 for half of the time, 8 for the other.
TEST(Thinned, TakesTheMeanOfAHeldInputOverTheTimeThatItIsHeldFor) {
    EstimationTask task;
    task.recordings = {counting(8)};
    const EstimationTask shorter = thinned(task, {3});
    EXPECT_NEAR(shorter.recordings.front().inputs(1, 1), 8 * 1.0 / 1.5, 1e-12);
}

TEST(Thinned, LeavesAloneWhatOnlyValidates) {
    EstimationTask task;
    task.recordings = {counting(8), counting(8, Role::Validate)};
    const EstimationTask shorter = thinned(task, {3});
    EXPECT_EQ(shorter.recordings[0].time.size(), 3u);
    EXPECT_EQ(shorter.recordings[1].time.size(), 8u);
    EXPECT_EQ(thinned(task, {}).recordings[0].time.size(), 8u);
}

TEST(ThinningFor, BringsAllFittedRecordingsTogetherUnderTheLimit) {
    EstimationTask task;
    task.recordings = {counting(60), counting(41), counting(1000, Role::Validate)};
    EXPECT_TRUE(thinningFor(task, 101).isWhole());
    EXPECT_EQ(thinningFor(task, 100).factor, 3) << "an even raster stays even";
    EXPECT_EQ(thinningFor(task, 50).factor, 3);
}

TEST(Finer, IsAThirdOfTheMeansOfTheFirstPart) {
    EXPECT_EQ(finer({17}).factor, 5);
    EXPECT_EQ(finer({5}).factor, 1);
    EXPECT_EQ(finer({3}).factor, 1);
    EXPECT_TRUE(finer({3}).isFirstPart);
    EXPECT_FALSE(finer({3}).isWhole());
}

TEST(Thinned, KeepsTheFirstPartOfEachRecording) {
    EstimationTask task;
    task.recordings = {counting(300), counting(100), counting(1000, Role::Validate)};
    const EstimationTask part = thinned(task, {1, true}, 40);
    EXPECT_EQ(part.recordings[0].time.size(), 30u);
    EXPECT_EQ(part.recordings[0].outputs(0, 29), 290);
    EXPECT_EQ(part.recordings[0].spares.front().values.size(), 30u);
    EXPECT_EQ(part.recordings[1].inputs.cols(), 10);
    EXPECT_EQ(part.recordings[2].time.size(), 1000u);
    const EstimationTask means = thinned(task, {3, true}, 40);
    EXPECT_EQ(means.recordings[0].time.size(), 30u);
    EXPECT_EQ(means.recordings[0].time[1], 1.5);
    EXPECT_EQ(thinned(task, {3, true}, 1000).recordings[0].time.size(), 100u) << "there are no more";
}

}  // namespace
}  // namespace analogon
