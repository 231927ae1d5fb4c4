#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/flat/flat_support.hpp"

namespace analogon {
namespace {

using namespace test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string surroundings = R"(
    model Surroundings parameter Real T = 293.15; Real t; equation t = time; end Surroundings;
    model Part outer Surroundings ambient; Real x; equation x = ambient.T + ambient.t; end Part;
    model Group Part part; end Group;)";

TEST(Outer, AllPartsShareTheInnerComponentAroundThem) {
    const FlatModel m = flatOf(surroundings + "model M inner Surroundings ambient(T = 300); Part a; Group g; end M;");
    EXPECT_THAT(equations(m), Contains("a.x = ambient.T + ambient.t"));
    EXPECT_THAT(equations(m), Contains("g.part.x = ambient.T + ambient.t"));
    EXPECT_THAT(names(m), Not(Contains("a.ambient.T")));
    EXPECT_EQ(valueOf(m, "ambient.T"), 300);
    EXPECT_EQ(m.equations.size(), 3u) << "the shared component has its equations once";
}

TEST(Outer, TheNearestInnerComponentCounts) {
    const FlatModel m = flatOf(surroundings + R"(
        model Room inner Surroundings ambient(T = 250); Group g; end Room;
        model M inner Surroundings ambient(T = 300); Room room; Part a; end M;)");
    EXPECT_THAT(equations(m), Contains("room.g.part.x = room.ambient.T + room.ambient.t"));
    EXPECT_THAT(equations(m), Contains("a.x = ambient.T + ambient.t"));
}

TEST(Outer, ASizeAndAVariableMayBeTakenFromAround) {
    const FlatModel m = flatOf(R"(
        model Part outer parameter Integer n; outer Real u; Real x[n]; equation x = fill(u, n); end Part;
        model M inner parameter Integer n = 2; inner Real u = time; Part p; end M;)");
    EXPECT_THAT(equations(m), Contains("p.x[2] = u"));
}

TEST(Outer, AMissingInnerComponentIsToldOnce) {
    EXPECT_THAT(
        faultsOf(surroundings + "model M Part a; end M;"),
        ElementsAre("the outer component 'ambient' of component 'a' (Part) has no inner one around it | declare "
                    "it in a model that holds this one: inner Surroundings ambient"));
}

TEST(Outer, AnInnerComponentOfAnotherKindOrAModifiedOuterOneIsRefused) {
    EXPECT_THAT(
        faultsOf(surroundings + "model Other Real y = 1; end Other; model M inner Other ambient; Part a; end M;"),
        ElementsAre(HasSubstr("Other cannot take the place of Surroundings: it has no 'T'")));
    EXPECT_THAT(faultsOf(surroundings + R"(
        model Set outer Surroundings ambient(T = 1); end Set;
        model M inner Surroundings ambient; Set s; end M;)"),
                ElementsAre(HasSubstr("the outer component 'ambient' cannot be modified")));
}

TEST(Outer, WhatIsInnerAndOuterAtOnceIsOneToItsClassAndAnotherToWhatLiesWithin) {
    const FlatModel m = flatOf(surroundings + R"(
        model Cabinet inner outer Surroundings ambient(T = 310); Part part; Real own = ambient.T; end Cabinet;
        model M inner Surroundings ambient(T = 290); Cabinet cabinet; Cabinet hot(ambient(T = 350)); end M;)");
    EXPECT_THAT(equations(m), Contains("cabinet.own = ambient.T"));
    EXPECT_THAT(equations(m), Contains("cabinet.part.x = cabinet.ambient.T + cabinet.ambient.t"));
    EXPECT_EQ(valueOf(m, "cabinet.ambient.T"), 310);
    EXPECT_EQ(valueOf(m, "hot.ambient.T"), 350);
    EXPECT_EQ(valueOf(m, "ambient.T"), 290);
    EXPECT_THAT(faultsOf(surroundings + R"(
        model Cabinet inner outer Surroundings ambient; Part part; end Cabinet; model M Cabinet cabinet; end M;)"),
                ElementsAre(HasSubstr("has no inner one around it")));
}

TEST(Outer, ConnectionsToAnOuterComponentAreOfTheClassThatHasIt) {
    const FlatModel m = flatOf(R"(
        connector Port Real v; flow Real i; end Port;
        model Bus Port p; equation p.v = 1; end Bus;
        model Load Port p; equation p.i = p.v; end Load;
        model Slot outer Bus bus; Load load; equation connect(load.p, bus.p); end Slot;
        model M inner Bus bus; Slot a, b; end M;)");
    EXPECT_THAT(equations(m), Contains("a.load.p.i + bus.p.i + b.load.p.i = 0"));
    EXPECT_EQ(m.equations.size(), 6u);
}

}  // namespace
}  // namespace analogon
