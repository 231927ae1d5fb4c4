#include "core/effect/search/beside_recordings.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

TEST(BestPath, OfARecordThatBeginsElsewhereFreesItsStart) {
    WarmSearch of(laggingBody(0, 0, 320));
    const Outcome<Node> path = bestPath(of.search, of.base);
    ASSERT_TRUE(path);
    EXPECT_TRUE(path->steps.empty());
    EXPECT_EQ(of.search.readings.freedStarts.size(), 1u);
    EXPECT_TRUE(isNoise(path->null));
}

TEST(BesideRecordings, NoStartIsFreedWhereTheRecordBeginsWhereTheModelDoes) {
    WarmSearch of(laggingBody(3));
    const Outcome<Node> path = bestPath(of.search, of.base);
    ASSERT_TRUE(path);
    ASSERT_EQ(path->steps.size(), 1u);
    EXPECT_EQ(path->null.variant.effects.front().effect.kind, "sensor.lag");
    EXPECT_TRUE(of.search.readings.freedStarts.empty());
}

}  // namespace
}  // namespace analogon
