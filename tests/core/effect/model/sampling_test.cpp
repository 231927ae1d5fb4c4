#include "core/effect/model/sampling.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace analogon
