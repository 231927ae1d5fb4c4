#include "core/study/parameter_sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/effect/model/model_state.hpp"
#include "core/study/run.hpp"

namespace analogon {
namespace {

Study lambda() {
    const Outcome<Study> study = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
    EXPECT_TRUE(study);
    return *study;
}

/// What a simulation of the study says that has these values.
double errorWith(Study study, const std::map<std::string, double>& values) {
    for (const auto& [name, value] : values) study.parameters[name].value = value;
    const Outcome<RunResult> run = runSimulate(study, {});
    EXPECT_TRUE(run) << format(run.diagnostics());
    return errorPercentOf(run->finding.baseline, Role::Fit);
}

TEST(SweepValues, AreEvenlySpacedOrByEqualFactors) {
    EXPECT_EQ(sweepValues(1, 3, 3, false), (std::vector<double>{1, 2, 3}));
    const std::vector<double> decades = sweepValues(0.01, 100, 5, true);
    ASSERT_EQ(decades.size(), 5u);
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(decades[static_cast<std::size_t>(i)], std::pow(10, i - 2), 1e-9);
    EXPECT_EQ(sweepValues(-1, -100, 3, true)[1], -10);
    EXPECT_EQ(sweepValues(0.1, 0.7, 4, false).back(), 0.7);
    EXPECT_EQ(sweepValues(5, 9, 1, false), std::vector<double>{5});
}

TEST(ParameterSweep, IsTheErrorOfASimulationAtEachPoint) {
    const Study study = lambda();
    const auto one = sweep(study, {{"heater.R", {2, 3, 4}}});
    ASSERT_TRUE(one) << format(one.diagnostics());
    ASSERT_EQ(one->errorPercent.rows(), 1);
    ASSERT_EQ(one->errorPercent.cols(), 3);
    EXPECT_EQ(one->units, std::vector<std::string>{"Ohm"});
    EXPECT_EQ(one->done, 3);
    EXPECT_NEAR(one->errorPercent(0, 2), errorWith(study, {{"heater.R", 4}}), 1e-3 * one->errorPercent(0, 2));
    const auto two = sweep(study, {{"heater.R", {2, 3, 4}}, {"heater.alpha", {0.002, 0.004}}});
    ASSERT_TRUE(two) << format(two.diagnostics());
    ASSERT_EQ(two->errorPercent.rows(), 2);
    ASSERT_EQ(two->errorPercent.cols(), 3);
    const double expected = errorWith(study, {{"heater.R", 2}, {"heater.alpha", 0.004}});
    EXPECT_NEAR(two->errorPercent(1, 0), expected, 1e-3 * expected);
    const auto [row, column] = two->least();
    EXPECT_EQ(two->errorPercent(row, column), two->errorPercent.minCoeff());
}

TEST(ParameterSweep, HasItsLeastErrorNearWhereAFitEnds) {
    const Outcome<RunResult> fitted = runFit(lambda(), {});
    ASSERT_TRUE(fitted);
    double best = 0;
    for (const FitEstimate& e : fitted->finding.final.parameters)
        if (e.name == "heater.R") best = e.value;
    ASSERT_GT(best, 0);
    const auto swept = sweep(fitted->completed, {{"heater.R", sweepValues(0.8 * best, 1.2 * best, 9, false)}});
    ASSERT_TRUE(swept);
    EXPECT_EQ(swept->least().second, 4);
}

TEST(ParameterSweep, LeavesPointsOpenThatCannotBeSimulated) {
    const auto swept = sweep(lambda(), {{"heater.R", {0, 3}}});  // a short circuit
    ASSERT_TRUE(swept) << format(swept.diagnostics());
    EXPECT_TRUE(std::isnan(swept->errorPercent(0, 0)));
    EXPECT_TRUE(std::isfinite(swept->errorPercent(0, 1)));
    EXPECT_EQ(swept->least().second, 1);
}

TEST(ParameterSweep, StopsBetweenTwoPointsWithWhatItHas) {
    std::stop_source stop;
    std::vector<double> fractions;
    const Progress progress(stop.get_token(), [&](const Progress::Report& report) {
        if (report.stage != "sweep") return;
        fractions.push_back(report.fraction);
        if (fractions.size() == 2) stop.request_stop();
    });
    const auto swept = sweep(lambda(), {{"heater.R", sweepValues(2, 4, 10, false)}}, progress);
    ASSERT_TRUE(swept);
    EXPECT_EQ(swept->done, 2);
    EXPECT_EQ(fractions, (std::vector<double>{0.1, 0.2}));
    EXPECT_TRUE(std::isfinite(swept->errorPercent(0, 1)));
    EXPECT_TRUE(std::isnan(swept->errorPercent(0, 2)));
}

TEST(ParameterSweep, SaysWhatItCannotLead) {
    for (const std::vector<SweepAxis>& axes :
         std::vector<std::vector<SweepAxis>>{{},
                                             {{"heater.R", {}}},
                                             {{"heater.R", {1}}, {"heater.R", {2}}},
                                             {{"heater.R", {1}}, {"heater.alpha", {1}}, {"heater.T_ref", {1}}},
                                             {{"heater.nosuch", {1}}}})
        EXPECT_FALSE(sweep(lambda(), axes)) << axes.size();
}

}  // namespace
}  // namespace analogon
