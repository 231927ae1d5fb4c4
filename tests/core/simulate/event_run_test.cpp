#include "core/simulate/event_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "tests/core/simulate/class_run.hpp"

namespace analogon {
namespace {

using test::runOf;
using test::Simulated;
using ::testing::HasSubstr;

TEST(EventRun, ABallBouncesWhereTheFormulaSays) {
    const Simulated run = runOf(R"(
        model M Real h(start = 1, fixed = true), v(start = 0, fixed = true); Integer n(start = 0, fixed = true);
        equation
          der(h) = v; der(v) = -9.81;
          when h < 0 then reinit(v, -0.5*pre(v)); n = pre(n) + 1; end when;
        end M;)",
                                {"h", "v", "n"}, 0.8);
    ASSERT_RAN(run);
    const double first = std::sqrt(2 / 9.81), speed = std::sqrt(2 * 9.81);
    const double since = 0.8 - first;
    EXPECT_EQ(run.at(first - 1e-6, "n"), 0);
    EXPECT_EQ(run.at(first + 1e-6, "n"), 1);
    EXPECT_NEAR(run.last("h"), 0.5 * speed * since - 0.5 * 9.81 * since * since, 1e-6);
}

TEST(EventRun, SamplesComeAtTheirTimesAndSeeTheValueBefore) {
    const Simulated run = runOf(R"(
        model M Real x(start = 0, fixed = true); discrete Real y(start = 0, fixed = true), z(start = 0, fixed = true);
        equation
          der(x) = 1;
          when sample(0.1, 0.25) then y = x; z = pre(y); end when;
        end M;)",
                                {"x", "y", "z"});
    ASSERT_RAN(run);
    EXPECT_EQ(run.at(0.0999, "y"), 0);
    EXPECT_NEAR(run.at(0.1, "y"), 0.1, 1e-9);
    EXPECT_NEAR(run.at(0.4, "y"), 0.35, 1e-9);
    EXPECT_NEAR(run.at(0.4, "z"), 0.1, 1e-9);
    EXPECT_NEAR(run.last("y"), 0.85, 1e-9);
    EXPECT_NEAR(run.last("z"), 0.6, 1e-9);
}

TEST(EventRun, TheFirstSampleComesInTheEventBehindTheStart) {
    // while the start is found sample() is false
    const Simulated run = runOf(R"(
        model M Boolean tick, first(start = false, fixed = true); Integer n(start = 0, fixed = true);
        equation
          tick = sample(0, 0.1);
          when tick then first = time <= 0.05; n = pre(n) + 1; end when;
        end M;)",
                                {"first", "n", "tick"}, 0.25);
    ASSERT_RAN(run);
    EXPECT_EQ(run.at(0, "n"), 1);
    EXPECT_EQ(run.at(0.05, "first"), 1);
    EXPECT_EQ(run.at(0.11, "first"), 0);
    EXPECT_EQ(run.last("n"), 3);
}

TEST(EventRun, AStartWithoutAValueInOneBranchIsFoundInTheOther) {
    // the law of large negative voltages divides by them
    const Simulated run = runOf(R"(
        model M Real v(start = 0), i; Real x(start = 0, fixed = true);
        equation
          i = if v > -0.1 then 1e-3*(exp(10*v) - 1) else -(1e-3 + 1e-4/v)*v/v;
          v + 100*i = x;
          der(x) = 1;
        end M;)",
                                {"v", "i"});
    ASSERT_RAN(run);
    const double v = run.last("v");
    EXPECT_NEAR(v + 0.1 * (std::exp(10 * v) - 1), 1, 1e-6);
}

TEST(EventRun, TellsTimesOfPicosecondsApart) {
    const Simulated run = runOf(R"(
        model M Real x(start = 0, fixed = true), y;
        equation
          y = if time < 4e-12 then 0 else if time < 4.1e-12 then (time - 4e-12)/1e-13 else 1;
          der(x) = 1e12*y;
        end M;)",
                                {"x"}, 1e-11);
    ASSERT_RAN(run);
    EXPECT_NEAR(run.last("x"), 0.05 + 5.9, 1e-6);
}

