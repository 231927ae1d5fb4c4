#include "study_fixture.hpp"

namespace analogon {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class StudyTask : public analogon::test::StudyTest {
protected:
    EstimationTask task() const {
        Outcome<EstimationTask> result = estimationTask(read());
        EXPECT_TRUE(result.hasValue()) << format(result.diagnostics());
        return result ? *result : EstimationTask{};
    }
};

TEST_F(StudyTask, HoldsChannelsInTheUnitsOfTheModel) {
    putHeater();
    const EstimationTask result = task();
    EXPECT_EQ(result.className, "Heater");
    ASSERT_EQ(result.recordings.size(), 1u);
    const Recording& recording = result.recordings[0];
    EXPECT_EQ(recording.name, "warm-up");
    EXPECT_THAT(recording.time, ElementsAre(0, 0.5, 1, 1.5));
    EXPECT_THAT(recording.inputNames, ElementsAre("u", "T_amb"));
    EXPECT_NEAR(recording.inputs(0, 3), 2, 1e-12);
    EXPECT_NEAR(recording.inputs(1, 2), 294.15, 1e-9);
    EXPECT_THAT(recording.outputNames, ElementsAre("i"));
    EXPECT_NEAR(recording.outputs(0, 3), 0.667, 1e-12);
    EXPECT_EQ(recording.weights[0], 1);
    ASSERT_EQ(recording.units.size(), 3u);
    EXPECT_EQ(recording.units[1].channel, "T_amb");
    EXPECT_EQ(recording.units[1].column, "T_air");
    EXPECT_EQ(recording.units[1].unit, "degC");
    EXPECT_EQ(recording.units[1].modelUnit, "K");
    EXPECT_THAT(result.model->text(), HasSubstr("model Heater"));
}

TEST_F(StudyTask, LeavesOutWhatIsNotUsed) {
    putHeater();
    Study study = read();
    StudyExperiment bad = study.experiments.front();
    bad.name = "bad";
    bad.inputs.begin()->second.column = "nowhere";
    study.experiments.insert(study.experiments.begin(), bad);
    EXPECT_FALSE(estimationTask(study));
    study.experiments.front().isUsed = false;
    const Outcome<EstimationTask> task = estimationTask(study);
    ASSERT_TRUE(task) << format(task.diagnostics());
    ASSERT_EQ(task->recordings.size(), 1u);
    EXPECT_EQ(task->recordings[0].name, "warm-up");
    const Outcome<Study> again = parseStudyJson(std::make_shared<const Source>("study.json", studyJson(study)));
    ASSERT_TRUE(again) << format(again.diagnostics());
    EXPECT_FALSE(again->experiments[0].isUsed);
    EXPECT_TRUE(again->experiments[1].isUsed);
    study.experiments.back().isUsed = false;
    const Outcome<EstimationTask> none = estimationTask(study);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.diagnostics().front().message, "no experiment of the study is used");
}

TEST_F(StudyTask, KeepsUnusedColumnsAndBridgesTheirGaps) {
    putHeater();
    const EstimationTask result = task();
    const auto& spares = result.recordings.all().at(0).spares;
    ASSERT_EQ(spares.size(), 2u);
    EXPECT_EQ(spares[1].name, "broken");
    EXPECT_THAT(spares[1].values, ElementsAre(1, 1.5, 2, 3));
    EXPECT_EQ(spares[0].name, "flow");
    EXPECT_EQ(spares[0].unit, "l/min");
    EXPECT_THAT(spares[0].values, ElementsAre(1, 2, 3, 4));
}

TEST_F(StudyTask, LeavesOutUnusedColumnsOfWhichLittleWasRecorded) {
    putHeater();
    put("train.csv",
        "t [ms],u_heater [mV],T_air [degC],current [mA],late,rare\n"
        "0,0,20,0,,\n500,1000,20,333,,\n1000,1000,21,333,3,2\n1500,2000,21,667,4,\n");
    const EstimationTask result = task();
    const auto& spares = result.recordings.all().at(0).spares;
    ASSERT_EQ(spares.size(), 1u);
    EXPECT_EQ(spares[0].name, "late");
    EXPECT_THAT(spares[0].values, ElementsAre(3, 3, 3, 4));
}

