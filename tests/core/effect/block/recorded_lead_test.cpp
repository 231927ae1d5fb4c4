#include "core/effect/block/recorded_lead.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/effect/hand_made.hpp"

namespace analogon {
namespace {

constexpr int samples = 200;
constexpr double interval = 0.1;

/// A problem of one output, and the fit of a model that simulates `own` where `measured` was recorded.
struct Recorded {
    FitProblem problem;
    NullModel null;

    Recorded(const Eigen::VectorXd& own, const Eigen::VectorXd& measured, double weight = 1) {
        FitExperiment experiment;
        for (int k = 0; k < samples; ++k) experiment.inputs.time.push_back(interval * k);
        experiment.measured = measured.transpose();
        experiment.weights = Eigen::VectorXd::Constant(1, weight);
        problem.experiments = {experiment};
        Trajectory t;
        t.outputs = own.transpose();
        null.fit.optimum.trajectories = {t};
    }
    std::optional<std::vector<Eigen::VectorXd>> leadOf(const Eigen::VectorXd& simulated) const {
        return recordedLead(null, problem, {simulated});
    }
};

TEST(RecordedLead, IsToldByAnOutputThatIsProportional) {
    const Eigen::VectorXd own = sineWave(samples, 2), ahead = Eigen::VectorXd::Constant(samples, 0.3);
    const std::optional<std::vector<Eigen::VectorXd>> lead = Recorded(own, own + ahead).leadOf(5 * own);
    ASSERT_TRUE(lead);
    EXPECT_NEAR((lead->front() - 5 * ahead).cwiseAbs().maxCoeff(), 0, 1e-9);
}

/// An angle beside a recorded speed: what the speed was more adds up.
TEST(RecordedLead, IsToldByAnOutputThatIsTheRate) {
    Eigen::VectorXd speed(samples), angle(samples);
    for (int k = 0; k < samples; ++k) {
        speed[k] = std::cos(0.5 * interval * k);
        angle[k] = 2 * std::sin(0.5 * interval * k);
    }
    const Eigen::VectorXd more = speed.array() + 0.1;
    const std::optional<std::vector<Eigen::VectorXd>> lead = Recorded(speed, more).leadOf(angle);
    ASSERT_TRUE(lead);
    EXPECT_NEAR(lead->front()[samples - 1], 0.1 * interval * (samples - 1), 1e-2);
}

TEST(RecordedLead, HasTheDifferenceOfTheOneBeforeWhereASampleWasLost) {
    const Eigen::VectorXd own = sineWave(samples, 2);
    Eigen::VectorXd measured = own;
    measured[9] += 0.5;
    measured[10] = std::nan("");
    const std::optional<std::vector<Eigen::VectorXd>> lead = Recorded(own, measured).leadOf(own);
    ASSERT_TRUE(lead);
    EXPECT_NEAR(lead->front()[10], 0.5, 1e-9);
    EXPECT_NEAR(lead->front()[11], 0, 1e-9);
}

TEST(RecordedLead, IsNoneWhereNoOutputTellsIt) {
    const Eigen::VectorXd own = sineWave(samples, 2);
    EXPECT_FALSE(Recorded(own, own).leadOf(sineWave(samples, 3))) << "another course";
    EXPECT_FALSE(Recorded(own, own, 0).leadOf(own)) << "it was not measured";
    EXPECT_FALSE(Recorded(own, own).leadOf(Eigen::VectorXd::Constant(samples, 1))) << "it stands still";
    EXPECT_FALSE(recordedLead(Recorded(own, own).null, {}, {}));
}

}  // namespace
}  // namespace analogon
