#include "tests/mutants.hpp"

#include "core/measure/text/text_recording.hpp"
#include "core/study/study.hpp"

/// Studies that are nearly one. Each must end in a task or in messages.
namespace analogon {
namespace {

const std::string soundJson = R"({
  "format": "analogon-study-1", "class": "Heater",
  "experiments": [
    {"name": "warm-up", "role": "fit", "file": "train.csv", "time": "t", "range": [0, 100],
     "inputs": {"u": "u_heater", "T_amb": {"column": "T_air", "unit": "degC", "scale": 1, "offset": 0}},
     "outputs": {"i": {"column": "current", "weight": 1, "clock": 0.1}}, "initial": {"T_start": "T_air"}}],
  "parameters": {"R": {"fit": true, "min": 0.1, "max": 20.0, "prior": {"mean": 3, "std": 1}},
    "C": {"fit": true, "min": 1, "max": 100, "scale": "log"}, "G[1]": {"fit": false, "value": 0.1}}
})";

const std::string soundModel = R"(model Heater "A heated body"
  input Real u(unit="V") "voltage"; input Real T_amb(unit="K"); output Real i(unit="A");
  parameter Real R(unit="Ohm", min=0) = 3; parameter Real C = 10; parameter Real G[2] = {0.1, 0.2};
  parameter Real T_start(unit="K") = 293.15; Real T(unit="K", start=T_start, fixed=true);
equation
  i = u/R; C*der(T) = u*i - sum(G[k]*(T - T_amb) for k in 1:2);
end Heater;
)";

const std::string soundTable =
    "t [ms],u_heater [mV],T_air [degC],current [mA],flow [l/min],\"a \"\"name\"\"\"\n"
    "0,0,20,0,1,1\n500,1000,20,333,2,\n1000,1000,21,333,3,2\n1500,2000,21,667,4,nan\n2e3,2000,-0.5,667,4,1e-300\n";

/// All that is done before numbers are worked out. Whether a task came of it.
bool goesThrough(const std::string& json, const std::string& model, const std::string& table) {
    Outcome<Study> study = parseStudyJson(std::make_shared<const Source>("study.json", json));
    if (!study) {
        EXPECT_FALSE(format(study.diagnostics()).empty());
        return false;
    }
    study->models["model.mo"] = model;
    Outcome<Table> read = textTables(table, "train.csv");
    if (!read) {
        EXPECT_LT(format(read.diagnostics()).size(), 20000u);
        return false;
    }
    const auto shared = std::make_shared<const Table>(std::move(*read));
    for (const StudyExperiment& e : study->experiments) study->tables[e.file] = shared;
    const Outcome<EstimationTask> task = estimationTask(*study);
    EXPECT_EQ(format(task.diagnostics()).find('\x1b'), std::string::npos);
    return task.hasValue();
}

TEST(Mutants, ComeFromASoundStudy) { EXPECT_TRUE(goesThrough(soundJson, soundModel, soundTable)); }

TEST(Mutants, OfStudiesEndInATaskOrInMessages) {
    expectAllEnd([](unsigned number) { return goesThrough(mutated(soundJson, number), soundModel, soundTable); });
}

TEST(Mutants, OfModelsEndInATaskOrInMessages) {
    expectAllEnd([](unsigned number) { return goesThrough(soundJson, mutated(soundModel, number), soundTable); });
}

TEST(Mutants, OfMeasurementsEndInATaskOrInMessages) {
    expectAllEnd([](unsigned number) { return goesThrough(soundJson, soundModel, mutated(soundTable, number)); });
}

}  // namespace
}  // namespace analogon
