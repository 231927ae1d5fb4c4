#include "core/effect/reading/input_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/effect/noisy_command.hpp"

namespace analogon {
namespace {

using namespace noisy_command;

EstimationTask taskOf(const Eigen::VectorXd& input) {
    Recording r;
    r.name = "run";
    r.inputNames = {"u"};
    r.inputs = input.transpose();
    EstimationTask task;
    task.recordings = {r};
    return task;
}

TEST(InputNoise, IsTakenOutBetweenTheSteps) {
    const Eigen::VectorXd told = command(), error = noise(0.05);
    EstimationTask task = taskOf(told + error);
    const std::vector<NoisyInput> found = quieten(task);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].name, "u");
    EXPECT_NEAR(found[0].deviation, 0.05, 0.01);
    const Eigen::VectorXd left = task.recordings[0].inputs.row(0).transpose() - told;
    EXPECT_LT(left.norm(), 0.5 * error.norm());
    EXPECT_LT(left.cwiseAbs().maxCoeff(), 0.25) << "no step is rounded off";
}

TEST(InputNoise, LeavesValidationAndCleanInputsAlone) {
    EstimationTask clean = taskOf(command()), other = taskOf(command() + noise(0.05));
    other.recordings.edit()[0].role = Role::Validate;
    EXPECT_TRUE(quieten(clean).empty());
    EXPECT_TRUE(quieten(other).empty());
    EXPECT_EQ(clean.recordings[0].inputs.row(0).transpose(), command());
}

}  // namespace
}  // namespace analogon
