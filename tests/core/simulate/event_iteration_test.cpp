#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/core/simulate/class_run.hpp"

namespace analogon {
namespace {

using test::runOf;
using test::Simulated;
using ::testing::HasSubstr;

TEST(EventIteration, OnTheBorderTheRelationItselfDecides) {
    // the ramp ends in an event, and there the difference is 0 exactly
    const Simulated run = runOf(R"(
        model M Real f; Boolean free;
        equation
          f = 1 - (if time < 0.5 then 2*time else 1);
          free = 100*f <= 0;
        end M;)",
                                {"f", "free"});
    ASSERT_RAN(run);
    EXPECT_EQ(run.at(0.49, "free"), 0);
    EXPECT_EQ(run.at(0.51, "free"), 1);
}

TEST(EventIteration, ALoopOfDiscreteAndContinuousQuantitiesIsSolved) {
    // an ideal diode: off decides the current, and the voltage of the diode decides off
    const Simulated run = runOf(R"(
        model M Real s, i, v, u; Boolean off(start = true);
        equation
          u = sin(6.283185307179586*time);
          off = s < 0;
          v = s*(if off then 1 else 1e-5);
          i = s*(if off then 1e-5 else 1);
          u = v + i;
        end M;)",
                                {"i", "off"});
    ASSERT_RAN(run);
    EXPECT_NEAR(run.at(0.25, "i"), 1 / (1 + 1e-5), 1e-9);
    EXPECT_NEAR(run.at(0.75, "i"), -1e-5 / (1 + 1e-5), 1e-9);
    EXPECT_EQ(run.at(0.75, "off"), 1);
}

/// A shaft that two brakes hold for half a second. What each of them takes is open meanwhile.
std::string twoBrakes(const std::string& second, const std::string& more = "") {
    return "model M parameter Real J = 2; Real w(start = 0, fixed = true), a, f1, f2, y(start = 0, fixed = true); "
           "Boolean isHeld = time < 0.5; equation der(w) = a; J*a = 3 - f1 - f2; 0 = if isHeld then a else f1; "
           "0 = if isHeld then " +
           second + " else f2; der(y) = " + (more.empty() ? "w" : more) + "; end M;";
}

TEST(EventIteration, EquationsThatRepeatEachOtherTakeTheSmallestValues) {
    const Simulated run = runOf(twoBrakes("2*a"), {"w", "f1", "f2"});
    ASSERT_RAN(run);
    EXPECT_NEAR(run.at(0.4, "f1") + run.at(0.4, "f2"), 3, 1e-12);
    EXPECT_LE(std::fabs(run.at(0.4, "f1")), 3);
    EXPECT_NEAR(run.at(0.4, "w"), 0, 1e-12);
    EXPECT_NEAR(run.last("w"), 0.75, 1e-6);
    ASSERT_EQ(run.trajectory.remarks.size(), 1u);
    EXPECT_THAT(run.trajectory.remarks[0].message.english(),
                HasSubstr("open for a time, since they repeat each other"));
}

TEST(EventIteration, EquationsThatContradictEachOtherHaveNoSolution) {
    EXPECT_THAT(format(runOf(twoBrakes("a - 1"), {"w"}).faults), HasSubstr("has no value"));
}

TEST(EventIteration, WhatTheEquationsLeaveOpenMustNotMoveTheStates) {
    EXPECT_THAT(format(runOf(twoBrakes("a", "f1"), {"w"}).faults),
                HasSubstr("the equations leave 'f1' open, and 'y' depends on it"));
}

TEST(EventIteration, WhatKeepsSwitchingIsNamed) {
    const Simulated run =
        runOf("model M Boolean b(start = false, fixed = true); equation b = not pre(b); end M;", {"b"});
    ASSERT_FALSE(run.faults.empty());
    EXPECT_THAT(format(run.faults), HasSubstr("'b' keeps switching"));
}

TEST(EventIteration, WhatLetsGoWithAJumpOfItsLoadFindsRestByWhatWasBefore) {
    // A body sticks up to 2 N and slides against 1 N from then on: between them neither sticking nor sliding agrees
    // with itself, until pre(slides) says which one it is.
    const Simulated run = runOf(R"(
        model M
          Real v(start = 0, fixed = true), a, s, f = 4*time; Boolean slides(start = false, fixed = true);
        equation
          slides = s > 2 or pre(slides) and s > 1;
          a = if slides then s - 1 else 0;
          f = 10*a + (if slides then 1 else s);
          der(v) = a;
        end M;)",
                                {"v", "slides"});
    ASSERT_RAN(run);
    EXPECT_EQ(run.at(0.499, "slides"), 0);
    EXPECT_EQ(run.at(0.501, "slides"), 1);
    EXPECT_NEAR(run.last("v"), (0.5 * 4 * (1 - 0.25) - 0.5) / 10, 1e-6);  // of (4 t - 1)/10 from 0.5 on
}

