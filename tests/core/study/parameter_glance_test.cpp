#include "core/study/parameter_glance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

namespace analogon {
namespace {

class Glance : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(Glance, IsWhatAWholeSimulationSaysAndFastEnoughToTurnAKnobBy) {
    const auto [example, parameter] = GetParam();
    Outcome<Study> study = readStudy(std::string(ANALOGON_ROOT "/examples/") + example);
    ASSERT_TRUE(study);
    const Outcome<ParameterGlance> glance = ParameterGlance::make(*study, parameter);
    ASSERT_TRUE(glance) << format(glance.diagnostics());
    const Outcome<TraceSimulator> whole = TraceSimulator::make(*study, {});
    ASSERT_TRUE(whole);
    const Outcome<EstimationTask> task = taskOf(*study, {});
    ASSERT_TRUE(task);
    const Outcome<PreparedTask> prepared = prepare(*task);
    ASSERT_TRUE(prepared);
    std::vector<Progress::Value> values;
    double start = 0;
    for (const FitParameter& p : prepared->problem.parameters) {
        const int e = p.experiment;
        const bool isTurned = p.name == parameter && e < 0;
        if (isTurned) start = p.start;
        values.push_back({p.name, e < 0 ? "" : prepared->problem.experiments[static_cast<std::size_t>(e)].name,
                          isTurned ? 1.1 * p.start : p.start});
    }
    const auto expected = whole->at(values), seen = glance->at(1.1 * start);
    ASSERT_TRUE(expected && seen);
    ASSERT_EQ(seen->experiments.size(), expected->experiments.size());
    EXPECT_NEAR(seen->errorPercent, expected->errorPercent, 0.01 * expected->errorPercent + 0.01);
    std::vector<double> taken;
    for (int i = 0; i < 21; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        ASSERT_TRUE(glance->at(start * (1 + 0.01 * i)));
        taken.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    }
    std::nth_element(taken.begin(), taken.begin() + 10, taken.end());
    std::cout << example << ": " << taken[10] << " ms\n";
    EXPECT_LT(taken[10], 25);
}

INSTANTIATE_TEST_SUITE_P(Examples, Glance,
                         testing::Values(std::pair("lambda-sensor-heating", "heater.R"),
                                         std::pair("water-pump", "motor.R")));

TEST(ParameterGlance, NamesAParameterThatThereIsNot) {
    Outcome<Study> study = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
    ASSERT_TRUE(study);
    EXPECT_FALSE(ParameterGlance::make(*study, "nothing.here"));
}

}  // namespace
}  // namespace analogon