TEST(EventRun, SamplesMayBeginWhereAnInitialEquationSays) {
    const Simulated run = runOf(R"(
        model M parameter Real f = 4; discrete Real y(start = 0, fixed = true); Real x(start = 0, fixed = true);
          parameter Real t0(fixed = false);
        initial equation t0 = time;
        equation
          der(x) = 1;
          when sample(t0 + 1/f, 1/f) then y = f*pre(x); reinit(x, 0); end when;
        end M;)",
                                {"x", "y"}, 1.1);
    ASSERT_RAN(run);
    EXPECT_EQ(run.at(0.24, "y"), 0);
    EXPECT_NEAR(run.at(0.26, "y"), 1, 1e-6);
    EXPECT_NEAR(run.at(0.6, "x"), 0.1, 1e-3);
    const Simulated bad = runOf(
        "model M parameter Real d = 0; Integer n(start = 0, fixed = true); equation "
        "when sample(0, d) then n = pre(n) + 1; end when; end M;",
        {"n"});
    ASSERT_FALSE(bad.faults.empty());
    EXPECT_THAT(format(bad.faults), HasSubstr("with an interval of 0 s"));
}

TEST(EventRun, ASubscriptThatLeavesItsArrayEndsTheSimulation) {
    const std::string model = R"(
        model M parameter Real a[3] = {10, 20, 30}; Integer k; Real y;
        equation k = integer(4*time) + 1; y = )";
    const Simulated run = runOf(model + "a[k]; end M;", {"y"}, 0.6);
    ASSERT_RAN(run);
    EXPECT_EQ(run.at(0.3, "y"), 20);
    EXPECT_EQ(run.last("y"), 30);
    const Simulated outside = runOf(model + "a[k]; end M;", {"y"}, 1);
    ASSERT_FALSE(outside.faults.empty());
    EXPECT_THAT(format(outside.faults), HasSubstr("at t = 0.75 s"));
    EXPECT_THAT(format(outside.faults), HasSubstr("the subscript 4 is outside 1:3"));
    const Simulated guarded = runOf(model + "if k <= 3 then a[k] else -1; end M;", {"y"}, 1);
    ASSERT_RAN(guarded);
    EXPECT_EQ(guarded.last("y"), -1);
}

TEST(EventRun, TimeEventsAreExactAndTheFirstActiveBranchCounts) {
    const Simulated run = runOf(R"(
        model M Real y; discrete Real a(start = 0, fixed = true); Boolean late;
        equation
          y = if time < 0.3 then 1 else 2;
          late = 2*time - 0.2 > 1;
          when {time >= 0.5, late} then a = 1; elsewhen time >= 0.5 then a = 2; elsewhen time >= 0.7 then a = 3; end when;
        end M;)",
                                {"y", "a", "late"});
    ASSERT_RAN(run);
    EXPECT_EQ(run.at(0.49, "a"), 0);
    EXPECT_EQ(run.at(0.5, "a"), 1);
    EXPECT_EQ(run.at(0.6 + 1e-9, "late"), 1);
    EXPECT_EQ(run.at(0.65, "a"), 1);
    EXPECT_EQ(run.last("a"), 3);
    EXPECT_EQ(run.at(0.3 - 1e-9, "y"), 1);
    EXPECT_EQ(run.at(0.3, "y"), 2);
}

TEST(EventRun, AHysteresisRemembers) {
    const Simulated run = runOf(R"(
        model M Real u; Boolean on(start = false, fixed = true);
        equation
          u = sin(6.283185307179586*time);
          on = u > 0.5 or pre(on) and u > -0.5;
        end M;)",
                                {"u", "on"});
    ASSERT_RAN(run);
    EXPECT_EQ(run.at(0.05, "on"), 0);
    EXPECT_EQ(run.at(1.0 / 12 + 1e-6, "on"), 1);
    EXPECT_EQ(run.at(7.0 / 12 - 1e-6, "on"), 1);
    EXPECT_EQ(run.at(7.0 / 12 + 1e-6, "on"), 0);
}

TEST(EventRun, AlgorithmsSetDiscreteVariablesInTheirOrder) {
    const Simulated run = runOf(R"(
        model M Integer n(start = 0, fixed = true), m; Real y;
        algorithm
          when sample(0.25, 0.25) then n := pre(n) + 1; n := n + 10; end when;
          m := 0;
          for k in 1:n loop if k > 11 then break; end if; m := m + k; end for;
          y := if n > 0 then n else -1;
        end M;)",
                                {"n", "y"});
    // the range of the loop is not known before the simulation: told, not guessed
    ASSERT_FALSE(run.faults.empty());
    const Simulated sound = runOf(R"(
        model M Integer n(start = 0, fixed = true); Real y;
        algorithm
          when sample(0.25, 0.25) then n := pre(n) + 1; n := n + 10; end when;
          y := if n > 0 then n else -1;
        end M;)",
                                  {"n", "y"});
    ASSERT_RAN(sound);
    EXPECT_EQ(sound.at(0.2, "y"), -1);
    EXPECT_EQ(sound.at(0.3, "y"), 11);
    EXPECT_EQ(sound.at(0.6, "n"), 22);
}

