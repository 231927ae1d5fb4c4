#include "core/structure/structure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/core/structure/analysed.hpp"
#include "tests/core/structure/sample_models.hpp"

namespace analogon {
namespace {

using test::analysed;
using test::Load;
using test::ModelBuilder;
using test::refusal;
using test::standIn;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

std::vector<std::string> namesOf(const Structure& s, const std::vector<VariableId>& ids) {
    std::vector<std::string> names;
    for (const VariableId id : ids) names.push_back((*s.model)[id].name);
    return names;
}

int implicitBlocks(const Structure& s) {
    return static_cast<int>(
        std::count_if(s.blocks.begin(), s.blocks.end(), [](const SolutionBlock& b) { return !b.isExplicit; }));
}

TEST(Structure, PrintsAThermalMass) {
    const Structure s = analysed(test::thermalMass(), {"C", "G", "T_start"});
    EXPECT_EQ(print(s), R"(ThermalMass: 9 equations, 3 after alias elimination, 0 differentiated
inputs Q_flow T_amb
outputs T_out
parameters C G T_start
states mass.T
at the start
  mass.T := T_start
equations
  loss.Q_flow := G*(mass.T - T_amb)
  mass.port.Q_flow := Q_flow - loss.Q_flow
  der(mass.T) := mass.port.Q_flow/C
derivatives
  der(mass.T) := der(mass.T)
aliases
  T_out = mass.T
  mass.port.T = mass.T
  loss.port_a.T = mass.T
  loss.port_a.Q_flow = loss.Q_flow
  source.port.Q_flow = -Q_flow
  source.port.T = mass.T
)");
}

TEST(Structure, FoldsEveryParameterThatIsNotKept) {
    const Structure s = analysed(test::motorWithShaft(0, 0, Load::Quadratic), {"R"});
    EXPECT_THAT(namesOf(s, s.parameters), ElementsAre("R"));
    EXPECT_THAT(s.parameterValues, ElementsAre(2.0));
    EXPECT_THAT(namesOf(s, s.states), UnorderedElementsAre("shaft.phi1", "shaft.w1", "shaft.phi2"));
    EXPECT_EQ(s.folded.size(), 9u);
}

TEST(Structure, AParameterAtZeroThatIsKeptStays) {
    const Structure folded = analysed(test::motorWithShaft(0, 1e-3, Load::Viscous), {"R"});
    EXPECT_EQ(folded.states.size(), 4u);
    const Structure kept = analysed(test::motorWithShaft(0, 1e-3, Load::Viscous), {"R", "J2"});
    EXPECT_EQ(kept.states.size(), 5u);
}

TEST(Structure, PutsDependentParametersInOrder) {
    ModelBuilder m;
    m.parameter("volume", m.c(0));  // replaced below, so that it is declared before what it depends on
    m.parameter("area", m.c(0));
    m.parameter("side", 2);
    m["volume"].binding = (m.v("area") * m.v("side")).id;
    m["area"].binding = (m.v("side") * m.v("side")).id;
    m.variable("x");
    m.eq(m.der("x"), -(m.v("volume") * m.v("x")));
    const Structure s = analysed(m.model(), {"side"});
    ASSERT_EQ(s.parameterBlocks.size(), 2u);
    const auto name = [&](const SolutionBlock& b) { return (*s.model)[(*s.pool)[b.unknowns[0]].variable].name; };
    EXPECT_EQ(name(s.parameterBlocks[0]), "area");
    EXPECT_EQ(name(s.parameterBlocks[1]), "volume");
    EXPECT_THAT(analysed(m.model()).parameterBlocks, IsEmpty());
}

TEST(Structure, RefusesUnknownAndUnusableParameters) {
    ModelBuilder m;
    m.parameter("alpha", 1);
    m.variable("x");
    m.eq(m.der("x"), m.v("alpha"));
    EXPECT_THAT(refusal(m.model(), {"alpa"}), AllOf(HasSubstr("no parameter 'alpa'"), HasSubstr("'alpha'")));
    EXPECT_THAT(refusal(m.model(), {"x"}), HasSubstr("'x' is not a parameter"));
    m["alpha"].binding = {};
    EXPECT_THAT(refusal(m.model()), HasSubstr("'alpha' has no value"));
    m["alpha"].binding = (m.v("alpha") + 1.0).id;
    EXPECT_THAT(refusal(m.model()), HasSubstr("depends on itself"));
}

TEST(Structure, MergesPositionsSpeedsAndAccelerations) {
    const Structure s = analysed(test::rigidInertias(), {"J1", "J2"});
    EXPECT_EQ(s.indexReduction, 0);
    EXPECT_THAT(namesOf(s, s.states), UnorderedElementsAre("a.phi", "a.w"));
    EXPECT_EQ(standIn(s, "b.w"), "a.w");
    EXPECT_EQ(standIn(s, "b.phi"), "a.phi");
    EXPECT_EQ(standIn(s, "b.a"), "a.a");
    EXPECT_EQ(standIn(s, "b.flange.tau"), "-a.flange.tau");
    EXPECT_EQ(standIn(s, "w"), "a.w");
    EXPECT_EQ(implicitBlocks(s), 0);
}

TEST(Structure, MergesWithTheSignOfAMirroredShaft) {
    ModelBuilder m;
    m.parameter("J", 2);
    m.variables({"phi1", "w1", "phi2", "w2", "tau"});
    m.input("u");
    m.eq(m.v("w1"), m.der("phi1"));
    m.eq(m.v("w2"), m.der("phi2"));
    m.eq(m.v("phi1") + m.v("phi2"), 0);
    m.eq(m.v("J") * m.der("w1"), m.v("u") - m.v("tau"));
    m.eq(m.v("J") * m.der("w2"), -m.v("tau"));
    m.start("phi2", 3);
    const Structure s = analysed(m.model(), {"J"});
    EXPECT_THAT(namesOf(s, s.states), UnorderedElementsAre("phi2", "w1"));
    EXPECT_EQ(standIn(s, "phi1"), "-phi2");
    EXPECT_EQ(standIn(s, "w2"), "-w1");
    const std::size_t phi2 = namesOf(s, s.states)[0] == "phi2" ? 0 : 1;
    EXPECT_EQ(s.pool->print(s.stateDerivatives[phi2], [&](VariableId v) { return (*s.model)[v].name; }), "-w1");
}

TEST(Structure, FollowsConstantsThroughTheEquations) {
    ModelBuilder m;
    m.variables({"a", "b", "c", "x"});
    m.eq(m.v("b") - m.v("a"), m.c(0));
    m.eq(2.0 * m.v("a"), 6);
    m.eq(m.v("c"), m.v("a") * m.v("b"));  // a product of two constants: seen in the second round
    m.eq(m.der("x"), m.v("c") - m.v("x"));
    const Structure s = analysed(m.model());
    EXPECT_EQ(standIn(s, "b"), "3");
    EXPECT_EQ(standIn(s, "c"), "9");
    EXPECT_EQ(s.equationsAfter, 1);
}

TEST(Structure, TakesNothingForAStateWhoseDerivativeHasTheFactorZero) {
    // v = R*i + L_i*der(i), L_i = L*f: without an inductance the current follows the voltage
    for (const double L : {0.0, 0.1}) {
        ModelBuilder m;
        m.parameter("L", L);
        m.input("v");
        m.variables({"i", "f", "L_i"});
        m.eq(m.v("f"), m.c(1) + m.v("i") * m.v("i"));
        m.eq(m.v("L_i"), m.v("L") * m.v("f"));
        m.eq(m.v("v"), m.c(2) * m.v("i") + m.v("L_i") * m.der("i"));
        const Structure s = analysed(m.model());
        EXPECT_EQ(s.states.size(), L > 0 ? 1u : 0u);
        EXPECT_EQ(s.indexReduction, 0);
    }
}

TEST(Structure, AcceptsAVariableThatIsItsOwnDerivative) {
    ModelBuilder m;
    m.variables({"x", "y"});
    m.eq(m.der("x"), m.v("x"));
    m.eq(m.der("y"), -m.v("y"));
    const Structure s = analysed(m.model());
    EXPECT_THAT(namesOf(s, s.states), UnorderedElementsAre("x", "y"));
}

TEST(Structure, ConflictingFixedStartValuesAreAFault) {
    ModelBuilder m;
    m.variables({"T1", "T2", "Q"});
    m.eq(m.v("T1"), m.v("T2"));
    m.eq(2.0 * m.der("T1"), m.v("Q"));
    m.eq(3.0 * m.der("T2"), -m.v("Q"));
    m.start("T1", 290);
    m.start("T2", 300);
    EXPECT_THAT(refusal(m.model()), AllOf(HasSubstr("'T1' and 'T2' are the same quantity"), HasSubstr("290")));
    m.start("T2", 290);
    EXPECT_THAT(analysed(m.model()).warnings, IsEmpty());
}

TEST(Structure, TakesTheFixedStartOfAnyMember) {
    ModelBuilder m;
    m.parameter("T_start", 310);
    m.variables({"a.T", "b.T"});
    m.eq(m.v("a.T"), m.v("b.T"));
    m.eq(m.der("a.T"), m.c(1));
    m.start("b.T", m.v("T_start"));
    m.start("a.T", 5, false);
    const Structure s = analysed(m.model());
    ASSERT_EQ(s.initialBlocks.size(), 1u);
    EXPECT_TRUE(s.pool->isConstant(s.initialBlocks[0].expressions[0], 310));
}

TEST(Structure, SaysWhichInitialEquationIsSuperfluous) {
    ModelBuilder m;
    m.variable("T");
    m.eq(m.der("T"), -m.v("T"));
    m.start("T", 300);
    m.initialEq(m.v("T"), m.c(310));
    const Structure s = analysed(m.model());
    ASSERT_EQ(s.warnings.size(), 1u);
    EXPECT_THAT(s.warnings[0].message, HasSubstr("fixed start value of 'T' is not used"));
}

TEST(Structure, HoldsTheStartOfAStateThatNoInitialEquationNames) {
    // what y lags behind depends on x: the equation tells where y begins, not x
    ModelBuilder m;
    m.variables({"y", "x", "u"});
    m.eq(m.der("x"), -m.v("x"));
    m.eq(m.v("u"), 3.0 * m.v("x"));
    m.eq(m.der("y"), m.v("u") - m.v("y"));
    m.initialEq(m.v("y"), m.v("u"));
    const Structure s = analysed(m.model());
    ASSERT_EQ(s.warnings.size(), 1u);
    EXPECT_EQ(s.warnings[0].message, "No start value is given for x; 0 is taken.");
}

TEST(Structure, NotesAStartValueThatIsNotGiven) {
    ModelBuilder m;
    m.variables({"x", "y"});
    m.eq(m.der("x"), -m.v("x"));
    m.eq(m.der("y"), -m.v("y"));
    m.start("y", 2, false);
    const Structure s = analysed(m.model());
    ASSERT_EQ(s.warnings.size(), 1u);
    EXPECT_EQ(s.warnings[0].severity, Severity::Note);
    EXPECT_EQ(s.warnings[0].message, "No start value is given for x; 0 is taken.");
}

TEST(Structure, ReducesTheIndexOfAGearAndPrefersGivenStates) {
    const Structure s = analysed(test::gearedInertias(), {"r"});
    EXPECT_EQ(s.indexReduction, 2);
    EXPECT_THAT(namesOf(s, s.states), UnorderedElementsAre("phi2", "w2"));
    EXPECT_EQ(implicitBlocks(s), 0);  // torn to one unknown, solved symbolically

    auto other = std::make_shared<FlatModel>(*test::gearedInertias());
    for (const char* name : {"phi1", "w1"}) other->variables[other->find(name).value].stateSelect = StateSelect::Always;
    EXPECT_THAT(namesOf(analysed(other), analysed(other).states), UnorderedElementsAre("phi1", "w1"));
}

TEST(Structure, ReducesAConstraintBetweenStates) {
    // Two capacitances in parallel, through an algebraic detour: x1 = s, s = 2*x2.
    ModelBuilder m;
    m.variables({"x1", "x2", "s", "q"});
    m.input("u");
    m.eq(m.der("x1"), m.v("u") - m.v("q"));
    m.eq(m.der("x2"), m.v("q"));
    m.eq(m.v("x1"), 1.5 * m.v("s"));
    m.eq(m.v("s"), 2.0 * m.v("x2"));
    const Structure s = analysed(m.model());
    EXPECT_EQ(s.indexReduction, 2);
    ASSERT_EQ(s.states.size(), 1u);
    EXPECT_THAT(namesOf(s, s.states)[0], ::testing::AnyOf("x1", "x2"));
}

TEST(Structure, AcceptsAPendulumInCartesianCoordinates) {
    ModelBuilder m;
    m.parameter("L", 1);
    m.variables({"x", "y", "vx", "vy", "F"});
    m.eq(m.der("x"), m.v("vx"));
    m.eq(m.der("y"), m.v("vy"));
    m.eq(m.der("vx"), -(m.v("F") * m.v("x")));
    m.eq(m.der("vy"), -(m.v("F") * m.v("y")) - 9.81);
    m.eq(m.v("x") * m.v("x") + m.v("y") * m.v("y"), m.v("L") * m.v("L"));
    m.start("x", 0.1);
    m.start("y", -1, false);
    const Structure s = analysed(m.model(), {"L"});
    EXPECT_EQ(s.indexReduction, 2);
    // No choice of two holds all the way round: all four stay, and the constraint is held by its last derivative.
    EXPECT_THAT(namesOf(s, s.states), UnorderedElementsAre("x", "y", "vx", "vy"));
}

/// What follows from the time alone is no state, though its slope along what it follows from is another at each moment:
/// that is known when it is solved.
TEST(Structure, ADerivativeOfWhatIsKnownMakesNoState) {
    ModelBuilder m;
    m.input("u");
    m.parameter("k", 2);
    m.variables({"s", "x", "v"});
    m.eq(m.v("s"), m.v("k") * m.v("u"));
    m.eq(m.v("x"), m.v("s") * m.v("s") * m.v("s"));
    m.eq(m.v("v"), m.der("x"));
    const Structure s = analysed(m.model(), {"k"});
    EXPECT_EQ(s.indexReduction, 2);
    EXPECT_THAT(namesOf(s, s.states), IsEmpty());
}

TEST(Structure, PrescribingAPositionNeedsASecondDerivative) {
    ModelBuilder m;
    m.input("phi_in");
    m.variables({"phi", "w", "tau"});
    m.eq(m.v("phi"), m.v("phi_in"));
    m.eq(m.v("w"), m.der("phi"));
    m.eq(2.0 * m.der("w"), m.v("tau"));
    EXPECT_THAT(refusal(m.model()), AllOf(HasSubstr("second derivative"), HasSubstr("'phi_in'")));
}

TEST(Structure, NamesWhatIsNotDetermined) {
    ModelBuilder m;
    m.input("u");
    m.variables({"x", "p", "q"});
    m.eq(m.der("x"), m.v("u") - m.v("x"));
    m.component("circuit");
    m.eq(m.v("p") - m.v("q"), m.v("u"));
    m.eq(2.0 * m.v("p"), 2.0 * m.v("q") + 2.0 * m.v("u") * m.v("u"));
    // Sound by count of variables, but p and q only ever appear as p - q: seen when the loop is solved.
    EXPECT_THAT(refusal(m.model()), AllOf(HasSubstr("circuit"), HasSubstr("p")));
}

TEST(Structure, NamesARepeatedEquation) {
    ModelBuilder m;
    m.variables({"a", "b", "c"});
    m.component("joint");
    m.eq(m.v("a"), m.v("b"));
    m.eq(m.v("b"), m.v("a"));
    m.component("");
    m.eq(m.der("c"), -m.v("c") + m.v("a"));
    EXPECT_THAT(refusal(m.model()),
                AllOf(HasSubstr("No equation determines a"), HasSubstr("b = a (in joint)"), HasSubstr("repeat")));
}

TEST(Structure, NamesTheEquationsThatCompete) {
    ModelBuilder m;
    m.input("u1");
    m.input("u2");
    m.variables({"T", "free"});
    m.component("source1");
    m.eq(2.0 * m.v("T"), m.v("u1"));
    m.component("source2");
    m.eq(3.0 * m.v("T"), m.v("u2"));
    EXPECT_THAT(refusal(m.model()),
                AllOf(HasSubstr("No equation determines free"), HasSubstr("in source1"), HasSubstr("in source2")));
}

TEST(Structure, RefusesContradictingConstantsAndInputs) {
    ModelBuilder m;
    m.input("u");
    m.variables({"a", "b"});
    m.eq(m.v("a"), 1);
    m.eq(m.v("a") + m.v("b"), 0);
    m.eq(m.v("b"), 2);
    EXPECT_THAT(refusal(m.model()), HasSubstr("cannot hold"));
    ModelBuilder n;
    n.input("u");
    n.variable("a");
    n.component("source");
    n.eq(n.v("a"), n.v("u"));
    n.eq(n.v("a"), 5);
    EXPECT_THAT(refusal(n.model()), AllOf(HasSubstr("fixes an input"), HasSubstr("source")));
}

TEST(Structure, TearsALinearLoopToItsCore) {
    // A chain of n adders closed to a loop: one torn variable, solved symbolically.
    constexpr int n = 300;
    ModelBuilder m;
    m.input("u");
    for (int i = 0; i < n; ++i) m.variable("z" + std::to_string(i));
    for (int i = 0; i + 1 < n; ++i)
        m.eq(m.v("z" + std::to_string(i + 1)), 0.99 * m.v("z" + std::to_string(i)) + m.v("u"));
    m.eq(m.v("z0"), 0.5 * m.v("z" + std::to_string(n - 1)));
    const Structure s = analysed(m.model());
    EXPECT_EQ(implicitBlocks(s), 0);
    EXPECT_EQ(s.blocks.size(), static_cast<std::size_t>(n));
}

TEST(Structure, LongChainsNeedNoDeepStack) {
    constexpr int n = 20000;
    ModelBuilder m;
    m.input("u");
    for (int i = 0; i < n; ++i) m.variable("z" + std::to_string(i));
    // Declared backwards, so that every equation waits for the next one.
    for (int i = n - 1; i > 0; --i)
        m.eq(m.v("z" + std::to_string(i)), m.f(Operation::Sin, m.v("z" + std::to_string(i - 1))));
    m.eq(m.v("z0"), m.f(Operation::Sin, m.v("u")));
    const Structure s = analysed(m.model());
    EXPECT_EQ(s.blocks.size(), static_cast<std::size_t>(n));
    EXPECT_EQ(implicitBlocks(s), 0);
}

TEST(Structure, NamesWhatMakesAnEquationImpossible) {
    const auto faultOf = [](const std::function<void(ModelBuilder&)>& fill) {
        ModelBuilder m;
        m.variables({"x"});
        fill(m);
        const Outcome<Structure> result = analyse(m.model());
        return result ? std::string() : result.diagnostics().front().message.english();
    };
    EXPECT_EQ(faultOf([](ModelBuilder& m) {
                  m.parameter("k", 0);
                  m.eq(m.der("x"), m.v("x") / m.v("k"));
              }),
              "The equation der(x) = x/k cannot hold: x/k divides by 0 (k = 0).");
    EXPECT_EQ(faultOf([](ModelBuilder& m) {
                  m.parameter("k", 0);
                  m.parameter("r", 1 / m.v("k"));
                  m.eq(m.der("x"), 2 * m.v("r"));
              }),
              "The equation der(x) = 2*r cannot hold: 1/k divides by 0 (k = 0).");
    EXPECT_EQ(faultOf([](ModelBuilder& m) {
                  m.parameter("k", std::nan(""));
                  m.eq(m.der("x"), m.v("k") * m.v("x"));
              }),
              "The equation der(x) = k*x cannot hold: 'k' is not a number.");
}

TEST(Structure, AParameterOf0TakesOutWhatItsQuotientsMultiply) {
    // A transit time of 0 over a voltage that runs: the capacitance is 0, and v no state.
    ModelBuilder m;
    m.variables({"v", "u", "c"});
    m.parameter("T", 0);
    m.eq(m.v("u"), m.c(1) + m.v("v") * m.v("v"));
    m.eq(m.v("c"), m.v("T") / m.v("u"));
    m.eq(m.v("c") * m.der("v") + m.v("v") * m.v("v") * m.v("v"), m.c(8));
    const Outcome<Structure> structure = analyse(m.model());
    ASSERT_TRUE(structure) << format(structure.diagnostics());
    EXPECT_TRUE(structure->states.empty());
}

TEST(Structure, AllowsWhatNeedNotBeEvaluated) {
    ModelBuilder m;
    m.variables({"x", "y", "z"});
    m.parameter("k", 0);
    m.parameter("unused", 1 / m.v("k"));
    // A branch of an if whose condition varies; infinity as a limit; a free parameter that starts at 0.
    m.eq(m.der("x"), m.ifElse(m.f(Operation::Greater, m.v("x"), m.c(0)), 1 / m.v("k"), m.c(1)));
    m.eq(m.v("y"), m.f(Operation::Min, m.v("x"), 1 / m.v("k")));
    m.eq(m.v("z"), m.c(1));
    const Outcome<Structure> folded = analyse(m.model());
    EXPECT_TRUE(folded) << format(folded.diagnostics());

    ModelBuilder free;
    free.variables({"x"});
    free.parameter("k", 0);
    free.eq(free.der("x"), 1 / free.v("k"));
    EXPECT_TRUE(analyse(free.model(), {{"k"}}));
}

}  // namespace
}  // namespace analogon
