#include "core/effect/search/course_search.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/effect/search/warm_nodes.hpp"

namespace analogon {
namespace {

TEST(CourseSearch, SeeksNoChangeBehindNoise) {
    WarmSearch of(laggingBody(0));
    seekCourses(of.search, of.base);
    EXPECT_FALSE(of.search.courses.isSought);
    EXPECT_FALSE(isCourseAll(of.search, of.base, of.base));
    settleCourses(of.search, of.base, of.base);
    EXPECT_TRUE(of.search.courses.areEmpty());
}

TEST(CourseSearch, KeepsNoChangeThatExplainsNoMoreThanAnEffect) {
    WarmSearch of(laggingBody(3));
    const Node node = lagFound(of);
    seekCourses(of.search, of.base);
    EXPECT_TRUE(of.search.courses.isSought);
    settleCourses(of.search, of.base, node.null);
    EXPECT_TRUE(of.search.courses.areEmpty());
}

TEST(CourseSearch, SaysWhichCourseIsTheBetterAccount) {
    Courses courses;
    courses.dependence.emplace().parameter = "load.b";
    EXPECT_EQ(betterAccount(courses), "load.b that moves with a recorded channel is the better account");
    courses = {};
    courses.change.emplace().parameter = "rotor.J";
    EXPECT_EQ(betterAccount(courses), "rotor.J that changes in mid run is the better account");
}

/// A body whose joint passes on more from the middle of the record on.
EstimationTask bodyThatChanges(double before, double after) {
    constexpr int samples = 400, within = 50;
    constexpr double step = 0.25;
    EstimationTask task = warmBody({{"joint.G", "W/K", 0.3, 0.01, 10}});
    Recording r = warmBodyRecording("run", samples);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 0.05);
    double T = 300;
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(step * k);
        r.inputs(0, k) = 8;
        r.outputs(0, k) = T + noise(random);
        for (int i = 0; i < within; ++i) T += step / within * (8 - (k < samples / 2 ? before : after) * (T - 300)) / 4;
    }
    task.recordings = {r};
    return task;
}

TEST(CourseSearch, KeepsAChangeThatAccountsForAllThatIsLeft) {
    WarmSearch of(bodyThatChanges(0.2, 0.3));
    EXPECT_TRUE(isCourseAll(of.search, of.base, of.base));
    settleCourses(of.search, of.base, of.base);
    ASSERT_TRUE(of.search.courses.change);
    EXPECT_EQ(of.search.courses.change->parameter, "joint.G");
    EXPECT_NEAR(of.search.courses.change->time, 50, 0.5);
    EXPECT_NEAR(of.search.courses.change->before, 0.2, 0.01);
    EXPECT_NEAR(of.search.courses.change->after, 0.3, 0.01);
    EXPECT_FALSE(of.search.courses.dependence);
}

TEST(CourseSearch, TakesNoChangeForAllBesideEffectsThatExplainAsMuch) {
    WarmSearch of(laggingBody(3));
    const Node node = lagFound(of);
    EXPECT_FALSE(isCourseAll(of.search, of.base, node.null));
    EXPECT_FALSE(isCourseAlone(of.search, of.base, Round())) << "nothing was chosen";
}

}  // namespace
}  // namespace analogon