TEST(EventRun, FunctionsRunWithLoopsRecordsAndSeveralOutputs) {
    const Simulated run = runOf(R"(
        package P
          record R Real a; Real b[2]; end R;
          function f input Real x; input Integer n = 3; output Real y; output R r; protected Real z;
          algorithm
            y := 0; z := 1;
            for i in 1:n loop z := z*x; y := y + z; end for;
            if x > 0.5 then y := -y; end if;
            r.a := x; r.b := {x, 2*x}; r.b[2] := r.b[2] + 1;
          end f;
        end P;
        model M Real y, q; P.R r; Real only;
        equation (y, r) = P.f(time); q = r.b[2]; only = P.f(time, n = 1); end M;)",
                                {"y", "q", "only", "r.a"});
    ASSERT_RAN(run);
    EXPECT_NEAR(run.at(0.4, "y"), 0.4 + 0.16 + 0.064, 1e-9);
    EXPECT_NEAR(run.last("y"), -3, 1e-9);
    EXPECT_NEAR(run.last("q"), 3, 1e-9);
    EXPECT_NEAR(run.at(0.4, "only"), 0.4, 1e-9);
    EXPECT_NEAR(run.last("r.a"), 1, 1e-9);
}

TEST(EventRun, AnAssertionEndsTheSimulationAndAWarningIsToldOnce) {
    const std::string model =
        "model M Real x(start = 0, fixed = true); equation der(x) = 1; assert(x < 0.5, \"too far\"";
    const Simulated run = runOf(model + "); end M;", {"x"});
    ASSERT_FALSE(run.faults.empty());
    EXPECT_THAT(format(run.faults), HasSubstr("too far"));
    const Simulated warned = runOf(model + ", AssertionLevel.warning); end M;", {"x"});
    ASSERT_RAN(warned);
    EXPECT_EQ(warned.trajectory.remarks.size(), 1u);
}

TEST(EventRun, APeriodicTimeTableGoesOnFromEventToEvent) {
    const Simulated run = runOf(R"(
        package T
          class Table extends ExternalObject;
            function constructor input Real table[:, :]; output Table t;
              external "C" t = ModelicaStandardTables_CombiTimeTable_init3("NoName", "NoName", table, 3, 2, 0, {2}, 1, 3,
                3, 0, 1, false, ",", 0); end constructor;
            function destructor input Table t; external "C" ModelicaStandardTables_CombiTimeTable_close(t); end destructor;
          end Table;
          function value input Table t; input Real time_; input Real next; output Real y;
            external "C" y = ModelicaStandardTables_CombiTimeTable_getValue(t, 1, time_, next, next); end value;
          function event input Table t; input Real time_; output Real next;
            external "C" next = ModelicaStandardTables_CombiTimeTable_nextTimeEvent(t, time_); end event;
        end T;
        model M
          parameter T.Table t = T.Table({{0, 1}, {0.3, 2}, {0.7, 3}});
          Real y; discrete Real next(start = 0, fixed = true); Integer n(start = 0, fixed = true);
        equation
          when {time >= pre(next), initial()} then next = T.event(t, time); n = pre(n) + 1; end when;
          y = T.value(t, time, next);
        end M;)",
                                {"y", "n", "next"}, 70);
    ASSERT_RAN(run);
    EXPECT_EQ(run.at(69.95, "n"), 200);  // at 0, twice in each of 99 periods, once in the last
    EXPECT_EQ(run.at(69.59, "y"), 1);
    EXPECT_EQ(run.at(69.61, "y"), 2);
    EXPECT_EQ(run.at(69.31, "y"), 1);
}

