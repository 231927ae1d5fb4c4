#include "core/effect/search/refine.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/search/warm_nodes.hpp"

namespace analogon {
namespace {

TEST(Refine, LeavesAloneWhatRoundsNothingOff) {
    WarmSearch of(laggingBody(3));
    Node node = lagFound(of);
    const double before = node.null.sumOfSquares();
    sharpen(of.search, node);
    treatAlike(of.search, node);
    EXPECT_EQ(node.null.sumOfSquares(), before);
}

/// A lag that is said to be drawn sharper by a factor, and has nothing that is rounded off.
TEST(Refine, TakesASharperFormOnlyWhereTheDataAskForIt) {
    WarmSearch of(laggingBody(3));
    Node node = nodeThatChose(of, "sensor.lag");
    PlacedEffect& placed = node.null.variant.effects.front();
    placed.effect.trial.sharper["T"] = 0.25;
    placed.values["T"] = 3;
    const double before = node.null.sumOfSquares();
    sharpen(of.search, node);
    EXPECT_EQ(node.null.sumOfSquares(), before) << "the fitted lag is the same";
}

TEST(Refine, PutsAnEffectInFrontOfEqualSensorsWhereMuchIsLeft) {
    WarmSearch of(laggingBody(3));
    Node node = nodeThatChose(of, "sensor.lag");
    ASSERT_LT(reducedChi(node.null.fit), 1.2);
    treatAlike(of.search, node);
    EXPECT_TRUE(node.null.variant.effects.front().twins.empty()) << "nothing is left, and there is no other";
}

}  // namespace
}  // namespace analogon
