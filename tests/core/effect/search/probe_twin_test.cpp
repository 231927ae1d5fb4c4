#include "core/effect/search/probe_twin.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace analogon {
namespace {

/// A probe along one direction, which is so much like the first axis.
Probe along(double correlation) {
    Probe p;
    p.course = Eigen::MatrixXd(Eigen::Vector2d(correlation, std::sqrt(1 - correlation * correlation)));
    return p;
}

TEST(IsTwin, IsWhatAnyProbeOfTheOtherPromisesAsWell) {
    Screened other;
    other.probes = {along(0), along(0.9991)};
    EXPECT_TRUE(isTwin(along(1), other));
    other.probes = {along(0), along(0.9989)};
    EXPECT_FALSE(isTwin(along(1), other));
    other.probes = {along(-1)};
    EXPECT_TRUE(isTwin(along(1), other)) << "of either sign";
}

TEST(IsTwin, IsOfOneDirectionEach) {
    Screened other;
    other.probes = {along(1)};
    other.probes[0].course.reset();  // it has several
    EXPECT_FALSE(isTwin(along(1), other));
    EXPECT_FALSE(isTwin(along(1), Screened()));
}

}  // namespace
}  // namespace analogon
