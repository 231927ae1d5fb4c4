#include "core/effect/search/run.hpp"

#include <gtest/gtest.h>

#include "core/effect/model/model_state.hpp"
#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

DiscoverOptions amongSensors() {
    DiscoverOptions options;
    options.kinds = {"sensor.lag", "sensor.offset"};
    return options;
}

TEST(Run, NamesTheEffectAndTellsItWithItsFigures) {
    const Outcome<Finding> finding = analogon::Run(laggingBody(3), amongSensors(), {}).run();
    ASSERT_TRUE(finding) << format(finding.diagnostics());
    EXPECT_EQ(finding->kind, FindingKind::Effect);
    ASSERT_EQ(finding->effects.size(), 1u);
    const AddedEffect& lag = finding->effects.front();
    EXPECT_EQ(lag.kind, "sensor.lag");
    ASSERT_FALSE(lag.parameters.empty());
    EXPECT_NEAR(lag.parameters.front().value, 3, 5 * lag.parameters.front().standardError);
    EXPECT_EQ(lag.evidence.errorPercentAfter, errorPercentOf(finding->final, Role::Fit));
    EXPECT_GT(lag.evidence.errorPercentBefore, lag.evidence.errorPercentAfter);
}

TEST(Run, SaysThatNothingIsMissing) {
    const Outcome<Finding> finding = analogon::Run(laggingBody(0), amongSensors(), {}).run();
    ASSERT_TRUE(finding);
    EXPECT_EQ(finding->kind, FindingKind::Adequate);
    EXPECT_TRUE(finding->effects.empty());
    EXPECT_FALSE(finding->candidates.empty());
}

TEST(Run, OfAKindThatIsNoneIsAFault) {
    DiscoverOptions options;
    options.kinds = {"sensor.leg"};
    EXPECT_FALSE(analogon::Run(laggingBody(3), options, {}).run());
}

/// The work is counted, not the time: on one thread or on many it ends at the same place.
TEST(Run, ThatTakesLongerThanAllowedSaysWhatItHas) {
    std::vector<double> ends;
    for (const int threads : {1, 3}) {
        DiscoverOptions options = amongSensors();
        options.patience = 1e-6;
        options.threads = threads;
        options.trace = std::make_shared<DecisionTrace>();
        const Outcome<Finding> finding = analogon::Run(laggingBody(3), options, {}).run();
        ASSERT_TRUE(finding);
        EXPECT_TRUE(finding->end.interrupted);
        EXPECT_TRUE(finding->end.isAtLimitOfWork) << "nobody stopped it";
        ASSERT_FALSE(finding->warnings.empty());
        EXPECT_NE(finding->warnings.back().find("--patience"), std::string::npos);
        for (const Decision& d : options.trace->decisions())
            if (d.step == "work") ends.push_back(d.figures.front().second);
    }
    ASSERT_EQ(ends.size(), 2u);
    EXPECT_EQ(ends[0], ends[1]);
    DiscoverOptions patient = amongSensors();
    patient.patience = 1;
    const Outcome<Finding> whole = analogon::Run(laggingBody(3), patient, {}).run();
    ASSERT_TRUE(whole);
    EXPECT_FALSE(whole->end.interrupted);
    EXPECT_FALSE(whole->end.isAtLimitOfWork);
}

TEST(Run, ThatIsStoppedAtTheLimitOfItsWorkSaysSo) {
    DiscoverOptions options = amongSensors();
    options.mostWork = 1;
    const Outcome<Finding> finding = analogon::Run(laggingBody(3), options, {}).run();
    ASSERT_TRUE(finding);
    EXPECT_TRUE(finding->end.interrupted);
    EXPECT_NE(finding->kind, FindingKind::Adequate);
    EXPECT_NE(finding->kind, FindingKind::Unexplained);
}

}  // namespace
}  // namespace analogon
