#include "core/study/run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <sstream>

#include "core/effect/model/null_model.hpp"
#include "core/report/report.hpp"
#include "core/report/words.hpp"
#include "core/residual/noise.hpp"
#include "study_fixture.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;

class Run : public test::StudyTest {
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

/// A recording of the heater whose current runs straight from one value to another.
std::string fewSamples(int count, double from, double to) {
    std::ostringstream csv;
    csv << "t [s],u_heater [V],T_air [K],current [A]\n";
    for (int k = 0; k < count; ++k) csv << k << ",12,293.15," << from + (to - from) * k / (count - 1) << '\n';
    return csv.str();
}

TEST_F(Run, AFewSamplesAreTooFewToJudgeAModelBy) {
    put("train.csv", "t [s],u_heater [V],T_air [K],current [A]\n0,12,293.15,6\n1,12,293.15,2\n2,12,293.15,5\n");
    const Outcome<RunResult> result = runDiscover(read(), {}, {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    const Finding& finding = result->finding;
    EXPECT_GT(finding.final.experiments.at(0).errorPercent, 20);
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    EXPECT_THAT(finding.end.notSearched.english(), HasSubstr("too few samples to judge: 3 samples, 2 parameters"));
    EXPECT_EQ(std::count(finding.warnings.begin(), finding.warnings.end(), finding.end.notSearched), 1);
    EXPECT_THAT(summaryWords(finding, "discover"), HasSubstr("No effect was looked for: too few samples to judge"));
    const Outcome<RunResult> fitted = runFit(read(), {}, {});
    ASSERT_TRUE(fitted) << format(fitted.diagnostics());
    const std::vector<Text>& remarks = fitted->finding.final.remarks;
    EXPECT_EQ(std::count(remarks.begin(), remarks.end(), finding.end.notSearched), 1) << "a fit says the same";
}

TEST_F(Run, ATrendIsToldFromNoiseByFifteenSamplesBeyondTheParameters) {
    const auto trend = [](int count) { return Eigen::VectorXd::LinSpaced(count, -1, 1).eval(); };
    EXPECT_GT(summarise(trend(14)).whiteProbability, whiteSignificance);
    EXPECT_LT(summarise(trend(15)).whiteProbability, whiteSignificance);
    for (const int count : {16, 17}) {  // two parameters are fitted
        put("train.csv", fewSamples(count, 6, 2));
        const Outcome<RunResult> result = runDiscover(read(), {}, {});
        ASSERT_TRUE(result) << format(result.diagnostics());
        EXPECT_EQ(result->finding.end.notSearched.empty(), count == 17);
    }
}

TEST_F(Run, AFitTellsHowLongItTook) {
    const Outcome<RunResult> result = runFit(read(), {}, {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    EXPECT_GT(result->finding.final.seconds, 0);
    EXPECT_GE(result->finding.end.seconds, result->finding.final.seconds) << "with what comes before and after";
}

TEST_F(Run, ACancelledFitKeepsTheBestWithItsFigures) {
    std::stop_source source;
    const Progress progress(source.get_token(), [&](const Progress::Report&) { source.request_stop(); });
    const Outcome<RunResult> result = runFit(read(), {}, progress);
    ASSERT_TRUE(result) << format(result.diagnostics());
    EXPECT_TRUE(result->finding.end.interrupted);
    EXPECT_TRUE(std::isfinite(result->finding.final.experiments.at(0).errorPercent));
}

/// Whoever stopped a run waits for its end; nobody does where it came to its limit of work.
TEST_F(Run, LeavesLongTracesOutOnlyWhereItWasStoppedFromOutside) {
    Finding finding;
    finding.baseline.experiments.resize(1);
    finding.baseline.experiments[0].time.resize(200'000);
    finding.baseline.experiments[0].outputs.resize(1);
    EXPECT_FALSE(leavesTracesOut(finding));
    finding.end.interrupted = true;
    EXPECT_TRUE(leavesTracesOut(finding));
    finding.end.isAtLimitOfWork = true;
    EXPECT_FALSE(leavesTracesOut(finding));
    EXPECT_TRUE(leavesTracesOut(finding, Traces::Short));
}

TEST_F(Run, ASearchThatIsStoppedClaimsNothingThatItHasNotLookedAt) {
    for (const char* stage : {"fit", "screen"}) {
        std::stop_source source;
        std::optional<RunResult> kept;
        RunOptions options;
        options.keep = [&](RunResult result) { kept = std::move(result); };
        const Progress progress(source.get_token(), [&](const Progress::Report& report) {
            if (report.stage == stage && !(report.stage == "fit" && report.best.empty())) source.request_stop();
        });
        const Outcome<RunResult> result = runDiscover(read(), options, progress);
        ASSERT_TRUE(result) << format(result.diagnostics());
        const Finding& finding = result->finding;
        EXPECT_TRUE(finding.end.interrupted);
        EXPECT_EQ(finding.kind, FindingKind::Interrupted) << name(finding.kind);
        EXPECT_TRUE(finding.effects.empty());
        EXPECT_TRUE(std::isfinite(finding.final.experiments.at(0).errorPercent));
        EXPECT_FALSE(finding.final.parameters.empty());
        EXPECT_EQ(kept.has_value(), stage == std::string("screen"))
            << "from the first fit on there is something to tell";
        if (kept) {
            EXPECT_EQ(kept->finding.kind, FindingKind::Interrupted);
            EXPECT_EQ(kept->finding.final.modelText, finding.final.modelText);
        }
    }
}

TEST_F(Run, AFitThatIsStoppedGivesNoHalfAProfile) {
    std::stop_source source;
    RunOptions options;
    options.profiled = {"all"};
    const Progress progress(source.get_token(), [&](const Progress::Report& report) {
        if (report.stage == "profile") source.request_stop();
    });
    const Outcome<RunResult> result = runFit(read(), options, progress);
    ASSERT_TRUE(result) << format(result.diagnostics());
    EXPECT_TRUE(result->finding.end.interrupted);
    EXPECT_EQ(result->finding.final.status, FitStatus::Converged) << "the fit itself was over";
    for (const FitEstimate& e : result->finding.final.parameters) EXPECT_FALSE(e.interval) << e.name;
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
    EXPECT_THAT(format(result.diagnostics()), HasSubstr("(x)"));
}

TEST_F(Run, ASimulationThatFailsNamesTheOperationAndTheEquation) {
    put("model.mo", R"(model Heater
  input Real u(unit="V"), T_amb(unit="K");
  parameter Real R = 1.5;
  parameter Real C = 20;
  Real x(start=1, fixed=true);
  output Real i(unit="A");
equation
  der(x) = -0.1 + 0*(u + T_amb + R + C);
  i = log(x);
end Heater;
)");
    const Outcome<RunResult> result = runSimulate(read(), {}, {});
    ASSERT_FALSE(result);
    EXPECT_THAT(format(result.diagnostics()), HasSubstr("log(x) is the logarithm of"));
    EXPECT_THAT(format(result.diagnostics()), HasSubstr("in the equation i = log(x) ("));
    EXPECT_THAT(format(result.diagnostics()), HasSubstr("model.mo, line 9)"));
}

TEST_F(Run, ASimulationReportsHowFarItIs) {
    std::ostringstream csv;
    csv << "t [s],u_heater [V],T_air [K],current [A]\n";
    for (int k = 0; k < 60000; ++k) csv << 0.1 * k << ",12,293.15," << 6.0 - 1e-5 * k << '\n';
    put("train.csv", csv.str());
    std::vector<double> fractions;
    const Progress progress({}, [&](const Progress::Report& report) {
        if (report.stage == "simulate") fractions.push_back(report.fraction);
    });
    ASSERT_TRUE(runSimulate(read(), {}, progress));
    ASSERT_GT(fractions.size(), 10u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end())) << "a bar does not go back";
    EXPECT_EQ(fractions.front(), 0);
    EXPECT_EQ(fractions.back(), 1);
    const auto isBetween = [](double f) { return f > 0.01 && f < 0.99; };
    EXPECT_GE(std::count_if(fractions.begin(), fractions.end(), isBetween), 5);
}

/// A motor at rest beside one that moves: supply voltage, speed and a channel of zeros are measured.
class AtRest : public test::StudyTest {
protected:
    void putStudy(double supplyMeasured, double zeroSimulated = 0) {
        put("model.mo",
            "model M\n  input Real u;\n  output Real w = x;\n  output Real supply = 12;\n  output Real zero = " +
                std::to_string(zeroSimulated) +
                ";\n  parameter Real k = 1;\n  parameter Real T = 2;\n  Real x(start=0, fixed=true);\n"
                "equation\n  T*der(x) = k*u - x;\nend M;\n");
        put("study.json", R"({"format": "analogon-study-1", "class": "M", "experiments": [
  {"name": "bench", "role": "fit", "file": "a.csv", "time": "t", "inputs": {"u": "u"},
   "outputs": {"w": "w", "supply": "supply", "zero": "zero"}}],
 "parameters": {"k": {"fit": true, "min": 0.1, "max": 10}, "T": {"fit": true, "min": 0.1, "max": 10}}})");
        std::ostringstream csv;
        csv << "t [s],u,w,supply,zero\n";
        std::mt19937 random(5);
        std::normal_distribution<double> noise(0.0, 0.01);
        const auto u = [this](int k) { return moves_ ? 0.5 + 0.5 * std::sin(0.05 * k) + 0.3 * std::sin(0.17 * k) : 0; };
        double x = 0;
        for (int k = 0; k < 400; ++k) {
            csv << 0.1 * k << ',' << u(k) << ',' << (moves_ ? x + noise(random) : 0.0) << ',' << supplyMeasured
                << ",0\n";
            for (int s = 0; s < 100; ++s) x += 1e-3 * (2.5 * (u(k) + (u(k + 1) - u(k)) * (s + 0.5) / 100) - x) / 1.6;
        }
        put("a.csv", csv.str());
    }
    const OutputState& output(const RunResult& result, const std::string& name) const {
        for (const OutputState& o : result.finding.final.experiments.at(0).outputs)
            if (o.name == name) return o;
        throw std::runtime_error(name);
    }
    bool moves_{true};
};

TEST_F(AtRest, AConstantOutputLeavesTheFitOfTheOthersAlone) {
    for (const double supply : {12.0, 11.0, 24.0, 0.0}) {
        putStudy(supply);
        const Outcome<RunResult> result = runFit(read(), {}, {});
        ASSERT_TRUE(result) << supply << format(result.diagnostics());
        const ModelState& state = result->finding.final;
        EXPECT_EQ(state.status, FitStatus::Converged) << state.message;
        for (const FitEstimate& e : state.parameters)
            EXPECT_NEAR(e.value, e.name == "k" ? 2.5 : 1.6, 0.02) << supply << " " << e.name;
        for (const FitEstimate& e : state.parameters)
            EXPECT_LT(e.standardError, 0.01) << "what is off by a constant says nothing of the scatter";
        EXPECT_LT(output(*result, "w").figures.errorPercent, 1);
    }
}

TEST_F(AtRest, AConstantErrorIsAnErrorAndNotAdequate) {
    putStudy(24);
    const Outcome<RunResult> result = runDiscover(read(), {}, {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    EXPECT_NEAR(result->finding.baseline.experiments.at(0).outputs.at(1).figures.errorPercent, 50, 1e-6);
    EXPECT_NE(result->finding.kind, FindingKind::Adequate);
    putStudy(12);
    const Outcome<RunResult> right = runDiscover(read(), {}, {});
    ASSERT_TRUE(right) << format(right.diagnostics());
    EXPECT_EQ(right->finding.kind, FindingKind::Adequate);
}

TEST_F(AtRest, ARecordingThatNeverMovesIsFittedAndSaysWhatItTells) {
    moves_ = false;
    putStudy(12);
    const Outcome<RunResult> fitted = runFit(read(), {}, {});
    ASSERT_TRUE(fitted) << format(fitted.diagnostics());
    const ModelState& state = fitted->finding.final;
    EXPECT_EQ(state.experiments.at(0).errorPercent, 0);
    std::string remarks;
    for (const Text& remark : state.remarks) remarks += remark.english() + "\n";
    EXPECT_THAT(remarks, HasSubstr("k has no influence on what was measured here"));
    EXPECT_THAT(remarks, HasSubstr("supply stands still at 12: its error is told in percent of that"));
    EXPECT_THAT(remarks, HasSubstr("zero is 0 throughout: it has no error in percent"));
    EXPECT_THAT(remarks, HasSubstr("nothing can be judged: no measured output moves in the fitted recordings"));
    const Outcome<RunResult> searched = runDiscover(read(), {}, {});
    ASSERT_TRUE(searched) << format(searched.diagnostics());
    const Finding& finding = searched->finding;
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    EXPECT_TRUE(finding.effects.empty() && finding.candidates.empty());
    EXPECT_THAT(finding.end.notSearched.english(), HasSubstr("(w = 0, supply = 12 and zero = 0)"));
    EXPECT_EQ(std::count(finding.warnings.begin(), finding.warnings.end(), finding.end.notSearched), 1);
}

TEST_F(AtRest, AConstantErrorIsAnErrorWhateverIsLookedFor) {
    putStudy(24);
    RunOptions options;
    options.discover.kinds = {"sensor.lag"};
    const Outcome<RunResult> result = runDiscover(read(), options, {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    EXPECT_EQ(result->finding.kind, FindingKind::Unexplained);
    ASSERT_FALSE(result->finding.unexplained.remainders.empty());
    EXPECT_EQ(result->finding.unexplained.remainders.front().output, "supply");
}

TEST_F(Run, AConstantOutputOfAnySizeIsNotAdequate) {
    for (const char* const value : {"1e300", "1e-300", "-3e-100", "7"}) {
        std::ostringstream csv;
        csv << "t [s],u_heater [V],T_air [K],current [A]\n";
        for (int k = 0; k < 400; ++k) csv << 0.1 * k << ",12,293.15," << value << '\n';
        put("train.csv", csv.str());
        const Outcome<RunResult> result = runDiscover(read(), {}, {});
        ASSERT_TRUE(result) << value << format(result.diagnostics());
        EXPECT_EQ(result->finding.kind, FindingKind::Unexplained) << value;
        EXPECT_THAT(result->finding.end.notSearched.english(), HasSubstr("no measured output moves")) << value;
        if (std::fabs(std::atof(value)) < 1e-200) continue;  // a percentage of nothing
        EXPECT_TRUE(std::isfinite(result->finding.baseline.experiments.at(0).errorPercent)) << value;
    }
}

TEST_F(Run, AnOutputThatMovesWhereTheInputStandsAtZeroIsUnexplained) {
    std::ostringstream csv;
    csv << "t [s],u_heater [V],T_air [K],current [A]\n";
    for (int k = 0; k < 400; ++k) csv << 0.1 * k << ",0,293.15," << std::sin(0.1 * k) << '\n';
    put("train.csv", csv.str());
    const Outcome<RunResult> result = runDiscover(read(), {}, {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    EXPECT_NE(result->finding.kind, FindingKind::Adequate);
}

TEST_F(Run, AFitOfWhatIsAtRestConvergesWhereItBegins) {
    put("study.json", R"({"format": "analogon-study-1", "class": "Box", "experiments": [
  {"name": "rest", "role": "fit", "file": "rest.csv", "time": "t", "inputs": {"on": "on", "T_amb": "T_amb"},
   "outputs": {"T": "T"}, "initial": {"body.T_start": "fit"}}],
 "parameters": {"power.k": {"fit": true, "min": 1, "max": 1000, "scale": "log"},
  "body.C": {"fit": true, "min": 10, "max": 1e5, "scale": "log"},
  "wall.G": {"fit": true, "min": 0.01, "max": 100, "scale": "log"}}})");
    put("model.mo", R"(model Box "Heated box"
  Analogon.Interfaces.RealInput on(unit="1"), T_amb(unit="K");
  Analogon.Interfaces.RealOutput T(unit="K");
  Analogon.Signals.Gain power(k=25);
  Analogon.Sources.PrescribedHeatFlow heater;
  Analogon.Thermal.HeatCapacitor body(C=600, T_start=293.15);
  Analogon.Thermal.ThermalConductor wall(G=1.5);
  Analogon.Sources.PrescribedTemperature outside;
  Analogon.Sensors.TemperatureSensor probe;
equation
  connect(on, power.u);
  connect(power.y, heater.Q_flow);
  connect(heater.port, body.port);
  connect(body.port, wall.port_a);
  connect(wall.port_b, outside.port);
  connect(T_amb, outside.T);
  connect(body.port, probe.port);
  connect(probe.T, T);
end Box;
)");
    for (const char* const celsius : {"0", "20"}) {
        std::ostringstream csv;
        csv << "t [s],on [1],T_amb [degC],T [degC]\n";
        for (int k = 0; k < 400; ++k) csv << 10 * k << ",0," << celsius << ',' << celsius << '\n';
        put("rest.csv", csv.str());
        const Outcome<RunResult> result = runFit(read(), {}, {});
        ASSERT_TRUE(result) << celsius << format(result.diagnostics());
        const ModelState& state = result->finding.final;
        EXPECT_EQ(state.status, FitStatus::Converged) << celsius << ": " << state.message;
        std::string remarks;
        for (const Text& remark : state.remarks) remarks += remark.english() + "\n";
        for (const FitEstimate& e : state.parameters) {
            if (e.experiment >= 0) continue;
            EXPECT_FALSE(std::isfinite(e.standardError)) << e.name << " ± " << e.standardError;
            EXPECT_THAT(remarks, HasSubstr(e.name + " has no influence on what was measured here"));
        }
    }
}

TEST_F(AtRest, AChannelOfZerosHasNoErrorInPercentAndIsJudgedAllTheSame) {
    putStudy(12, 0.7);
    const Outcome<RunResult> result = runDiscover(read(), {}, {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    EXPECT_NE(result->finding.kind, FindingKind::Adequate);
    const std::string json = reportJson(result->finding, {"M", "discover", "0"});
    EXPECT_THAT(json, HasSubstr("\"error_percent\": null"));
    EXPECT_THAT(json, ::testing::Not(HasSubstr(": nan")));
    EXPECT_TRUE(std::isfinite(result->finding.baseline.experiments.at(0).errorPercent)) << "of those that have one";
}

/// Two recordings of one input, the second to validate.
class TwoRecordings : public test::StudyTest {
protected:
    void putStudy(const std::string& equation, double uFit, double uValidate) {
        put("study.json", R"({"format": "analogon-study-1", "class": "M", "experiments": [
  {"name": "bench", "role": "fit", "file": "a.csv", "time": "t", "inputs": {"u": "u"}, "outputs": {"y": "y"}},
  {"name": "drive", "role": "validate", "file": "b.csv", "time": "t", "inputs": {"u": "u"}, "outputs": {"y": "y"}}],
 "parameters": {"k": {"fit": true, "min": 0.1, "max": 10}}})");
        put("model.mo",
            "model M\n  input Real u;\n  output Real y = x;\n  parameter Real k = 1;\n"
            "  Real x(start=0.5, fixed=true);\nequation\n  " +
                equation + ";\nend M;\n");
        for (const auto& [file, u] : {std::pair{"a.csv", uFit}, std::pair{"b.csv", uValidate}}) {
            std::ostringstream csv;
            csv << "t [s],u,y\n";
            for (int k = 0; k < 21; ++k) csv << 0.5 * k << ',' << u << ',' << 0.5 + 0.01 * (k % 3) << '\n';
            put(file, csv.str());
        }
    }
};

TEST_F(TwoRecordings, OfWhichTheValidationFailsGiveTheFitAndSayWhatFailed) {
    putStudy("der(x) = u*x^2 - k*(x - 0.51)", 0, 12);
    const Outcome<RunResult> result = runFit(read(), {}, {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    const ModelState& state = result->finding.final;
    ASSERT_EQ(state.experiments.size(), 2u);
    EXPECT_TRUE(std::isfinite(state.experiments[0].errorPercent));
    EXPECT_TRUE(state.experiments[1].failure.failed);
    ASSERT_FALSE(state.remarks.empty());
    EXPECT_THAT(state.remarks.back(), HasSubstr("\"drive\" stopped at t = "));
}

TEST_F(TwoRecordings, AreSimulatedFromEventToEvent) {
    putStudy("der(x) = if x < 0.7734 then k else 0.1*k", 0, 0);
    const Outcome<RunResult> result = runSimulate(read(), {}, {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    const OutputState& y = result->finding.final.experiments.at(0).outputs.at(0);
    EXPECT_NEAR(y.simulated[1], 0.7734 + 0.1 * (0.5 - 0.2734), 1e-6) << "far more than a step of the recording is off";
    EXPECT_NEAR(y.simulated[20], 0.7734 + 0.1 * (10 - 0.2734), 1e-5);
}

/// A heater whose current follows a swinging voltage and its own temperature, recorded by a logger 37 ms ahead.
class LateCurrent : public Run {
protected:
    void SetUp() override {
        Run::SetUp();
        std::ostringstream csv;
        csv << "t [s],u_heater [V],T_air [K],current [A]\n";
        const auto voltage = [](double t) { return 10.0 + 3.0 * std::sin(2.0 * t) + std::sin(5.3 * t); };
        std::mt19937 random(4);
        std::normal_distribution<double> normal(0.0, 0.005);
        double temperature = 293.15;
        std::vector<double> current;  // every millisecond
        for (int j = 0; j < 40000; ++j) {
            const double u = voltage(1e-3 * j), i = u / (1.6 * (1.0 + 0.004 * (temperature - 293.15)));
            current.push_back(i);
            temperature += 1e-3 * (u * i - 0.2 * (temperature - 293.15)) / 30.0;
        }
        for (int k = 0; k < 2000; ++k)
            csv << 0.02 * k << ',' << voltage(0.02 * k) << ",293.15,"
                << current[static_cast<std::size_t>(std::max(0, 20 * k - 37))] + normal(random) << '\n';
        put("train.csv", csv.str());
        change("\"current\"", "{\"column\": \"current\", \"clock\": \"fit\"}");
        change("\"max\": 20.0", "\"max\": 20.0, \"prior\": {\"mean\": 1.6, \"std\": 0.01}");
    }
};

TEST_F(LateCurrent, IsReportedAndWrittenIntoTheCompletedStudy) {
    const Outcome<RunResult> result = runFit(read(), {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    bool isFound = false;
    for (const FitEstimate& e : result->finding.final.parameters) {
        const double truth = e.name == "R" ? 1.6 : e.name == "C" ? 30.0 : 0.037;
        EXPECT_NEAR(e.value, truth, 4.0 * e.standardError) << e.name;
        if (e.name == "clock i") {
            isFound = true;
            EXPECT_EQ(e.unit, "s");
            EXPECT_LT(e.standardError, 1e-3);
        }
        EXPECT_EQ(e.prior.has_value(), e.name == "R");
    }
    EXPECT_TRUE(isFound);
    const OutputState& output = result->finding.final.experiments[0].outputs[0];
    EXPECT_LT(output.figures.rmse, 0.006);
    EXPECT_EQ(output.measured.array().isNaN().count(), 2);  // stamped 0 and 20 ms: before the recording
    ASSERT_EQ(output.deviation.size(), output.simulated.size());
    EXPECT_GT(output.deviation.maxCoeff(), 0.0);
    EXPECT_LT(output.deviation.maxCoeff(), 0.002);
    ASSERT_TRUE(writeResults(*result, "fit", directory_ / "out"));
    const Outcome<Study> completed = readStudy(directory_ / "out" / "study");
    ASSERT_TRUE(completed) << format(completed.diagnostics());
    EXPECT_TRUE(completed->experiments[0].outputs.at("i").fitsClock);
    EXPECT_NEAR(*completed->parameters.at("clock i").value, 0.037, 0.002);
    EXPECT_EQ(completed->parameters.at("R").prior, (NormalPrior{1.6, 0.01}));
    EXPECT_EQ(get(directory_ / "out" / "study" / "model.mo").find("clock"), std::string::npos);
    EXPECT_TRUE(estimationTask(*completed));
}

TEST_F(LateCurrent, IsNoMissingEffect) {
    const Outcome<RunResult> result = runDiscover(read(), {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    EXPECT_EQ(result->finding.kind, FindingKind::Adequate);
    EXPECT_TRUE(result->finding.effects.empty());
}

/// A body that cools down to the ambient temperature, from a start that nobody knew: 360 K, and 330 K to validate.
class UnknownStart : public Run {
protected:
    void SetUp() override {
        Run::SetUp();
        put("model.mo", R"(model Heater
  input Real u(unit="V"), T_amb(unit="K");
  parameter Real R(unit="Ohm") = 2;
  parameter Real C(unit="J/K") = 30;
  parameter Real T_start(unit="K") = 293.15;
  Real T(start=T_start, fixed=true);
  output Real i(unit="K") "what is measured";
equation
  C*der(T) = u*u/R - 0.5*(T - T_amb);
  i = T;
end Heater;
)");
        put("train.csv", recorded(360, 0.0, 1));
        put("check.csv", recorded(330, 0.0, 2));
        put("study.json", R"({"format": "analogon-study-1", "class": "Heater", "experiments": [
    {"name": "warm-up", "role": "fit", "file": "train.csv", "time": "t", "initial": {"T_start": "fit"},
     "inputs": {"u": "u_heater", "T_amb": "T_air"}, "outputs": {"i": "T"}},
    {"name": "check", "role": "validate", "file": "check.csv", "time": "t", "initial": {"T_start": "fit"},
     "inputs": {"u": "u_heater", "T_amb": "T_air"}, "outputs": {"i": "T"}}],
  "parameters": {"R": {"fit": true, "min": 0.1, "max": 20.0}, "C": {"fit": true, "min": 1, "max": 100}}})");
    }

    /// The truth: R = 1.6, C = 20. What is added is 0.1 K of noise, of which `memory` stays to the next sample.
    static std::string recorded(double start, double memory, unsigned seed) {
        std::mt19937 random(seed);
        std::normal_distribution<double> normal(0.0, 0.1 * std::sqrt(1.0 - memory * memory));
        std::ostringstream csv;
        csv.precision(10);
        csv << "t [s],u_heater [V],T_air [K],T [K]\n";
        double temperature = start, noise = 0.0;
        for (int k = 0; k < 800; ++k) {
            const double u = k < 400 ? 2.0 : 8.0, level = 293.15 + u * u / 1.6 / 0.5;
            noise = memory * noise + normal(random);
            csv << 0.2 * k << ',' << u << ",293.15," << temperature + noise << '\n';
            // inputs run linearly between samples: half of the step of the voltage counts
            const double next = k == 399 ? 293.15 + (4.0 + 16.0 + 64.0) / 3.0 / 1.6 / 0.5 : level;
            temperature = next + (temperature - next) * std::exp(-0.5 * 0.2 / 20.0);
        }
        return csv.str();
    }

    static const ExperimentState& check(const RunResult& result) { return result.finding.final.experiments.at(1); }
};

TEST_F(UnknownStart, OfAValidationIsEstimatedFromItAlone) {
    const Outcome<RunResult> result = runFit(read(), {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    ASSERT_EQ(check(*result).starts.size(), 1u);
    const FitEstimate& start = check(*result).starts.front();
    EXPECT_EQ(start.name, "T_start");
    EXPECT_NEAR(start.value, 330, 4 * start.standardError + 0.1);
    EXPECT_LT(start.standardError, 0.1);
    EXPECT_NEAR(check(*result).outputs.at(0).figures.rmse, 0.1, 0.02);

    // nothing else is made of that recording
    put("check.csv", recorded(310, 0.0, 3));
    const Outcome<RunResult> other = runFit(read(), {});
    ASSERT_TRUE(other) << format(other.diagnostics());
    EXPECT_NEAR(check(*other).starts.at(0).value, 310, 0.2);
    const auto& parameters = result->finding.final.parameters;
    ASSERT_EQ(parameters.size(), 3u);
    for (std::size_t i = 0; i < parameters.size(); ++i)
        EXPECT_EQ(other->finding.final.parameters.at(i).value, parameters[i].value) << parameters[i].name;
}

TEST_F(UnknownStart, IsReportedAndStaysOpenInTheCompletedStudy) {
    const Outcome<RunResult> result = runFit(read(), {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    ASSERT_TRUE(writeResults(*result, "fit", directory_ / "out"));
    const std::string json = get(directory_ / "out" / "report.json");
    EXPECT_THAT(json, HasSubstr("\"T_start (warm-up)\""));
    EXPECT_THAT(json, HasSubstr("\"T_start (check)\""));
    const Outcome<Study> completed = readStudy(directory_ / "out" / "study");
    ASSERT_TRUE(completed) << format(completed.diagnostics());
    EXPECT_TRUE(std::holds_alternative<FittedStart>(completed->experiments.at(1).initial.at("T_start")));
    // simulated as it stands then, it is as good as it was fitted
    const Outcome<RunResult> again = runSimulate(*completed, {});
    ASSERT_TRUE(again) << format(again.diagnostics());
    for (const std::size_t e : {0u, 1u})
        EXPECT_NEAR(again->finding.final.experiments.at(e).errorPercent,
                    result->finding.final.experiments.at(e).errorPercent, 1e-3);
}

TEST_F(UnknownStart, HasStandardErrorsThatReckonWithTheColourOfTheResidual) {
    const auto isRobust = [](const FitEstimate& e) { return std::isfinite(e.whiteError); };
    const Outcome<RunResult> white = runFit(read(), {});
    ASSERT_TRUE(white) << format(white.diagnostics());
    for (const FitEstimate& e : white->finding.final.parameters) EXPECT_FALSE(isRobust(e)) << e.name;

    put("train.csv", recorded(360, 0.9, 1));
    put("check.csv", recorded(330, 0.9, 2));
    const Outcome<RunResult> coloured = runFit(read(), {});
    ASSERT_TRUE(coloured) << format(coloured.diagnostics());
    for (const FitEstimate& e : coloured->finding.final.parameters) {
        EXPECT_TRUE(isRobust(e)) << e.name;
        EXPECT_EQ(e.standardError, e.robustError) << e.name;
        EXPECT_GT(e.standardError, 1.5 * e.whiteError) << e.name;
    }
    EXPECT_TRUE(isRobust(check(*coloured).starts.at(0)));
}

TEST_F(Run, FitsWhereAnOutputWasNotMeasuredThroughout) {
    std::string csv = get(directory_ / "train.csv");
    const Outcome<RunResult> whole = runFit(read(), {});
    ASSERT_TRUE(whole) << format(whole.diagnostics());
    for (const char* const sample : {"\n10,12,293.15,", "\n20.5,12,293.15,"}) {
        const std::size_t at = csv.find(sample);
        ASSERT_NE(at, std::string::npos);
        const std::size_t cell = at + std::string(sample).size();
        csv.erase(cell, csv.find('\n', cell) - cell);
    }
    put("train.csv", csv);
    const Outcome<RunResult> result = runFit(read(), {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    EXPECT_THAT(format(result.diagnostics()), HasSubstr("'current' was not measured in 2 of 400 rows"));
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(result->finding.final.parameters.at(i).value / whole->finding.final.parameters.at(i).value, 1,
                    1e-3);
}

TEST_F(Run, WritesTheBlockOfALawBesideTheReport) {
    RunResult result;
    result.completed = read();
    Remainder law;
    law.proposal.className = "MissingTorque1";
    law.proposal.block = "model MissingTorque1\nend MissingTorque1;\n";
    result.finding.unexplained.remainders = {law};
    result.proposed = read();
    ASSERT_TRUE(writeResults(result, "discover", directory_ / "out"));
    EXPECT_EQ(get(directory_ / "out" / "proposed.mo"), law.proposal.block);
    EXPECT_TRUE(readStudy(directory_ / "out" / "study-proposed"));
    // what an earlier run proposed is not left beside a report that proposes nothing
    result.finding.unexplained.remainders.clear();
    result.proposed.reset();
    ASSERT_TRUE(writeResults(result, "discover", directory_ / "out"));
    EXPECT_FALSE(std::filesystem::exists(directory_ / "out" / "proposed.mo"));
    EXPECT_FALSE(std::filesystem::exists(directory_ / "out" / "study-proposed"));
}

}  // namespace
}  // namespace analogon