TEST_F(StudyTask, TakesStartBoundsAndScaleOfParameters) {
    putHeater();
    change("\"R\": {\"fit\": true, \"min\": 0.1, \"max\": 20.0}",
           "\"R\": {\"fit\": true, \"value\": 5, \"max\": 20.0}");
    const EstimationTask result = task();
    ASSERT_EQ(result.parameters.size(), 2u);
    const FitParameter& c = result.parameters[0];
    EXPECT_EQ(c.name, "C");
    EXPECT_EQ(c.start, 10);
    EXPECT_EQ(c.min, 1);
    EXPECT_EQ(c.scale, ParameterScale::Logarithmic);
    const FitParameter& r = result.parameters[1];
    EXPECT_EQ(r.start, 5);
    EXPECT_EQ(r.min, 0);  // of the model
    EXPECT_EQ(r.max, 20);
    EXPECT_EQ(r.unit, "Ohm");
}

TEST_F(StudyTask, SetsWhatIsNotFitted) {
    putHeater();
    change("\"C\": {\"fit\": true, \"min\": 1", "\"C\": {\"fit\": false, \"value\": 7, \"min\": 1");
    const EstimationTask result = task();
    EXPECT_EQ(result.parameters.size(), 1u);
    ASSERT_EQ(result.recordings.all().at(0).starts.size(), 1u);
    EXPECT_EQ(result.recordings[0].starts[0].parameter, "C");
    EXPECT_EQ(result.recordings[0].starts[0].value, 7);
    EXPECT_FALSE(result.recordings[0].starts[0].isFitted);
}

TEST_F(StudyTask, ReadsStartValuesOfAnExperiment) {
    putHeater();
    change("\"outputs\": {\"i\": \"current\"}",
           "\"outputs\": {\"i\": \"current\"}, \"initial\": {\"T_start\": \"T_air\", \"G\": \"fit\", \"C\": 4}");
    change("\"C\": {\"fit\": true", "\"C\": {\"fit\": false");  // else it had two starts
    const EstimationTask result = task();
    const auto& starts = result.recordings.all().at(0).starts;
    ASSERT_EQ(starts.size(), 3u);
    EXPECT_EQ(starts[0].parameter, "C");
    EXPECT_EQ(starts[0].value, 4);
    EXPECT_TRUE(starts[1].isFitted);
    EXPECT_DOUBLE_EQ(starts[1].value, 0.1);
    EXPECT_NEAR(starts[2].value, 293.15, 1e-9);
    EXPECT_EQ(starts[2].column, "T_air");
    EXPECT_EQ(starts[0].column, "") << "it was told";
}

TEST_F(StudyTask, ReadsWhereAVariableBegins) {
    putHeater();
    const std::string outputs = "\"outputs\": {\"i\": \"current\"}";
    change(outputs, outputs + ", \"initial\": {\"T\": \"T_air\"}");
    const Recording told = task().recordings.all().at(0);
    ASSERT_EQ(told.starts.size(), 1u);
    EXPECT_EQ(told.starts[0].parameter, "T.start");
    EXPECT_NEAR(told.starts[0].value, 293.15, 1e-9);
    change("\"T\": \"T_air\"", "\"T.start\": \"fit\"");
    const EstimationTask fitted = task();
    EXPECT_EQ(fitted.recordings.all().at(0).starts.at(0).parameter, "T.start");
    EXPECT_TRUE(fitted.recordings[0].starts[0].isFitted);
    EXPECT_NEAR(fitted.recordings[0].starts[0].value, 293.15, 1e-9) << "the model's own";
    const Outcome<PreparedTask> prepared = prepare(fitted);
    ASSERT_TRUE(prepared) << format(prepared.diagnostics());
    EXPECT_GE(prepared->system->parameterIndex("T.start"), 0);
}

