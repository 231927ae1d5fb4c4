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

TEST(Redraw, OfClocksEndsBehindThreeChanges) {
    EstimationTask late = laggingBody(0);
    Recording& r = late.recordings.edit().front();
    for (Eigen::Index k = r.inputs.cols() - 1; k >= 2; --k) r.inputs(0, k) = r.inputs(0, k - 2);
    WarmSearch of(late);
    of.search.work.clockChanges = 2;
    const std::optional<Late> found = findClocks(of.search, of.base, 0, 0);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->clocks.front().late, 0.5, 0.05);
    of.search.work.clockChanges = 3;
    EXPECT_FALSE(findClocks(of.search, of.base, 0, 0));
}

}  // namespace
}  // namespace analogon
