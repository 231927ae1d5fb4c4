#include "core/effect/model/null_model.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace analogon