TEST_F(StudyTask, RefusesAStartThatIsToldTwice) {
    putHeater();
    const std::string outputs = "\"outputs\": {\"i\": \"current\"}";
    change(outputs, outputs + ", \"initial\": {\"T\": 290, \"T.start\": \"fit\"}");
    const Outcome<EstimationTask> refused = estimationTask(read());
    ASSERT_FALSE(refused);
    EXPECT_THAT(format(refused.diagnostics()), HasSubstr("where 'T' begins is told twice"));
}

TEST_F(StudyTask, TakesAStartInPlaceOfWhatAnInitialEquationDecides) {
    putHeater();
    put("model.mo",
        "model Heater input Real u; input Real T_amb; output Real i; parameter Real R = 3; parameter Real C "
        "= 1; Real T; equation i = u/R; C*der(T) = T_amb - T; initial equation T = 280; end Heater;");
    const std::string outputs = "\"outputs\": {\"i\": \"current\"}";
    change(outputs, outputs + ", \"initial\": {\"T\": 290}");
    const Outcome<EstimationTask> task = estimationTask(read());
    ASSERT_TRUE(task) << format(task.diagnostics());
    const Outcome<PreparedTask> prepared = prepare(*task);
    ASSERT_TRUE(prepared) << format(prepared.diagnostics());
    const auto value = [&](const char* name) {
        const int index = prepared->system->parameterIndex(name);
        return index < 0 ? std::nan("")
                         : prepared->problem.experiments.front().parameters[static_cast<std::size_t>(index)];
    };
    EXPECT_EQ(value("T.start"), 290);
    EXPECT_EQ(value("T.start.told"), 1);
}

TEST_F(StudyTask, TakesPriors) {
    putHeater();
    change("\"max\": 20.0", "\"max\": 20.0, \"prior\": {\"mean\": 3.2, \"std\": 0.1}");
    const Outcome<EstimationTask> task = estimationTask(read());
    ASSERT_TRUE(task.hasValue()) << format(task.diagnostics());
    for (const FitParameter& p : task->parameters) {
        EXPECT_EQ(p.prior.has_value(), p.name == "R");
        EXPECT_EQ(p.prior.value_or(NormalPrior{3.2, 0.1}), (NormalPrior{3.2, 0.1}));
    }
}

TEST_F(StudyTask, TakesTheClockOfAnOutputAsAParameter) {
    putHeater();
    change("\"current\"", "{\"column\": \"current\", \"clock\": \"fit\"}");
    Outcome<EstimationTask> task = estimationTask(read());
    ASSERT_TRUE(task.hasValue()) << format(task.diagnostics());
    ASSERT_EQ(task->recordings[0].clocks.size(), 1u);
    const auto clock = std::find_if(task->parameters.begin(), task->parameters.end(),
                                    [](const FitParameter& p) { return p.name == "clock i"; });
    ASSERT_NE(clock, task->parameters.end());
    EXPECT_EQ(clock->unit, "s");
    EXPECT_NEAR(clock->max, 0.05 * 1.5, 1e-12);  // a twentieth of the recording
    EXPECT_NEAR(clock->min, -clock->max, 1e-12);
    // Its start, bounds and prior may be set as those of any parameter.
    change("\"parameters\": {", "\"parameters\": {\"clock i\": {\"value\": 0.2, \"min\": 0, \"max\": 0.3},");
    task = estimationTask(read());
    ASSERT_TRUE(task.hasValue()) << format(task.diagnostics());
    for (const FitParameter& p : task->parameters) {
        if (p.name != "clock i") continue;
        EXPECT_EQ(p.start, 0.2);
        EXPECT_EQ(p.max, 0.3);
    }
    // What it may stamp before the recording is left out.
    const Outcome<PreparedTask> prepared = prepare(*task);
    ASSERT_TRUE(prepared.hasValue()) << format(prepared.diagnostics());
    const int output = prepared->system->outputIndex("i");
    EXPECT_TRUE(std::isnan(prepared->problem.experiments[0].measured(output, 0)));
    EXPECT_FALSE(std::isnan(prepared->problem.experiments[0].measured(output, 1)));
}

