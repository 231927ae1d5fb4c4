#include "core/eval/system.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/eval/tangent_check.hpp"
#include "tests/core/structure/sample_models.hpp"

namespace analogon {
namespace {

using test::checkTangents;
using test::Load;
using test::ModelBuilder;
using test::modelParameters;
using ::testing::HasSubstr;

std::shared_ptr<const System> buildSystem(std::shared_ptr<const FlatModel> model, std::vector<std::string> keep = {}) {
    Outcome<Structure> structure = analyse(std::move(model), {std::move(keep)});
    EXPECT_TRUE(structure) << format(structure.diagnostics());
    if (!structure) return nullptr;
    Outcome<std::shared_ptr<const System>> system = System::build(*structure);
    EXPECT_TRUE(system) << format(system.diagnostics());
    return system ? *system : nullptr;
}

std::vector<double> start(const System& system, std::vector<double> u, double t = 0) {
    Workspace w = system.workspace(0);
    std::vector<double> x(static_cast<std::size_t>(system.stateCount()));
    EXPECT_TRUE(system.setParameters(w, modelParameters(system)));
    EXPECT_TRUE(system.initialise(w, t, u, x)) << system.failure(w);
    return x;
}

std::vector<double> derivative(const System& system, std::vector<double> x, std::vector<double> u, double t = 0) {
    Workspace w = system.workspace(0);
    std::vector<double> xdot(x.size());
    EXPECT_TRUE(system.setParameters(w, modelParameters(system)));
    EXPECT_TRUE(system.derivatives(w, t, x, u, xdot)) << system.failure(w);
    return xdot;
}

std::vector<double> output(const System& system, std::vector<double> x, std::vector<double> u, double t = 0) {
    Workspace w = system.workspace(0);
    std::vector<double> y(static_cast<std::size_t>(system.outputCount()));
    EXPECT_TRUE(system.setParameters(w, modelParameters(system)));
    EXPECT_TRUE(system.outputs(w, t, x, u, y)) << system.failure(w);
    return y;
}

double observe(const System& system, const std::string& name, std::vector<double> x, std::vector<double> u) {
    Workspace w = system.workspace(0);
    EXPECT_TRUE(system.setParameters(w, modelParameters(system)));
    const std::vector<std::string> names{name};
    const std::vector<int> handles = system.observe(names);
    double value = 0;
    EXPECT_TRUE(system.observed(w, 0, x, u, handles, {&value, 1}));
    return value;
}

int stateIndex(const System& system, const std::string& name) {
    for (int i = 0; i < system.stateCount(); ++i)
        if (system.states()[static_cast<std::size_t>(i)].name == name) return i;
    ADD_FAILURE() << "no state " << name;
    return 0;
}

TEST(System, EvaluatesAThermalMassThroughItsConnectors) {
    const auto system = buildSystem(test::thermalMass(), {"C", "G", "T_start"});
    ASSERT_TRUE(system);
    ASSERT_EQ(system->stateCount(), 1);
    EXPECT_EQ(system->states()[0].name, "mass.T");
    EXPECT_EQ(system->slotCount(), 2);
    EXPECT_DOUBLE_EQ(start(*system, {10, 295})[0], 300);
    EXPECT_DOUBLE_EQ(derivative(*system, {310}, {10, 295})[0], (10 - 0.4 * 15) / 5);
    EXPECT_DOUBLE_EQ(output(*system, {310}, {10, 295})[0], 310);
    EXPECT_TRUE(system->isLinearTimeInvariant());
    EXPECT_FALSE(system->needsInputDerivative());
    checkTangents(*system, {310}, {10, 295});
}

TEST(System, MergesRigidlyCoupledInertiasWithoutDifferentiating) {
    const auto system = buildSystem(test::rigidInertias(), {"J1", "J2"});
    ASSERT_TRUE(system);
    ASSERT_EQ(system->stateCount(), 2);
    std::vector<double> x(2);
    x[static_cast<std::size_t>(1 - stateIndex(*system, "a.w"))] = 0.5;
    x[static_cast<std::size_t>(stateIndex(*system, "a.w"))] = 3;
    const std::vector<double> xdot = derivative(*system, x, {0.2});
    EXPECT_DOUBLE_EQ(xdot[static_cast<std::size_t>(stateIndex(*system, "a.w"))], 0.2 / 0.05);
    EXPECT_DOUBLE_EQ(xdot[static_cast<std::size_t>(stateIndex(*system, "a.phi"))], 3);
    EXPECT_NEAR(observe(*system, "b.flange.tau", x, {0.2}), 0.03 * 4, 1e-15);
    EXPECT_NEAR(observe(*system, "a.flange.tau", x, {0.2}), -0.03 * 4, 1e-15);
    EXPECT_TRUE(system->isLinearTimeInvariant());
    checkTangents(*system, x, {0.2});
}

TEST(System, KeepsAnInertiaThatIsZeroSolvable) {
    ModelBuilder unused;
    const auto system = buildSystem(test::rigidInertias(), {"J1", "J2"});
    ASSERT_TRUE(system);
    Workspace w = system->workspace(0);
    std::vector<double> xdot(2);
    for (const auto& p : std::vector<std::vector<double>>{{0.02, 0}, {0, 0.02}}) {
        ASSERT_TRUE(system->setParameters(w, p)) << system->failure(w);
        ASSERT_TRUE(system->derivatives(w, 0, std::vector<double>{1, 1}, std::vector<double>{0.4}, xdot))
            << system->failure(w);
        EXPECT_DOUBLE_EQ(xdot[static_cast<std::size_t>(stateIndex(*system, "a.w"))], 20);
    }
}

TEST(System, MotorWithElasticShaftHasFiveStates) {
    const auto system =
        buildSystem(test::motorWithShaft(2e-4, 1e-3, Load::Quadratic), {"R", "L", "k", "J1", "J2", "c", "d", "k_q"});
    ASSERT_TRUE(system);
    ASSERT_EQ(system->stateCount(), 5);
    std::vector<double> x(5);
    x[static_cast<std::size_t>(stateIndex(*system, "motor.i"))] = 1.5;
    x[static_cast<std::size_t>(stateIndex(*system, "shaft.phi1"))] = 0.4;
    x[static_cast<std::size_t>(stateIndex(*system, "shaft.phi2"))] = 0.15;
    x[static_cast<std::size_t>(stateIndex(*system, "shaft.w1"))] = 20;
    x[static_cast<std::size_t>(stateIndex(*system, "shaft.w2"))] = -8;
    const double tau = 3 * (0.2 - 0.15) + 0.02 * (10 + 8);
    const std::vector<double> xdot = derivative(*system, x, {12});
    EXPECT_NEAR(xdot[static_cast<std::size_t>(stateIndex(*system, "motor.i"))], (12 - 2 * 1.5 - 0.05 * 20) / 1e-3,
                1e-9);
    EXPECT_NEAR(xdot[static_cast<std::size_t>(stateIndex(*system, "shaft.w1"))], (2 * 0.05 * 1.5 - tau) / (2 * 1e-4),
                1e-9);
    EXPECT_NEAR(xdot[static_cast<std::size_t>(stateIndex(*system, "shaft.w2"))], (tau + 1e-3 * 64) / 2e-4, 1e-9);
    EXPECT_FALSE(system->isLinearTimeInvariant());
    checkTangents(*system, x, {12});
}

TEST(System, FoldsAZeroInertiaAndAZeroInductance) {
    const auto system = buildSystem(test::motorWithShaft(0, 0, Load::Quadratic), {"R", "k", "J1", "c", "d", "k_q"});
    ASSERT_TRUE(system);
    ASSERT_EQ(system->stateCount(), 3);  // phi1, w1, phi2: the speed behind the shaft follows from the load
    std::vector<double> x(3);
    x[static_cast<std::size_t>(stateIndex(*system, "shaft.phi1"))] = 0.4;
    x[static_cast<std::size_t>(stateIndex(*system, "shaft.phi2"))] = 0.15;
    x[static_cast<std::size_t>(stateIndex(*system, "shaft.w1"))] = 20;
    const double w2 = observe(*system, "shaft.w2", x, {12});
    const double torque = 3 * 0.05 + 0.02 * (10 - w2);
    EXPECT_NEAR(torque, 1e-3 * w2 * std::fabs(w2), 1e-12);
    EXPECT_DOUBLE_EQ(output(*system, x, {12})[0], (12 - 0.05 * 20) / 2);
    checkTangents(*system, x, {12});
}

TEST(System, DividesOutALinearLoadBehindTheShaft) {
    const auto system = buildSystem(test::motorWithShaft(0, 1e-3, Load::Viscous), {"R", "k", "c", "d", "b"});
    ASSERT_TRUE(system);
    ASSERT_EQ(system->stateCount(), 4);
    EXPECT_TRUE(system->isLinearTimeInvariant());
    const std::vector<double> x{0.1, 0.2, 0.3, 0.4};
    const double tau = observe(*system, "shaft.tau_s", x, {12});
    EXPECT_NEAR(observe(*system, "load.flange.tau", x, {12}), tau, 1e-15);
    checkTangents(*system, x, {12});
}

TEST(System, ReducesTheIndexOfAnIdealGear) {
    const auto system = buildSystem(test::gearedInertias(), {"J1", "J2", "r"});
    ASSERT_TRUE(system);
    ASSERT_EQ(system->stateCount(), 2);
    EXPECT_THAT((std::vector<std::string>{system->states()[0].name, system->states()[1].name}),
                ::testing::UnorderedElementsAre("phi2", "w2"));
    const std::vector<double> x0 = start(*system, {0});
    EXPECT_DOUBLE_EQ(x0[static_cast<std::size_t>(stateIndex(*system, "phi2"))], 0.1);
    EXPECT_DOUBLE_EQ(x0[static_cast<std::size_t>(stateIndex(*system, "w2"))], 2);
    const std::vector<double> xdot = derivative(*system, x0, {0.7});
    EXPECT_NEAR(xdot[static_cast<std::size_t>(stateIndex(*system, "w2"))], 4 * 0.7 / (0.5 + 16 * 0.02), 1e-12);
    EXPECT_NEAR(observe(*system, "w1", x0, {0.7}), 8, 1e-12);
    EXPECT_NEAR(observe(*system, "phi1", x0, {0.7}), 0.4, 1e-12);
    checkTangents(*system, x0, {0.7});
}

TEST(System, DifferentiatesAPrescribedTemperature) {
    const auto system = buildSystem(test::prescribedTemperature(), {"C", "G"});
    ASSERT_TRUE(system);
    EXPECT_EQ(system->stateCount(), 1);
    EXPECT_TRUE(system->needsInputDerivative());
    ASSERT_EQ(system->slotCount(), 2);
    EXPECT_DOUBLE_EQ(output(*system, {300}, {310, 0.25})[0], 12 * 0.25 + 0.5 * 10);
    checkTangents(*system, {300}, {310, 0.25});
}

TEST(System, DifferentiatesAConstraintOnAnInput) {
    // The same through a signal chain that is no alias: T = 2*u + offset.
    ModelBuilder m;
    m.parameter("C", 12);
    m.parameter("offset", 20);
    m.input("u");
    m.output("Q");
    m.variable("T");
    m.eq(m.v("T"), 2.0 * m.v("u") + m.v("offset"));
    m.eq(m.v("C") * m.der("T"), m.v("Q"));
    const auto system = buildSystem(m.model(), {"C", "offset"});
    ASSERT_TRUE(system);
    EXPECT_EQ(system->stateCount(), 0);
    EXPECT_TRUE(system->needsInputDerivative());
    EXPECT_DOUBLE_EQ(output(*system, {}, {300, 0.5})[0], 12 * 1.0);
    checkTangents(*system, {}, {300, 0.5});
}

TEST(System, SolvesInitialEquations) {
    ModelBuilder m;
    m.parameter("C", 5);
    m.parameter("G", 0.4);
    m.parameter("T_amb", 290);
    m.input("Q");
    m.variables({"T", "y", "z"});
    m.output("out");
    m.eq(m.v("C") * m.der("T"), m.v("Q") - m.v("G") * (m.v("T") - m.v("T_amb")));
    m.eq(0.5 * m.der("y"), m.v("T") - m.v("y"));
    m.eq(m.der("z"), m.v("Q") - m.v("z") * m.f(Operation::Abs, m.v("z")));
    m.eq(m.v("out"), m.v("y") + m.v("z"));
    m.initialEq(m.der("T"), m.c(0));        // at rest
    m.initialEq(m.v("y"), m.v("T") - 1.0);  // given by another
    m.initialEq(m.der("z"), m.c(0));        // nonlinear
    m.start("z", 1, false);
    const auto system = buildSystem(m.model(), {"C", "G", "T_amb"});
    ASSERT_TRUE(system);
    const std::vector<double> x = start(*system, {9});
    EXPECT_NEAR(x[static_cast<std::size_t>(stateIndex(*system, "T"))], 290 + 9 / 0.4, 1e-10);
    EXPECT_NEAR(x[static_cast<std::size_t>(stateIndex(*system, "y"))], 289 + 9 / 0.4, 1e-10);
    EXPECT_NEAR(x[static_cast<std::size_t>(stateIndex(*system, "z"))], 3, 1e-10);
    checkTangents(*system, x, {9});
}

TEST(System, SolvesLinearLoopsWithPivoting) {
    // A bridge of three resistors between two voltages; a resistance of 0 is legal.
    ModelBuilder m;
    for (const char* name : {"R1", "R2", "R3"}) m.parameter(name, 10);
    m.input("u");
    m.output("i3");
    m.variables({"v1", "i1", "i2", "x"});
    m.eq(m.v("u") - m.v("v1"), m.v("R1") * m.v("i1"));
    m.eq(m.v("v1"), m.v("R2") * m.v("i2"));
    m.eq(m.v("v1"), m.v("R3") * m.v("i3"));
    m.eq(m.v("i1"), m.v("i2") + m.v("i3"));
    m.eq(m.der("x"), m.v("i3"));
    const auto system = buildSystem(m.model(), {"R1", "R2", "R3"});
    ASSERT_TRUE(system);
    EXPECT_NEAR(output(*system, {0}, {6})[0], 0.2, 1e-14);
    checkTangents(*system, {0}, {6});
    Workspace w = system->workspace(0);
    double y = 0;
    ASSERT_TRUE(system->setParameters(w, std::vector<double>{0, 10, 20}));
    ASSERT_TRUE(system->outputs(w, 0, std::vector<double>{0}, std::vector<double>{6}, {&y, 1})) << system->failure(w);
    EXPECT_NEAR(y, 0.3, 1e-14);
    ASSERT_TRUE(system->setParameters(w, std::vector<double>{10, 20, 0}));
    ASSERT_TRUE(system->outputs(w, 0, std::vector<double>{0}, std::vector<double>{6}, {&y, 1})) << system->failure(w);
    EXPECT_NEAR(y, 0.6, 1e-14);
}

TEST(System, SolvesCoupledNonlinearEquations) {
    ModelBuilder m;
    m.parameter("a", 2);
    m.parameter("b", 0.3);
    m.input("u");
    m.output("y");
    m.variables({"p", "q", "x"});
    m.eq(m.v("p") + m.v("b") * m.v("p") * m.v("p") * m.v("p"), m.v("u") - m.v("q"));
    m.eq(m.f(Operation::Exp, m.v("q") / m.v("a")), m.v("p") * m.v("p") + 1.0);
    m.eq(m.v("y"), m.v("p") * m.v("q"));
    m.eq(m.der("x"), m.v("y") - m.v("x"));
    const auto system = buildSystem(m.model(), {"a", "b"});
    ASSERT_TRUE(system);
    const double p = observe(*system, "p", {0}, {3}), q = observe(*system, "q", {0}, {3});
    EXPECT_NEAR(p + 0.3 * p * p * p + q, 3, 1e-12);
    EXPECT_NEAR(std::exp(q / 2), p * p + 1, 1e-12);
    checkTangents(*system, {0.4}, {3});
}

TEST(System, TakesTheChosenBranchOfIf) {
    ModelBuilder m;
    m.parameter("k", 3);
    m.input("u");
    m.variable("x");
    m.eq(m.der("x"), m.ifElse(m.f(Operation::Greater, m.v("x"), m.v("u")), m.v("k") * m.v("x"), m.v("k") * m.v("k")));
    const auto system = buildSystem(m.model(), {"k"});
    ASSERT_TRUE(system);
    EXPECT_EQ(system->rootCount(), 1);
    EXPECT_DOUBLE_EQ(derivative(*system, {2}, {1})[0], 6);
    EXPECT_DOUBLE_EQ(derivative(*system, {0}, {1})[0], 9);
    checkTangents(*system, {2}, {1});
    checkTangents(*system, {0}, {1});
    Workspace w = system->workspace(0);
    double root = 0;
    ASSERT_TRUE(system->setParameters(w, std::vector<double>{3}));
    ASSERT_TRUE(system->roots(w, 0, std::vector<double>{2.5}, std::vector<double>{1}, {&root, 1}));
    EXPECT_DOUBLE_EQ(root, 1.5);
}

TEST(System, RaisesNoEventInsideNoEvent) {
    ModelBuilder m;
    m.variable("x");
    const auto relation = m.f(Operation::Greater, m.v("x"), m.c(0));
    m.eq(m.der("x"), m.f(Operation::NoEvent, m.ifElse(relation, -m.v("x"), m.c(1))));
    const auto system = buildSystem(m.model());
    ASSERT_TRUE(system);
    EXPECT_EQ(system->rootCount(), 0);
}

TEST(System, DelaysOfInputsAreSlotsAndOthersAreTaps) {
    ModelBuilder m;
    m.parameter("T_u", 0.2);
    m.parameter("T_y", 0.1);
    m.input("u");
    m.output("y");
    m.variables({"x", "u_in", "s"});
    m.eq(m.v("u_in"), m.v("u"));
    m.eq(m.der("x"), m.delay(m.v("u_in"), m.v("T_u")) - m.v("x"));
    m.eq(m.v("s"), 2.0 * m.v("x"));
    m.eq(m.v("y"), m.delay(m.v("s"), 2.0 * m.v("T_y")) + 1.0);
    const auto system = buildSystem(m.model(), {"T_u", "T_y"});
    ASSERT_TRUE(system);
    ASSERT_EQ(system->delays().size(), 2u);
    ASSERT_EQ(system->tapCount(), 1);
    ASSERT_EQ(system->slotCount(), 3);
    const int ofInput = system->delays()[0].input == 0 ? 0 : 1;
    EXPECT_EQ(system->delays()[static_cast<std::size_t>(ofInput)].tap, -1);
    EXPECT_EQ(system->delays()[static_cast<std::size_t>(1 - ofInput)].tap, 0);
    std::vector<double> u(3);
    u[0] = 100;
    u[static_cast<std::size_t>(1 + ofInput)] = 7;
    u[static_cast<std::size_t>(2 - ofInput)] = 5;
    EXPECT_DOUBLE_EQ(derivative(*system, {3}, u)[0], 4);
    EXPECT_DOUBLE_EQ(output(*system, {3}, u)[0], 6);
    Workspace w = system->workspace(2);
    double y = 0, tap = 0;
    ASSERT_TRUE(system->setParameters(w, std::vector<double>{0.2, 0.1}, std::vector<double>{1, 0, 0, 1}));
    ASSERT_TRUE(system->outputs(w, 0, std::vector<double>{3}, u, {&y, 1}, {&tap, 1}));
    EXPECT_DOUBLE_EQ(tap, 6);
    std::vector<double> times(2), dtimes(4);
    system->delayTimes(w, times, dtimes);
    EXPECT_DOUBLE_EQ(times[static_cast<std::size_t>(ofInput)], 0.2);
    EXPECT_DOUBLE_EQ(times[static_cast<std::size_t>(1 - ofInput)], 0.2);
    EXPECT_DOUBLE_EQ(dtimes[static_cast<std::size_t>(2 * ofInput)], 1);
    EXPECT_DOUBLE_EQ(dtimes[static_cast<std::size_t>(2 * (1 - ofInput) + 1)], 2);
    checkTangents(*system, {3}, u);
}

TEST(System, MovesTheDelayOfASignalOfInputsToTheInputs) {
    ModelBuilder m;
    m.parameter("T", 0.2);
    m.parameter("gain", 3);
    m.parameter("offset", 0.5);
    m.input("u");
    m.variables({"x", "amplified", "shifted", "late"});
    m.eq(m.v("amplified"), m.v("gain") * m.v("u"));
    m.eq(m.v("shifted"), m.v("amplified") + m.v("offset"));
    m.eq(m.v("late"), m.delay(m.v("shifted"), m.v("T")));
    m.eq(m.der("x"), m.delay(m.v("late"), 0.5 * m.v("T")) - m.v("x"));
    const auto system = buildSystem(m.model(), {"T", "gain", "offset"});
    ASSERT_TRUE(system);
    EXPECT_EQ(system->tapCount(), 0);
    ASSERT_EQ(system->delays().size(), 2u);  // `late` itself, and what drives the state
    EXPECT_EQ(system->delays()[0].input, 0);
    EXPECT_EQ(system->delays()[1].input, 0);
    Workspace w = system->workspace(0);
    std::vector<double> times(2);
    ASSERT_TRUE(system->setParameters(w, std::vector<double>{0.2, 3, 0.5}));
    system->delayTimes(w, times);
    EXPECT_THAT(times, ::testing::UnorderedElementsAre(::testing::DoubleEq(0.2), ::testing::DoubleEq(0.3)));
    const std::size_t late = times[0] > 0.25 ? 1 : 2;
    std::vector<double> u{100, 100, 100};
    u[late] = 2;
    EXPECT_DOUBLE_EQ(derivative(*system, {1}, u)[0], 3 * 2 + 0.5 - 1);
}

TEST(System, RefusesADelayedTapThatDrivesAState) {
    ModelBuilder m;
    m.parameter("T", 0.2);
    m.variables({"x", "y"});
    m.eq(m.v("y"), 2.0 * m.v("x"));
    m.eq(m.der("x"), -m.delay(m.v("y"), m.v("T")));
    const Outcome<Structure> structure = analyse(m.model(), {{"T"}});
    ASSERT_TRUE(structure) << format(structure.diagnostics());
    const auto system = System::build(*structure);
    ASSERT_FALSE(system);
    EXPECT_THAT(system.diagnostics().front().message, HasSubstr("delayed signal"));
}

TEST(System, NamesTheVariableThatIsNotFinite) {
    ModelBuilder m;
    m.input("u");
    m.output("y");
    m.variables({"x", "ratio"});
    m.eq(m.v("ratio"), 1.0 / m.v("u"));
    m.eq(m.der("x"), m.v("ratio") - m.v("x"));
    m.eq(m.v("y"), m.v("x"));
    const auto system = buildSystem(m.model());
    ASSERT_TRUE(system);
    Workspace w = system->workspace(0);
    std::vector<double> xdot(1);
    ASSERT_TRUE(system->setParameters(w, {}));
    EXPECT_FALSE(system->derivatives(w, 0, std::vector<double>{1}, std::vector<double>{0}, xdot));
    EXPECT_EQ(system->failure(w), "ratio");
    EXPECT_FALSE(system->failedToSolve(w));
    EXPECT_TRUE(system->derivatives(w, 0, std::vector<double>{1}, std::vector<double>{2}, xdot));
}

TEST(System, NamesTheUnknownThatHasNoSolution) {
    ModelBuilder m;
    m.input("u");
    m.output("z");
    m.eq(m.v("z") * m.v("z") + 1.0, m.v("u"));
    const auto system = buildSystem(m.model());
    ASSERT_TRUE(system);
    Workspace w = system->workspace(0);
    double y = 0;
    ASSERT_TRUE(system->setParameters(w, {}));
    EXPECT_FALSE(system->outputs(w, 0, {}, std::vector<double>{0}, {&y, 1}));
    EXPECT_EQ(system->failure(w), "z");
    EXPECT_TRUE(system->failedToSolve(w));
    EXPECT_TRUE(system->outputs(w, 0, {}, std::vector<double>{5}, {&y, 1}));
    EXPECT_NEAR(y * y, 4, 1e-12);
}

TEST(System, StartsAtRestWhereTheSlopeOfALoadIsInfinite) {
    // k*w*abs(w) = c*(phi1 - phi2): at rest dw/dphi is infinite; values and tangents stay finite.
    ModelBuilder m;
    m.parameter("k", 2);
    m.parameter("c", 5);
    m.input("phi1");
    m.variables({"phi2", "w"});
    m.eq(m.v("w"), m.der("phi2"));
    m.eq(m.v("k") * m.v("w") * m.f(Operation::Abs, m.v("w")), m.v("c") * (m.v("phi1") - m.v("phi2")));
    const auto system = buildSystem(m.model(), {"k", "c"});
    ASSERT_TRUE(system);
    Workspace w = system->workspace(1);
    std::vector<double> x{0}, dx{1}, xdot(1), dxdot(1);
    ASSERT_TRUE(system->setParameters(w, std::vector<double>{2, 5}, std::vector<double>{0, 0}));
    ASSERT_TRUE(system->derivatives(w, 0, x, dx, std::vector<double>{0}, {}, xdot, dxdot)) << system->failure(w);
    EXPECT_EQ(xdot[0], 0);
    EXPECT_EQ(dxdot[0], 0);
    // And off it from there: the last solution, 0, is no start for Newton.
    ASSERT_TRUE(system->derivatives(w, 0, x, dx, std::vector<double>{0.4}, {}, xdot, dxdot)) << system->failure(w);
    EXPECT_NEAR(xdot[0], 1, 1e-12);
    EXPECT_NEAR(dxdot[0], -5.0 / 4, 1e-12);
    checkTangents(*system, {0.1}, {0.4});
}

TEST(System, ObservesAliasesParametersAndDerivatives) {
    const auto system = buildSystem(test::thermalMass(), {"G"});
    ASSERT_TRUE(system);
    EXPECT_DOUBLE_EQ(observe(*system, "source.port.T", {310}, {10, 295}), 310);
    EXPECT_DOUBLE_EQ(observe(*system, "source.port.Q_flow", {310}, {10, 295}), -10);
    EXPECT_DOUBLE_EQ(observe(*system, "loss.Q_flow", {310}, {10, 295}), 6);
    EXPECT_DOUBLE_EQ(observe(*system, "T_amb", {310}, {10, 295}), 295);
    EXPECT_DOUBLE_EQ(observe(*system, "G", {310}, {10, 295}), 0.4);
    EXPECT_DOUBLE_EQ(observe(*system, "C", {310}, {10, 295}), 5);
    EXPECT_DOUBLE_EQ(observe(*system, "der(mass.T)", {310}, {10, 295}), 0.8);
    const std::vector<std::string> unknown{"nothing"};
    EXPECT_EQ(system->observe(unknown)[0], -1);
}

TEST(System, CarriesDependentParametersWithTangents) {
    ModelBuilder m;
    m.parameter("a", 2);
    m.parameter("area", m.v("a") * m.v("a"));
    m.parameter("half", m.v("area") / m.c(2));
    m.variable("x");
    m.eq(m.der("x"), -(m.v("half") * m.v("x")));
    m.start("x", m.v("area"));
    const auto system = buildSystem(m.model(), {"a"});
    ASSERT_TRUE(system);
    EXPECT_DOUBLE_EQ(start(*system, {})[0], 4);
    EXPECT_DOUBLE_EQ(derivative(*system, {3}, {})[0], -6);
    EXPECT_DOUBLE_EQ(system->states()[0].value, 4);
    EXPECT_TRUE(system->isLinearTimeInvariant());
    checkTangents(*system, {3}, {});
}

TEST(System, DifferentiatesEveryFunction) {
    using enum Operation;
    ModelBuilder m;
    m.parameter("p", 0.7);
    m.input("u");
    m.variable("x");
    auto sum = m.c(0);
    for (const Operation f : {Abs, Sqrt, Exp, Log, Log10, Sin, Cos, Tan, Asin, Acos, Atan, Sinh, Cosh, Tanh})
        sum = sum + m.f(f, m.v("p") * m.v("x")) * m.v("u");
    for (const Operation f : {Power, Atan2, Min, Max, Mod, Rem}) sum = sum + m.f(f, m.v("x"), m.v("p"));
    LookupTable table{{-1, 0, 1, 2}, {0, 1, 3, 4}, LookupTable::Interpolation::MonotoneCubic, 0, {}};
    ExpressionPool& pool = *m.model()->pool;
    sum = sum + m.v("p") * sum.of(pool.table(table, m.v("x").id));
    sum = sum + m.v("p") * sum.of(pool.tableDerivative(0, m.v("x").id));
    for (const double n : {2.0, 3.0, 4.0, -1.0, -2.0, 0.5, 1.7}) sum = sum + m.f(Power, m.v("x"), m.c(n));
    for (const Operation f : {Floor, Ceil, Sign}) sum = sum + m.f(f, m.v("x")) * m.v("p");
    m.eq(m.der("x"), sum);
    const auto system = buildSystem(m.model(), {"p"});
    ASSERT_TRUE(system);
    checkTangents(*system, {0.9}, {1.3});
    checkTangents(*system, {0.31}, {-0.4});
}

TEST(System, TimeMakesItVarying) {
    ModelBuilder m;
    m.variable("x");
    m.eq(m.der("x"), m.f(Operation::Sin, m.time()) - m.v("x"));
    const auto system = buildSystem(m.model());
    ASSERT_TRUE(system);
    EXPECT_FALSE(system->isLinearTimeInvariant());
    EXPECT_DOUBLE_EQ(derivative(*system, {0.5}, {}, 2)[0], std::sin(2.0) - 0.5);
}

}  // namespace
}  // namespace analogon
