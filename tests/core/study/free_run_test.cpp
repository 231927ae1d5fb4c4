#include "core/study/free_run.hpp"

#include <cmath>

#include "core/report/words.hpp"
#include "core/study/class_run.hpp"
#include "core/study/run_history.hpp"
#include "tests/core/study/study_fixture.hpp"

namespace analogon {
namespace {

class FreeRun : public test::StudyTest {
protected:
    static Study studyOf(const std::string& text) {
        Study study;
        study.className = "M";
        study.models["model.mo"] = text;
        return study;
    }
    /// A lag that a step drives.
    static Study lag(const std::string& more = {}) {
        return studyOf(R"(model M
  Analogon.Sources.Step step(height=2, startTime=0.5);
  Analogon.Signals.FirstOrder lag(T=0.4);
  Analogon.Interfaces.RealOutput y(unit="K");
equation
  connect(step.y, lag.u);
  connect(lag.y, y);)" +
                       more + "\nend M;\n");
    }
    static const ExperimentState& only(const Outcome<RunResult>& run) { return run->finding.final.experiments.front(); }
    /// What the lag says at its last sample.
    static double exact(double t, double height = 2, double T = 0.4) { return height * (1 - std::exp(-(t - 0.5) / T)); }
};

TEST_F(FreeRun, GivesTheOutputsOfTheModelWithoutARecording) {
    const Outcome<RunResult> run = runFreely(lag(), 3.0, {});
    ASSERT_TRUE(run) << format(run.diagnostics());
    const ExperimentState& experiment = only(run);
    EXPECT_EQ(experiment.name, "Simulation");
    EXPECT_EQ(experiment.role, Role::Validate);
    ASSERT_EQ(experiment.outputs.size(), 1u);
    EXPECT_EQ(experiment.outputs[0].name, "y");
    EXPECT_EQ(experiment.outputs[0].unit, "K");
    EXPECT_DOUBLE_EQ(experiment.time.front(), 0);
    EXPECT_DOUBLE_EQ(experiment.time.back(), 3);
    ASSERT_EQ(experiment.outputs[0].simulated.size(), static_cast<Eigen::Index>(experiment.time.size()));
    for (std::size_t k = 0; k < experiment.time.size(); ++k) {
        const double t = experiment.time[k];
        EXPECT_NEAR(experiment.outputs[0].simulated[static_cast<Eigen::Index>(k)], t < 0.5 ? 0 : exact(t), 1e-5) << t;
    }
    EXPECT_TRUE(experiment.outputs[0].measured.array().isNaN().all());
}

TEST_F(FreeRun, EndsWhenTheModelSaysOrWhenItIsTold) {
    const Study told = lag("\n  annotation (experiment(StopTime=7));");
    const Outcome<RunResult> run = runFreely(told, {}, {});
    ASSERT_TRUE(run) << format(run.diagnostics());
    EXPECT_DOUBLE_EQ(only(run).time.back(), 7);
    EXPECT_DOUBLE_EQ(only(runFreely(told, 2.0, {})).time.back(), 2);
    EXPECT_DOUBLE_EQ(only(runFreely(lag(), {}, {})).time.back(), 1);
    const Outcome<RunResult> backwards = runFreely(told, -1.0, {});
    ASSERT_FALSE(backwards);
    EXPECT_THAT(format(backwards.diagnostics()), ::testing::HasSubstr("before it begins"));
}

TEST_F(FreeRun, NamesEachInputThatNothingDrives) {
    const Outcome<RunResult> run = runFreely(studyOf("model M\n  input Real u;\n  input Real w;\n  output Real y;\n"
                                                     "equation\n  der(y) = u - w;\nend M;\n"),
                                             1.0, {});
    ASSERT_FALSE(run);
    ASSERT_EQ(run.diagnostics().size(), 2u);
    EXPECT_EQ(run.diagnostics()[0].message.english(), "nothing drives the input 'u' of the model");
    EXPECT_EQ(run.diagnostics()[0].place.line, 2);
    EXPECT_EQ(run.diagnostics()[1].place.line, 3);
    EXPECT_THAT(run.diagnostics()[0].hint.english(), ::testing::HasSubstr("Connect a source"));
}

TEST_F(FreeRun, NamesNoneOfTheInputsThatEventsBringAlong) {
    const Outcome<RunResult> run = runFreely(studyOf("model M\n  discrete Real n(start = 0, fixed = true);\n"
                                                     "  output Real y = n;\nequation\n"
                                                     "  when sample(0.05, 0.1) then\n    n = pre(n) + 1;\n"
                                                     "  end when;\nend M;\n"),
                                             1.0, {});
    ASSERT_TRUE(run) << format(run.diagnostics());
    EXPECT_DOUBLE_EQ(only(run).outputs[0].simulated.tail(1)[0], 10);
}

TEST_F(FreeRun, TakesTheValuesThatTheStudyGives) {
    Study study = lag();
    study.parameters["lag.T"].value = 0.1;
    const Outcome<RunResult> run = runFreely(study, 0.7, {});
    ASSERT_TRUE(run) << format(run.diagnostics());
    EXPECT_NEAR(only(run).outputs[0].simulated.tail(1)[0], exact(0.7, 2, 0.1), 1e-5);
    EXPECT_EQ(run->completed.parameters.at("lag.T").value, 0.1) << "the study stays as it is";
}

TEST_F(FreeRun, ShowsTheStatesOfAModelWithoutOutputs) {
    const Outcome<RunResult> run = runFreely(studyOf("model M\n  Real x(start=1, fixed=true);\n  Real z = 2*x;\n"
                                                     "equation\n  der(x) = -x;\nend M;\n"),
                                             1.0, {});
    ASSERT_TRUE(run) << format(run.diagnostics());
    ASSERT_EQ(only(run).outputs.size(), 1u);
    EXPECT_EQ(only(run).outputs[0].name, "x");
}

TEST_F(FreeRun, RunsModelsWithEvents) {
    const Outcome<RunResult> run = runFreely(studyOf(R"(model M
  Real h(start=1, fixed=true);
  Real v(start=0, fixed=true);
  discrete Integer bounces(start=0, fixed=true);
  output Real y = h;
equation
  der(h) = v;
  der(v) = -9.81;
  when h < 0 then
    reinit(v, -0.7*pre(v));
    bounces = pre(bounces) + 1;
  end when;
end M;
)"),
                                             1.5, {});
    ASSERT_TRUE(run) << format(run.diagnostics());
    EXPECT_GT(only(run).outputs[0].simulated.minCoeff(), -1e-6);
    EXPECT_LT(only(run).outputs[0].simulated.tail(1)[0], 0.5);
}

TEST_F(FreeRun, HasNoErrorAndIsCalledLikeNoRecording) {
    Study study = lag();
    study.experiments.resize(2);
    study.experiments[0].name = "Simulation";
    study.experiments[1].name = "Simulation 2";
    EXPECT_EQ(freeRunName(study), "Simulation 3");
    const Outcome<RunResult> run = runFreely(lag(), 1.0, {});
    ASSERT_TRUE(run);
    EXPECT_TRUE(std::isnan(errorPercent(run->finding.final, Role::Validate)));
    EXPECT_FALSE(only(run).outputs[0].figures.hasScale());
}

TEST_F(FreeRun, IsKeptInTheHistoryOfTheStudy) {
    const Study study = lag();
    const Outcome<RunResult> run = runFreely(study, 1.0, {});
    ASSERT_TRUE(run);
    PastRun past;
    past.command = "simulate";
    past.ended = "2026-03-01T14:02:11";
    past.ranOn = std::make_shared<const Study>(study);
    past.result = std::make_shared<const RunResult>(*run);
    ASSERT_TRUE(writeHistory({past}, directory_ / "history"));
    const Outcome<std::vector<PastRun>> read = readHistory(directory_ / "history", study);
    ASSERT_TRUE(read) << format(read.diagnostics());
    ASSERT_EQ(read->size(), 1u) << format(read.diagnostics());
    EXPECT_EQ(read->front().command, "simulate");
    const ExperimentState& kept = read->front().result->finding.final.experiments.front();
    EXPECT_EQ(kept.time, only(run).time);
    EXPECT_EQ(kept.outputs[0].simulated, only(run).outputs[0].simulated);
    EXPECT_TRUE(kept.outputs[0].measured.array().isNaN().all());
    EXPECT_TRUE(std::isnan(kept.errorPercent));
    EXPECT_FALSE(kept.outputs[0].figures.hasScale());
}

TEST_F(FreeRun, TellsAnyVariableOfTheModel) {
    const Outcome<VariableValues> values = freeVariableValues(lag(), 1.0, {"lag.u", "step.y"});
    ASSERT_TRUE(values) << format(values.diagnostics());
    ASSERT_EQ(values->values.size(), 2u);
    EXPECT_EQ(values->values[0], values->values[1]);
    EXPECT_DOUBLE_EQ(values->values[0].front(), 0);
    EXPECT_DOUBLE_EQ(values->values[0].back(), 2);
    EXPECT_FALSE(freeVariableValues(lag(), 1.0, {"lag.nothing"}));
}

TEST_F(FreeRun, StopsWhenItIsToldTo) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(runFreely(lag(), 1e9, {}, Progress(stop.get_token(), {})));
}

}  // namespace
}  // namespace analogon
