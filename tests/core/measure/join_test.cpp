#include "core/measure/join.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace analogon {
namespace {

using testing::ElementsAre;
using testing::IsNan;

const std::vector<double> fast{0, 0.5, 1, 1.5, 2};

TEST(Join, UnitesTheStampsOfWhatWasMeasured) {
    const std::vector<double> slow{0, 1}, values{1, NAN}, more{0.25, 0.5}, two{1, 2};
    const std::vector<Trace> traces{{slow, values}, {more, two}};
    EXPECT_THAT(unitedStamps(traces), ElementsAre(0, 0.25, 0.5));
}

TEST(Join, WhatIsBeyondAllNumbersWasNotMeasured) {
    const std::vector<double> stamps{0, 1, 2}, values{1, INFINITY, 3};
    const std::vector<Trace> traces{{stamps, values}};
    EXPECT_THAT(unitedStamps(traces), ElementsAre(0, 2));
    EXPECT_THAT(courseAt(traces[0], stamps, Course::Linear), ElementsAre(1, 2, 3));
}

TEST(Join, AnInputRunsStraightFromSampleToSampleAndNotBeyond) {
    const std::vector<double> stamps{0.5, 1.5}, values{2, 4};
    EXPECT_THAT(courseAt({stamps, values}, fast, Course::Linear), ElementsAre(IsNan(), 2, 3, 4, IsNan()));
}

TEST(Join, AHeldInputKeepsItsValueUntilTheNextSample) {
    const std::vector<double> stamps{0.5, 1.5}, values{2, 4};
    EXPECT_THAT(courseAt({stamps, values}, fast, Course::Held), ElementsAre(IsNan(), 2, 2, 4, 4));
}

TEST(Join, AGapIsBridgedAndAJumpTakesTheValueBehindIt) {
    const std::vector<double> stamps{0, 1, 1, 1.5, 2}, values{0, 1, 10, NAN, 20};
    EXPECT_THAT(courseAt({stamps, values}, fast, Course::Linear), ElementsAre(0, 0.5, 10, 15, 20));
}

}  // namespace
}  // namespace analogon
