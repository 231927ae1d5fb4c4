#include "core/effect/reading/readings.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

Recordings named(const std::string& name) {
    Recording r;
    r.name = name;
    return {r};
}

/// Readings whose inputs are drawn otherwise than they are recorded.
Readings drawn() {
    Readings readings;
    readings.searched.task.recordings = named("searched, drawn");
    readings.full.task.recordings = named("full, drawn");
    readings.drawn.stamped = named("searched, as stamped");
    readings.drawn.asRecorded = named("full, as recorded");
    readings.drawn.clocks = {{"u", 0.1}};
    return readings;
}

TEST(Readings, AsGivenAreThoseOfTheSearchWithoutItsClocks) {
    EXPECT_EQ(drawn().recordingsAsGiven().front().name, "searched, as stamped");
    Readings readings = drawn();
    readings.drawn.edges.resize(1);
    EXPECT_EQ(readings.recordingsAsGiven().front().name, "full, as recorded") << "jumps were placed on every sample";
}

TEST(Readings, TakenAsGivenAreNotRedrawnAnyMore) {
    for (const std::size_t edges : {0u, 2u}) {
        Readings readings = drawn();
        readings.drawn.edges.resize(edges);
        const std::string wanted = edges == 0 ? "searched, as stamped" : "full, as recorded";
        readings.takeRecordingsAsGiven();
        EXPECT_EQ(readings.searched.task.recordings.front().name, wanted);
        EXPECT_EQ(readings.full.task.recordings.front().name, "full, as recorded");
        EXPECT_TRUE(readings.drawn.asRecorded.empty());
        EXPECT_TRUE(readings.drawn.clocks.empty());
        EXPECT_TRUE(readings.drawn.edges.empty());
    }
}

}  // namespace
}  // namespace analogon