TEST_F(StudyTask, ShiftsAnInputWithAClockOfItsOwn) {
    putHeater();
    change("\"u_heater\"", "{\"column\": \"u_heater\", \"clock\": 0.25}");
    const Outcome<EstimationTask> task = estimationTask(read());
    ASSERT_TRUE(task.hasValue()) << format(task.diagnostics());
    const Recording& recording = task->recordings[0];  // 0, 1, 1, 2 V every 0.5 s, stamped 0.25 s late
    const auto row =
        std::find(recording.inputNames.begin(), recording.inputNames.end(), "u") - recording.inputNames.begin();
    EXPECT_NEAR(recording.inputs(row, 0), 0.5, 1e-12);
    EXPECT_NEAR(recording.inputs(row, 2), 1.5, 1e-12);
    EXPECT_NEAR(recording.inputs(row, 3), 2.0, 1e-12);
}

TEST_F(StudyTask, RefusesAClockThatCannotBeFitted) {
    putHeater();
    change("\"u_heater\"", "{\"column\": \"u_heater\", \"clock\": \"fit\"}");
    EXPECT_THAT(taskFault().message, HasSubstr("the clock of an input cannot be fitted"));
    putHeater();
    change("\"parameters\": {", "\"parameters\": {\"clock i\": {\"fit\": true},");
    EXPECT_THAT(taskFault().message, HasSubstr("no experiment asks for the clock of the output 'i'"));
}

TEST_F(StudyTask, CutsToTheRange) {
    putHeater();
    change("\"time\": \"t\"", "\"time\": \"t\", \"range\": [0.4, 1.2]");
    EXPECT_THAT(task().recordings.all().at(0).time, ElementsAre(0.5, 1));
    change("[0.4, 1.2]", "[5, 6]");
    const Diagnostic fault = taskFault();
    EXPECT_THAT(fault.message, HasSubstr("fewer than two samples lie between 5 s and 6 s"));
    EXPECT_EQ(fault.place.line, 5);
    EXPECT_THAT(fault.hint, HasSubstr("0 s to 1.5 s"));
}

TEST_F(StudyTask, LeavesBlankCellsOutsideTheRangeAlone) {
    putHeater();
    put("train.csv", "t [s],u_heater,T_air,current\n0,,20,0\n1,2,20,1\n2,2,20,1\n");
    const Diagnostic fault = taskFault();
    EXPECT_EQ(fault.place.line, 2);
    EXPECT_EQ(fault.place.column, 3);
    EXPECT_THAT(fault.hint, HasSubstr("range"));
    change("\"time\": \"t\"", "\"time\": \"t\", \"range\": [1, 2]");
    EXPECT_EQ(task().recordings.all().at(0).time.size(), 2u);
}

TEST_F(StudyTask, PointsAtAColumnThatIsNotThere) {
    putHeater();
    change("u_heater", "u_heatr");
    const Diagnostic fault = taskFault();
    EXPECT_EQ(fault.message, "experiment 'warm-up': 'train.csv' has no column 'u_heatr'");
    EXPECT_EQ(fault.hint, "Did you mean 'u_heater'?");
    EXPECT_EQ(fault.place.file, (directory_ / "study.json").string());
    EXPECT_EQ(fault.place.line, 6);
}

TEST_F(StudyTask, NamesInconvertibleAndUnknownUnits) {
    putHeater();
    change("\"u\": \"u_heater\"", "\"u\": \"T_air\"");
    EXPECT_THAT(taskFault().message, HasSubstr("column 'T_air' is in 'degC', which cannot be converted to the 'V'"));
    change("\"u\": \"T_air\"", "\"u\": {\"column\": \"u_heater\", \"unit\": \"blorb\"}");
    const Diagnostic fault = taskFault();
    EXPECT_THAT(fault.message, HasSubstr("unit 'blorb'"));
    EXPECT_EQ(fault.place.line, 6);
}

