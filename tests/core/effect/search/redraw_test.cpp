#include "core/effect/search/redraw.hpp"

#include <gtest/gtest.h>

#include "core/effect/search/recordings.hpp"
#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

TEST(Redraw, IsNotAskedWhereTheRecordingsAreTakenAsGiven) {
    WarmSearch of(laggingBody(0));
    EXPECT_TRUE(canPlaceEdges(of.search, of.base));
    of.search.readings.takesAsGiven = true;
    EXPECT_FALSE(canPlaceEdges(of.search, of.base));
    EXPECT_FALSE(findClocks(of.search, of.base, 0, 0));
}

TEST(Redraw, IsNotAskedBesideAnEquationThatStandsForSomething) {
    WarmSearch of(laggingBody(0));
    of.base.variant.effects.resize(1);
    EXPECT_TRUE(canPlaceEdges(of.search, of.base));
    of.base.variant.effects.front().effect.proposal = "y = u";
    EXPECT_FALSE(canPlaceEdges(of.search, of.base));
}

TEST(Redraw, FindsNoClockWhereTheInputsAreOnTime) {
    WarmSearch of(laggingBody(0));
    EXPECT_FALSE(findClocks(of.search, of.base, 0, 0));
    EXPECT_FALSE(takesEdgesForDelays(of.search, of.base)) << "there is no delay";
}

}  // namespace
}  // namespace analogon
