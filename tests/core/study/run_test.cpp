#include "core/study/run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "study_fixture.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;

class Run : public testing::StudyTest {
protected:
    void SetUp() override {
        StudyTest::SetUp();
        put("study.json", heaterJson);
        put("model.mo", R"(model Heater
  input Real u(unit="V"), T_amb(unit="K");
  parameter Real R(unit="Ohm") = 1.5;
  parameter Real C(unit="J/K") = 20;
  Real T(start=293.15, fixed=true);
  output Real i(unit="A");
equation
  C*der(T) = u*i - 0.2*(T - T_amb);
  i = u/(R*(1 + 0.004*(T - 293.15)));
end Heater;
)");
        std::ostringstream csv;
        csv << "t [s],u_heater [V],T_air [K],current [A]\n";
        for (int k = 0; k < 400; ++k) csv << 0.1 * k << ",12,293.15," << 6.0 - 0.002 * k << '\n';
        put("train.csv", csv.str());
    }
};

TEST_F(Run, ASimulationThatIsStoppedLeavesNoFigures) {
    std::stop_source source;
    source.request_stop();
    for (const Engine engine : {Engine::Grid, Engine::Adaptive}) {
        RunOptions options;
        options.discover.fit.simulation.engine = engine;
        const Outcome<RunResult> result = runSimulate(read(), options, Progress(source.get_token(), {}));
        ASSERT_TRUE(result) << format(result.diagnostics());
        const ExperimentState& e = result->finding.final.experiments.at(0);
        EXPECT_EQ(e.failure.reason, "cancelled");
        EXPECT_TRUE(std::isnan(e.errorPercent));
        EXPECT_EQ(e.outputs.at(0).simulated.size(), 400);
    }
}

TEST_F(Run, ACancelledFitKeepsTheBestWithItsFigures) {
    std::stop_source source;
    const Progress progress(source.get_token(), [&](const Progress::Report&) { source.request_stop(); });
    const Outcome<RunResult> result = runFit(read(), {}, progress);
    ASSERT_TRUE(result) << format(result.diagnostics());
    EXPECT_TRUE(result->finding.interrupted);
    EXPECT_TRUE(std::isfinite(result->finding.final.experiments.at(0).errorPercent));
}

TEST_F(Run, ASimulationThatFailsNamesTimeAndExperiment) {
    put("model.mo", R"(model Heater
  input Real u(unit="V"), T_amb(unit="K");
  parameter Real R = 1.5;
  parameter Real C = 20;
  Real x(start=1, fixed=true);
  output Real i(unit="A");
equation
  der(x) = 0.1*x^2;
  i = x + 0*(u + T_amb + R + C);
end Heater;
)");
    const Outcome<RunResult> result = runSimulate(read(), {}, {});
    ASSERT_FALSE(result);
    EXPECT_THAT(format(result.diagnostics()), HasSubstr("\"warm-up\" stopped at t = "));
}

TEST_F(Run, WritesTheBlockOfALawBesideTheReport) {
    RunResult result;
    result.completed = read();
    Remainder law;
    law.proposedClass = "MissingTorque1";
    law.proposedBlock = "model MissingTorque1\nend MissingTorque1;\n";
    result.finding.remainders = {law};
    ASSERT_TRUE(writeResults(result, "discover", directory_ / "out"));
    EXPECT_EQ(get(directory_ / "out" / "proposed.mo"), law.proposedBlock);
    // what an earlier run proposed is not left beside a report that proposes nothing
    result.finding.remainders.clear();
    ASSERT_TRUE(writeResults(result, "discover", directory_ / "out"));
    EXPECT_FALSE(std::filesystem::exists(directory_ / "out" / "proposed.mo"));
}

}  // namespace
}  // namespace analogon
