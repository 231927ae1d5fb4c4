#include "core/effect/search/run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

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

/// A body so small that it follows its heater within a few samples, for so many: means of them would blur it. Its
/// sensor lags by so much of a sample. [s]
EstimationTask fastBody(int samples, double lag) {
    constexpr int within = 200;
    constexpr double interval = 40;  // [s], twice what the body takes
    EstimationTask task = warmBody({{"joint.G", "W/K", 0.3, 0.01, 10}});
    Recording r = warmBodyRecording("run", samples);
    r.held = {"P"};
    std::mt19937 random(4);
    std::normal_distribution<double> noise(0, 0.02);
    double T = 300, sensor = 300, power = 0;
    for (int k = 0; k < samples; ++k) {
        if (k % 5 == 0) power = static_cast<double>(random() % 8);
        r.time.push_back(interval * k);
        r.inputs(0, k) = power;
        r.outputs(0, k) = (lag > 0 ? sensor : T) + noise(random);
        for (int i = 0; i < within; ++i) {
            if (lag > 0) sensor += interval / within * (T - sensor) / lag;
            T += interval / within * (power - 0.2 * (T - 300)) / 4;
        }
    }
    task.recordings = {r};
    return task;
}

bool says(const Finding& finding, const std::string& words) {
    return std::any_of(finding.warnings.begin(), finding.warnings.end(),
                       [&](const Text& w) { return w.find(words) != std::string::npos; });
}

TEST(Run, WorksOnTheFirstPartOfARecordThatMeansWouldBlur) {
    const Outcome<Finding> finding = analogon::Run(fastBody(7'000, 12), amongSensors(), {}).run();
    ASSERT_TRUE(finding);
    EXPECT_TRUE(says(*finding, "their first part"));
    ASSERT_EQ(finding->effects.size(), 1u);
    EXPECT_EQ(finding->effects.front().kind, "sensor.lag");
    const EffectValue& lag = finding->effects.front().parameters.front();
    EXPECT_NEAR(lag.value, 12, 0.3);
    EXPECT_EQ(finding->final.experiments.front().time.size(), 7'000u);
    const Outcome<Finding> slow = analogon::Run(laggingBody(3), amongSensors(), {}).run();
    EXPECT_FALSE(says(*slow, "long recordings"));
}

TEST(Run, ThatIsStoppedOnFewerSamplesTellsNoErrorThatGrows) {
    for (const double patience : {1e-6, 0.05, 0.5}) {
        DiscoverOptions options = amongSensors();
        options.patience = patience;
        const EstimationTask task = fastBody(7'000, 12);
        const Outcome<Finding> finding = analogon::Run(task, options, {}).run();
        ASSERT_TRUE(finding);
        EXPECT_EQ(finding->final.experiments.front().time.size(), 7'000u) << patience;
        EXPECT_LE(errorPercentOf(finding->final, Role::Fit), errorPercentOf(finding->baseline, Role::Fit)) << patience;
    }
}

}  // namespace
}  // namespace analogon
