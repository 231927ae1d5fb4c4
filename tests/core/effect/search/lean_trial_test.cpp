#include <gtest/gtest.h>

#include "core/effect/search/trials.hpp"
#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

// Of trials that are many few are judged: those that are kept without slopes are simulated once more then.
TEST(LeanTrials, AreJudgedAsThoseThatKeptTheirSlopes) {
    WarmSearch of(laggingBody(3));
    const std::vector<Screened> screened = screenAll(of.search, of.base);
    std::vector<const Screened*> all;
    for (const Screened& s : screened)
        if (s.failure.empty() && s.score() > 0) all.push_back(&s);
    ASSERT_FALSE(all.empty());
    const std::vector<Trial> whole = tryThese(of.search, of.base, all, 5, 1);
    const std::vector<Trial> lean = tryThese(of.search, of.base, all, 5, 1, TrialSize::Lean);
    ASSERT_EQ(whole.size(), lean.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        ASSERT_TRUE(whole[i].ok && lean[i].ok);
        EXPECT_FALSE(whole[i].isLean);
        EXPECT_TRUE(lean[i].isLean);
        EXPECT_EQ(lean[i].fit.optimum.jacobian.size(), 0);
        EXPECT_TRUE(lean[i].fit.optimum.trajectories.empty());
        EXPECT_EQ(whole[i].sumOfSquares(), lean[i].sumOfSquares());
        const Acceptance a = examine(of.search, of.base, whole[i], 10), b = examine(of.search, of.base, lean[i], 10);
        EXPECT_NEAR(a.explained, b.explained, 1e-6 * std::abs(a.explained));
        EXPECT_NEAR(a.heldOut, b.heldOut, 1e-6);
        EXPECT_EQ(a.accepted(), b.accepted());
    }
}

TEST(LeanTrials, HaveSlopesAgainOnceTheyGoOn) {
    WarmSearch of(laggingBody(3));
    const std::vector<Screened> screened = screenAll(of.search, of.base);
    std::vector<const Screened*> lag;
    for (const Screened& s : screened)
        if (s.candidate.effect.kind == "sensor.lag") lag.push_back(&s);
    std::vector<Trial> trials = tryThese(of.search, of.base, lag, 1, 1, TrialSize::Lean);
    ASSERT_EQ(trials.size(), 1u);
    ASSERT_TRUE(trials[0].isLean);
    proceed(of.base, trials[0], of.search.fit, of.search.progress);
    EXPECT_FALSE(trials[0].isLean);
    EXPECT_GT(trials[0].fit.optimum.jacobian.size(), 0);
}

// The columns of a round take more room than all else: what only tells courses apart is kept short, and shared.
TEST(Probes, KeepTheDirectionsOfTheBestAlone) {
    WarmSearch of(laggingBody(3));
    std::size_t others = 0;
    for (const Screened& s : screenAll(of.search, of.base))
        for (std::size_t i = 0; i < s.probes.size(); ++i) {
            EXPECT_EQ(s.probes[i].plain.directions->cols() > 0, i == 0);
            EXPECT_EQ(s.probes[i].column.size(), 0);
            EXPECT_EQ(s.probes[i].strengthIn.size() > 0, i == 0);
            EXPECT_LE(s.probes[i].course->rows(), 2000);
            others += i > 0;
        }
    EXPECT_GT(others, 0u);
}

}  // namespace
}  // namespace analogon
