#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/core/simulate/class_run.hpp"

namespace analogon {
namespace {

using test::runOf;
using test::Simulated;

/// A rotor under a constant torque, with an encoder that a board reads every 10 ms, and the times of two turns.
constexpr const char* encoder = R"(
    model M
      constant Real pi = 3.141592653589793;
      parameter Real q = 2*pi/64;
      Real phi(start = 0, fixed = true), w(start = 0, fixed = true), shown;
      discrete Real phi_q(start = 0, fixed = true), w_est(start = 0, fixed = true);
      discrete Real t0[2](each start = -1, each fixed = true);
    equation
      der(phi) = w;
      0.01*der(w) = 0.05;
      shown = w_est;
      when sample(0, 0.01) then
        phi_q = q*floor(phi/q);
        w_est = (phi_q - pre(phi_q))/0.01;
      end when;
      when phi > 2*pi then t0[1] = time; end when;
      when phi > 4*pi then t0[2] = time; end when;
    end M;)";

TEST(EventIntegration, SamplesThatOnlyMeasureLeaveTheMotionAsExactAsItIsWithoutThem) {
    const Simulated run = runOf(encoder, {"phi", "w_est", "shown", "t0[1]", "t0[2]"}, 3, 1e-6);
    ASSERT_RAN(run);
    EXPECT_NEAR(run.last("phi"), 22.5, 2e-5);
    EXPECT_NEAR(run.last("t0[1]"), std::sqrt(2 * std::numbers::pi / 2.5), 2e-6);
    EXPECT_NEAR(run.last("t0[2]"), std::sqrt(4 * std::numbers::pi / 2.5), 2e-6);
    const double mark = 2 * std::numbers::pi / 64;
    for (int k = 1; k < 300; ++k) {
        const double now = std::floor(2.5 * 1e-4 * k * k / mark),
                     before = std::floor(2.5e-4 * (k - 1) * (k - 1) / mark);
        EXPECT_NEAR(run.at(0.01 * k, "w_est"), (now - before) * mark / 0.01, 1e-9) << "sample " << k;
        EXPECT_EQ(run.at(0.01 * k, "shown"), run.at(0.01 * k, "w_est"));
    }
}

TEST(EventIntegration, AMarkThatOnlyASampleAsksForIsNoEvent) {
    const Simulated run = runOf(encoder, {"phi"}, 3, 1e-6);
    ASSERT_RAN(run);
    EXPECT_EQ(run.trajectory.events, 302);  // 0.01 s, 0.02 s, …, 3 s, and two turns
    EXPECT_LT(run.trajectory.steps, 1000);
}

TEST(EventIntegration, ASampleThatDrivesTheMotionBeginsANewOne) {
    // x' = -u, where u was x at the last sample: straight from one to the next
    const Simulated run = runOf(R"(
        model M Real x(start = 1, fixed = true); discrete Real u(start = 0, fixed = true); Real v;
        equation
          der(x) = -v; v = u;
          when sample(0, 0.1) then u = if x > 0.5 then x else 0.5; end when;
        end M;)",
                                {"x"}, 1, 1e-6);
    ASSERT_RAN(run);
    double x = 1;
    for (int k = 0; k < 10; ++k) {
        EXPECT_NEAR(run.at(0.1 * k, "x"), x, 1e-9);
        EXPECT_NEAR(run.at(0.1 * k + 0.05, "x"), x - 0.05 * std::max(x, 0.5), 2e-5);
        x -= 0.1 * std::max(x, 0.5);
    }
}

}  // namespace
}  // namespace analogon
