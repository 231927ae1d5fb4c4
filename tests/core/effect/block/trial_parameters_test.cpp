#include "core/effect/block/trial_parameters.hpp"

#include <gtest/gtest.h>

#include "core/effect/search/trials.hpp"
#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

TEST(OfferedByWhitened, IsWhatTheProbeThatExplainsMostOffersForTheEffectAlone) {
    WarmSearch of(laggingBody(3));
    const std::vector<Screened> screened = screenAll(of.search, of.base);
    const Screened& lag = *std::find_if(screened.begin(), screened.end(),
                                        [](const Screened& s) { return s.candidate.effect.kind == "sensor.lag"; });
    Trial trial = tryThese(of.search, of.base, {&lag}, 12, 1).front();
    ASSERT_TRUE(trial.ok);
    const PlacedEffect& placed = trial.variant.effects.back();
    for (Probe& p : trial.screened.probes) p.whitened.explained = 1;
    Probe& best = trial.screened.probes.back();
    best.whitened.explained = 100;
    best.whitened.visible = 1;
    best.whitened.wrongSign = false;
    best.whitened.strengths = Eigen::VectorXd::Constant(1, 2.5);
    best.secant = 2;
    const std::vector<ParameterValue> offered = offeredByWhitened(trial);
    ASSERT_EQ(offered.size(), placed.freed.size());
    EXPECT_EQ(offered.front().name, placed.freed.front().name);
    EXPECT_DOUBLE_EQ(offered.front().value, 2.5);
    for (Probe& p : trial.screened.probes) p.whitened.explained = 0;
    EXPECT_TRUE(offeredByWhitened(trial).empty());
}

}  // namespace
}  // namespace analogon
