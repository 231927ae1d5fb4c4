#include "core/simulate/state_jacobian.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "core/simulate/grid.hpp"
#include "tests/core/simulate/text_models.hpp"

namespace analogon {
namespace {

/// A rod of n cells, the first of them heated: tridiagonal, and not linear where its end radiates.
std::string rodText(int n, double stiffness, bool radiates = true) {
    std::string text = "model Rod\n  input Real q;\n  output Real first;\n  output Real last;\n";
    text += fmt::format("  parameter Real g = {};\n  parameter Real c = 2;\n  parameter Real e = 0.1;\n", stiffness);
    std::string equations = "equation\n  first = T1;\n" + fmt::format("  last = T{};\n", n);
    for (int i = 1; i <= n; ++i) {
        text += fmt::format("  Real T{}(start = 3, fixed = true);\n", i);
        equations += fmt::format(
            "  c*der(T{}) = {}{}{};\n", i, i == 1 ? std::string("q") : fmt::format("g*(T{} - T{})", i - 1, i),
            i < n ? fmt::format(" + g*(T{} - T{})", i + 1, i) : std::string(),
            i == n ? fmt::format(" - e*(T{}{})", n, radiates ? "^4 - 81" : " - 3") : std::string());
    }
    return text + equations + "end Rod;\n";
}

SampledInputs heating(int count, double step) {
    SampledInputs inputs;
    inputs.values.resize(1, count);
    for (int k = 0; k < count; ++k) {
        inputs.time.push_back(k * step);
        inputs.values(0, k) = (k / 25) % 2 == 0 ? 4 : -1;
    }
    return inputs;
}

struct Rod {
    explicit Rod(int n, double stiffness = 50, bool radiates = true)
        : system(test::compileText(rodText(n, stiffness, radiates), "Rod", {"g", "c", "e"})),
          inputs(heating(200, 0.1)) {
        task.system = system.get();
        task.inputs = &inputs;
        task.parameters = test::ownParameters(*system);
    }
    void alongAll() { task.directions = Eigen::MatrixXd::Identity(system->parameterCount(), system->parameterCount()); }
    SystemPtr system;
    SampledInputs inputs;
    SimulationTask task;
};

/// The same system with its pattern kept from the integrators.
class Full final : public Dynamics {
public:
    explicit Full(SystemDynamics& inner) : inner_(inner) { shape_ = inner.shape(); }
    bool initialise(double t, const double* u, const double* du, double* x, double* dx) override {
        return inner_.initialise(t, u, du, x, dx);
    }
    bool derivatives(double t, const double* x, const double* u, double* f) override {
        return inner_.derivatives(t, x, u, f);
    }
    bool derivatives(double t, const double* x, const double* dx, const double* u, const double* du, double* f,
                     double* df) override {
        return inner_.derivatives(t, x, dx, u, du, f, df);
    }
    bool jacobian(double t, const double* x, const double* u, double* f, double* j) override {
        return inner_.jacobian(t, x, u, f, j);
    }
    bool linearised(double t, const double* x, const double* u, const double* du, double* f, double* p) override {
        return inner_.linearised(t, x, u, du, f, p);
    }
    bool outputs(double t, const double* x, const double* u, double* y, double* taps) override {
        return inner_.outputs(t, x, u, y, taps);
    }
    bool outputs(double t, const double* x, const double* dx, const double* u, const double* du, double* y, double* dy,
                 double* taps, double* dtaps) override {
        return inner_.outputs(t, x, dx, u, du, y, dy, taps, dtaps);
    }
    void delayTimes(double* times, double* dtimes) override { inner_.delayTimes(times, dtimes); }
    bool roots(double t, const double* x, const double* u, double* r) override { return inner_.roots(t, x, u, r); }
    std::string failure() const override { return inner_.failure(); }

private:
    SystemDynamics& inner_;
};

TEST(StateJacobian, ByPatternIsTheFullOne) {
    Rod rod(20);
    rod.alongAll();
    SystemDynamics dynamics(rod.task, true);
    ASSERT_TRUE(dynamics.isReady());
    Full full(dynamics);
    StateJacobian sparse(dynamics), dense(full);
    ASSERT_TRUE(sparse.isSparse());
    ASSERT_FALSE(dense.isSparse());
    std::vector<double> x(20), f(20), g(20);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = 3 + std::sin(static_cast<double>(i));
    const double u[] = {2.5};
    ASSERT_TRUE(sparse.linearise(0, x.data(), u, nullptr, f.data()));
    ASSERT_TRUE(dense.linearise(0, x.data(), u, nullptr, g.data()));
    EXPECT_EQ(f, g);
    for (int i = 0; i < 20; ++i)
        for (int k = 0; k < 3; ++k) EXPECT_DOUBLE_EQ(sparse.held(i)[k], dense.held(i)[k]) << i;
    // solutions of the step's equations, one right-hand side and three
    for (const double c : {0.05, 0.3}) {
        ASSERT_TRUE(sparse.factorise(c));
        ASSERT_TRUE(dense.factorise(c));
        for (const int width : {1, 3}) {
            std::vector<double> a, b;
            for (int i = 0; i < 20 * width; ++i) a.push_back(std::cos(i));
            b = a;
            sparse.solve(a.data(), width);
            dense.solve(b.data(), width);
            for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-13) << i;
        }
    }
    EXPECT_TRUE(sparse.hasFactors(0.05));  // kept beside those of the longer step
    EXPECT_FALSE(dense.hasFactors(0.05));
    EXPECT_FALSE(sparse.hasFactors(0.1));
}

TEST(StateJacobian, TheRadiusByAVectorIsThatOfTheSquares) {
    for (const int n : {13, 40, 90}) {
        Rod rod(n);
        SystemDynamics dynamics(rod.task, false);
        StateJacobian jacobian(dynamics);
        ASSERT_TRUE(jacobian.isSparse());
        std::vector<double> x(static_cast<std::size_t>(n), 3.0), f(x.size());
        const double u[] = {1};
        ASSERT_TRUE(jacobian.evaluate(0, x.data(), u, f.data()));
        Eigen::MatrixXd full(n, n);
        ASSERT_TRUE(dynamics.jacobian(0, x.data(), u, f.data(), full.data()));
        const double radius = full.eigenvalues().cwiseAbs().maxCoeff();
        EXPECT_GE(jacobian.radius(0), 0.9 * radius) << n;
        EXPECT_LE(jacobian.radius(0), 1.25 * radius) << n;
        EXPECT_LE(jacobian.radius(3 * radius), 3 * radius) << n;
    }
}

void expectAlike(const Trajectory& a, const Trajectory& b) {
    ASSERT_FALSE(a.failure.failed) << a.failure.reason;
    ASSERT_FALSE(b.failure.failed) << b.failure.reason;
    EXPECT_LE((a.outputs - b.outputs).cwiseAbs().maxCoeff(), 1e-9);
    for (std::size_t o = 0; o < a.tangents.size(); ++o)
        EXPECT_LE((a.tangents[o] - b.tangents[o]).cwiseAbs().maxCoeff(), 1e-8 * b.tangents[o].cwiseAbs().maxCoeff());
}

TEST(StateJacobian, ImplicitStepsAndTheirTangentsAreThoseOfTheFullMatrix) {
    Rod rod(20, 500);
    rod.alongAll();
    SystemDynamics dynamics(rod.task, true), other(rod.task, true);
    Full full(other);
    GridRun run;
    run.plan = {GridMethod::Esdirk, 2, 0.0};
    expectAlike(runGrid(dynamics, rod.inputs, run), runGrid(full, rod.inputs, run));
}

TEST(StateJacobian, OfALinearModelIsFoundOnceAndItsStepsAreThoseOfTheFullMatrix) {
    Rod rod(20, 500, false);
    rod.alongAll();
    SystemDynamics dynamics(rod.task, true), other(rod.task, true);
    ASSERT_TRUE(dynamics.isLinear());
    Full full(other);
    GridRun run;
    run.plan = {GridMethod::Esdirk, 3, 0.0};
    expectAlike(runGrid(dynamics, rod.inputs, run), runGrid(full, rod.inputs, run));
    EXPECT_LE(4 * dynamics.evaluations(), 3 * other.evaluations());
}

TEST(StateJacobian, GridAndAdaptiveEngineAgreeOnALongStiffChain) {
    Rod rod(60, 2000);
    const Trajectory grid = simulate(rod.task);
    ASSERT_FALSE(grid.failure.failed) << grid.failure.reason;
    SimulationOptions exact;
    exact.relativeTolerance = 1e-9;
    const Trajectory reference = simulateAdaptive(rod.task, exact);
    ASSERT_FALSE(reference.failure.failed) << reference.failure.reason;
    const Eigen::ArrayXd range = reference.outputs.rowwise().maxCoeff() - reference.outputs.rowwise().minCoeff();
    EXPECT_LE(((grid.outputs - reference.outputs).array().abs().colwise() / range).maxCoeff(), 2e-5);
}

TEST(StateJacobian, AdaptiveSensitivitiesOfAChainAgreeWithTheTangentsOfTheGrid) {
    Rod rod(30, 100);
    rod.alongAll();
    SimulationOptions exact;
    exact.relativeTolerance = 1e-8;
    const Trajectory adaptive = simulateAdaptive(rod.task, exact);
    ASSERT_FALSE(adaptive.failure.failed) << adaptive.failure.reason;
    const Trajectory grid = simulateGrid(rod.task, {GridMethod::Esdirk, 16, 0.0});
    for (std::size_t o = 0; o < grid.tangents.size(); ++o)
        EXPECT_LE((grid.tangents[o] - adaptive.tangents[o]).cwiseAbs().maxCoeff(),
                  2e-4 * grid.tangents[o].cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace analogon
