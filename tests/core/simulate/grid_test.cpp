#include "core/simulate/grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/simulate/step_method.hpp"
#include "tests/core/simulate/hand_dynamics.hpp"

namespace analogon {
namespace {

using std::exp;
using std::sin;
using std::sqrt;
using std::tanh;
using test::HandDynamics;

SampledInputs sampled(int count, double step, const std::function<double(double)>& u) {
    SampledInputs inputs;
    inputs.values.resize(1, count);
    for (int k = 0; k < count; ++k) {
        inputs.time.push_back(k * step);
        inputs.values(0, k) = u(k * step);
    }
    return inputs;
}

GridRun plan(GridMethod method, int substeps) {
    GridRun run;
    run.plan = {method, substeps, 0.0};
    return run;
}

/// T x' = k u - x, y = x; parameters T, k, x(0).
struct Lag {
    static constexpr int states = 1, inputs = 1, outputNumber = 1;
    template <class T>
    void start(const T* p, T* x) const {
        x[0] = p[2];
    }
    template <class T>
    void rates(double, const T* x, const T* u, const T* p, T* xdot) const {
        xdot[0] = (p[1] * u[0] - x[0]) / p[0];
    }
    template <class T>
    void outputs(double, const T* x, const T*, const T*, T* y) const {
        y[0] = x[0];
    }
};

/// Response to the ramp u = r t from x(0).
double lagRamp(double t, double T, double k, double x0, double r) {
    return k * r * (t - T + T * std::exp(-t / T)) + x0 * std::exp(-t / T);
}

/// Van der Pol's oscillator, x1'' = mu (1 - x1^2) x1' - x1 + u.
struct VanDerPol {
    static constexpr int states = 2, inputs = 1, outputNumber = 2;
    template <class T>
    void start(const T* p, T* x) const {
        x[0] = p[1];
        x[1] = T(0.0);
    }
    template <class T>
    void rates(double, const T* x, const T* u, const T* p, T* xdot) const {
        xdot[0] = x[1];
        xdot[1] = p[0] * (T(1.0) - x[0] * x[0]) * x[1] - x[0] + u[0];
    }
    template <class T>
    void outputs(double, const T* x, const T*, const T*, T* y) const {
        y[0] = x[0];
        y[1] = x[0] * x[1];
    }
};

double errorOf(GridMethod method, int substeps) {
    const SampledInputs inputs = sampled(6, 1.0, [](double t) { return 2.0 * t; });
    HandDynamics<Lag> lag({}, {0.8, 3.0, 1.5});
    const Trajectory y = runGrid(lag, inputs, plan(method, substeps));
    EXPECT_FALSE(y.failure.failed);
    double error = 0.0;
    for (int k = 0; k < 6; ++k) error = std::max(error, std::abs(y.outputs(0, k) - lagRamp(k, 0.8, 3.0, 1.5, 2.0)));
    return error;
}

TEST(Grid, RungeKutta4ConvergesWithFourthOrderToTheExactRampResponse) {
    const double order = std::log2(errorOf(GridMethod::RungeKutta4, 16) / errorOf(GridMethod::RungeKutta4, 32));
    EXPECT_NEAR(order, 4.0, 0.2);
}

TEST(Grid, EsdirkConvergesWithThirdOrderToTheExactRampResponse) {
    const double order = std::log2(errorOf(GridMethod::Esdirk, 32) / errorOf(GridMethod::Esdirk, 64));
    EXPECT_NEAR(order, 3.0, 0.2);
}

TEST(Grid, EsdirkTableauMeetsTheOrderConditionsAndIsStifflyAccurate) {
    const Esdirk::Tableau& t = Esdirk::tableau();
    const int s = Esdirk::stages;
    const auto& b = t.a[s - 1];
    double sum = 0, first = 0, second = 0, nested = 0;
    for (int i = 0; i < s; ++i) {
        double row = 0, rowC = 0;
        for (int j = 0; j < s; ++j) {
            row += t.a[i][j];
            rowC += t.a[i][j] * t.c[j];
        }
        EXPECT_NEAR(row, t.c[i], 1e-14);
        sum += b[i];
        first += b[i] * t.c[i];
        second += b[i] * t.c[i] * t.c[i];
        nested += b[i] * rowC;
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_NEAR(first, 0.5, 1e-14);
    EXPECT_NEAR(second, 1.0 / 3.0, 1e-14);
    EXPECT_NEAR(nested, 1.0 / 6.0, 1e-14);
    EXPECT_EQ(t.c[s - 1], 1.0);
}

TEST(Grid, EsdirkDampsAVeryStiffModeAtOnce) {
    const SampledInputs inputs = sampled(5, 1.0, [](double) { return 1.0; });
    HandDynamics<Lag> lag({}, {1e-9, 1.0, 0.0});
    const Trajectory y = runGrid(lag, inputs, plan(GridMethod::Esdirk, 1));
    ASSERT_FALSE(y.failure.failed);
    EXPECT_NEAR(y.outputs(0, 1), 1.0, 1e-6);
    EXPECT_NEAR(y.outputs(0, 4), 1.0, 1e-9);
}

TEST(Grid, EsdirkFollowsTheStiffVanDerPolOscillatorLikeTheAdaptiveEngine) {
    const SampledInputs inputs = sampled(201, 0.1, [](double) { return 0.0; });
    HandDynamics<VanDerPol> model({}, {50.0, 2.0});
    const Trajectory grid = runGrid(model, inputs, plan(GridMethod::Esdirk, 8));
    SimulationOptions tight;
    tight.relativeTolerance = 1e-9;
    tight.absoluteTolerance = 1e-11;
    const Trajectory reference = runAdaptive(model, inputs, false, tight);
    ASSERT_FALSE(grid.failure.failed);
    ASSERT_FALSE(reference.failure.failed);
    EXPECT_LT((grid.outputs - reference.outputs).row(0).cwiseAbs().maxCoeff(), 1e-4);
}

template <class Model>
void expectTangentsOfTheDiscreteSolution(GridMethod method, std::vector<double> p, const SampledInputs& inputs,
                                         int substeps, double tolerance, std::vector<DelayInfo> delays = {},
                                         std::vector<int> delayParameters = {}, int taps = 0) {
    std::vector<int> directions;
    for (std::size_t i = 0; i < p.size(); ++i) directions.push_back(static_cast<int>(i));
    HandDynamics<Model> model({}, p, directions, delays, delayParameters, taps);
    const Trajectory with = runGrid(model, inputs, plan(method, substeps));
    ASSERT_FALSE(with.failure.failed) << with.failure.reason;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double step = 1e-5 * std::max(std::abs(p[i]), 1e-2);
        const auto at = [&](double shift) {
            std::vector<double> moved = p;
            moved[i] += shift;
            HandDynamics<Model> values({}, moved, {}, delays, delayParameters, taps);
            return runGrid(values, inputs, plan(method, substeps)).outputs;
        };
        const Eigen::MatrixXd slope = (at(step) - at(-step)) / (2.0 * step);
        for (Eigen::Index o = 0; o < with.outputs.rows(); ++o) {
            const Eigen::VectorXd tangent =
                with.tangents[static_cast<std::size_t>(o)].col(static_cast<Eigen::Index>(i));
            const double size = std::max(slope.row(o).cwiseAbs().maxCoeff(), 1e-6);
            EXPECT_LT((tangent.transpose() - slope.row(o)).cwiseAbs().maxCoeff() / size, tolerance)
                << "output " << o << ", parameter " << i;
        }
    }
}

TEST(Grid, TangentsAreThoseOfTheDiscreteSolution) {
    const SampledInputs inputs = sampled(81, 0.1, [](double t) { return std::sin(3.0 * t); });
    // Coarse steps: the derivative of the exact solution would be off by far more than this.
    expectTangentsOfTheDiscreteSolution<VanDerPol>(GridMethod::RungeKutta4, {2.0, 1.0}, inputs, 1, 1e-7);
    expectTangentsOfTheDiscreteSolution<VanDerPol>(GridMethod::Esdirk, {2.0, 1.0}, inputs, 1, 1e-6);
    expectTangentsOfTheDiscreteSolution<Lag>(GridMethod::Esdirk, {0.02, 2.0, 0.3}, inputs, 1, 1e-6);
}

/// Rotor with sharp dry friction: J w' = u - b w - tau_c tanh(w / eps); parameters b, tau_c.
struct Friction {
    static constexpr int states = 2, inputs = 1, outputNumber = 1;
    double eps{1e-6};
    template <class T>
    void start(const T*, T* x) const {
        x[0] = x[1] = T(0.0);
    }
    template <class T>
    void rates(double, const T* x, const T* u, const T* p, T* xdot) const {
        xdot[0] = (u[0] - p[0] * x[0] - p[1] * tanh(x[0] / T(eps))) / T(0.01);
        xdot[1] = x[0];
    }
    template <class T>
    void outputs(double, const T* x, const T*, const T*, T* y) const {
        y[0] = x[0];
    }
};

TEST(Grid, EsdirkSticksAndBreaksLooseWithSharpDryFriction) {
    // Slow triangle of torque between -2 and 2 against a dry friction of 1: stuck while |u| < 1.
    const SampledInputs inputs = sampled(2001, 0.002, [](double t) {
        const double phase = std::fmod(t, 2.0);
        return phase < 1.0 ? 4.0 * phase - 2.0 : 6.0 - 4.0 * phase;
    });
    HandDynamics<Friction> model({}, {0.1, 1.0}, {0, 1});
    const Trajectory y = runGrid(model, inputs, plan(GridMethod::Esdirk, 1));
    ASSERT_FALSE(y.failure.failed) << y.failure.reason << " at " << y.failure.time;
    ASSERT_TRUE(y.tangents[0].allFinite());
    int stuck = 0;
    for (int k = 0; k < 2001; ++k) stuck += std::abs(y.outputs(0, k)) < 1e-5;
    EXPECT_GT(stuck, 300);
    EXPECT_GT(y.outputs.maxCoeff(), 5.0);
    HandDynamics<Friction> fine({}, {0.1, 1.0});
    const Trajectory reference = runGrid(fine, inputs, plan(GridMethod::Esdirk, 16));
    EXPECT_LT((y.outputs - reference.outputs).cwiseAbs().maxCoeff(), 1e-2 * y.outputs.maxCoeff());
}

/// y = z(t - T) and a lag fed by u(t - T): z = x + u, x' = -x + u(t - T2); parameters T, T2.
struct Delayed {
    static constexpr int states = 1, inputs = 1, outputNumber = 2;
    template <class T>
    void start(const T*, T* x) const {
        x[0] = T(0.0);
    }
    template <class T>
    void rates(double, const T* x, const T* u, const T*, T* xdot) const {
        xdot[0] = u[2] - x[0];
    }
    template <class T>
    void outputs(double, const T* x, const T* u, const T*, T* y) const {
        y[0] = u[1];  // the delayed tap
        y[1] = x[0];
        y[2] = x[0] + u[0];  // the tap
    }
};
const std::vector<DelayInfo> delays{{-1, 0}, {0, -1}};
const std::vector<int> delayParameters{0, 1};

TEST(Grid, DelaysTakeTheExactPastOfInputsAndSignals) {
    // Ramp u = t: x = ramp response from T2 on, z = x + t.
    const SampledInputs inputs = sampled(101, 0.05, [](double t) { return t; });
    for (double T : {0.0, 0.05, 0.317, 1.0}) {
        const double T2 = 0.4;
        HandDynamics<Delayed> model({}, {T, T2}, {}, delays, delayParameters, 1);
        const Trajectory y = runGrid(model, inputs, plan(GridMethod::RungeKutta4, 2));
        ASSERT_FALSE(y.failure.failed) << y.failure.reason;
        for (int k = 0; k < 101; ++k) {
            const double past = std::max(0.0, inputs.time[static_cast<std::size_t>(k)] - T);
            const double x = past > T2 ? lagRamp(past - T2, 1.0, 1.0, 0.0, 1.0) : 0.0;
            EXPECT_NEAR(y.outputs(0, k), x + past, 1e-6) << "T " << T << " sample " << k;
        }
    }
}

TEST(Grid, DelayTimesHaveTangents) {
    const SampledInputs inputs = sampled(101, 0.05, [](double t) { return std::sin(2.0 * t); });
    expectTangentsOfTheDiscreteSolution<Delayed>(GridMethod::RungeKutta4, {0.3171, 0.2233}, inputs, 2, 2e-3, delays,
                                                 delayParameters, 1);
    expectTangentsOfTheDiscreteSolution<Delayed>(GridMethod::Esdirk, {0.3171, 0.2233}, inputs, 2, 2e-3, delays,
                                                 delayParameters, 1);
}

TEST(Adaptive, DelaysAgreeWithTheGrid) {
    const SampledInputs inputs = sampled(101, 0.05, [](double t) { return std::sin(2.0 * t); });
    HandDynamics<Delayed> model({}, {0.3171, 0.2233}, {0, 1}, delays, delayParameters, 1);
    const Trajectory grid = runGrid(model, inputs, plan(GridMethod::RungeKutta4, 8));
    const Trajectory adaptive = runAdaptive(model, inputs, false);
    ASSERT_FALSE(adaptive.failure.failed) << adaptive.failure.reason;
    EXPECT_LT((grid.outputs - adaptive.outputs).cwiseAbs().maxCoeff(), 1e-4);
    EXPECT_LT((grid.tangents[0] - adaptive.tangents[0]).cwiseAbs().maxCoeff(), 1e-2);
}

TEST(Adaptive, ForwardSensitivitiesAgreeWithTheTangentsOfFineSteps) {
    const SampledInputs inputs = sampled(81, 0.1, [](double t) { return t < 3.0 ? 0.0 : 1.0; });
    HandDynamics<VanDerPol> model({}, {2.0, 1.0}, {0, 1});
    SimulationOptions tight;
    tight.relativeTolerance = 1e-8;
    const Trajectory adaptive = runAdaptive(model, inputs, true, tight);
    const Trajectory grid = runGrid(model, inputs, plan(GridMethod::RungeKutta4, 16));
    ASSERT_FALSE(adaptive.failure.failed) << adaptive.failure.reason;
    EXPECT_LT((grid.outputs - adaptive.outputs).cwiseAbs().maxCoeff(), 1e-5);
    for (std::size_t o = 0; o < 2; ++o) {
        EXPECT_LT((grid.tangents[o] - adaptive.tangents[o]).cwiseAbs().maxCoeff(), 1e-4);
    }
}

/// x' = x^2 from 1: infinite at t = 1.
struct BlowUp {
    static constexpr int states = 1, inputs = 1, outputNumber = 1;
    template <class T>
    void start(const T*, T* x) const {
        x[0] = T(1.0);
    }
    template <class T>
    void rates(double, const T* x, const T*, const T*, T* xdot) const {
        xdot[0] = x[0] * x[0];
    }
    template <class T>
    void outputs(double, const T* x, const T*, const T*, T* y) const {
        y[0] = x[0];
    }
};

TEST(Grid, AFailureSaysWhenAndWhereAndLeavesNaNFromThere) {
    const SampledInputs inputs = sampled(41, 0.1, [](double) { return 0.0; });
    HandDynamics<BlowUp> model({}, {1.0}, {0});
    const Trajectory y = runGrid(model, inputs, plan(GridMethod::RungeKutta4, 4));
    EXPECT_TRUE(y.failure.failed);
    EXPECT_EQ(y.failure.reason, "not finite");
    EXPECT_EQ(y.failure.variable, "x1");
    EXPECT_GT(y.failure.time, 0.9);
    EXPECT_LT(y.failure.time, 2.5);
    EXPECT_NEAR(y.outputs(0, 5), 2.0, 1e-3);
    EXPECT_TRUE(std::isnan(y.outputs(0, 40)));
    EXPECT_TRUE(std::isnan(y.tangents[0](40, 0)));
}

TEST(Adaptive, AFailureSaysWhenAndWhere) {
    const SampledInputs inputs = sampled(41, 0.1, [](double) { return 0.0; });
    HandDynamics<BlowUp> model({}, {1.0});
    SimulationOptions options;
    options.stepLimit = 100000;
    const Trajectory y = runAdaptive(model, inputs, false, options);
    EXPECT_TRUE(y.failure.failed);
    EXPECT_NEAR(y.failure.time, 1.0, 1e-3);
    EXPECT_EQ(y.failure.variable, "x1");
    EXPECT_TRUE(std::isnan(y.outputs(0, 40)));
}

TEST(Grid, StopsWhenAsked) {
    const SampledInputs inputs = sampled(2000, 0.1, [](double) { return 0.0; });
    HandDynamics<Lag> lag({}, {1.0, 1.0, 1.0});
    std::stop_source source;
    source.request_stop();
    const Trajectory y = runGrid(lag, inputs, plan(GridMethod::RungeKutta4, 1), {}, Progress(source.get_token(), {}));
    EXPECT_TRUE(y.failure.failed);
    EXPECT_EQ(y.failure.reason, "cancelled");
    EXPECT_TRUE(y.failure.variable.empty());
}

TEST(Plan, TakesOneExplicitStepWhereTheSignalIsSlowAgainstTheSample) {
    const SampledInputs inputs = sampled(3000, 0.01, [](double t) { return std::sin(t); });
    HandDynamics<Lag> lag({}, {1.0, 1.0, 0.0});
    const GridPlan chosen = choosePlan(lag, inputs);
    EXPECT_EQ(chosen.method, GridMethod::RungeKutta4);
    EXPECT_EQ(chosen.substeps, 1);
    EXPECT_LE(chosen.errorEstimate, 1e-5);
}

TEST(Plan, RefinesUntilTheOutputsStayPut) {
    const SampledInputs inputs = sampled(500, 1.0, [](double t) { return std::sin(0.5 * t); });
    HandDynamics<Lag> lag({}, {0.5, 1.0, 0.0});
    const GridPlan chosen = choosePlan(lag, inputs);
    const Trajectory y = runGrid(lag, inputs, {chosen});
    GridPlan fine = chosen;
    fine.substeps *= 8;
    const Trajectory reference = runGrid(lag, inputs, {fine});
    EXPECT_LT((y.outputs - reference.outputs).cwiseAbs().maxCoeff(), 2.0 * 1.5e-5);
    EXPECT_GT(chosen.substeps, 1);
}

TEST(Plan, TakesTheImplicitMethodWhereTheModelIsStiff) {
    const SampledInputs inputs = sampled(4000, 1.0, [](double t) { return std::sin(0.01 * t); });
    HandDynamics<Lag> lag({}, {1e-4, 1.0, 0.0});
    const GridPlan chosen = choosePlan(lag, inputs);
    EXPECT_EQ(chosen.method, GridMethod::Esdirk);
    EXPECT_EQ(chosen.substeps, 1);
}

TEST(Plan, SeesWhatHappensLateInALongRecord) {
    // Van der Pol's oscillator at rest until it is kicked near the end.
    const SampledInputs inputs =
        sampled(8000, 0.2, [](double t) { return t < 1400.0 ? 0.0 : 3.0 * std::sin(3.0 * t); });
    HandDynamics<VanDerPol> model({}, {3.0, 0.0});
    const GridPlan chosen = choosePlan(model, inputs);
    const Trajectory y = runGrid(model, inputs, {chosen});
    ASSERT_FALSE(y.failure.failed);
    GridPlan fine{GridMethod::RungeKutta4, 64, 0.0};
    const Trajectory reference = runGrid(model, inputs, {fine});
    const double range = reference.outputs.row(0).maxCoeff() - reference.outputs.row(0).minCoeff();
    EXPECT_LT((y.outputs - reference.outputs).row(0).cwiseAbs().maxCoeff() / range, 1e-3);
}

TEST(Plan, UsesForcedMethodAndSubsteps) {
    const SampledInputs inputs = sampled(100, 0.1, [](double t) { return t; });
    HandDynamics<Lag> lag({}, {1.0, 1.0, 0.0});
    SimulationOptions options;
    options.method = GridMethod::Esdirk;
    options.substeps = 3;
    const GridPlan chosen = choosePlan(lag, inputs, options);
    EXPECT_EQ(chosen.method, GridMethod::Esdirk);
    EXPECT_EQ(chosen.substeps, 3);
}

TEST(SampledInputs, TrueKinksAreWhereTheLineIsLeft) {
    SampledInputs inputs = sampled(11, 1.0, [](double t) { return t < 5.0 ? 0.1 * t : 0.5; });
    EXPECT_EQ(trueKinks(inputs), (std::vector<int>{0, 5, 10}));
    inputs.values(0, 8) += 0.1;
    EXPECT_EQ(trueKinks(inputs), (std::vector<int>{0, 5, 7, 8, 9, 10}));
}

}  // namespace
}  // namespace analogon