/// A pipe that the heat of Q warms, between a cold and a warm reservoir; what mixes at a joint has no mass.
const char* const throughPipe = R"(
        model M
          Real T(start = 20, fixed = true), left, right, middle, first, second;
          Real m = if time < 0.3 then 2 else if time < 0.6 then 0 else -2;
        equation
          semiLinear(m, left, T) + semiLinear(-m, right, T) + 3 = 5*der(T);
          semiLinear(m, left, T) + semiLinear(-m, left, 10) = 0;
          semiLinear(-m, right, T) + semiLinear(m, right, middle) = 0;
          first = semiLinear(m, right, middle);
          second = semiLinear(-m, 70, middle);
          first + second = 0;
        end M;)";

TEST(EventRun, AMixtureWithoutFlowIsTheMeanOfWhatIsAroundIt) {
    const Simulated run = runOf(throughPipe, {"T", "left", "right", "middle", "first"}, 1, 1e-10);
    ASSERT_RAN(run);
    // 2*(10 - T) + 3 = 5 T'; then 3 = 5 T'; then 2*(70 - T) + 3 = 5 T'
    const double first = 11.5 + 8.5 * std::exp(-0.4 * 0.3), second = first + 0.6 * 0.3;
    EXPECT_NEAR(run.at(0.2999, "left"), 10, 1e-9);
    EXPECT_NEAR(run.at(0.5, "T"), first + 0.6 * 0.2, 1e-7);
    const double T = run.at(0.45, "T");
    EXPECT_NEAR(run.at(0.45, "left"), (10 + T) / 2, 1e-9);
    EXPECT_NEAR(run.at(0.45, "right"), T + (70 - T) / 3, 1e-9);
    EXPECT_NEAR(run.at(0.45, "middle"), T + 2 * (70 - T) / 3, 1e-9);
    EXPECT_EQ(run.at(0.45, "first") + 1, 1);
    EXPECT_NEAR(run.at(0.9, "right"), 70, 1e-9);
    EXPECT_NEAR(run.last("T"), 71.5 - (71.5 - second) * std::exp(-0.4 * 0.4), 1e-6);
}

TEST(EventRun, RandomNumbersAreDrawnAtSamples) {
    const Simulated run = runOf(R"(
        function draw input Integer before[2]; output Real number; output Integer after[2];
          external "C" ModelicaRandom_xorshift64star(before, after, number); end draw;
        model M Real r(start = 0, fixed = true); Integer state[2](start = {1, 0}, each fixed = true);
        equation
          when sample(0.1, 0.1) then (r, state) = draw(pre(state)); end when;
        end M;)",
                                {"r"}, 0.55);
    ASSERT_RAN(run);
    std::uint64_t x = 1;
    for (int k = 1; k <= 5; ++k) {
        x ^= x >> 12;
        x ^= x << 25;
        x ^= x >> 27;
        x *= 2685821657736338717u;
        const double number = static_cast<double>(static_cast<std::int64_t>(x)) * std::ldexp(1, -64) + 0.5;
        EXPECT_EQ(run.at(0.1 * k + 0.04, "r"), number) << k;
    }
}

TEST(EventRun, ADelayedSignalArrivesWithItsJumpsAndItsKinks) {
    // A delayed feedback: x' = -x(t - 0.5) from 1 on is a line, then a parabola. A delayed step counts at 0.3 + 0.25.
    const Simulated run = runOf(R"(
        model M Real x(start = 1, fixed = true), s, d, e; Integer n(start = 0, fixed = true); parameter Real T = 0.5;
        equation
          der(x) = -delay(x, T);
          s = if time > 0.3 then 2 else 1; d = delay(s, T/2); e = noEvent(if d > 1.5 then delay(s, T) else 7);
          when d > 1.5 then n = pre(n) + 1; end when;
        end M;)",
                                {"x", "d", "e", "n"}, 1);
    ASSERT_RAN(run);
    EXPECT_NEAR(run.at(0.5, "x"), 0.5, 1e-6);
    EXPECT_NEAR(run.last("x"), 1 - 1 + 0.125, 1e-5);
    EXPECT_EQ(run.at(0.54, "d"), 1);
    EXPECT_EQ(run.at(0.551, "d"), 2);
    EXPECT_EQ(run.at(0.54, "n"), 0);
    EXPECT_EQ(run.at(0.551, "n"), 1);
    EXPECT_EQ(run.at(0.7, "e"), 1);
    EXPECT_EQ(run.last("e"), 2);
}

