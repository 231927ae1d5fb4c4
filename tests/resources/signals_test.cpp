#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/resources/bench.hpp"

namespace analogon::bench {
namespace {

TEST(Signals, GainSumAndProductAreArithmetic) {
    const Recording r = run(R"(
  Analogon.Interfaces.RealInput a, b;
  Analogon.Signals.Gain gain(k=-3);
  Analogon.Signals.Sum sum;
  Analogon.Signals.Product product;
  Analogon.Sources.Constant two(k=2);
  Analogon.Signals.Sum shifted;
  Analogon.Interfaces.RealOutput g, s, p, c;
equation
  connect(a, gain.u);
  connect(a, sum.u1);
  connect(b, sum.u2);
  connect(a, product.u1);
  connect(b, product.u2);
  connect(a, shifted.u1);
  connect(two.y, shifted.u2);
  connect(gain.y, g);
  connect(sum.y, s);
  connect(product.y, p);
  connect(shifted.y, c);)",
                            4, 9, {[](double t) { return t; }, [](double t) { return 5 - 2 * t; }});
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "g", [](double t) { return -3 * t; }), 1e-12);
    EXPECT_LT(worst(r, "s", [](double t) { return 5 - t; }), 1e-12);
    EXPECT_LT(worst(r, "p", [](double t) { return t * (5 - 2 * t); }), 1e-12);
    EXPECT_LT(worst(r, "c", [](double t) { return t + 2; }), 1e-12);
}

TEST(Signals, FirstOrderAnswersAStepExponentially) {
    const Recording r = run(R"(
  Analogon.Interfaces.RealInput u;
  Analogon.Signals.FirstOrder lag(T=0.5);
  Analogon.Interfaces.RealOutput y;
equation
  connect(u, lag.u);
  connect(lag.y, y);)",
                            3, 31, {[](double) { return 4.0; }});
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "y", [](double t) { return 4 * (1 - std::exp(-t / 0.5)); }), 1e-7);
}

/// The value of a source, alone and through a lag: jumps must not be missed by what is integrated.
Recording source(const std::string& declared, double duration = 4) {
    return run("  Analogon.Sources." + declared + R"(;
  Analogon.Signals.FirstOrder lag(T=0.5);
  Analogon.Interfaces.RealOutput y, lagged;
equation
  connect(source.y, y);
  connect(source.y, lag.u);
  connect(lag.y, lagged);)",
               duration, 201);
}

TEST(Sources, StepJumpsAtItsStart) {
    const Recording r = source("Step source(height=3, offset=-1, startTime=1.013)");
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "y", [](double t) { return t < 1.013 ? -1 : 2; }), 1e-12);
    const auto lagged = [](double t) {
        const double before = -(1 - std::exp(-t / 0.5));
        return before + (t < 1.013 ? 0 : 3 * (1 - std::exp(-(t - 1.013) / 0.5)));
    };
    EXPECT_LT(worst(r, "lagged", lagged), 1e-6);
}

TEST(Sources, RampRisesAndKeepsItsHeight) {
    const Recording r = source("Ramp source(height=4, duration=2, offset=1, startTime=0.5)");
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "y", [](double t) { return 1 + 4 * std::min(1.0, std::max(0.0, (t - 0.5) / 2)); }), 1e-12);
    const Recording step = source("Ramp source(duration=0, startTime=0.49)");
    ASSERT_EQ(step.fault, "");
    EXPECT_LT(worst(step, "y", [](double t) { return t < 0.49 ? 0 : 1; }), 1e-12) << "without a duration it is a step";
}

TEST(Sources, SineSwingsAboutItsOffset) {
    const Recording r = source("Sine source(amplitude=2, f=1.5, phase=0.3, offset=5, startTime=0.25)");
    ASSERT_EQ(r.fault, "");
    const double pi = std::acos(-1);
    EXPECT_LT(worst(r, "y", [=](double t) { return t < 0.25 ? 5 : 5 + 2 * std::sin(2 * pi * 1.5 * (t - 0.25) + 0.3); }),
              1e-12);
}

TEST(Sources, PulseAndTrapezoidRepeatThemselves) {
    const Recording pulse = source("Pulse source(amplitude=2, width=25, period=0.805, offset=1, startTime=0.31)");
    ASSERT_EQ(pulse.fault, "");
    const auto since = [](double t, double start, double period) {
        return t - start - period * std::floor((t - start) / period);
    };
    EXPECT_LT(worst(pulse, "y", [&](double t) { return t >= 0.31 && since(t, 0.31, 0.805) < 0.25 * 0.805 ? 3 : 1; }),
              1e-12);
    const Recording trapezoid =
        source("Trapezoid source(amplitude=2, rising=0.2, width=0.3, falling=0.4, period=1.3, startTime=0.11)");
    ASSERT_EQ(trapezoid.fault, "");
    EXPECT_LT(worst(trapezoid, "y",
                    [&](double t) {
                        const double s = since(t, 0.11, 1.3);
                        if (t < 0.11 || s > 0.9) return 0.0;
                        return s < 0.2 ? 2 * s / 0.2 : s < 0.5 ? 2.0 : 2 * (0.9 - s) / 0.4;
                    }),
              1e-9);
    const Recording square = source("Trapezoid source(rising=0, width=0.5, falling=0, startTime=0.01)");
    ASSERT_EQ(square.fault, "");
    EXPECT_LT(worst(square, "y", [&](double t) { return t >= 0.01 && since(t, 0.01, 1) < 0.5 ? 1 : 0; }), 1e-12);
}

TEST(Sources, ChirpSweepsItsFrequencyAndKeepsTheLast) {
    const Recording r = source("Chirp source(amplitude=2, f1=0.5, f2=3, duration=2, offset=1, startTime=0.5)");
    ASSERT_EQ(r.fault, "");
    const double pi = std::acos(-1);
    EXPECT_LT(worst(r, "y",
                    [=](double t) {
                        const double s = std::max(0.0, t - 0.5), swept = std::min(s, 2.0);
                        return 1 + 2 * std::sin(2 * pi * (0.5 * swept + 2.5 * swept * swept / 4 + 3 * (s - swept)));
                    }),
              1e-9);
}

TEST(Sources, TimeTableRunsThroughItsPointsAndKeepsTheLast) {
    const Recording r = source("TimeTable source(t={0.5, 1, 2.5}, value={1, 4, 3})");
    ASSERT_EQ(r.fault, "");
    EXPECT_LT(worst(r, "y",
                    [](double t) {
                        if (t <= 0.5) return 1.0;
                        return t <= 1 ? 1 + 6 * (t - 0.5) : t <= 2.5 ? 4 - (t - 1) / 1.5 : 3.0;
                    }),
              1e-12);
}

}  // namespace
}  // namespace analogon::bench
