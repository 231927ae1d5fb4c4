#include "core/effect/disturbance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace analogon {
namespace {

constexpr int rows = 3000, pieces = 100;

/// One channel, and one node whose flow is felt with a delay of first order, as a heat flow by a body.
class OneNode : public testing::Test {
protected:
    OneNode() : disturbance_({channel()}, {{"body.port", true, responses()}}, pieces) {}

    static ResidualChannel channel() {
        ResidualChannel c{0, 0, 0, rows, std::vector<int>(rows)};
        std::iota(c.samples.begin(), c.samples.end(), 0);
        return c;
    }

    static Eigen::VectorXd through(const Eigen::VectorXd& flow) {
        Eigen::VectorXd trace(rows);
        double x = 0;
        for (int k = 0; k < rows; ++k) trace[k] = x += (flow[k] - x) / 60;
        return trace;
    }

    static Eigen::MatrixXd responses() {
        Eigen::MatrixXd columns(rows, pieces + 1);
        for (int j = 0; j <= pieces; ++j) {
            Eigen::VectorXd hat(rows);
            for (int k = 0; k < rows; ++k) hat[k] = std::max(0.0, 1 - std::abs(1.0 * k * pieces / (rows - 1) - j));
            columns.col(j) = through(hat);
        }
        return columns;
    }

    Eigen::VectorXd noise() {
        std::normal_distribution<double> normal;
        Eigen::VectorXd n(rows);
        for (double& x : n) x = normal(random_);
        return n;
    }

    /// A flow that wanders with a correlation time of a fiftieth of the record.
    Eigen::VectorXd wandering() {
        const Eigen::VectorXd white = noise();
        Eigen::VectorXd flow(rows);
        double x = 0;
        for (int k = 0; k < rows; ++k) flow[k] = x += -x / 60 + std::sqrt(2.0 / 60) * white[k];
        return flow;
    }

    /// The model without an effect and the one with it, refitted: its trace is a column of the Jacobian.
    double evidenceOf(const Eigen::VectorXd& trace, const Eigen::VectorXd& residual) const {
        Linearisation without, with;
        without.residuals = residual;
        without.jacobian = Eigen::MatrixXd::Ones(rows, 1);
        with.jacobian.resize(rows, 2);
        with.jacobian << without.jacobian, trace;
        with.residuals = residual - trace * (trace.dot(residual) / trace.squaredNorm());
        return disturbance_.evidence(without, with, 1);
    }

    /// What an effect at the node does that follows from the inputs of the experiment: levels held for a while.
    static Eigen::VectorXd effect() {
        Eigen::VectorXd levels(rows);
        for (int k = 0; k < rows; ++k) levels[k] = (k / 170 * 7) % 5 - 2;
        return through(levels);
    }

    std::mt19937 random_{3};
    Disturbance disturbance_;
};

TEST_F(OneNode, LetsAWeakEffectBeSeenInWhiteNoise) {
    const Eigen::VectorXd trace = effect();
    EXPECT_GT(evidenceOf(trace, noise() + 0.3 * trace), 50);
    EXPECT_LT(evidenceOf(trace, noise()), 0) << "nothing there";
}

TEST_F(OneNode, TakesOverWhatAnEffectOnlyImitates) {
    int imitated = 0;
    for (int run = 0; run < 10; ++run) {
        const Eigen::VectorXd trace = effect(), residual = noise() + 5 * through(wandering());
        const double fall = trace.dot(residual) * trace.dot(residual) / trace.squaredNorm();
        imitated += fall > 100;
        EXPECT_LT(evidenceOf(trace, residual), 15) << "run " << run;
    }
    EXPECT_GT(imitated, 5) << "in white noise it would pass for certain";
}

TEST_F(OneNode, LeavesAnEffectThatStandsOutOfADisturbance) {
    const Eigen::VectorXd trace = effect();
    EXPECT_GT(evidenceOf(trace, noise() + 5 * through(wandering()) + 8 * trace), 30);
}

}  // namespace
}  // namespace analogon