TEST(EventRun, ALineSendsBackWhatItsOtherEndSentBefore) {
    // An ideal line of 1 s, open at its end, behind its own resistance: half the voltage, then all of it.
    const Simulated run = runOf(R"(
        model M Real v1, v2, i1, e1, e2; parameter Real Z = 50; Real u = if time > 0.5 then 10 else 0;
        equation
          e1 = 2*delay(v2, 1) - delay(e2, 1); e2 = 2*delay(v1, 1) - delay(e1, 1);
          v1 = e1 + Z*i1; u = v1 + Z*i1; v2 = e2;
        end M;)",
                                {"v1", "v2"}, 4);
    ASSERT_RAN(run);
    EXPECT_NEAR(run.at(1.4, "v1"), 5, 1e-9);
    EXPECT_NEAR(run.at(1.4, "v2"), 0, 1e-9);
    EXPECT_NEAR(run.at(1.6, "v2"), 10, 1e-9);
    EXPECT_NEAR(run.at(2.4, "v1"), 5, 1e-9);
    EXPECT_NEAR(run.at(2.6, "v1"), 10, 1e-9);
}

TEST(EventRun, AnElementMayBeChosenAndSetByAnIndexThatRuns) {
    const auto model = [](int size) {
        return "function last input Real x; input Integer i; output Real y; protected Real a[3] = {1, 2, 3}; "
               "algorithm a[i] := x; y := a[1] + a[2] + a[3]; end last; "
               "model M Integer n(start = 0, fixed = true); discrete Real buf[" +
               std::to_string(size) +
               "](each start = 0, each fixed = true); parameter Real rows[3, 2] = {{1, 2}, {3, 4}, {5, 6}}; Real r[2], "
               "y; "
               "algorithm when sample(0, 0.1) then n := pre(n) + 1; if n <= 5 then buf[n] := time; end if; end when; "
               "equation r = rows[min(n, 3), :]; y = last(10, min(n, 3)); end M;";
    };
    const Simulated run = runOf(model(5), {"buf[1]", "buf[3]", "buf[5]", "r[1]", "r[2]", "y"}, 0.95);
    ASSERT_RAN(run);
    EXPECT_EQ(run.at(0.15, "buf[3]"), 0);
    EXPECT_NEAR(run.last("buf[3]"), 0.2, 1e-12);
    EXPECT_NEAR(run.last("buf[5]"), 0.4, 1e-12);
    EXPECT_EQ(run.at(0.15, "r[1]"), 3);
    EXPECT_EQ(run.at(0.15, "r[2]"), 4);
    EXPECT_EQ(run.at(0.15, "y"), 14);
    EXPECT_EQ(run.last("r[2]"), 6);
    EXPECT_EQ(run.last("y"), 13);
    EXPECT_THAT(format(runOf(model(4), {"n"}, 0.95).faults),
                HasSubstr("at t = 0.4 s: the subscript of 'buf[n]' is outside the array"));
}

/// Three windings whose star point is open: the currents sum to zero, and so does what the space phasor adds to them,
/// but for rounding. Only the zero component can be given up, although it would rather be a state.
TEST(EventRun, TheStateIsGivenUpThatAConstraintFixes) {
    const Simulated run = runOf(R"(
        model M
          parameter Real T[3, 2] = {{cos(2*3.141592653589793*k/3), sin(2*3.141592653589793*k/3)} for k in 0:2};
          Real i[3], v[3], e[3], n, a[2], va[2], z(start = 0, stateSelect = StateSelect.prefer), vz;
        initial equation
          i[1] = 0; i[2] = 0;
        equation
          for k in 1:2 loop
            a[k] = 2/3*sum(T[j, k]*i[j] for j in 1:3);
            va[k] = 2/3*sum(T[j, k]*v[j] for j in 1:3);
            va[k] = 0.5*a[k] + 0.1*der(a[k]);
          end for;
          z = sum(i)/3; vz = sum(v)/3; vz = 0.5*z + 0.02*der(z);
          for k in 1:3 loop
            v[k] = e[k] - n;
            e[k] = cos(5*time - 2*3.141592653589793*(k - 1)/3) + (if k == 1 then 0.3 else 0);
          end for;
          sum(i) = 0;
        end M;)",
                                {"i[1]", "i[2]", "z"});
    ASSERT_RAN(run);
    const double t = 1, decay = std::exp(-5 * t), second = 2 * M_PI / 3;
    EXPECT_NEAR(run.last("i[1]"), 0.4 * (1 - decay) + std::cos(5 * t) + std::sin(5 * t) - decay, 1e-6);
    // of this phase nothing was left where the zero component stayed a state
    EXPECT_NEAR(
        run.last("i[2]"),
        std::cos(5 * t - second) + std::sin(5 * t - second) - 0.2 + (0.2 - std::cos(second) + std::sin(second)) * decay,
        1e-6);
    EXPECT_NEAR(run.last("z"), 0, 1e-12);
}

