#include "core/effect/block/trial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/core/effect/lagging_body.hpp"

namespace analogon {
namespace {

/// A body whose sensor lags by 3 s, fitted without the lag.
Outcome<NullModel> fittedWithoutItsLag() { return fitNull({laggingBody(3), {}, {}}, {}, NoiseLevel::Estimate, {}, {}); }

/// The first place of a kind of effects, with its traces.
Screened screenedOf(const NullModel& null, const std::string& kind) {
    const Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(null.variant.task.library);
    const Outcome<std::vector<Candidate>> candidates = candidatesFor(null.variant, *catalogue);
    const auto wanted =
        std::find_if(candidates->begin(), candidates->end(), [&](const Candidate& c) { return c.effect.kind == kind; });
    return screen(null, *wanted, {}, {});
}

TEST(TrialStarts, TakeTheBestPromiseFirst) {
    const Outcome<NullModel> null = fittedWithoutItsLag();
    ASSERT_TRUE(null) << format(null.diagnostics());
    const FitOptions options = trialOptions({}, trialIterations);
    const Screened screened = screenedOf(*null, "sensor.lag");
    ASSERT_TRUE(screened.failure.empty());

    const Progress progress;
    TrialStarts starts(*null, screened, options, 2, progress);
    ASSERT_TRUE(starts.hasNext());
    EXPECT_FALSE(starts.best().ok) << "nothing is fitted before it is taken";
    const double first = starts.promised();
    EXPECT_LT(first, 0.5 * null->sumOfSquares());
    starts.takeNext();
    ASSERT_TRUE(starts.best().ok);
    EXPECT_NEAR(starts.best().fit.values[starts.best().fit.values.size() - 1], 3, 0.1);
    EXPECT_DOUBLE_EQ(starts.best().variant.effects.back().freed.front().max, 0.25 * 399)
        << "the recording does not tell what takes longer";
    const double reached = starts.best().sumOfSquares();
    ASSERT_TRUE(starts.hasNext());
    EXPECT_GE(starts.promised(), first);
    starts.takeNext();
    EXPECT_FALSE(starts.hasNext()) << "two were asked for";
    EXPECT_LE(starts.best().sumOfSquares(), reached);
    EXPECT_EQ(refit(*null, screened, options, 2, progress).sumOfSquares(), starts.best().sumOfSquares());
}

// A trace may promise far too much of whatever the effect is linear in: of a friction beside one of which it would take
// the part, and where the two are all but one, any amount.
TEST(TrialStarts, TakeBackAllThatTheTracePromisesTooMuch) {
    const Outcome<NullModel> null = fittedWithoutItsLag();
    ASSERT_TRUE(null) << format(null.diagnostics());
    for (const double tooMuch : {100.0, 1e8}) {
        Screened screened = screenedOf(*null, "proposal.heat.periodic");
        ASSERT_FALSE(screened.probes.empty());
        for (Probe& p : screened.probes) {
            ASSERT_EQ(p.plain.strengths.size(), 2);
            ASSERT_NE(p.plain.strengths[1], 0);
            p.plain.strengths[1] *= tooMuch;
        }
        const Progress progress;
        const FitOptions options = trialOptions({}, 0);
        TrialStarts starts(*null, screened, options, 1, progress);
        ASSERT_TRUE(starts.hasNext());
        starts.takeNext();
        ASSERT_TRUE(starts.best().ok);
        EXPECT_LT(starts.best().sumOfSquares(), null->sumOfSquares()) << tooMuch;
    }
}

TEST(TrialOptions, EndATrialWhereAMillionthOfTheMisfitIsLeftToGain) {
    FitOptions given;
    given.costTolerance = 1e-12;
    const FitOptions options = trialOptions(given, 5);
    EXPECT_EQ(options.maxIterations, 5);
    EXPECT_EQ(options.costTolerance, 1e-6);
}

TEST(IsWeighed, AreEightStartsAndBeyondFourNoneWhoseTraceExplainsFarLess) {
    EXPECT_TRUE(isWeighed(7, 0.3, 1));
    EXPECT_FALSE(isWeighed(8, 1, 1));
    EXPECT_TRUE(isWeighed(4, 0.21, 1));
    EXPECT_FALSE(isWeighed(4, 0.19, 1));
    EXPECT_TRUE(isWeighed(3, 0.01, 1));
}

}  // namespace
}  // namespace analogon