TEST_F(StudyTask, NamesSignalsThatTheModelDoesNotHave) {
    putHeater();
    change("\"T_amb\": \"T_air\"", "\"T_ambient\": \"T_air\"");
    Diagnostic fault = taskFault();
    EXPECT_EQ(fault.message, "experiment 'warm-up': the model 'Heater' has no input 'T_ambient'");
    EXPECT_THAT(fault.hint, HasSubstr("T_amb"));
    change(", \"T_ambient\": \"T_air\"", "");
    fault = taskFault();
    EXPECT_EQ(fault.message, "experiment 'warm-up': the input 'T_amb' of the model has no column");
    change("\"inputs\": {\"u\": \"u_heater\"}", "\"inputs\": {\"u\": \"u_heater\", \"i\": \"current\"}");
    EXPECT_THAT(taskFault().hint, HasSubstr("list it under \"outputs\""));
}

TEST_F(StudyTask, ComparesAnyVariableOfTheModel) {
    putHeater();
    change("\"i\": \"current\"", "\"i\": \"current\", \"T\": \"T_air\"");
    const EstimationTask result = task();
    ASSERT_EQ(result.recordings.size(), 1u);
    EXPECT_THAT(result.recordings[0].outputNames, ::testing::UnorderedElementsAre("i", "T"));
    EXPECT_NEAR(result.recordings[0].outputs(result.recordings[0].outputNames[0] == "T" ? 0 : 1, 2), 294.15, 1e-9)
        << "in the unit of the variable";
    const Outcome<PreparedTask> ready = prepare(result);
    ASSERT_TRUE(ready) << format(ready.diagnostics());
    EXPECT_GE(ready->system->outputIndex("T"), 0);
    change("\"T\": \"T_air\"", "\"R\": \"T_air\"");
    EXPECT_EQ(taskFault().message, "experiment 'warm-up': the model 'Heater' has no output 'R'");
}

TEST_F(StudyTask, DrivesAModelInPlaceOfItsSource) {
    putHeater();
    put("rig.mo", R"(model Rig
  Analogon.Sources.Constant supply(k = 5);
  Analogon.Sources.Constant room(k = 293.15);
  Heater heater;
equation
  connect(supply.y, heater.u);
  connect(room.y, heater.T_amb);
end Rig;
)");
    put("model.mo", R"(model Heater
  Analogon.Interfaces.RealInput u(unit="V"), T_amb(unit="K");
  Real i(unit="A") = u/R;
  parameter Real R(unit="Ohm") = 3;
  parameter Real C(unit="J/K") = 10;
  Real T(unit="K", start=293.15, fixed=true);
equation
  C*der(T) = u*i - 0.1*(T - T_amb);
end Heater;
)");
    change("\"class\": \"Heater\"", "\"class\": \"Rig\"");
    change("{\"u\": \"u_heater\", \"T_amb\": \"T_air\"}", "{\"supply.y\": \"u_heater\"}");
    change("\"i\": \"current\"", "\"heater.i\": \"current\"");
    change("\"R\"", "\"heater.R\"");
    change("\"C\"", "\"heater.C\"");
    const EstimationTask result = task();
    ASSERT_EQ(result.recordings.size(), 1u);
    EXPECT_THAT(result.recordings[0].inputNames, ElementsAre("supply.y"));
    EXPECT_THAT(result.recordings[0].outputNames, ElementsAre("heater.i"));
    const Outcome<PreparedTask> ready = prepare(result);
    ASSERT_TRUE(ready) << format(ready.diagnostics());
    EXPECT_GE(ready->system->inputIndex("supply.y"), 0);
    change("\"supply.y\"", "\"heater.T\"");
    EXPECT_THAT(taskFault().hint, HasSubstr("neither an input of the model nor the output of a block that only"));
}

TEST_F(StudyTask, WantsAnOutput) {
    putHeater();
    change("{\"i\": \"current\"}", "{}");
    EXPECT_THAT(taskFault().message, HasSubstr("measures no output"));
}