TEST(EventRun, AParameterMayFollowOneThatIsFoundAtTheStart) {
    const Simulated run = runOf(R"(
        model M
          parameter Real late(fixed = false), twice = 2*late, thrice = late + twice;
          Real x(start = 0, fixed = true);
        initial equation
          late = 0.1 + time;
        equation
          der(x) = if time >= thrice then 1 else 0;
        end M;)",
                                {"thrice", "x"});
    ASSERT_RAN(run);
    EXPECT_NEAR(run.last("thrice"), 0.3, 1e-12);
    EXPECT_NEAR(run.last("x"), 0.7, 1e-9);
}

TEST(EventRun, StiffRatesThatAreDifferencesOfLargeNumbersTakeFewSteps) {
    // 1000 + x has one digit more than x needs: quotients of differences of the rate say nothing of its slope
    const Simulated run = runOf(
        "model M Real x(start = 0, fixed = true); equation der(x) = 1e9*((1000 + 1e-6*sin(10*time)) - (1000 + x)); "
        "end M;",
        {"x"}, 1, 1e-6);
    ASSERT_RAN(run);
    EXPECT_LT(run.trajectory.steps, 1000) << "128817 with a matrix by differences";
    EXPECT_NEAR(run.last("x"), 1e-6 * std::sin(10.0), 1e-8);
}

TEST(EventRun, GoesOnByDifferencesWhereSlopesHaveNoValue) {
    // the slope of the root is infinite where it begins
    const Simulated run =
        runOf("model M Real x(start = 0, fixed = true); equation der(x) = 1 - 0.5*sqrt(noEvent(max(x, 0))); end M;",
              {"x"}, 1, 1e-6);
    ASSERT_RAN(run);
    // t = -4 (s + 2 ln(1 - s/2)) with s = sqrt(x)
    const double s = std::sqrt(run.last("x"));
    EXPECT_NEAR(-4 * (s + 2 * std::log(1 - s / 2)), 1, 1e-4);
}

TEST(EventRun, TextsThatChangeAreComparedAsTheyAre) {
    const Simulated run = runOf(R"(
        model M
          type E = enumeration(one, two, three);
          E e = if time < 0.2 then E.one else if time < 0.6 then E.two else E.three;
          Boolean isTwo = "is " + String(e) == "is two", isLate = String(time > 0.4) <> "false", isBehind = String(e) > "p";
        end M;)",
                                {"isTwo", "isLate", "isBehind"});
    ASSERT_RAN(run);
    for (const auto& [time, two, late, behind] :
         {std::tuple(0.1, 0, 0, 0), std::tuple(0.3, 1, 0, 1), std::tuple(0.5, 1, 1, 1), std::tuple(0.7, 0, 1, 1)}) {
        EXPECT_EQ(run.at(time, "isTwo"), two) << time;
        EXPECT_EQ(run.at(time, "isLate"), late) << time;
        EXPECT_EQ(run.at(time, "isBehind"), behind) << time;
    }
    const Simulated refused = runOf("model M Boolean b = String(3*time) == \"3\"; end M;", {"b"});
    EXPECT_THAT(format(refused.faults), HasSubstr("changes during the simulation: it cannot be compared"));
}

TEST(EventRun, ABranchMayDependOnAParameterThatIsFoundAtTheStart) {
    const auto model = [](const std::string& a) {
        return "model M parameter Real a = " + a +
               ", b(fixed = false); parameter Boolean isLarge(fixed = false); Real y; initial algorithm b := 2*a; "
               "isLarge := false; if b > 5 then isLarge := true; b := 5; end if; "
               "equation if isLarge then y = b + 1; else y = 2*b; end if; end M;";
    };
    const Simulated large = runOf(model("3"), {"y"}), small = runOf(model("2"), {"y"});
    ASSERT_RAN(large);
    ASSERT_RAN(small);
    EXPECT_NEAR(large.last("y"), 6, 1e-12);
    EXPECT_NEAR(small.last("y"), 8, 1e-12);
}

}  // namespace
}  // namespace analogon