TEST(EventIteration, ARelationThatFindsNoRestIsToldByItsText) {
    const Simulated run = runOf("model M Real y; equation y = if y > 0.5 + time then 0 else 1; end M;", {"y"}, 0.1);
    EXPECT_THAT(format(run.faults), HasSubstr("'y > 0.5 + time' keeps switching"));
}

/// Two frictions on one shaft, of 0.5 and of 3 N.m, against a torque that grows. Where both hold, each takes half; the
/// first then begins to slide, whereupon the second holds it exactly on its border.
TEST(EventIteration, AFrictionThatBeginsToSlideWhereAnotherHoldsStaysOnItsBorder) {
    const Simulated run = runOf(R"(
        model M Real w(start = 0, fixed = true), a, sa1, sa2, tau1, tau2; Boolean slides1(start = false), slides2;
        equation
          der(w) = a;
          a = 4*time - tau1 - tau2;
          slides1 = sa1 > 0.5; slides2 = sa2 > 3;
          a = if slides1 then sa1 - 0.5 else 0;
          a = if slides2 then sa2 - 3 else 0;
          tau1 = if slides1 then 0.5 else sa1;
          tau2 = if slides2 then 3 else sa2;
        end M;)",
                                {"w", "tau1", "tau2", "slides1", "slides2"});
    ASSERT_RAN(run);
    EXPECT_NEAR(run.at(0.2, "tau1"), 0.4, 1e-9);  // the smallest values
    EXPECT_EQ(run.at(0.3, "slides1"), 1);
    EXPECT_NEAR(run.at(0.5, "tau2"), 1.5, 1e-9);
    EXPECT_NEAR(run.at(0.87, "w"), 0, 1e-9);
    EXPECT_NEAR(run.last("w"), 2 * (1 - 0.875) * (1 - 0.875), 1e-6);
}

/// A line without losses, fed with a direct voltage: at the start both waves are what they were before. From an end
/// that is all but open nearly all of a wave goes back: taken in turn they come to no rest.
TEST(EventIteration, DelayedSignalsThatWaitForEachOtherAreFoundAtTheStart) {
    for (const double R : {200.0, 1e6}) {
        const Simulated run = runOf("model M parameter Real Z = 50, T = 0.1, R = " + std::to_string(R) + R"(;
        Real v1, v2, i1, i2, es, er;
        equation
          v1 = 10 + (if time < 0.5 then 0 else 5);
          i1 = (v1 - es)/Z; i2 = (v2 - er)/Z; v2 = -R*i2;
          es = 2*delay(v2, T) - delay(er, T);
          er = 2*delay(v1, T) - delay(es, T);
        end M;)",
                                    {"v2", "i1", "i2"});
        ASSERT_RAN(run);
        EXPECT_NEAR(run.at(0.3, "v2"), 10, 1e-9);
        EXPECT_NEAR(run.at(0.3, "i1"), 10 / R, 1e-9);
        EXPECT_NEAR(run.at(0.59, "v2"), 10, 1e-9);
        EXPECT_NEAR(run.at(0.65, "v2"), 10 + 2.0 * 5 * R / (R + 50), 1e-6);  // the wave arrives, and most goes back
    }
}

/// The logarithm of a number that is not drawn yet has no value: it has one when the number is there.
TEST(EventIteration, AnInitialValueMayFollowFromAnotherThatIsFoundWithIt) {
    const Simulated run = runOf(R"(
        model M discrete Real raw, r; Real x;
        initial equation
          r = log(raw); raw = exp(-1); x = r;
        equation
          when sample(0.5, 1) then raw = exp(-2); r = log(raw); end when;
          der(x) = r;
        end M;)",
                                {"r", "x"});
    ASSERT_RAN(run);
    EXPECT_NEAR(run.at(0.4, "r"), -1, 1e-12);
    EXPECT_NEAR(run.last("x"), -1 - 0.5 - 1, 1e-6);
}

}  // namespace
}  // namespace analogon
