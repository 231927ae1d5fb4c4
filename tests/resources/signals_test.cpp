#include <gtest/gtest.h>

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

}  // namespace
}  // namespace analogon::bench
