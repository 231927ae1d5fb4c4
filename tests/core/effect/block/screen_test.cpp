#include "core/effect/block/screen.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/effect/block/candidates_of.hpp"
#include "tests/core/effect/lagging_body.hpp"

namespace analogon {
namespace {

Probe probe(double explained, double visible = 1, bool wrongSign = false) {
    Probe p;
    p.plain.explained = p.whitened.explained = explained;
    p.plain.visible = p.whitened.visible = visible;
    p.plain.wrongSign = p.whitened.wrongSign = wrongSign;
    p.plain.strengths = Eigen::Vector3d(2, 5, 7);
    return p;
}

TEST(Probe, HasNoStrengthOfTheWrongSign) {
    EXPECT_EQ(probe(9).strength(), 2);
    EXPECT_EQ(probe(9).linear(), (std::vector<double>{5, 7}));
    EXPECT_EQ(probe(9, 1, true).strength(), 0);
    EXPECT_TRUE(Probe().linear().empty());
}

TEST(Screened, ScoresByItsBestProbeAlone) {
    Screened s;
    EXPECT_EQ(s.score(), 0);
    EXPECT_FALSE(s.isAbsorbed()) << "nothing was seen of it";
    s.probes = {probe(9), probe(4)};
    s.probes[1].whitened.explained = 20;
    EXPECT_EQ(s.score(), 9);
    EXPECT_EQ(s.whitenedScore(), 20);
    s.probes = {probe(9, 1, true)};
    EXPECT_EQ(s.score(), 0);
    EXPECT_TRUE(s.isWrongSign());
    s.probes.push_back(probe(4));
    EXPECT_FALSE(s.isWrongSign()) << "of one probe only";
}

TEST(Screened, IsAbsorbedWhereNoProbeShowsBesideTheParameters) {
    Screened s;
    s.probes = {probe(9, 0.0029), probe(9, 0.0028)};
    EXPECT_TRUE(s.isAbsorbed());
    EXPECT_EQ(s.score(), 0);
    s.probes[0].plain.visible = 0.0031;
    EXPECT_FALSE(s.isAbsorbed());
    EXPECT_EQ(s.score(), 9);
}

TEST(Limited, GivesUpWhatNeedsMoreThanSixHundredEvaluationsASample) {
    NullModel null;
    Recording shorter = warmBodyRecording("short", 10), longer = warmBodyRecording("long", 20);
    shorter.time.resize(10);
    longer.time.resize(20);
    Recording check = longer;
    check.role = Role::Validate;
    check.time.resize(1000);
    null.variant.task.recordings = {shorter, longer, check};
    EXPECT_EQ(limited(null, {}).evaluationLimit, 20 * 600) << "of the longest that is fitted";
}

TEST(Screen, PromisesTheEffectThatTheBodyHas) {
    const NullModel null = fittedModel(laggingBody(3));
    const Screened lag = screen(null, firstCandidate(null.variant, "sensor.lag"), {}, {}),
                   gain = screen(null, firstCandidate(null.variant, "sensor.gain"), {}, {});
    ASSERT_TRUE(lag.failure.empty()) << lag.failure;
    EXPECT_GT(lag.score(), 0.7 * null.sumOfSquares());
    EXPECT_LT(gain.score(), lag.score());
    for (std::size_t i = 1; i < lag.probes.size(); ++i) {
        EXPECT_LE(lag.probes[i].plain.explained * !lag.probes[i].plain.wrongSign, lag.probes[0].plain.explained);
        EXPECT_EQ(lag.probes[i].plain.directions->size(), 0) << "of the best alone";
    }
    EXPECT_EQ(lag.probes[0].plain.directions->size(), 400);
    EXPECT_NEAR(lag.probes[0].strengthIn.norm(), 1, 1e-12);
    const Outcome<Variant> wired = wiredIn(null, lag);
    ASSERT_TRUE(wired);
    ASSERT_EQ(wired->effects.size(), 1u);
    EXPECT_TRUE(wired->effects[0].freed.empty()) << "not yet freed";
}

/// As much more power is as much less heat capacity and conductance.
TEST(Screen, NamesTheParametersThatImitateWhatIsAbsorbed) {
    EstimationTask task = laggingBody(0);
    task.parameters.push_back({"body.C", "J/K", 4, 1, 20});
    const NullModel null = fittedModel(task);
    const Screened gain = screen(null, firstCandidate(null.variant, "actuator.gain"), {}, {});
    ASSERT_TRUE(gain.failure.empty()) << gain.failure;
    EXPECT_TRUE(gain.isAbsorbed());
    EXPECT_THAT(gain.absorbedBy, testing::UnorderedElementsAre("joint.G", "body.C"));
}

TEST(Screen, OfAPlaceThatIsNotThereSaysWhy) {
    const NullModel null = fittedModel(laggingBody(0));
    Candidate lag = firstCandidate(null.variant, "sensor.lag");
    lag.place.at = "output w";
    lag.place.connector = "w";
    const Screened screened = screen(null, lag, {}, {});
    EXPECT_FALSE(screened.failure.empty());
    EXPECT_TRUE(screened.probes.empty());
}

TEST(IsAnotherCourse, ByAFiftiethOfATurnOrOfTheShortestWave) {
    EXPECT_TRUE(isAnotherCourse(0.021, 1, 1));
    EXPECT_FALSE(isAnotherCourse(0.019, 1, 1));
    EXPECT_TRUE(isAnotherCourse(0.007, 3, 1)) << "of three waves a turn each is a third as long";
    EXPECT_FALSE(isAnotherCourse(0.021, 1, 2));
    EXPECT_FALSE(isAnotherCourse(0, 1, 0));
}

}  // namespace
}  // namespace analogon
