#include "core/study/sensitivity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/study/parameter_glance.hpp"
#include "core/study/run.hpp"

namespace analogon {
namespace {

Study example(const char* name) {
    const Outcome<Study> study = readStudy(std::string(ANALOGON_ROOT "/examples/") + name);
    EXPECT_TRUE(study);
    return *study;
}

TEST(Sensitivity, IsHowFarAnOutputMovesWhenAParameterIsChanged) {
    const Study study = example("lambda-sensor-heating");
    const Outcome<Sensitivity> found = sensitivityOf(study);
    ASSERT_TRUE(found) << format(found.diagnostics());
    const auto at = std::find(found->parameters.begin(), found->parameters.end(), "heater.R");
    ASSERT_NE(at, found->parameters.end());
    const auto column = at - found->parameters.begin();
    EXPECT_EQ(found->units[static_cast<std::size_t>(column)], "Ohm");
    ASSERT_EQ(found->outputs.size(), 1u) << "what validates is not looked at";
    const OutputSensitivity& output = found->outputs[0];
    EXPECT_EQ(output.output, "i_mod");
    ASSERT_EQ(output.slopes.rows(), static_cast<Eigen::Index>(output.time.size()));
    const Outcome<ParameterGlance> glance = ParameterGlance::make(study, "heater.R");
    ASSERT_TRUE(glance);
    const double value = found->values[column], step = 1e-4 * value;
    const auto above = glance->at(value + step), below = glance->at(value - step);
    ASSERT_TRUE(above && below);
    const auto& high = above->experiments[0].outputs[0].values;
    const auto& low = below->experiments[0].outputs[0].values;
    ASSERT_EQ(high.size(), output.time.size());
    const double largest = output.slopes.col(column).cwiseAbs().maxCoeff();
    EXPECT_GT(largest, 0);
    for (std::size_t i = 0; i < high.size(); i += 50)
        EXPECT_NEAR(output.slopes(static_cast<Eigen::Index>(i), column), (high[i] - low[i]) / (2 * step),
                    5e-3 * largest);
}

TEST(Sensitivity, TellsTheErrorsAndCorrelationsOfTheFitThatEndsThere) {
    const Outcome<RunResult> fitted = runFit(example("water-pump"), {});
    ASSERT_TRUE(fitted);
    const Outcome<Sensitivity> found = sensitivityOf(fitted->completed);
    ASSERT_TRUE(found) << format(found.diagnostics());
    const auto count = static_cast<Eigen::Index>(found->parameters.size());
    ASSERT_GT(count, 1);
    for (Eigen::Index i = 0; i < count; ++i) {
        EXPECT_NEAR(found->correlation(i, i), 1, 1e-9);
        for (Eigen::Index j = 0; j < count; ++j) {
            EXPECT_LE(std::abs(found->correlation(i, j)), 1 + 1e-9);
            EXPECT_NEAR(found->correlation(i, j), found->correlation(j, i), 1e-9);
        }
        for (const FitEstimate& e : fitted->finding.final.parameters) {
            if (e.name != found->parameters[static_cast<std::size_t>(i)] || e.atBound) continue;
            const double white = std::isnan(e.whiteError) ? e.standardError : e.whiteError;
            EXPECT_NEAR(found->standardErrors[i], white, 0.02 * white) << e.name;
        }
    }
}

TEST(Sensitivity, OfAStudyThatFitsNothingSaysSo) {
    Study study = example("lambda-sensor-heating");
    for (auto& [name, parameter] : study.parameters) parameter.fit = false;
    const Outcome<Sensitivity> found = sensitivityOf(study);
    ASSERT_FALSE(found);
    EXPECT_FALSE(found.diagnostics().front().hint.empty());
}

}  // namespace
}  // namespace analogon
