#include "core/effect/model/null_model.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/hand_made.hpp"
#include "tests/core/effect/heated_runs.hpp"

namespace analogon {
namespace {

TEST(NullModel, HasStepsForWhatIsNotLinearBesideALinearModel) {
    const NullModel null = HeatedRuns::fitted(1);
    ASSERT_EQ(null.fit.plans.size(), 1u);
    EXPECT_EQ(null.fit.plans[0].method, GridMethod::Exact);
    const StepsBeside& steps = null.steps({}, {});
    EXPECT_EQ(&steps, &null.steps({}, {})) << "found once";
    EXPECT_EQ(steps.states.size(), 1u);
    EXPECT_EQ(steps.fine[0].method, GridMethod::RungeKutta4);
    EXPECT_EQ(steps.coarse[0].method, GridMethod::RungeKutta4);
    const Outcome<PreparedTask> linear = prepareHeld(null.variant, {}, null.noise);
    ASSERT_TRUE(linear) << format(linear.diagnostics());
    EXPECT_EQ(null.plansOf(*linear->system, {}, {})[0].method, GridMethod::Exact);
    Variant radiating = null.variant;
    const auto text = R"(model Radiating
  extends Body;
  Analogon.Effects.Thermal.Radiation more(k_r=1e-10);
equation
  connect(body.port, more.port);
end Radiating;
)";
    Outcome<Library> library = radiating.task.library.withSource(std::make_shared<Source>("radiating.mo", text));
    ASSERT_TRUE(library) << format(library.diagnostics());
    radiating.task.library = std::move(*library);
    radiating.task.className = "Radiating";
    const Outcome<PreparedTask> bent = prepareHeld(radiating, {}, null.noise);
    ASSERT_TRUE(bent) << format(bent.diagnostics());
    EXPECT_TRUE(null.plansOf(*bent->system, {}, {})[0] == steps.fine[0]);
}

TEST(NullModel, ObservesWhatIsSwitchedOffAlongItsOwnStates) {
    const NullModel null = HeatedRuns::fitted(2);
    const Outcome<PreparedTask> held = prepareHeld(null.variant, {}, null.noise);
    ASSERT_TRUE(held) << format(held.diagnostics());
    const std::vector<Trajectory> seen = observe(null, *held, {"joint.Q_flow", "body.T"}, {});
    ASSERT_EQ(seen.size(), 2u);
    for (std::size_t e = 0; e < seen.size(); ++e) {
        SimulationTask task = taskOf(held->problem.experiments[e]);
        task.observe = {"joint.Q_flow", "body.T"};
        const Trajectory run = simulateGrid(task, null.fit.plans[e]);
        ASSERT_EQ(seen[e].observed.rows(), 2);
        EXPECT_LT((seen[e].observed - run.observed).cwiseAbs().maxCoeff(), 1e-9);
        EXPECT_TRUE(seen[e].outputs.size() == 0) << "nothing was simulated for it";
    }
}

TEST(NullModel, WithAnotherFitKnowsNothingOfTheFirst) {
    const NullModel null = HeatedRuns::fitted(1);
    const ScoresBeside& scores = null.scores();
    EXPECT_EQ(&scores, &null.scores()) << "found once";
    FitResult moved = null.fit;
    moved.optimum.residuals *= 2;
    const NullModel other = null.with(null.variant, moved);
    EXPECT_LT((other.scores().whiteResidual - 2 * scores.whiteResidual).norm(), 1e-9 * scores.whiteResidual.norm());
    EXPECT_EQ(other.noise, null.noise);
}

NullModel measuredInSteps(const Eigen::VectorXd& residuals, double step, int levels) {
    NullModel null = modelThatLeaves(residuals, Eigen::MatrixXd::Zero(residuals.size(), 0));
    Eigen::VectorXd& measured = null.channels.front().measured;
    for (Eigen::Index k = 0; k < measured.size(); ++k) measured[k] = step * static_cast<double>(k % (levels + 1));
    return null;
}

TEST(IsNoise, IsOnlyWhatChanceWouldLeaveOnceInTenThousandChannels) {
    const Eigen::VectorXd white = whiteNoise(400);
    const auto withWave = [&](double amplitude) {
        return modelThatLeaves(white + amplitude * sineWave(400, 5), Eigen::MatrixXd::Zero(400, 0));
    };
    EXPECT_TRUE(isNoise(withWave(0)));
    EXPECT_FALSE(isNoise(withWave(1)));
    double p = 1, amplitude = 0;  // a wave that chance hardly brings
    for (; p > 7e-5; amplitude += 0.005) p = summarise(withWave(amplitude).fit.optimum.residuals).whiteProbability;
    ASSERT_GT(p, 4e-5) << "between a third of the limit and the limit";
    EXPECT_FALSE(isNoise(withWave(amplitude - 0.005)));
    for (p = 1, amplitude = 0; p > 2.5e-4; amplitude += 0.005)
        p = summarise(withWave(amplitude).fit.optimum.residuals).whiteProbability;
    ASSERT_GT(p, 1.3e-4) << "between the limit and three times the limit";
    EXPECT_TRUE(isNoise(withWave(amplitude - 0.005)));
}

TEST(IsNoise, IsWhatAConverterRoundsOffWhereTheSignalPassesManySteps) {
    constexpr double step = 3;
    const Eigen::VectorXd slow = 0.25 * step * sineWave(400, 4);
    EXPECT_TRUE(isNoise(measuredInSteps(slow, step, 12)));
    EXPECT_FALSE(isNoise(measuredInSteps(slow, step, 4))) << "a few steps may be a signal of a few values";
}

TEST(IndependentShare, IsSmallBesideMuchThatNothingExplains) {
    const Eigen::VectorXd white = whiteNoise(4000);
    const auto shareBeside = [&](double factor) {
        const NullModel null = modelThatLeaves(factor * white, Eigen::MatrixXd::Zero(4000, 0));
        return independentShare(null, null.fit);
    };
    EXPECT_GT(shareBeside(1), 0.9);
    EXPECT_NEAR(shareBeside(2), 10 / (0.03 * 4000), 1e-9) << "3 % of it would not count as different";
}

}  // namespace
}  // namespace analogon
