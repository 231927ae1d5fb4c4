#include "core/study/trace_simulator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <mutex>
#include <sstream>

#include "study_fixture.hpp"

namespace analogon {
namespace {

/// A heater whose recording asks for other parameters than its model has.
class TraceSimulation : public test::StudyTest {
protected:
    void SetUp() override {
        StudyTest::SetUp();
        putHeater();
        std::ostringstream csv;
        csv << "t [s],u_heater [V],T_air [K],current [A]\n";
        for (int k = 0; k < 400; ++k) csv << 0.1 * k << ',' << 6 + k % 7 << ",293.15," << (6 + k % 7) / 4.2 << '\n';
        put("train.csv", csv.str());
    }
};

TEST_F(TraceSimulation, ShowsWhatAFitReportsAsItsBest) {
    std::mutex mutex;
    std::vector<Progress::Report> reports;
    const Progress progress({}, [&](const Progress::Report& report) {
        const std::lock_guard lock(mutex);
        if (!report.best.empty()) reports.push_back(report);
    });
    const Outcome<RunResult> result = runFit(read(), {}, progress);
    ASSERT_TRUE(result) << format(result.diagnostics());
    ASSERT_GE(reports.size(), 2u);

    const Outcome<TraceSimulator> simulator = TraceSimulator::make(read(), {});
    ASSERT_TRUE(simulator) << format(simulator.diagnostics());
    const auto first = simulator->at(reports.front().best), last = simulator->at(reports.back().best);
    ASSERT_TRUE(first && last);
    EXPECT_GT(first->errorPercent, last->errorPercent);
    ASSERT_EQ(last->experiments.size(), 1u);
    EXPECT_EQ(last->experiments.front().name, "warm-up");
    ASSERT_EQ(last->experiments.front().outputs.size(), 1u) << "only what was measured";

    const ExperimentState& fitted = result->finding.final.experiments.front();
    const SimulatedTrace& trace = last->experiments.front().outputs.front();
    ASSERT_EQ(trace.output, fitted.outputs.front().name);
    ASSERT_EQ(static_cast<Eigen::Index>(trace.values.size()), fitted.outputs.front().simulated.size());
    for (std::size_t k = 0; k < trace.values.size(); ++k)
        EXPECT_NEAR(trace.values[k], fitted.outputs.front().simulated[static_cast<Eigen::Index>(k)], 1e-6);
}

TEST_F(TraceSimulation, PassesOverTheValuesOfAnotherModel) {
    const Outcome<TraceSimulator> simulator = TraceSimulator::make(read(), {});
    ASSERT_TRUE(simulator) << format(simulator.diagnostics());
    EXPECT_TRUE(simulator->at({{"R", "", 3}, {"C", "", 10}}));
    EXPECT_FALSE(simulator->at({{"R", "", 3}, {"C", "", 10}, {"radiation.Gr", "", 1e-9}}));
    EXPECT_FALSE(simulator->at({{"R", "", 3}, {"G", "", 0.1}}));
    EXPECT_FALSE(simulator->at({{"R", "warm-up", 3}, {"C", "", 10}}));
}

}  // namespace
}  // namespace analogon
