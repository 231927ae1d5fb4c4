#include "core/effect/model/sampling.hpp"

#include <gtest/gtest.h>

#include "core/effect/model/thin.hpp"
#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

EstimationTask sampledAt(std::vector<double> time) {
    EstimationTask task;
    Recording r = warmBodyRecording("run", static_cast<int>(time.size()));
    for (std::size_t k = 0; k < time.size(); ++k) {
        r.inputs(0, static_cast<Eigen::Index>(k)) = static_cast<double>(k);
        r.outputs(0, static_cast<Eigen::Index>(k)) = 2 * static_cast<double>(k);
    }
    r.time = std::move(time);
    task.recordings = {r};
    return task;
}

TEST(SamplingInterval, IsTheMedianOfTheFittedRecordings) {
    EXPECT_DOUBLE_EQ(samplingInterval(sampledAt({0, 1, 2, 3, 100})), 1);
    EstimationTask checked = sampledAt({0, 1, 2});
    checked.recordings.edit().front().role = Role::Validate;
    EXPECT_EQ(samplingInterval(checked), 0) << "nothing is fitted";
}

TEST(Thinned, IsTheMeanOfNeighboursBehindTheFirstSample) {
    const EstimationTask thin = thinned(sampledAt({0, 1, 2, 3, 4, 5, 6}), 3);
    const Recording& r = thin.recordings.front();
    ASSERT_EQ(r.time.size(), 3u);
    EXPECT_DOUBLE_EQ(r.time[0], 0);
    EXPECT_DOUBLE_EQ(r.time[1], 2);
    EXPECT_DOUBLE_EQ(r.inputs(0, 1), 2);
    EXPECT_DOUBLE_EQ(r.outputs(0, 2), 10);
}

TEST(Thinned, ByAsMuchAsBringsAllTogetherUnderALimit) {
    const EstimationTask task = sampledAt({0, 1, 2, 3, 4, 5, 6});
    EXPECT_EQ(thinningFor(task, 7), 1);
    EXPECT_GE(thinningFor(task, 3), 2);
}

}  // namespace
}  // namespace analogon
