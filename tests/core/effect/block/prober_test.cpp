#include "core/effect/block/prober.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/block/candidates_of.hpp"
#include "tests/core/effect/lagging_body.hpp"

namespace analogon {
namespace {

/// An effect at its first place in a model, switched off.
Variant wiredInto(const NullModel& null, const std::string& kind) {
    const Candidate c = firstCandidate(null.variant, kind);
    Outcome<Variant> wired = withEffect(null.variant, c.effect, c.place, {});
    EXPECT_TRUE(wired) << format(wired.diagnostics());
    return wired ? std::move(*wired) : Variant{};
}

TEST(Prober, TakesTheSlopeAlongTheStrength) {
    const NullModel null = fittedModel(laggingBody(0, 2));
    const Variant wired = wiredInto(null, "sensor.offset");
    const SimulationOptions simulation;
    const Progress progress;
    Prober prober(null, wired, {}, simulation, progress);
    ASSERT_TRUE(prober.compile());
    EXPECT_EQ(prober.addedStates(), 0);
    Probe probe;
    ASSERT_TRUE(prober.take({}, 0, probe));
    // an offset of 1 K, in units of the noise
    const double unit = 1 / null.noise[0][0];
    EXPECT_TRUE(probe.column.isApproxToConstant(unit, 1e-6));
    EXPECT_NEAR(probe.strength(), 2, 0.3);
    EXPECT_EQ(probe.secant, 0);
}

/// The slope at no lag tells too little of a lag of seconds: the difference that it makes is taken, per second.
TEST(Prober, TakesASecantWhereTheSlopeMisleads) {
    const NullModel null = fittedModel(laggingBody(3));
    const Variant wired = wiredInto(null, "sensor.lag");
    const SimulationOptions simulation;
    const Progress progress;
    Prober prober(null, wired, {}, simulation, progress);
    ASSERT_TRUE(prober.compile());
    EXPECT_EQ(prober.addedStates(), 1);
    Probe near, far;
    ASSERT_TRUE(prober.take({}, 0.0625, near));
    ASSERT_TRUE(prober.take({}, 3, far));
    EXPECT_EQ(far.secant, 3);
    EXPECT_GT(far.plain.explained, near.plain.explained);
    EXPECT_GT(far.plain.explained, 0.9 * null.scores().plain(null.fit.optimum.residuals).squaredNorm());
    EXPECT_NEAR(far.strength(), 3, 0.4);
}

}  // namespace
}  // namespace analogon
