#include "core/effect/model/evidence.hpp"

#include <gtest/gtest.h>

#include <random>

namespace analogon {
namespace {

constexpr int samples = 400;

/// A model without parameters, its input switched every 40 samples; what it leaves is white but for so much at the
/// samples that lie `behind` each switch.
NullModel leaving(double extra, int behind) {
    NullModel null;
    Recording r;
    r.name = "run";
    r.inputNames = {"u"};
    r.outputNames = {"y"};
    r.inputs = Eigen::MatrixXd::Zero(1, samples);
    r.outputs = Eigen::MatrixXd::Zero(1, samples);
    ResidualChannel channel;
    channel.end = samples;
    std::mt19937 random(4);
    std::normal_distribution<double> noise;
    Eigen::VectorXd residuals(samples);
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(k);
        r.inputs(0, k) = k / 40 % 2;
        channel.samples.push_back(k);
        residuals[k] = noise(random) + (k >= 40 && k % 40 == behind ? extra : 0);
    }
    channel.measured = Eigen::VectorXd::Zero(samples);
    null.variant.task.recordings = {r};
    null.channels = {channel};
    null.fit.optimum.residuals = residuals;
    null.fit.optimum.jacobian = Eigen::MatrixXd::Zero(samples, 0);
    return null;
}

Acceptance examined(double extra, int behind) { return examine(leaving(extra, behind), leaving(0, 0).fit, 1, 0); }

TEST(Examine, DoubtsWeakEvidenceThatLiesRightBehindJumpsOfAnInputAlone) {
    EXPECT_GT(examined(2.5, 20).evidence, 20);
    EXPECT_LT(examined(2.5, 20).evidence, 100);
    EXPECT_TRUE(examined(2.5, 20).isSignificant) << "far behind the jumps";
    EXPECT_FALSE(examined(2.5, 1).isSignificant) << "how the input ran there is not known";
    EXPECT_TRUE(examined(6, 1).isSignificant) << "too much for that";
}

}  // namespace
}  // namespace analogon
