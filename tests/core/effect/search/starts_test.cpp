#include "core/effect/search/starts.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

TEST(FindBeginning, TellsWhereARecordBeginsThatWasCutOutOfALongerOne) {
    WarmSearch of(laggingBody(0, 0, 320));
    const std::optional<Begun> begun = findBeginning(of.search, of.base, Against::Noise, 0);
    ASSERT_TRUE(begun);
    ASSERT_EQ(begun->starts.size(), 1u);
    EXPECT_LT(begun->sumOfSquares, 0.1 * of.base.sumOfSquares());
    WarmSearch sound(laggingBody(0));
    EXPECT_FALSE(findBeginning(sound.search, sound.base, Against::Noise, 0));
}

TEST(FreeStarts, AreHeldAgainWhereTheyExplainNothing) {
    WarmSearch of(laggingBody(0));
    ToldStart start;
    start.parameter = "body.T_start";
    start.value = 300;
    freeStarts(of.search, {start});
    EXPECT_EQ(of.search.readings.freedStarts.size(), 1u);
    Outcome<NullModel> freed =
        fitNull(of.search.readings.searched, of.base.noise, NoiseLevel::Keep, of.search.fit, of.search.progress);
    ASSERT_TRUE(freed);
    EXPECT_EQ(freed->parameterCount(), of.base.parameterCount() + 1);
    holdUnneededStarts(of.search, *freed);
    EXPECT_TRUE(of.search.readings.freedStarts.empty());
    EXPECT_EQ(freed->parameterCount(), of.base.parameterCount());
}

TEST(RefitWith, FitsTheStartsFromHereOn) {
    WarmSearch of(laggingBody(0, 0, 320));
    const std::optional<Begun> begun = findBeginning(of.search, of.base, Against::Noise, 0);
    ASSERT_TRUE(begun);
    NullModel null = of.base;
    EXPECT_TRUE(refitWith(of.search, null, begun->starts, begun->values));
    EXPECT_TRUE(isNoise(null));
    EXPECT_NEAR(null.fit.find("body.T_start", 0)->value, 320, 0.1);
    EXPECT_EQ(of.search.readings.freedStarts.size(), 1u);
}

TEST(FreeChecks, EstimatesWhereARecordingBeginsThatOnlyValidates) {
    const auto checksOf = [](double startsAt) {
        EstimationTask task = laggingBody(0);
        Recording check = laggingBody(0, 0, startsAt).recordings.front();
        check.name = "check";
        check.role = Role::Validate;
        task.recordings.push_back(check);
        WarmSearch of(task);
        freeChecks(of.search, of.base);
        return of.search.readings.checkStarts;
    };
    const std::vector<ToldStart> starts = checksOf(320);
    ASSERT_EQ(starts.size(), 1u);
    EXPECT_EQ(starts[0].parameter, "body.T_start");
    EXPECT_EQ(starts[0].recording, 1);
    EXPECT_TRUE(checksOf(300).empty());
}

TEST(CanTry, AreTwelveStartValues) {
    EXPECT_TRUE(canTry(std::vector<ToldStart>(12)));
    EXPECT_FALSE(canTry(std::vector<ToldStart>(13)));
}

TEST(IsElsewhere, IsThreeStandardErrorsFromWhereItWasToldToBegin) {
    ToldStart start;
    start.value = 300;
    FitEstimate fitted;
    fitted.standardError = 1;
    fitted.value = 303.1;
    EXPECT_TRUE(isElsewhere(start, &fitted));
    fitted.value = 297.1;
    EXPECT_FALSE(isElsewhere(start, &fitted));
    EXPECT_FALSE(isElsewhere(start, nullptr));
}

}  // namespace
}  // namespace analogon
