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

TEST(Refine, DrawsNoFormSharperThanTwice) {
    WarmSearch of(laggingBody(1.5));
    Node node = nodeThatChose(of, "sensor.lag");
    // a lag that is held, and passes for what is rounded off
    std::vector<PlacedEffect> effects = node.null.variant.effects;
    effects.back().freed.clear();
    effects.back().values["T"] = 12;
    effects.back().effect.trial.sharper["T"] = 0.5;
    std::optional<NullModel> blunt = refittedWith(of.search, node.null, effects);
    ASSERT_TRUE(blunt);
    node.null = std::move(*blunt);
    sharpen(of.search, node);
    EXPECT_EQ(node.null.variant.effects.back().values.at("T"), 3) << "once more would be better still";
}

TEST(IsBetterSharp, IsWhatLeavesEightLess) {
    EXPECT_TRUE(isBetterSharp(100, 91.9));
    EXPECT_FALSE(isBetterSharp(100, 92.1));
}

}  // namespace
}  // namespace analogon