TEST_F(StudyTask, NamesParametersThatCannotBeFitted) {
    putHeater();
    change("\"C\": {", "\"Cc\": {");
    Diagnostic fault = taskFault();
    EXPECT_EQ(fault.message, "the model 'Heater' has no parameter 'Cc'");
    EXPECT_EQ(fault.place.line, 11);
    for (const auto& [name, reason] : {std::pair("T", "a variable"), {"k", "declared final"}, {"n", "an Integer"}}) {
        putHeater();
        change("\"C\": {", std::string("\"") + name + "\": {");
        EXPECT_THAT(taskFault().message, HasSubstr(reason));
    }
    putHeater();
    change("\"max\": 20.0", "\"max\": 2.0");
    EXPECT_THAT(taskFault().message, HasSubstr("the start value 3 of 'R' lies outside its bounds 0.1 … 2"));
}

TEST_F(StudyTask, SaysOfAParameterThatAnInitialEquationComputesThatItIsOne) {
    const auto reasonFor = [&](const std::string& name) {
        putHeater();
        put("model.mo",
            "model Heater input Real u; input Real T_amb; output Real i; parameter Real R = 3; parameter Real C = 1; "
            "parameter Real p(fixed = false), s(fixed = false), f = 2*s; Real T(start = 280, fixed = true); "
            "initial equation p = 3*R; s*s = T; equation i = u/R; C*der(T) = T_amb - T + p*s*f; end Heater;");
        change("\"C\": {", "\"" + name + "\": {");
        return taskFault().message;
    };
    for (const std::string name : {"p", "s", "f"})  // in a closed form, by a search, by what follows from it
        EXPECT_EQ(reasonFor(name).english(),
                  "'" + name + "' cannot be set or fitted: it is computed by an initial equation");
    EXPECT_THAT(reasonFor("T").english(), HasSubstr("it is a variable"));
}

TEST_F(StudyTask, SuggestsTheClassThatWasMeant) {
    putHeater();
    change("\"class\": \"Heater\"", "\"class\": \"Heatr\"");
    const Diagnostic fault = taskFault();
    EXPECT_EQ(fault.message, "there is no class 'Heatr' in the models of the study");
    EXPECT_EQ(fault.hint, "Did you mean 'Heater'?");
    EXPECT_EQ(fault.place.line, 3);
}

TEST_F(StudyTask, PassesOnTheFaultsOfTheModel) {
    putHeater();
    put("model.mo", "model Heater\n  Reel x;\nequation\n  x = 1;\nend Heater;\n");
    const Diagnostic fault = taskFault();
    EXPECT_EQ(fault.place.line, 2);
    EXPECT_EQ(fault.place.file, (directory_ / "model.mo").string());
}

TEST_F(StudyTask, UsesBlocksThatLieBeside) {
    putHeater();
    put("blocks.mo",
        "model Base\n  input Real u(unit=\"V\");\n  input Real T_amb(unit=\"K\");\n  output Real i(unit=\"A\");\n"
        "  parameter Real R = 2;\n  parameter Real C = 3;\nequation\n  i = u/R + 0*T_amb*C;\nend Base;\n");
    put("model.mo", "model Heater\n  extends Base;\nend Heater;\n");
    EXPECT_EQ(task().parameters.size(), 2u);
}

TEST_F(StudyTask, ReadsEveryPublicCase) {
    const std::filesystem::path cases = ANALOGON_ROOT "/../shared/cases";
    if (!std::filesystem::exists(cases)) GTEST_SKIP() << "the shared cases are not here";
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(cases)) {
        if (!entry.is_directory()) continue;
        const Outcome<Study> study = readStudy(entry.path());
        ASSERT_TRUE(study.hasValue()) << format(study.diagnostics());
        const Outcome<EstimationTask> result = estimationTask(*study);
        ASSERT_TRUE(result.hasValue()) << format(result.diagnostics());
        EXPECT_EQ(result->recordings.size(), 2u);
        ++count;
    }
    EXPECT_GE(count, 14);
}

}  // namespace
}  // namespace analogon
